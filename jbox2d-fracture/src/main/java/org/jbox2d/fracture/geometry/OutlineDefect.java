package org.jbox2d.fracture.geometry;

/** Why an outline is refused. */
public enum OutlineDefect {
  /** The outline is valid. */
  NONE("is valid"),
  /** A coordinate is NaN or infinite. */
  NOT_FINITE("is not finite"),
  /** A ring has fewer than three vertices. */
  TOO_FEW_VERTICES("belongs to a ring of fewer than three vertices"),
  /** Two vertices of the outline are the same point. */
  REPEATED_VERTEX("is repeated by vertex"),
  /** A ring encloses no area. */
  ZERO_AREA("belongs to a ring without area"),
  /** Two edges of a ring cross or touch, or an edge folds back on the one before it. */
  SELF_INTERSECTION("starts an edge that meets the edge from vertex"),
  /** A hole crosses or touches the outer ring or another hole. */
  RINGS_MEET("starts an edge that meets, in another ring, the edge from vertex"),
  /** A hole lies outside the outer ring. */
  HOLE_OUTSIDE("belongs to a hole outside the outer ring"),
  /** A hole lies inside another hole. */
  HOLE_IN_HOLE("belongs to a hole inside that of vertex");

  private final String text;

  OutlineDefect(String text) {
    this.text = text;
  }

  /**
   * What is wrong with a vertex that has this defect, as the end of a sentence that starts with the
   * vertex.
   */
  public String text() {
    return text;
  }
}
