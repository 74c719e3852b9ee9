package org.jbox2d.testbed.simulation;

import java.util.Arrays;
import org.jbox2d.collision.shapes.ChainShape;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.EdgeShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.Fixture;

/**
 * What a body looks like, in its own frame, as immutable flat arrays.
 *
 * <p>Vertex i of part p is {@code (x[i], y[i])} with {@code start[p] <= i < start[p + 1]}. A
 * polygon's edge i runs to the next vertex of its part; it is {@code inner} if another part of the
 * body has it too. A part of one vertex is a circle about it with {@code radius[p]}; a part of two
 * is a line.
 */
public final class BodyOutline {
  /**
   * How far apart, relative to the body's extent, vertices of two parts may be that are one: they
   * were made from the same floats, so a few roundings.
   */
  private static final float SAME_VERTEX = 1e-6f;

  /** A number of its own for each body of a run, in order of appearance. */
  public final int id;

  /** Static, kinematic or dynamic. */
  public final BodyType type;

  /** Simple name of the class of the first fixture's material, or the empty string. */
  public final String material;

  /** Bounds of the parts in the arrays below; one more than there are parts. */
  final int[] start;

  /** See the class. */
  final float[] radius;

  /** See the class. */
  final float[] x;

  /** See the class. */
  final float[] y;

  /** See the class. */
  final boolean[] inner;

  private final float reach;
  private final Fixture first;
  private final int fixtureCount;

  BodyOutline(int id, Body body) {
    this.id = id;
    type = body.getType();
    first = body.getFixtureList();
    fixtureCount = body.m_fixtureCount;
    material =
        first == null || first.getMaterial() == null
            ? ""
            : first.getMaterial().getClass().getSimpleName();
    Collector collector = new Collector();
    for (Fixture f = first; f != null; f = f.getNext()) {
      collector.add(f.getShape());
    }
    start = Arrays.copyOf(collector.start, collector.parts + 1);
    radius = Arrays.copyOf(collector.radius, collector.parts);
    x = Arrays.copyOf(collector.x, collector.vertices);
    y = Arrays.copyOf(collector.y, collector.vertices);
    inner = new boolean[collector.vertices];
    reach = farthest();
    if (collector.parts > 1) {
      findInnerEdges();
    }
  }

  /** Returns whether a body still looks like this. */
  boolean isOf(Body body) {
    return first == body.getFixtureList()
        && fixtureCount == body.m_fixtureCount
        && type == body.getType();
  }

  private float farthest() {
    float most = 0f;
    for (int p = 0; p < radius.length; p++) {
      for (int i = start[p]; i < start[p + 1]; i++) {
        most = Math.max(most, (float) Math.sqrt(x[i] * x[i] + y[i] * y[i]) + radius[p]);
      }
    }
    return most;
  }

  /** Returns how far from its origin it reaches at most, m. */
  public float reach() {
    return reach;
  }

  /** Returns whether it is a convex polygon and nothing else. */
  public boolean isOnePolygon() {
    return radius.length == 1 && start[1] > 2;
  }

  /** Returns the number of parts. */
  public int partCount() {
    return radius.length;
  }

  /** Returns the index of the first vertex of a part; that of {@code partCount()} ends the last. */
  public int start(int part) {
    return start[part];
  }

  /** Returns the radius of a circle, m. */
  public float radius(int part) {
    return radius[part];
  }

  /** Returns a vertex' local coordinate, m. */
  public float x(int vertex) {
    return x[vertex];
  }

  /** Returns a vertex' local coordinate, m. */
  public float y(int vertex) {
    return y[vertex];
  }

  /** Returns whether the edge from a vertex to the next of its part lies inside the body. */
  public boolean isInner(int vertex) {
    return inner[vertex];
  }

  private void findInnerEdges() {
    float extent = 0f;
    for (int i = 0; i < x.length; i++) {
      extent = Math.max(extent, Math.max(Math.abs(x[i]), Math.abs(y[i])));
    }
    float same = SAME_VERTEX * extent;
    for (int p = 0; p < partCount(); p++) {
      for (int i = start[p]; i < start[p + 1]; i++) {
        inner[i] = inner[i] || findTwin(p, i, same);
      }
    }
  }

  /** Looks for the edge in the parts that follow; both orientations are counter-clockwise. */
  private boolean findTwin(int part, int i, float same) {
    int next = following(part, i);
    for (int p = part + 1; p < partCount(); p++) {
      for (int j = start[p]; j < start[p + 1]; j++) {
        if (near(i, following(p, j), same) && near(next, j, same)) {
          inner[j] = true;
          return true;
        }
      }
    }
    return false;
  }

  private int following(int part, int i) {
    return i + 1 < start[part + 1] ? i + 1 : start[part];
  }

  private boolean near(int i, int j, float same) {
    return Math.abs(x[i] - x[j]) <= same && Math.abs(y[i] - y[j]) <= same;
  }

  /** Gathers parts in growing arrays. */
  private static final class Collector {
    int[] start = new int[8];
    float[] radius = new float[8];
    float[] x = new float[32];
    float[] y = new float[32];
    int parts;
    int vertices;

    void add(Shape shape) {
      if (shape instanceof CircleShape circle) {
        vertex(circle.m_p);
        endPart(circle.m_radius);
      } else if (shape instanceof PolygonShape polygon) {
        for (int i = 0; i < polygon.getVertexCount(); i++) {
          vertex(polygon.getVertex(i));
        }
        endPart(0f);
      } else if (shape instanceof EdgeShape edge) {
        vertex(edge.m_vertex1);
        vertex(edge.m_vertex2);
        endPart(0f);
      } else if (shape instanceof ChainShape chain) {
        for (int i = 0; i + 1 < chain.m_count; i++) {
          vertex(chain.m_vertices[i]);
          vertex(chain.m_vertices[i + 1]);
          endPart(0f);
        }
      }
    }

    private void vertex(Vec2 v) {
      if (vertices == x.length) {
        x = Arrays.copyOf(x, 2 * vertices);
        y = Arrays.copyOf(y, 2 * vertices);
      }
      x[vertices] = v.x;
      y[vertices] = v.y;
      vertices++;
    }

    private void endPart(float r) {
      if (parts + 2 > start.length) {
        start = Arrays.copyOf(start, 2 * start.length);
        radius = Arrays.copyOf(radius, 2 * start.length);
      }
      radius[parts] = r;
      parts++;
      start[parts] = vertices;
    }
  }
}
