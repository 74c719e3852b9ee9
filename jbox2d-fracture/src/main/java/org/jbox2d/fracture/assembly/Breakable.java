package org.jbox2d.fracture.assembly;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.collision.shapes.ShapeType;
import org.jbox2d.dynamics.CompoundShape;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.fracture.PolygonFixture;
import org.jbox2d.fracture.geometry.Outline;

/**
 * What breaks as one: a fixture, or all fixtures of a polygon; and its outline in the body's frame.
 */
final class Breakable {
  /** A circle breaks as a regular polygon of as many vertices and the same area. */
  private static final int CIRCLE_VERTICES = 32;

  final List<Fixture> fixtures;
  final Outline outline;

  /** Area of the body of which this is a piece of a piece; its own if it never broke. */
  final double originalArea;

  /**
   * Area of the outline over that of the fixtures, by which a piece's density was multiplied when
   * it was made.
   */
  final float densityFactor;

  private Breakable(
      List<Fixture> fixtures, Outline outline, double originalArea, float densityFactor) {
    this.fixtures = fixtures;
    this.outline = outline;
    this.originalArea = originalArea;
    this.densityFactor = densityFactor;
  }

  /** Returns what breaks when a fixture is struck, or {@code null} if its shape has no area. */
  static Breakable of(Fixture struck) {
    CompoundShape compound = struck.getCompound();
    if (compound != null) {
      Outline outline = outlineOf(compound);
      List<Fixture> parts = partsOf(struck, compound);
      // A compound of which the user has destroyed a part no longer has that outline: its parts
      // break one by one.
      if (outline != null && parts.size() == compound.getParts().length) {
        Piece piece = compound instanceof Piece ? (Piece) compound : null;
        return piece == null
            ? new Breakable(parts, outline, outline.area(), factorOf(compound, outline))
            : new Breakable(parts, outline, piece.originalArea, piece.densityFactor);
      }
    }
    Outline outline = outlineOf(struck);
    return outline == null
        ? null
        : new Breakable(Collections.singletonList(struck), outline, outline.area(), 1f);
  }

  /** The parts of a user's polygon do not fill it to the last bit either; their mass is kept. */
  private static float factorOf(CompoundShape compound, Outline outline) {
    return (float) (outline.area() / PartShapes.area(compound.getParts()));
  }

  private static Outline outlineOf(CompoundShape compound) {
    if (compound instanceof Piece) {
      return ((Piece) compound).outline;
    }
    return compound instanceof PolygonFixture ? ((PolygonFixture) compound).normalOutline() : null;
  }

  private static List<Fixture> partsOf(Fixture struck, CompoundShape compound) {
    List<Fixture> parts = new ArrayList<>();
    for (Fixture f = struck.getBody().getFixtureList(); f != null; f = f.getNext()) {
      if (f.getCompound() == compound) {
        parts.add(f);
      }
    }
    return parts;
  }

  private static Outline outlineOf(Fixture fixture) {
    if (fixture.getType() == ShapeType.POLYGON) {
      PolygonShape polygon = (PolygonShape) fixture.getShape();
      double[] xy = new double[2 * polygon.m_count];
      for (int i = 0; i < polygon.m_count; i++) {
        xy[2 * i] = polygon.m_vertices[i].x;
        xy[2 * i + 1] = polygon.m_vertices[i].y;
      }
      return Outline.of(xy);
    }
    return fixture.getType() == ShapeType.CIRCLE ? circle((CircleShape) fixture.getShape()) : null;
  }

  /**
   * {@code r' = r sqrt(a / sin a)} with {@code a = 2 pi / n} gives the regular n-gon the area of
   * the circle (thesis, 6.7.2).
   */
  private static Outline circle(CircleShape circle) {
    double a = 2 * Math.PI / CIRCLE_VERTICES;
    double radius = circle.m_radius * Math.sqrt(a / StrictMath.sin(a));
    double[] xy = new double[2 * CIRCLE_VERTICES];
    for (int i = 0; i < CIRCLE_VERTICES; i++) {
      xy[2 * i] = circle.m_p.x + radius * StrictMath.cos(i * a);
      xy[2 * i + 1] = circle.m_p.y + radius * StrictMath.sin(i * a);
    }
    return Outline.of(xy);
  }
}
