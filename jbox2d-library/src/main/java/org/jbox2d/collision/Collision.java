package org.jbox2d.collision;

import org.jbox2d.collision.Distance.SimplexCache;
import org.jbox2d.collision.narrowphase.CircleCircle;
import org.jbox2d.collision.narrowphase.EdgeCircle;
import org.jbox2d.collision.narrowphase.EdgePolygon;
import org.jbox2d.collision.narrowphase.FaceQuery;
import org.jbox2d.collision.narrowphase.PartPolygons;
import org.jbox2d.collision.narrowphase.PolygonCircle;
import org.jbox2d.collision.narrowphase.PolygonPolygon;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.EdgeShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.Rot;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;
import org.jbox2d.pooling.IWorldPool;

/**
 * Contact generation: one method for each pair of shapes, and the steps they are made of.
 *
 * <p>A manifold exists if the shapes are no further apart than the sum of their skin radii. Its
 * points carry ids that stay the same from step to step while the same features touch, so that
 * impulses can be carried over; the impulses themselves are not touched here. Manifolds of circles
 * have one point, all others at most two.
 *
 * <p>An instance keeps scratch memory: use one for each thread.
 */
public class Collision {

  /** Marks the absence of a feature. */
  public static final int NULL_FEATURE = Integer.MAX_VALUE;

  /**
   * Distance of the skins in metres up to which {@link #testOverlap} calls two shapes overlapping:
   * ten float steps at 1 m, the rounding of a distance between shapes of that size.
   */
  private static final float OVERLAP_TOLERANCE = 10f * Settings.EPSILON;

  private static final byte VERTEX = (byte) ContactID.Type.VERTEX.ordinal();
  private static final byte FACE = (byte) ContactID.Type.FACE.ordinal();

  private final PolygonPolygon polygons = new PolygonPolygon();
  private final PartPolygons parts = new PartPolygons(polygons);
  private final EdgePolygon edgePolygon = new EdgePolygon();
  private final FaceQuery query = new FaceQuery();
  private final Distance distance = new Distance();
  private final DistanceInput distanceInput = new DistanceInput();
  private final DistanceOutput distanceOutput = new DistanceOutput();
  private final SimplexCache cache = new SimplexCache();
  private int pass;

  public Collision() {}

  /** As {@link #Collision()}; the pool is not used, and is taken for compatibility. */
  public Collision(IWorldPool argPool) {}

  /** Engine-internal: another pass over all contacts begins. */
  public final void beginPass() {
    pass++;
  }

  /** Engine-internal: number of the pass; what is looked at once in each remembers it. */
  public final int pass() {
    return pass;
  }

  /**
   * Whether two shapes touch or overlap, skins included.
   *
   * @param indexA link of a chain, otherwise ignored
   * @param indexB link of a chain, otherwise ignored
   */
  public final boolean testOverlap(
      Shape shapeA, int indexA, Shape shapeB, int indexB, Transform xfA, Transform xfB) {
    distanceInput.proxyA.set(shapeA, indexA);
    distanceInput.proxyB.set(shapeB, indexB);
    distanceInput.transformA.set(xfA);
    distanceInput.transformB.set(xfB);
    distanceInput.useRadii = true;
    cache.count = 0;
    distance.distance(distanceOutput, cache, distanceInput);
    return distanceOutput.distance < OVERLAP_TOLERANCE;
  }

  /** Writes the manifold of two circles. */
  public final void collideCircles(
      Manifold manifold, CircleShape circle1, Transform xfA, CircleShape circle2, Transform xfB) {
    CircleCircle.collide(manifold, circle1, xfA, circle2, xfB);
  }

  /** Writes the manifold of a polygon (A) and a circle (B). */
  public final void collidePolygonAndCircle(
      Manifold manifold, PolygonShape polygon, Transform xfA, CircleShape circle, Transform xfB) {
    PolygonCircle.collide(manifold, polygon, xfA, circle, xfB);
  }

  /**
   * Engine-internal: writes the manifold of a polygon that is a part of a compound, and a circle.
   *
   * @param wayX how the circle has moved against the polygon in the last step, in the world, m
   * @param wayY see {@code wayX}
   */
  public final void collidePartAndCircle(
      Manifold manifold,
      PolygonShape polygon,
      Transform xfA,
      CircleShape circle,
      Transform xfB,
      float wayX,
      float wayY) {
    PolygonCircle.collide(manifold, polygon, xfA, circle, xfB, wayX, wayY);
  }

