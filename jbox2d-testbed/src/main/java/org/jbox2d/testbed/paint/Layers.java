package org.jbox2d.testbed.paint;

/**
 * What a picture shows besides the bodies.
 *
 * @param parts the edges between the convex parts of a body
 * @param contacts points of contact, with a line along the normal as long as the impulse is strong
 * @param centres centres of mass
 */
public record Layers(boolean parts, boolean contacts, boolean centres) {
  /** Bodies and joints alone. */
  public static final Layers NONE = new Layers(false, false, false);

  /** Returns these layers with that of the parts switched over. */
  public Layers toggledParts() {
    return new Layers(!parts, contacts, centres);
  }

  /** Returns these layers with that of the contacts switched over. */
  public Layers toggledContacts() {
    return new Layers(parts, !contacts, centres);
  }

  /** Returns these layers with that of the centres switched over. */
  public Layers toggledCentres() {
    return new Layers(parts, contacts, !centres);
  }
}
