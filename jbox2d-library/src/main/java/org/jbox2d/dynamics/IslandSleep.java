package org.jbox2d.dynamics;

import java.util.Arrays;
import org.jbox2d.common.Settings;

/**
 * Puts islands to sleep that have come to rest, by either of two signs.
 *
 * <p><b>Calm</b>, as in JBox2D: all bodies have been slow for {@link Settings#timeToSleep}, and the
 * last step ended with all positions within tolerance.
 *
 * <p><b>Still</b>: no dynamic body has gone further, in a span of time, than slow bodies go.
 * Velocities tell less in a pile: a splinter that is wedged between two heavy pieces is pushed one
 * way and pressed back in each step, and its velocity, measured between the two, is above the
 * tolerance for ever; it goes nowhere. Nor can its overlap be resolved, so that the island is never
 * within tolerance. What is driven, a kinematic body, counts as still while it is slow.
 *
 * <p>The span S is chosen so that, but for what trembles on the spot, the two signs agree. A body
 * of steady speed is either slow or not. One that turns back with an acceleration a is calm for a
 * time T about its turning point if {@code a <= 2 v / T}. It is still if in a span it goes by no
 * more than {@code v S} towards that point, back, and by as much beyond where it began: {@code S =
 * sqrt(2 v S / a) + sqrt(4 v S / a)}, hence {@code a <= 11.7 v / S}. With S = 4 T that is {@code
 * 2.9 v / T}.
 */
final class IslandSleep {
  /** A span, in times of {@link Settings#timeToSleep}. */
  private static final float SPAN = 4f;

  /**
   * Share of the way of other bodies that one with joints may go: motors and springs tremble for a
   * purpose, unless by less than {@link Settings#linearSlop}, which no one sees.
   */
  private static final float JOINTED_SHARE = 0.25f;

  private float[] calm = new float[64];
  private float[] still = new float[64];

  /**
   * Looks at the awake bodies after a step.
   *
   * @param settled of each island, whether its positions are within tolerance
   * @param n how many bodies were solved; those that listeners have woken since lie behind them,
   *     have no island and are awake anyway
   * @param dt length of the step, s
   */
  void update(World world, Islands islands, boolean[] settled, int n, float dt) {
    if (calm.length < islands.count) {
      calm = new float[islands.count + (islands.count >> 1)];
      still = new float[calm.length];
    }
    Arrays.fill(calm, 0, islands.count, Float.MAX_VALUE);
    Arrays.fill(still, 0, islands.count, Float.MAX_VALUE);
    Body[] awake = world.awake.bodies;
    for (int i = 0; i < n; i++) {
      Body b = awake[i];
      boolean maySleep = (b.m_flags & Body.e_autoSleepFlag) != 0;
      b.m_sleepTime = maySleep && isSlow(b) ? b.m_sleepTime + dt : 0f;
      b.stillTime = maySleep ? stillTime(b, dt) : 0f;
      int k = islands.islandOf[i];
      calm[k] = Math.min(calm[k], b.m_sleepTime);
      still[k] = Math.min(still[k], b.stillTime);
    }
    float time = Settings.timeToSleep;
    for (int i = n - 1; i >= 0; i--) {
      int k = islands.islandOf[i];
      if ((settled[k] && calm[k] >= time) || still[k] >= SPAN * time) {
        world.awake.fallAsleep(awake[i]);
      }
    }
  }

  private static boolean isSlow(Body b) {
    float v = Settings.linearSleepTolerance;
    return Math.abs(b.m_angularVelocity) <= Settings.angularSleepTolerance
        && b.m_linearVelocity.lengthSquared() <= v * v;
  }

  /**
   * How long a body has been still, s: since when it has never been far from where it was when the
   * current span began.
   */
  private static float stillTime(Body b, float dt) {
    if (b.m_type != BodyType.DYNAMIC) {
      return isSlow(b) ? b.stillTime + dt : 0f;
    }
    float x = b.m_sweep.c.x - b.restX;
    float y = b.m_sweep.c.y - b.restY;
    float angle = Math.abs(b.m_sweep.a - b.restAngle);
    float span = SPAN * Settings.timeToSleep;
    float time = b.m_jointList == null ? span : JOINTED_SHARE * span;
    float way = Settings.linearSleepTolerance * time;
    float turn = Settings.angularSleepTolerance * time;
    boolean still = x * x + y * y <= way * way && angle <= turn;
    float since = still ? b.stillTime + dt : 0f;
    if (!still || (int) (since / span) > (int) (b.stillTime / span)) {
      b.restX = b.m_sweep.c.x;
      b.restY = b.m_sweep.c.y;
      b.restAngle = b.m_sweep.a;
    }
    return since;
  }
}
