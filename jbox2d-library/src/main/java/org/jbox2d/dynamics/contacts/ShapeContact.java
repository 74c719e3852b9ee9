package org.jbox2d.dynamics.contacts;

import org.jbox2d.collision.Collision;
import org.jbox2d.collision.Manifold;
import org.jbox2d.collision.narrowphase.KeptManifold;
import org.jbox2d.collision.narrowphase.PartShape;
import org.jbox2d.collision.shapes.ChainShape;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.EdgeShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.collision.shapes.ShapeType;
import org.jbox2d.common.Sweep;
import org.jbox2d.common.Transform;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.pooling.IWorldPool;

/**
 * The one kind of contact there is: it picks the narrow phase by the shapes' types once, when it is
 * made.
 */
public final class ShapeContact extends Contact {
  private static final int CIRCLES = 0;
  private static final int POLYGON_CIRCLE = 1;
  private static final int POLYGONS = 2;
  private static final int EDGE_CIRCLE = 3;
  private static final int EDGE_POLYGON = 4;
  private static final int CHAIN_CIRCLE = 5;
  private static final int CHAIN_POLYGON = 6;
  private static final int PART_CIRCLE = 7;
  private static final int PARTS = 8;

  private int pair;

  /** Where the narrow phase begins to search. */
  private int guess;

  private KeptManifold kept;

  private EdgeShape chainEdge;

  /** Makes a contact that has no fixtures yet. */
  public ShapeContact(IWorldPool pool) {
    super(pool);
  }

  /**
   * Whether a pair of shapes must be swapped so that the narrow phase takes them in its order:
   * chain, edge, polygon, circle. Segments do not collide with segments; for such a pair the answer
   * is of no use.
   */
  public static boolean mustSwap(ShapeType a, ShapeType b) {
    return rank(a) > rank(b);
  }

  /**
   * Whether shapes of these types collide at all: segments have no area, and do not collide with
   * one another.
   */
  public static boolean canCollide(ShapeType a, ShapeType b) {
    return rank(a) > 1 || rank(b) > 1;
  }

  private static int rank(ShapeType type) {
    switch (type) {
      case CHAIN:
        return 0;
      case EDGE:
        return 1;
      case POLYGON:
        return 2;
      default:
        return 3;
    }
  }

  @Override
  public void init(Fixture fA, int indexA, Fixture fB, int indexB) {
    super.init(fA, indexA, fB, indexB);
    guess = 0;
    if (kept != null) {
      kept.forget();
    }
    if (fA == null) {
      return;
    }
    boolean circle = fB.getType() == ShapeType.CIRCLE;
    switch (fA.getType()) {
      case CIRCLE:
        pair = CIRCLES;
        break;
      case POLYGON:
        if (fA.m_shape instanceof PartShape || fB.m_shape instanceof PartShape) {
          pair = circle ? PART_CIRCLE : PARTS;
        } else {
          pair = circle ? POLYGON_CIRCLE : POLYGONS;
        }
        break;
      case EDGE:
        pair = circle ? EDGE_CIRCLE : EDGE_POLYGON;
        break;
      default:
        pair = circle ? CHAIN_CIRCLE : CHAIN_POLYGON;
        break;
    }
  }

  @Override
  boolean isGood(Transform xfA, Transform xfB) {
    return pair == POLYGONS && kept != null && kept.isGood(xfA, xfB) && kept.isOf(shapes());
  }

  /** Checksum of both polygons. */
  private int shapes() {
    int pass = pool.getCollision().pass();
    return KeptManifold.joined(m_fixtureA.polygonChecksum(pass), m_fixtureB.polygonChecksum(pass));
  }

  @Override
  void keep(Transform xfA, Transform xfB) {
    if (pair != POLYGONS) {
      return;
    }
    if (kept == null) {
      kept = new KeptManifold();
    }
    kept.keep(
        m_manifold,
        (PolygonShape) m_fixtureA.m_shape,
        xfA,
        (PolygonShape) m_fixtureB.m_shape,
        xfB,
        pool.getCollision().separationOfPolygons(),
        shapes());
  }

  @Override
  void lookAtManifold() {
    if (kept != null) {
      kept.forgetIfChanged(m_manifold);
    }
  }

  @Override
  public void evaluate(Manifold manifold, Transform xfA, Transform xfB) {
    Collision collision = pool.getCollision();
    Shape a = m_fixtureA.m_shape;
    Shape b = m_fixtureB.m_shape;
    switch (pair) {
      case CIRCLES:
        collision.collideCircles(manifold, (CircleShape) a, xfA, (CircleShape) b, xfB);
        break;
      case POLYGON_CIRCLE:
        collision.collidePolygonAndCircle(manifold, (PolygonShape) a, xfA, (CircleShape) b, xfB);
        break;
      case PART_CIRCLE:
        collision.collidePartAndCircle(
            manifold, (PolygonShape) a, xfA, (CircleShape) b, xfB, wayX(), wayY());
        break;
      case POLYGONS:
        guess =
            collision.collidePolygons(
                manifold, (PolygonShape) a, xfA, (PolygonShape) b, xfB, guess);
        break;
      case PARTS:
        collision.collideParts(
            manifold, (PolygonShape) a, xfA, (PolygonShape) b, xfB, wayX(), wayY());
        break;
      case EDGE_CIRCLE:
        collision.collideEdgeAndCircle(manifold, (EdgeShape) a, xfA, (CircleShape) b, xfB);
        break;
      case EDGE_POLYGON:
        collision.collideEdgeAndPolygon(manifold, (EdgeShape) a, xfA, (PolygonShape) b, xfB);
        break;
      case CHAIN_CIRCLE:
        collision.collideEdgeAndCircle(manifold, edgeOf(a), xfA, (CircleShape) b, xfB);
        break;
      default:
        collision.collideEdgeAndPolygon(manifold, edgeOf(a), xfA, (PolygonShape) b, xfB);
        break;
    }
  }

  /** How B's centre of mass has moved against A's in the last step, m. */
  private float wayX() {
    Sweep a = m_fixtureA.m_body.m_sweep;
    Sweep b = m_fixtureB.m_body.m_sweep;
    return (b.c.x - b.c0.x) - (a.c.x - a.c0.x);
  }

  private float wayY() {
    Sweep a = m_fixtureA.m_body.m_sweep;
    Sweep b = m_fixtureB.m_body.m_sweep;
    return (b.c.y - b.c0.y) - (a.c.y - a.c0.y);
  }

  private EdgeShape edgeOf(Shape chain) {
    if (chainEdge == null) {
      chainEdge = new EdgeShape();
    }
    ((ChainShape) chain).getChildEdge(chainEdge, m_indexA);
    return chainEdge;
  }
}
