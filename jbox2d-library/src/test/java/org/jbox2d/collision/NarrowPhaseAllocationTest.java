package org.jbox2d.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Random;
import org.jbox2d.collision.TimeOfImpact.TOIInput;
import org.jbox2d.collision.TimeOfImpact.TOIOutput;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.EdgeShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;
import org.junit.jupiter.api.Test;

/** Warm calls allocate nothing, and the same calls give the same bits. */
class NarrowPhaseAllocationTest {

  private static final int PAIRS = 200;

  /** Calls that may still load classes and grow scratch memory. */
  private static final int WARM_UP = 3;

  private final PolygonShape[] polygons = new PolygonShape[PAIRS];
  private final Transform[] transforms = new Transform[PAIRS];
  private final CircleShape circle = new CircleShape();
  private final EdgeShape edge = new EdgeShape();

  NarrowPhaseAllocationTest() {
    Random random = new Random(41);
    for (int i = 0; i < PAIRS; i++) {
      polygons[i] = ConvexOracle.randomPolygon(random, 1f);
      transforms[i] =
          ConvexOracle.at(
              2.0 * random.nextDouble(), 2.0 * random.nextDouble(), ConvexOracle.angle(random));
    }
    circle.m_radius = 0.5f;
    edge.set(new Vec2(-1f, 0f), new Vec2(1f, 0.5f));
  }

  @Test
  void warmCallsAllocateNothing() {
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    long thread = Thread.currentThread().getId();
    Run run = new Run();
    for (int i = 0; i < WARM_UP; i++) {
      run.all();
    }
    long before = threads.getThreadAllocatedBytes(thread);
    long empty = threads.getThreadAllocatedBytes(thread) - before;
    before = threads.getThreadAllocatedBytes(thread);
    run.all();
    assertEquals(empty, threads.getThreadAllocatedBytes(thread) - before);
  }

  @Test
  void sameCallsGiveTheSameBits() {
    Run first = new Run();
    first.all();
    Run second = new Run();
    // Scratch memory of earlier calls must not show.
    second.all();
    second.hash = 0L;
    second.all();
    assertEquals(first.hash, second.hash);
    assertTrue(first.points > PAIRS, "points " + first.points);
  }

  /** One of each call for each pair, hashed. */
  private final class Run {
    private final Collision collision = new Collision();
    private final Manifold manifold = new Manifold();
    private final TimeOfImpact toi = new TimeOfImpact();
    private final TOIInput input = new TOIInput();
    private final TOIOutput output = new TOIOutput();
    private long hash;
    private int points;

    void all() {
      for (int i = 0; i + 1 < PAIRS; i++) {
        PolygonShape a = polygons[i];
        PolygonShape b = polygons[i + 1];
        Transform xfA = transforms[i];
        Transform xfB = transforms[i + 1];
        collision.collidePolygons(manifold, a, xfA, b, xfB);
        mixManifold();
        collision.collidePolygonAndCircle(manifold, a, xfA, circle, xfB);
        mixManifold();
        collision.collideCircles(manifold, circle, xfA, circle, xfB);
        mixManifold();
        collision.collideEdgeAndCircle(manifold, edge, xfA, circle, xfB);
        mixManifold();
        collision.collideEdgeAndPolygon(manifold, edge, xfA, b, xfB);
        mixManifold();
        mix(collision.testOverlap(a, 0, b, 0, xfA, xfB) ? 1 : 0);
        input.proxyA.set(a, 0);
        input.proxyB.set(b, 0);
        input.sweepA.c0.set(xfA.p);
        input.sweepA.c.set(xfB.p);
        input.sweepB.c0.set(xfB.p.x + 3f, xfB.p.y);
        input.sweepB.c.set(xfA.p);
        input.sweepB.a = 2f;
        input.tMax = 1f;
        toi.timeOfImpact(output, input);
        mix(Float.floatToRawIntBits(output.t));
        mix(output.state.ordinal());
      }
    }

    private void mixManifold() {
      points += manifold.pointCount;
      mix(manifold.pointCount);
      for (int i = 0; i < manifold.pointCount; i++) {
        mix(Float.floatToRawIntBits(manifold.localNormal.x));
        mix(Float.floatToRawIntBits(manifold.localPoint.y));
        mix(Float.floatToRawIntBits(manifold.points[i].localPoint.x));
        mix(manifold.points[i].id.getKey());
      }
    }

    private void mix(int value) {
      hash = hash * 0x9E3779B97F4A7C15L + value;
    }
  }
}
