package org.jbox2d.fracture.assembly;

import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.dynamics.CompoundShape;
import org.jbox2d.fracture.geometry.Outline;

/**
 * A piece of a broken body: its outline in the frame of the body it came from, which is its own
 * body's frame too.
 */
public final class Piece implements CompoundShape {
  /** Counter-clockwise, holes clockwise, m. */
  public final Outline outline;

  /** Area of the body that broke first, of which this is a piece of a piece, m^2. */
  public final double originalArea;

  /**
   * Factor on the density that makes up for what rounding to float coordinates and the engine's
   * vertex tolerance change of the area, so that mass is kept: 1 but for some millionths, or some
   * thousandths for the smallest pieces.
   */
  final float densityFactor;

  /** Area of the parts, m^2; the outline's but for that rounding. */
  final double areaOfParts;

  private final Shape[] parts;

  Piece(Outline outline, double originalArea, Shape[] parts) {
    this.outline = outline;
    this.originalArea = originalArea;
    this.parts = parts;
    areaOfParts = PartShapes.area(parts);
    densityFactor = (float) (outline.area() / areaOfParts);
  }

  @Override
  public Shape[] getParts() {
    return parts.clone();
  }

  /** Length of all rings, m. */
  double perimeter() {
    double sum = 0;
    for (int r = 0; r < outline.ringCount(); r++) {
      int end = outline.ringEnd(r);
      for (int i = outline.ringStart(r), j = end - 1; i < end; j = i++) {
        double dx = outline.x(i) - outline.x(j);
        double dy = outline.y(i) - outline.y(j);
        sum += Math.sqrt(dx * dx + dy * dy);
      }
    }
    return sum;
  }

  boolean contains(double x, double y) {
    boolean inside = false;
    for (int r = 0; r < outline.ringCount(); r++) {
      int end = outline.ringEnd(r);
      for (int i = outline.ringStart(r), j = end - 1; i < end; j = i++) {
        boolean crosses = (outline.y(i) > y) != (outline.y(j) > y);
        if (crosses
            && x
                < outline.x(i)
                    + (y - outline.y(i))
                        * (outline.x(j) - outline.x(i))
                        / (outline.y(j) - outline.y(i))) {
          inside = !inside;
        }
      }
    }
    return inside;
  }
}
