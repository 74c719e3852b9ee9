package org.jbox2d.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.jbox2d.collision.TimeOfImpact.TOIInput;
import org.jbox2d.collision.TimeOfImpact.TOIOutput;
import org.jbox2d.collision.TimeOfImpact.TOIOutputState;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Sweep;
import org.jbox2d.common.Transform;
import org.junit.jupiter.api.Test;

/** Times of contact of moving shapes. */
class TimeOfImpactTest {

  private final TimeOfImpact toi = new TimeOfImpact();
  private final TOIInput input = new TOIInput();
  private final TOIOutput output = new TOIOutput();

  @Test
  void discsHitThinWallsAtAnySpeed() {
    float[] radii = {0.05f, 0.1f, 0.2f, 0.5f};
    float[] speeds = {10f, 30f, 100f, 300f, 1000f, 2000f};
    float[] walls = {0.01f, 0.02f, 0.05f, 0.1f, 0.2f};
    for (float radius : radii) {
      for (float speed : speeds) {
        for (float wall : walls) {
          CircleShape disc = new CircleShape();
          disc.m_radius = radius;
          PolygonShape box = new PolygonShape();
          box.setAsBox(0.5f * wall, 5f);
          float way = speed / 60f;
          input.proxyA.set(box, 0);
          input.proxyB.set(disc, 0);
          input.sweepA.a0 = 0f;
          input.sweepA.a = 0f;
          input.sweepB.c0.set(-radius - wall - 0.4f * way, 0.1f);
          input.sweepB.c.set(input.sweepB.c0.x + way, 0.1f);
          input.tMax = 1f;
          toi.timeOfImpact(output, input);
          String what = "radius " + radius + ", speed " + speed + ", wall " + wall;
          float reach = -0.5f * wall - radius - box.m_radius + 3f * Settings.linearSlop;
          if (input.sweepB.c.x < reach) {
            assertEquals(TOIOutputState.SEPARATED, output.state, what);
          } else {
            assertEquals(TOIOutputState.TOUCHING, output.state, what);
            float expected = (reach - input.sweepB.c0.x) / way;
            assertEquals(expected, output.t, 0.3f * Settings.linearSlop / way + 1e-6f, what);
          }
        }
      }
    }
  }

  /**
   * Follows both sweeps in fine steps, and compares: no overlap of the skins before the reported
   * time, and at that time the distance is in the band above the target.
   */
  @Property(tries = 1500, seed = "31")
  void neverLaterThanTheFirstContact(@ForAll long seed) {
    Random random = new Random(seed);
    float sizeA = ConvexOracle.randomSize(random);
    float sizeB = ConvexOracle.randomSize(random);
    input.proxyA.set(ConvexOracle.randomPolygon(random, sizeA), 0);
    if (random.nextInt(3) == 0) {
      input.proxyB.m_count = 1;
      input.proxyB.m_vertices[0].set(0.1f * sizeB, 0f);
      input.proxyB.m_radius = 0.5f * sizeB;
    } else {
      input.proxyB.set(ConvexOracle.randomPolygon(random, sizeB), 0);
    }
    double size = sizeA + sizeB;
    sweep(input.sweepA, random, 0.5 * size, size);
    sweep(input.sweepB, random, 2.5 * size, 5.0 * size);
    Sweep copyA = new Sweep().set(input.sweepA);
    Sweep copyB = new Sweep().set(input.sweepB);
    input.tMax = random.nextBoolean() ? 1f : random.nextFloat();
    toi.timeOfImpact(output, input);
    assertEquals(copyA.toString(), input.sweepA.toString());
    assertEquals(copyB.toString(), input.sweepB.toString());

    double radius = input.proxyA.m_radius + input.proxyB.m_radius;
    double slop = Settings.linearSlop;
    double target = Math.max(slop, radius - 3.0 * slop);
    double rounding = 3e-6 * (10.0 * size + 1.0);
    double atEnd = distanceAt(output.t);
    double firstContact = firstContact(input.tMax, target - rounding);
    assertTrue(output.t <= input.tMax);
    switch (output.state) {
      case SEPARATED:
        assertEquals(input.tMax, output.t);
        assertEquals(Double.POSITIVE_INFINITY, firstContact);
        break;
      case TOUCHING:
        assertTrue(atEnd <= target + 0.25 * slop + rounding, atEnd + " above " + target);
        assertTrue(output.t == 0f || atEnd >= target - rounding, atEnd + " below " + target);
        assertTrue(output.t <= firstContact + 1e-6, output.t + " after " + firstContact);
        break;
      case OVERLAPPED:
        assertEquals(0f, output.t);
        assertEquals(0.0, atEnd, rounding);
        break;
      default:
        fail("state " + output.state + " at " + output.t);
    }
  }

