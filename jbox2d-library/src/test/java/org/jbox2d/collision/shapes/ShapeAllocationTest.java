package org.jbox2d.collision.shapes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import org.jbox2d.collision.AABB;
import org.jbox2d.collision.Manifold;
import org.jbox2d.collision.Manifold.ManifoldType;
import org.jbox2d.collision.RayCastInput;
import org.jbox2d.collision.RayCastOutput;
import org.jbox2d.collision.WorldManifold;
import org.jbox2d.common.Sweep;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;
import org.junit.jupiter.api.Test;

/** What a step or a query calls of the shapes and value types allocates nothing. */
class ShapeAllocationTest {

  private final ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
  private final CircleShape circle = new CircleShape();
  private final PolygonShape polygon = ShapeMassTest.polygon(6, 0.2f, 1, 0);
  private final EdgeShape edge = new EdgeShape();
  private final ChainShape chain = new ChainShape();
  private final Shape[] shapes = {circle, polygon, edge, chain};
  private final Transform xf = new Transform();
  private final Sweep sweep = new Sweep();
  private final AABB box = new AABB();
  private final MassData mass = new MassData();
  private final RayCastInput input = new RayCastInput();
  private final RayCastOutput output = new RayCastOutput();
  private final Vec2 out = new Vec2();
  private final Manifold manifold = new Manifold();
  private final WorldManifold worldManifold = new WorldManifold();
  private int hits;

  @Test
  void warmCallsAllocateNothing() {
    circle.m_radius = 1;
    edge.set(new Vec2(-1, 0), new Vec2(1, 0.5f));
    chain.createLoop(new Vec2[] {new Vec2(-2, -1), new Vec2(2, -1), new Vec2(0, 2)}, 3);
    input.p1.set(-5, 0.1f);
    input.p2.set(5, 0.2f);
    input.maxFraction = 1;
    manifold.pointCount = 2;
    calls(500);
    long fewest = Long.MAX_VALUE;
    for (int round = 0; round < 5; round++) {
      long before = threads.getCurrentThreadAllocatedBytes();
      calls(50);
      fewest = Math.min(fewest, threads.getCurrentThreadAllocatedBytes() - before);
    }
    assertEquals(0, fewest, "bytes in 50 warm rounds");
    assertTrue(hits > 0);
  }

  private void calls(int rounds) {
    for (int i = 0; i < rounds; i++) {
      sweep.a = 0.01f * i;
      sweep.getTransform(xf, 0.5f);
      for (Shape shape : shapes) {
        for (int child = 0; child < shape.getChildCount(); child++) {
          shape.computeAABB(box, xf, child);
          shape.computeDistanceToOut(xf, input.p1, child, out);
          hits += shape.raycast(output, input, xf, child) ? 1 : 0;
          hits += box.raycast(output, input) ? 1 : 0;
        }
        shape.computeMass(mass, 1);
        hits += shape.testPoint(xf, out) ? 1 : 0;
      }
      chain.getChildEdge(edge, i % 3);
      manifold.type = i % 2 == 0 ? ManifoldType.FACE_A : ManifoldType.CIRCLES;
      worldManifold.initialize(manifold, xf, 0.1f, xf, 0.2f);
      hits += xf.q.getAngle() > 0 ? 1 : 0;
    }
  }
}
