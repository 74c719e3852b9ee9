package org.jbox2d.dynamics;

import java.util.Arrays;
import org.jbox2d.common.Settings;

/**
 * Puts islands to sleep that have come to rest, by any of three signs.
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
 * <p><b>Still but for a few</b>: all are still except a small share of the bodies and of the mass,
 * which creep: none of them has gone further in the span than a few times that way. A heap of
 * hundreds of splinters has always one or two that are squeezed out from under a heavy piece by
 * millimetres a step, or topple onto the next; each keeps all of the heap awake, and its coming to
 * rest is nothing to be seen. Being of the island they touch others of it, so nothing stops in the
 * air.
 *
 * <p>The span S is chosen so that, but for what trembles on the spot, calm and still agree. A body
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
   * purpose, unless by less than {@link Settings#linearSlop}, which no one sees. Up to the way of
   * the others it creeps: hinges that lie in a heap of hundreds of bodies and give by millimetres
   * kept all of it awake.
   */
  private static final float JOINTED_SHARE = 0.25f;

  /** How many times as far as what is still goes what creeps, at most: 8 cm in two seconds. */
  private static final float CREEP = 4f;

  /** One in so many bodies of an island may creep, and as much of its mass. */
  private static final int FEW = 16;

  /** What an island's bodies have come to. */
  private static final class Sum {
    float calm;
    float still;
    float creep;
    int bodies;
    int creeping;
    float mass;
    float creepingMass;

    void clear() {
      calm = Float.MAX_VALUE;
      still = Float.MAX_VALUE;
      creep = Float.MAX_VALUE;
      bodies = 0;
      creeping = 0;
      mass = 0f;
      creepingMass = 0f;
    }

    void add(Body b, float span) {
      calm = Math.min(calm, b.m_sleepTime);
      still = Math.min(still, b.still.time);
      bodies++;
      mass += b.m_mass;
      if (b.still.time < span) {
        creep = Math.min(creep, b.creep.time);
        creeping++;
        creepingMass += b.m_mass;
      }
    }

    boolean rests(boolean settled, float time, float span) {
      return (settled && calm >= time)
          || still >= span
          || (creep >= span && FEW * creeping <= bodies && FEW * creepingMass <= mass);
    }
  }

  private Sum[] sums = new Sum[0];
  private boolean[] rests = new boolean[0];

  /**
   * Looks at the awake bodies after a step.
   *
   * @param settled of each island, whether its positions are within tolerance
   * @param n how many bodies were solved; those that listeners have woken since lie behind them,
   *     have no island and are awake anyway
   * @param dt length of the step, s
   */
  void update(World world, Islands islands, boolean[] settled, int n, float dt) {
    begin(islands.count);
    float time = Settings.timeToSleep;
    float span = SPAN * time;
    Body[] awake = world.awake.bodies;
    for (int i = 0; i < n; i++) {
      Body b = awake[i];
      look(b, span, dt);
      sums[islands.islandOf[i]].add(b, span);
    }
    for (int k = 0; k < islands.count; k++) {
      rests[k] = sums[k].rests(settled[k], time, span);
    }
    for (int i = n - 1; i >= 0; i--) {
      if (rests[islands.islandOf[i]]) {
        world.awake.fallAsleep(awake[i]);
      }
    }
  }

  private void begin(int islands) {
    int had = sums.length;
    if (had < islands) {
      sums = Arrays.copyOf(sums, islands + (islands >> 1));
      rests = new boolean[sums.length];
      for (int k = had; k < sums.length; k++) {
        sums[k] = new Sum();
      }
    }
    for (int k = 0; k < islands; k++) {
      sums[k].clear();
    }
  }

  /** Notes for how long a body has been calm and still, and crept. */
  private static void look(Body b, float span, float dt) {
    boolean maySleep = (b.m_flags & Body.e_autoSleepFlag) != 0;
    boolean slow = maySleep && isSlow(b);
    b.m_sleepTime = slow ? b.m_sleepTime + dt : 0f;
    if (!maySleep) {
      b.still.time = 0f;
      b.creep.time = 0f;
    } else if (b.m_type != BodyType.DYNAMIC) {
      b.still.time = slow ? b.still.time + dt : 0f;
      b.creep.time = 0f;
    } else {
      float way = Settings.linearSleepTolerance * span;
      float turn = Settings.angularSleepTolerance * span;
      if (b.m_jointList == null) {
        b.still.update(b.m_sweep, way, turn, span, dt);
        b.creep.update(b.m_sweep, CREEP * way, CREEP * turn, span, dt);
      } else {
        b.still.update(b.m_sweep, JOINTED_SHARE * way, JOINTED_SHARE * turn, span, dt);
        b.creep.update(b.m_sweep, way, turn, span, dt);
      }
    }
  }

  private static boolean isSlow(Body b) {
    float v = Settings.linearSleepTolerance;
    return Math.abs(b.m_angularVelocity) <= Settings.angularSleepTolerance
        && b.m_linearVelocity.lengthSquared() <= v * v;
  }
}