  @Test
  void spinningRodDoesNotPassThroughAPost() {
    // Pinned at its middle, 4 m long, up to five turns a step: the post is met from the side.
    PolygonShape rod = new PolygonShape();
    rod.setAsBox(2f, 0.05f);
    CircleShape post = new CircleShape();
    post.m_radius = 0.05f;
    for (int k = 1; k <= 40; k++) {
      input.proxyA.set(rod, 0);
      input.proxyB.set(post, 0);
      input.sweepA.c0.set(7f, 7f);
      input.sweepA.c.set(7f, 7f);
      input.sweepA.a0 = 0f;
      input.sweepA.a = 0.25f * (float) Math.PI * k;
      // At 22.5 degrees on a radius of 1.8 m.
      float x = 7f + 1.8f * (float) StrictMath.cos(Math.PI / 8);
      float y = 7f + 1.8f * (float) StrictMath.sin(Math.PI / 8);
      input.sweepB.c0.set(x, y);
      input.sweepB.c.set(x, y);
      input.tMax = 1f;
      toi.timeOfImpact(output, input);
      assertEquals(TOIOutputState.TOUCHING, output.state, "turns " + k / 8.0);
      double target = 0.05 + Settings.polygonRadius - 3.0 * Settings.linearSlop;
      // Height 1.8 sin(angle) above the rod's face is the target.
      double angle = Math.PI / 8 - StrictMath.asin((0.05 + target) / 1.8);
      double reached = output.t * input.sweepA.a;
      assertTrue(reached <= angle + 1e-5, reached + " after " + angle);
      assertEquals(angle, reached, 0.3 * Settings.linearSlop / 1.8);
    }
  }

  @Test
  void numbersThatAreNoneFail() {
    CircleShape disc = new CircleShape();
    disc.m_radius = 1f;
    input.proxyA.set(disc, 0);
    input.proxyB.set(disc, 0);
    input.sweepB.c0.set(10f, 0f);
    input.sweepB.c.set(Float.NaN, 0f);
    input.tMax = 1f;
    toi.timeOfImpact(output, input);
    assertEquals(TOIOutputState.FAILED, output.state);
    assertEquals(0f, output.t);
    input.sweepB.c.set(0f, 0f);
    input.tMax = Float.NaN;
    toi.timeOfImpact(output, input);
    assertEquals(TOIOutputState.FAILED, output.state);
  }

  private static void sweep(Sweep sweep, Random random, double spread, double way) {
    double to = ConvexOracle.angle(random);
    double from = ConvexOracle.angle(random);
    sweep.localCenter.set(0.1f * (float) spread * random.nextFloat(), 0f);
    sweep.c0.set((float) (spread * StrictMath.cos(from)), (float) (spread * StrictMath.sin(from)));
    double length = way * random.nextDouble();
    sweep.c.set(
        sweep.c0.x - (float) (length * StrictMath.cos(from + 0.1 * to)),
        sweep.c0.y - (float) (length * StrictMath.sin(from + 0.1 * to)));
    sweep.a0 = (float) to;
    int kind = random.nextInt(3);
    sweep.a = sweep.a0 + (kind == 0 ? 0f : (kind == 1 ? 1f : 6f) * (float) random.nextGaussian());
  }

  private double distanceAt(double t) {
    Transform xfA = new Transform();
    Transform xfB = new Transform();
    input.sweepA.getTransform(xfA, (float) t);
    input.sweepB.getTransform(xfB, (float) t);
    return ConvexOracle.distance(
        ConvexOracle.corners(input.proxyA, xfA), ConvexOracle.corners(input.proxyB, xfB));
  }

  /** The first of 400 even steps at which the distance is below the threshold. */
  private double firstContact(double end, double threshold) {
    int steps = 400;
    for (int i = 0; i <= steps; i++) {
      double t = end * i / steps;
      if (distanceAt(t) < threshold) {
        return t;
      }
    }
    return Double.POSITIVE_INFINITY;
  }
}