  /** Writes the manifold of two polygons. */
  public final void collidePolygons(
      Manifold manifold, PolygonShape polyA, Transform xfA, PolygonShape polyB, Transform xfB) {
    polygons.collide(manifold, polyA, xfA, polyB, xfB, 0);
  }

  /**
   * Engine-internal: as {@link #collidePolygons(Manifold, PolygonShape, Transform, PolygonShape,
   * Transform)}, but begins to search where the last call for the pair ended.
   *
   * @param guess what that call returned, or 0
   * @return the same for the next call
   * @see #separationOfPolygons
   */
  public final int collidePolygons(
      Manifold manifold,
      PolygonShape polyA,
      Transform xfA,
      PolygonShape polyB,
      Transform xfB,
      int guess) {
    return polygons.collide(manifold, polyA, xfA, polyB, xfB, guess);
  }

  /**
   * Engine-internal: by how much the outlines of the last two polygons are apart at least, without
   * their skins, m; negative if they overlap.
   */
  public final float separationOfPolygons() {
    return polygons.separation;
  }

  /**
   * Engine-internal: writes the manifold of two polygons that may be parts of compounds.
   *
   * @param wayX how B has moved against A in the last step, in the world, m
   * @param wayY see {@code wayX}
   */
  public final void collideParts(
      Manifold manifold,
      PolygonShape polyA,
      Transform xfA,
      PolygonShape polyB,
      Transform xfB,
      float wayX,
      float wayY) {
    parts.collide(manifold, polyA, xfA, polyB, xfB, wayX, wayY);
  }

  /** Writes the manifold of an edge (A) and a circle (B). */
  public void collideEdgeAndCircle(
      Manifold manifold, EdgeShape edgeA, Transform xfA, CircleShape circleB, Transform xfB) {
    EdgeCircle.collide(manifold, edgeA, xfA, circleB, xfB);
  }

  /** Writes the manifold of an edge (A) and a polygon (B). */
  public void collideEdgeAndPolygon(
      Manifold manifold, EdgeShape edgeA, Transform xfA, PolygonShape polygonB, Transform xfB) {
    edgePolygon.collide(manifold, edgeA, xfA, polygonB, xfB);
  }

  /**
   * Compares two manifolds of a contact by their ids.
   *
   * @param state1 receives for each point of {@code manifold1} whether it persists or is removed
   * @param state2 receives for each point of {@code manifold2} whether it persists or is added
   */
  public static final void getPointStates(
      PointState[] state1, PointState[] state2, Manifold manifold1, Manifold manifold2) {
    compare(state1, manifold1, manifold2, PointState.REMOVE_STATE);
    compare(state2, manifold2, manifold1, PointState.ADD_STATE);
  }

  private static void compare(PointState[] states, Manifold of, Manifold other, PointState alone) {
    for (int i = 0; i < states.length; i++) {
      states[i] = PointState.NULL_STATE;
    }
    for (int i = 0; i < of.pointCount; i++) {
      states[i] = alone;
      for (int j = 0; j < other.pointCount; j++) {
        if (of.points[i].id.isEqual(other.points[j].id)) {
          states[i] = PointState.PERSIST_STATE;
        }
      }
    }
  }

  /**
   * Cuts a segment by the half plane normal . v &lt;= offset (Sutherland and Hodgman, "Reentrant
   * polygon clipping", 1974, for one edge).
   *
   * @param vOut two vertices that receive what remains; a cut end is identified as vertex {@code
   *     vertexIndexA} of A on a face of B
   * @param vIn the two ends
   * @return how many vertices remain: 0 or 2, or 1 if just an end lies on the boundary
   */
  public static final int clipSegmentToLine(
      ClipVertex[] vOut, ClipVertex[] vIn, Vec2 normal, float offset, int vertexIndexA) {
    Vec2 start = vIn[0].v;
    Vec2 end = vIn[1].v;
    float excess0 = normal.x * start.x + normal.y * start.y - offset;
    float excess1 = normal.x * end.x + normal.y * end.y - offset;
    int count = 0;
    if (excess0 <= 0f) {
      vOut[count++].set(vIn[0]);
    }
    if (excess1 <= 0f) {
      vOut[count++].set(vIn[1]);
    }
    if ((excess0 < 0f && excess1 > 0f) || (excess0 > 0f && excess1 < 0f)) {
      float fraction = excess0 / (excess0 - excess1);
      ClipVertex cut = vOut[count++];
      cut.v.set(start.x + fraction * (end.x - start.x), start.y + fraction * (end.y - start.y));
      cut.id.indexA = (byte) vertexIndexA;
      cut.id.indexB = vIn[0].id.indexB;
      cut.id.typeA = VERTEX;
      cut.id.typeB = FACE;
    }
    return count;
  }

