package org.jbox2d.fracture;

import org.jbox2d.common.Vec2;

/**
 * A site whose Voronoi cell is united with those of other sites to one piece: so a material can
 * have pieces that no diagram with one site each has, such as bricks in a bond or long splinters
 * whose ends do not lie side by side. {@link Material#focee} may return sites of this class and
 * plain vectors side by side; the cell of a plain vector is a piece of its own.
 */
public final class Site extends Vec2 {
  private static final long serialVersionUID = 1L;

  /** Numbers of pieces are below this. */
  public static final int NUMBERS = 1 << 20;

  private final int piece;

  /**
   * A site of a piece.
   *
   * @param x in the body's frame, m
   * @param y in the body's frame, m
   * @param piece number of the piece, from 0 to {@link #NUMBERS} - 1. The cells of all sites with
   *     the same number are one piece if they lie side by side
   * @throws IllegalArgumentException if the number is not one of these
   */
  public Site(float x, float y, int piece) {
    super(x, y);
    if (piece < 0 || piece >= NUMBERS) {
      throw new IllegalArgumentException(
          "number of a piece must be 0 to " + (NUMBERS - 1) + ", is " + piece);
    }
    this.piece = piece;
  }

  /** Returns the number of the piece. */
  public int piece() {
    return piece;
  }
}
