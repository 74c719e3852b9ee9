package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import org.jbox2d.callbacks.RayCastCallback;
import org.jbox2d.common.MathUtils;
import org.jbox2d.common.Vec2;
import org.junit.jupiter.api.Test;

/** Rays cast into a world; those cast into single shapes are tested with the shapes. */
class RayCastTest {
  private static final int RAYS = 200;

  /** Rounding of a hit's coordinates, m. */
  private static final float ROUNDING = 1e-5f;

  private final World world = Make.weightless();

  @Test
  void tellsWhereAndHowAFixtureIsMet() {
    Body box = Make.box(world, BodyType.STATIC, 5f, 1f, 1f, 2f);
    List<Hit> hits = cast(new Vec2(0f, 0f), new Vec2(8f, 0f));
    assertEquals(1, hits.size());
    Hit hit = hits.get(0);
    assertEquals(box.getFixtureList(), hit.fixture());
    assertEquals(4f, hit.point().x, ROUNDING);
    assertEquals(0f, hit.point().y, ROUNDING);
    assertEquals(new Vec2(-1f, 0f), hit.normal());
    assertEquals(0.5f, hit.fraction(), ROUNDING);
  }

  @Test
  void callbackEndsCutsOrIgnores() {
    for (int i = 1; i <= 5; i++) {
      Make.disc(world, 2f * i, 0f, 0.5f);
    }
    Vec2 from = new Vec2();
    Vec2 to = new Vec2(20f, 0f);
    assertEquals(5, countWhileReturning(1f, from, to));
    assertEquals(5, countWhileReturning(-1f, from, to));
    assertEquals(1, countWhileReturning(0f, from, to));

    float[] nearest = {2f};
    world.raycast(
        (fixture, point, normal, fraction) -> {
          nearest[0] = Math.min(nearest[0], fraction);
          return fraction;
        },
        from,
        to);
    assertEquals(1.5f / 20f, nearest[0], ROUNDING);
  }

  /** The outer cast goes on where it was, with its own point and normal. */
  @Test
  void callbackMayCastFurtherRays() {
    for (int i = 1; i <= 3; i++) {
      Make.box(world, BodyType.STATIC, 2f * i, 0f, 0.5f, 0.5f);
    }
    List<Integer> inner = new ArrayList<>();
    List<Float> outer = new ArrayList<>();
    world.raycast(
        (fixture, point, normal, fraction) -> {
          inner.add(cast(new Vec2(20f, 0.1f), new Vec2(fixture.getBody().getPosition())).size());
          outer.add(point.x);
          assertEquals(new Vec2(-1f, 0f), normal);
          return 1f;
        },
        new Vec2(),
        new Vec2(20f, 0f));
    outer.sort(null);
    inner.sort(null);
    assertEquals(List.of(1.5f, 3.5f, 5.5f), rounded(outer));
    assertEquals(List.of(1, 2, 3), inner);
  }

  @Test
  void castIsOverWhenACallbackThrows() {
    Make.disc(world, 2f, 0f, 0.5f);
    RayCastCallback angry =
        (fixture, point, normal, fraction) -> {
          throw new UnsupportedOperationException("as the test wants it");
        };
    Vec2 to = new Vec2(20f, 0f);
    assertThrows(UnsupportedOperationException.class, () -> world.raycast(angry, new Vec2(), to));
    assertEquals(1, cast(new Vec2(), to).size());
  }

  @Test
  void warmCastsAllocateNothing() {
    World debris = Make.debris(60, 3);
    Make.steps(debris, 30);
    int[] heard = new int[1];
    RayCastCallback nearest =
        (fixture, point, normal, fraction) -> {
          heard[0]++;
          return fraction;
        };
    Vec2 from = new Vec2(0f, 5f);
    Vec2 to = new Vec2();
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    long fewest = Long.MAX_VALUE;
    for (int round = 0; round < 10; round++) {
      long before = threads.getCurrentThreadAllocatedBytes();
      for (int i = 0; i < RAYS; i++) {
        float angle = MathUtils.TWOPI * i / RAYS;
        to.set(40f * MathUtils.cos(angle), 40f * MathUtils.sin(angle));
        debris.raycast(nearest, from, to);
      }
      fewest = Math.min(fewest, threads.getCurrentThreadAllocatedBytes() - before);
    }
    assertEquals(0, fewest, "bytes in " + RAYS + " rays");
    assertTrue(heard[0] > RAYS, heard[0] + " hits");
  }

  private List<Hit> cast(Vec2 from, Vec2 to) {
    List<Hit> hits = new ArrayList<>();
    world.raycast(
        (fixture, point, normal, fraction) -> {
          hits.add(new Hit(fixture, point.clone(), normal.clone(), fraction));
          return 1f;
        },
        from,
        to);
    return hits;
  }

  private int countWhileReturning(float answer, Vec2 from, Vec2 to) {
    int[] count = new int[1];
    world.raycast(
        (fixture, point, normal, fraction) -> {
          count[0]++;
          return answer;
        },
        from,
        to);
    return count[0];
  }

  private static List<Float> rounded(List<Float> values) {
    List<Float> rounded = new ArrayList<>();
    for (float value : values) {
      rounded.add(Math.round(1000f * value) / 1000f);
    }
    return rounded;
  }

  private record Hit(Fixture fixture, Vec2 point, Vec2 normal, float fraction) {}
}