  /**
   * Separation of face {@code edge1} of the first polygon from the second one, in metres: the least
   * height of a vertex above the face.
   */
  public final float edgeSeparation(
      PolygonShape poly1, Transform xf1, int edge1, PolygonShape poly2, Transform xf2) {
    float c = relativeCos(xf1.q, xf2.q);
    float s = relativeSin(xf1.q, xf2.q);
    return FaceQuery.measure(
        poly1.m_normals[edge1],
        poly1.m_vertices[edge1],
        poly2.m_vertices,
        poly2.m_count,
        c,
        s,
        relativeX(xf1, xf2),
        relativeY(xf1, xf2));
  }

  /** Finds the face of the first polygon that separates it best from the second one. */
  public final void findMaxSeparation(
      EdgeResults results, PolygonShape poly1, Transform xf1, PolygonShape poly2, Transform xf2) {
    query.run(
        poly1,
        poly2,
        relativeCos(xf1.q, xf2.q),
        relativeSin(xf1.q, xf2.q),
        relativeX(xf1, xf2),
        relativeY(xf1, xf2),
        Float.POSITIVE_INFINITY);
    results.separation = query.separation;
    results.edgeIndex = query.face;
  }

  /**
   * Finds the face of the second polygon that looks most against face {@code edge1} of the first.
   *
   * @param c receives its two ends in world coordinates
   */
  public final void findIncidentEdge(
      ClipVertex[] c,
      PolygonShape poly1,
      Transform xf1,
      int edge1,
      PolygonShape poly2,
      Transform xf2) {
    Vec2 normal = poly1.m_normals[edge1];
    float cos = relativeCos(xf1.q, xf2.q);
    float sin = relativeSin(xf1.q, xf2.q);
    int face =
        FaceQuery.incidentFace(
            poly2, cos * normal.x + sin * normal.y, cos * normal.y - sin * normal.x);
    for (int i = 0; i < 2; i++) {
      int vertex = face + i < poly2.m_count ? face + i : 0;
      Transform.mulToOut(xf2, poly2.m_vertices[vertex], c[i].v);
      c[i].id.indexA = (byte) edge1;
      c[i].id.indexB = (byte) vertex;
      c[i].id.typeA = FACE;
      c[i].id.typeB = VERTEX;
    }
  }

  private static float relativeCos(Rot q1, Rot q2) {
    return q1.c * q2.c + q1.s * q2.s;
  }

  private static float relativeSin(Rot q1, Rot q2) {
    return q1.c * q2.s - q1.s * q2.c;
  }

  private static float relativeX(Transform xf1, Transform xf2) {
    return xf1.q.c * (xf2.p.x - xf1.p.x) + xf1.q.s * (xf2.p.y - xf1.p.y);
  }

  private static float relativeY(Transform xf1, Transform xf2) {
    return xf1.q.c * (xf2.p.y - xf1.p.y) - xf1.q.s * (xf2.p.x - xf1.p.x);
  }

  /** An end of a segment that is being cut, and the features it stands for. */
  public static class ClipVertex {

    public final Vec2 v = new Vec2();
    public final ContactID id = new ContactID();

    public ClipVertex() {}

    /** Copies {@code cv}. */
    public void set(ClipVertex cv) {
      v.set(cv.v);
      id.set(cv.id);
    }
  }

  /** What has become of a contact point between two manifolds. */
  public enum PointState {
    /** There is no such point. */
    NULL_STATE,
    /** The point is new. */
    ADD_STATE,
    /** The point was there before, and still is. */
    PERSIST_STATE,
    /** The point is gone. */
    REMOVE_STATE
  }

  /** Result of {@link #findMaxSeparation}. */
  public static class EdgeResults {

    /** In metres; negative: penetration. */
    public float separation;

    public int edgeIndex;

    public EdgeResults() {}
  }
}
