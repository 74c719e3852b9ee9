package org.jbox2d.collision;

/**
 * Names the features (vertices or faces) of two shapes that make a contact point, so that the point
 * is known again in the next step.
 */
public class ContactID implements Comparable<ContactID> {

  /** Kind of a feature. */
  public enum Type {
    VERTEX,
    FACE
  }

  /** Index of the feature on shape A. */
  public byte indexA;

  /** Index of the feature on shape B. */
  public byte indexB;

  /** Ordinal of the {@link Type} on shape A. */
  public byte typeA;

  /** Ordinal of the {@link Type} on shape B. */
  public byte typeB;

  public ContactID() {}

  public ContactID(ContactID c) {
    set(c);
  }

  /**
   * The four bytes as one number: {@link #indexA} is the most significant, {@link #typeB} the
   * least.
   */
  public int getKey() {
    return (indexA & 0xff) << 24 | (indexB & 0xff) << 16 | (typeA & 0xff) << 8 | (typeB & 0xff);
  }

  public boolean isEqual(ContactID cid) {
    return getKey() == cid.getKey();
  }

  public void set(ContactID c) {
    indexA = c.indexA;
    indexB = c.indexB;
    typeA = c.typeA;
    typeB = c.typeB;
  }

  /** Exchanges A and B. */
  public void flip() {
    byte index = indexA;
    indexA = indexB;
    indexB = index;
    byte type = typeA;
    typeA = typeB;
    typeB = type;
  }

  public void zero() {
    indexA = 0;
    indexB = 0;
    typeA = 0;
    typeB = 0;
  }

  @Override
  public int compareTo(ContactID o) {
    return Integer.compare(getKey(), o.getKey());
  }
}
