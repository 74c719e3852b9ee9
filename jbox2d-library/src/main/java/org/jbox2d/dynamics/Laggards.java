package org.jbox2d.dynamics;

import java.util.ArrayList;
import java.util.List;
import org.jbox2d.collision.WorldManifold;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.contacts.Contact;
import org.jbox2d.dynamics.contacts.ContactEdge;

/**
 * Bodies that have spent the last part of a step with a velocity that was taken back afterwards,
 * such as a bullet that was held up by what then turned out to break. They make up for it in the
 * next step, when the velocities that they really have, with all they now meet, have been solved:
 *
 * <p>{@code c += h (v - u), a += h (w - s)}, h the time spent, u and s the velocities taken back.
 * Bodies of one fracture lag by the same time, so those that move together make up together.
 *
 * <p>A body that would be pushed into one that does not catch up is held, and so is what would be
 * pushed into it. Still bodies, and for bullets all others, are seen to by the continuous phase,
 * which finds the way of the step longer by the addition.
 */
final class Laggards {
  /** Longest time to be made up for, in steps; what is beyond is lost. */
  private static final int MOST_STEPS = 4;

  /** Those that catch up in the next step, and those that did so in this one. */
  private List<Lag> waiting = new ArrayList<>();

  private List<Lag> lags = new ArrayList<>();
  private final WorldManifold manifold = new WorldManifold();

  /** How far a body lags behind. */
  static final class Lag {
    final Body body;

    /** What those share that have struck each other; {@code null}: something else had a part. */
    final Object group;

    private final float time;
    private final float u;
    private final float v;
    private final float spin;

    /** What is made up for, m and rad. */
    private float x;

    private float y;
    private float turn;
    private boolean held;

    private Lag(Body body, Object group, float time, Vec2 velocity, float angularVelocity) {
      this.body = body;
      this.group = group;
      this.time = time;
      u = velocity.x;
      v = velocity.y;
      spin = angularVelocity;
    }

    /** Moves the body on. */
    void move() {
      body.m_sweep.c.addLocal(x, y);
      body.m_sweep.a += turn;
      body.synchronizeTransform();
    }
  }

  /** Lets a body make up for the given time in the next step; an earlier call is forgotten. */
  void add(Body body, Object group, float time, float dt, Vec2 velocity, float angularVelocity) {
    float most = MOST_STEPS * dt;
    Lag lag = new Lag(body, group, Math.min(time, most), velocity, angularVelocity);
    for (int i = 0; i < waiting.size(); i++) {
      if (waiting.get(i).body == body) {
        waiting.set(i, lag);
        return;
      }
    }
    waiting.add(lag);
  }

  /** Time by which the way of a body in this step is longer than the step, s. */
  static float timeOf(Body body) {
    Lag lag = body.lag;
    return lag == null || lag.held ? 0f : lag.time;
  }

  /** Moves the bodies on; velocities have been solved, and positions too. */
  void catchUp(LateIslands islands) {
    if (lags.isEmpty() && waiting.isEmpty()) {
      return;
    }
    begin();
    if (lags.isEmpty()) {
      return;
    }
    for (Lag lag : lags) {
      measure(lag);
    }
    boolean changed = true;
    while (changed) {
      changed = false;
      for (Lag lag : lags) {
        if (!lag.held && isInTheWay(lag)) {
          lag.held = true;
          changed = true;
        }
      }
    }
    List<Lag> due = new ArrayList<>();
    for (Lag lag : lags) {
      if (!lag.held) {
        due.add(lag);
      }
    }
    islands.moveOn(due);
  }

  private void begin() {
    for (Lag lag : lags) {
      lag.body.lag = null;
    }
    lags.clear();
    List<Lag> empty = lags;
    lags = waiting;
    waiting = empty;
    for (Lag lag : lags) {
      lag.body.lag = lag;
    }
  }

  /** What is tied by joints to others is not moved alone. */
  private static void measure(Lag lag) {
    Body b = lag.body;
    lag.held = b.awakeIndex < 0 || b.m_type != BodyType.DYNAMIC || b.m_jointList != null;
    lag.x = lag.time * (b.m_linearVelocity.x - lag.u);
    lag.y = lag.time * (b.m_linearVelocity.y - lag.v);
    lag.turn = lag.time * (b.m_angularVelocity - lag.spin);
  }

  /**
   * Whether a body would be moved into one that stays. Those that catch up together have been
   * solved together; they may come as much nearer to each other as in any step.
   */
  private boolean isInTheWay(Lag lag) {
    for (ContactEdge edge = lag.body.m_contactList; edge != null; edge = edge.next) {
      Contact c = edge.contact;
      Lag other = edge.other.lag;
      if (edge.other.m_type != BodyType.DYNAMIC
          || (other != null && !other.held)
          || !c.isTouching()
          || !c.isEnabled()
          || c.m_manifold.pointCount == 0
          || c.m_fixtureA.m_isSensor
          || c.m_fixtureB.m_isSensor) {
        continue;
      }
      c.getWorldManifold(manifold);
      float sign = c.m_fixtureA.m_body == lag.body ? 1f : -1f;
      float into = sign * (manifold.normal.x * lag.x + manifold.normal.y * lag.y);
      if (into > Settings.linearSlop) {
        return true;
      }
    }
    return false;
  }
}
