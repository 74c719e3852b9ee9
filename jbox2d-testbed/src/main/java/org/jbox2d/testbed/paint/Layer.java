package org.jbox2d.testbed.paint;

/** Something that a picture may show or leave out. */
public enum Layer {
  /** Bodies, filled. */
  SHAPES("Shapes"),
  /** Edges between the convex parts of a body. */
  PARTS("Convex parts"),
  /** Points of contact, with a line along the normal as long as the impulse is strong. */
  CONTACTS("Contacts"),
  /** Centres of mass. */
  CENTRES("Mass centres"),
  /** Boxes of the broad phase. */
  BOXES("AABBs"),
  /** Voronoi cells of the last fracture, and where they broke away. */
  CELLS("Last fracture"),
  /** Numbers of bodies. */
  IDS("Ids"),
  /** Joints. */
  JOINTS("Joints"),
  /** Sleeping bodies, dimmed. */
  SLEEPING("Sleeping");

  private final String title;

  Layer(String title) {
    this.title = title;
  }

  /** Returns a few words for a list. */
  public String title() {
    return title;
  }
}
