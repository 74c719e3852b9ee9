package org.jbox2d.dynamics;

import org.jbox2d.common.Sweep;

/** For how long a body has kept near a place: where it was when the current span of time began. */
final class Rest {
  /** How long, s. */
  float time;

  private float x;
  private float y;
  private float angle;

  /**
   * Looks where the body is at the end of a step.
   *
   * @param way how far it may go in a span, m
   * @param turn how far it may turn, rad
   * @param span s
   * @param dt length of the step, s
   */
  void update(Sweep sweep, float way, float turn, float span, float dt) {
    float dx = sweep.c.x - x;
    float dy = sweep.c.y - y;
    boolean near = dx * dx + dy * dy <= way * way && Math.abs(sweep.a - angle) <= turn;
    float since = near ? time + dt : 0f;
    if (!near || (int) (since / span) > (int) (time / span)) {
      x = sweep.c.x;
      y = sweep.c.y;
      angle = sweep.a;
    }
    time = since;
  }
}
