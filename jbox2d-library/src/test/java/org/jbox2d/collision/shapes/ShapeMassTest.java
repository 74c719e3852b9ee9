package org.jbox2d.collision.shapes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.FloatRange;
import net.jqwik.api.constraints.IntRange;
import org.jbox2d.common.MathUtils;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;
import org.junit.jupiter.api.Test;

class ShapeMassTest {

  @Test
  void boxesHaveTheTextbookMoment() {
    PolygonShape box = new PolygonShape();
    box.setAsBox(2, 1);
    MassData data = new MassData();
    box.computeMass(data, 3);
    assertEquals(24f, data.mass);
    assertEquals(24f * (16 + 4) / 12, data.I, 1e-5f);
    assertEquals(new Vec2(), data.center);
  }

  @Test
  void circlesHaveTheTextbookMoment() {
    CircleShape circle = new CircleShape();
    circle.m_p.set(3, 4);
    circle.setRadius(2);
    MassData data = new MassData();
    circle.computeMass(data, 0.5f);
    double mass = 2 * Math.PI;
    assertEquals(mass, data.mass, 1e-6);
    assertEquals(mass * (2 + 25), data.I, 1e-4);
    assertEquals(new Vec2(3, 4), data.center);
  }

  @Test
  void linesHaveNoMass() {
    EdgeShape edge = new EdgeShape();
    edge.set(new Vec2(1, 2), new Vec2(3, 6));
    ChainShape chain = new ChainShape();
    chain.createChain(new Vec2[] {new Vec2(1, 2), new Vec2(3, 6)}, 2);
    MassData data = new MassData();
    edge.computeMass(data, 3);
    assertEquals(0f, data.mass + data.I);
    assertEquals(new Vec2(2, 4), data.center);
    chain.computeMass(data, 3);
    assertEquals(0f, data.mass + data.I);
    assertEquals(new Vec2(), data.center);
  }

  @Test
  void massDataIsCopied() {
    MassData data = new MassData();
    data.mass = 1;
    data.I = 2;
    data.center.set(3, 4);
    MassData copy = data.clone();
    data.center.set(9, 9);
    assertEquals(1f, copy.mass);
    assertEquals(2f, copy.I);
    assertEquals(new Vec2(3, 4), new MassData(copy).center);
  }

  /** Against thin slices, each summed by the exact moments of a trapezium's mid line in double. */
  @Property(tries = 60, seed = "61")
  void polygonsAgreeWithTheSumOfTheirSlices(
      @ForAll @IntRange(min = 3, max = 8) int n,
      @ForAll @FloatRange(min = 0, max = 1) float phase,
      @ForAll @FloatRange(min = 0.2f, max = 3) float flatness,
      @ForAll @FloatRange(min = -20, max = 20) float offset) {
    PolygonShape shape = polygon(n, phase, flatness, offset);
    MassData data = new MassData();
    shape.computeMass(data, 2);

    double[] sums = sliced(shape, 4000);
    double area = sums[0];
    assertEquals(2 * area, data.mass, 1e-5 * data.mass);
    assertEquals(sums[1] / area, data.center.x, 1e-4);
    assertEquals(sums[2] / area, data.center.y, 1e-4);
    assertEquals(2 * sums[3], data.I, 2e-5 * data.I);
    assertEquals(0f, data.center.sub(shape.m_centroid).length(), 1e-6f * (1 + Math.abs(offset)));
  }

  /**
   * Far from the origin nothing cancels: the moment about the centre stays that of the same polygon
   * at home.
   */
  @Test
  void farPolygonsKeepMassAndCentre() {
    PolygonShape home = new PolygonShape();
    home.setAsBox(0.5f, 0.25f);
    PolygonShape far = new PolygonShape();
    far.setAsBox(0.5f, 0.25f, new Vec2(65536, -32768), 0);
    MassData data = new MassData();
    far.computeMass(data, 1);
    assertEquals(0.5f, data.mass);
    assertEquals(new Vec2(65536, -32768), data.center);
    Vec2 centroid = new Vec2();
    far.computeCentroidToOut(far.m_vertices, 4, centroid);
    assertEquals(new Vec2(65536, -32768), centroid);
  }

  @Test
  void theCentroidMovesWithTheTransform() {
    PolygonShape shape = polygon(5, 0.3f, 1, 2);
    Transform xf = new Transform();
    xf.set(new Vec2(3, 4), 1f);
    Vec2 out = new Vec2();
    assertEquals(Transform.mul(xf, shape.m_centroid), shape.centroid(xf));
    assertEquals(shape.centroid(xf), shape.centroidToOut(xf, out));
  }

  @Test
  void polygonsWithoutAreaWrittenByHandHaveNoMass() {
    PolygonShape shape = new PolygonShape();
    shape.m_count = 3;
    shape.m_vertices[1].set(1, 1);
    shape.m_vertices[2].set(2, 2);
    MassData data = new MassData();
    shape.computeMass(data, 1);
    assertEquals(0f, data.mass + data.I);
    shape.computeCentroidToOut(shape.m_vertices, 3, shape.m_centroid);
    assertEquals(new Vec2(1, 1), shape.m_centroid);
  }

  static PolygonShape polygon(int n, float phase, float flatness, float offset) {
    Vec2[] points = new Vec2[n];
    for (int i = 0; i < n; i++) {
      float angle = (i + phase) * MathUtils.TWOPI / n;
      points[i] =
          new Vec2(
              2 * MathUtils.cos(angle) + offset, flatness * MathUtils.sin(angle) - 0.5f * offset);
    }
    PolygonShape shape = new PolygonShape();
    shape.set(points, n);
    return shape;
  }

  /**
   * Area, moments of x and y, and the second moment about the origin, by vertical strips and the
   * midpoint rule.
   */
  private static double[] sliced(PolygonShape shape, int slices) {
    double minX = Double.POSITIVE_INFINITY;
    double maxX = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < shape.m_count; i++) {
      minX = Math.min(minX, shape.m_vertices[i].x);
      maxX = Math.max(maxX, shape.m_vertices[i].x);
    }
    double width = (maxX - minX) / slices;
    double[] sums = new double[4];
    for (int k = 0; k < slices; k++) {
      double x = minX + (k + 0.5) * width;
      double low = Double.POSITIVE_INFINITY;
      double high = Double.NEGATIVE_INFINITY;
      for (int i = 0; i < shape.m_count; i++) {
        Vec2 a = shape.m_vertices[i];
        Vec2 b = shape.m_vertices[(i + 1) % shape.m_count];
        if (x >= Math.min(a.x, b.x) && x <= Math.max(a.x, b.x) && a.x != b.x) {
          double y = a.y + (x - a.x) / ((double) b.x - a.x) * ((double) b.y - a.y);
          low = Math.min(low, y);
          high = Math.max(high, y);
        }
      }
      assertTrue(low <= high);
      double area = width * (high - low);
      sums[0] += area;
      sums[1] += area * x;
      sums[2] += area * 0.5 * (low + high);
      sums[3] += area * x * x + width * (high * high * high - low * low * low) / 3;
    }
    return sums;
  }
}
