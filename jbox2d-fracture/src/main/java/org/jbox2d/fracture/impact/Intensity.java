package org.jbox2d.fracture.impact;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.SolvedContact;

/**
 * How hard a blow was: the normal impulse of a contact, summed over its points, without what a
 * resting load carries.
 *
 * <p>The solver's impulse of a step is the blow's impulse plus that of the load: {@code i = m v + F
 * dt}. Only the first does not depend on the length of the step. What is load is told from the
 * contact's past:
 *
 * <ul>
 *   <li>A contact that carried an impulse in the last step goes on carrying it, give or take what
 *       an iterative solver moves between the contacts of a pile: only what rises above {@link
 *       #LOAD_RISE} times that is a blow. So a resting box never breaks, and a blow that comes
 *       through it does.
 *   <li>A contact that is new has no past. Of its approach speed vn, gravity and forces have added
 *       up to g, the larger of what the two bodies gained along the normal, in this very step; a
 *       body that is set down approaches with g alone, or not at all if both fall. The share g / vn
 *       of the impulse is load.
 * </ul>
 */
final class Intensity {
  /**
   * By how much a resting load may rise in a step, as loads of a pile settle on its contacts over a
   * few steps. The solver starts a step from the impulses of the last one. In the first step of a
   * contact it answers the speed that gravity adds in one step by an impulse i, and may leave
   * nearly all of that speed, as under a heavy weight on light boxes; in the second it answers what
   * is left and what gravity adds anew, each by at most i again; later steps rise by less. Soft
   * contacts swing about that, which makes it a little more than 3.
   */
  private static final float LOAD_RISE = 4f;

  private Intensity() {}

  static float of(SolvedContact s) {
    float impulse = s.normalImpulse();
    float load =
        s.previousNormalImpulse > 0f ? LOAD_RISE * s.previousNormalImpulse : impulse * loadShare(s);
    return Math.max(0f, impulse - load);
  }

  private static float loadShare(SolvedContact s) {
    Vec2 n = s.normal;
    float gained =
        Math.max(
            Math.abs(s.gainA.x * n.x + s.gainA.y * n.y),
            Math.abs(s.gainB.x * n.x + s.gainB.y * n.y));
    float approach = 0f;
    for (int i = 0; i < s.pointCount; i++) {
      approach = Math.max(approach, approachSpeed(s, s.points[i]));
    }
    return approach > gained ? gained / approach : 1f;
  }

  private static float approachSpeed(SolvedContact s, Vec2 p) {
    float ax = s.velocityA.x - s.angularVelocityA * (p.y - s.centerA.y);
    float ay = s.velocityA.y + s.angularVelocityA * (p.x - s.centerA.x);
    float bx = s.velocityB.x - s.angularVelocityB * (p.y - s.centerB.y);
    float by = s.velocityB.y + s.angularVelocityB * (p.x - s.centerB.x);
    return (ax - bx) * s.normal.x + (ay - by) * s.normal.y;
  }
}
