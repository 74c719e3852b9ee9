package org.jbox2d.fracture.impact;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;

/**
 * Gives back what bodies that broke did not take of the blows of a step.
 *
 * <p>Breaking costs the impulse p; of a blow of intensity i the share {@code z = p / i} acts, and
 * {@code 1 - z} is given back to both bodies at the contact's points, equal and opposite (thesis,
 * section 6.7, {@code v = v_old + z (v_new - v_old)}, for the breaking contact alone). So linear
 * and angular momentum of the pair are what they were.
 *
 * <p>Energy: the kinetic energy that a step's solving takes from the world is the sum over its
 * contacts of {@code -W = -P . (u0 + u1) / 2}, u0 and u1 the relative velocity at the contact
 * before and after solving (from {@code dE = (v0 + v1) / 2 . M dv} and {@code M dv = sum J^T P}).
 * What giving back may return is what the blows themselves have taken. Bodies linked by blows form
 * a group; give back the share s of all that is due in it: its energy is a parabola in s, and s is
 * the largest value up to 1 for which it has risen by no more than the blows of the group took, and
 * all groups together by no more than solving took from the world. For a pair alone that is always
 * 1.
 */
public final class GiveBack {
  /** Walked in insertion order. */
  private final Map<Body, Change> changes = new LinkedHashMap<>();

  private final Set<Long> solves = new HashSet<>();
  private double takenInAll;

  /** Takes in a blow of which the share {@code z} in [0, 1] acts. */
  public void add(Blow blow, float z) {
    Change a = changeOf(blow.bodyA);
    Change b = changeOf(blow.bodyB);
    if (solves.add(blow.solve)) {
      takenInAll += Math.max(0, blow.energyTaken);
    }
    if (a.moves() && b.moves()) {
      a.root().parent = b.root();
    }
    // The bodies have moved on since the contact was solved, each with its own point; that both
    // impulses act at one point, midway
    // between the two, is what keeps the angular momentum.
    double driftX = 0.5 * (a.wayX(blow.centerA) + b.wayX(blow.centerB));
    double driftY = 0.5 * (a.wayY(blow.centerA) + b.wayY(blow.centerB));
    double due = 1.0 - z;
    double taken = 0;
    for (int i = 0; i < blow.pointCount; i++) {
      double jn = due * blow.normalImpulses[i];
      double jt = due * blow.tangentImpulses[i];
      double px = jn * blow.normal.x + jt * blow.normal.y;
      double py = jn * blow.normal.y - jt * blow.normal.x;
      double x = blow.points[i].x + driftX;
      double y = blow.points[i].y + driftY;
      a.add(px, py, x, y);
      b.add(-px, -py, x, y);
      taken -= work(blow, i);
    }
    (a.moves() ? a : b).taken += Math.max(0, taken);
  }

  /**
   * Work of the impulse at point i on the pair: {@code P . (u0 + u1) / 2}, u the velocity of B
   * relative to A.
   */
  private static double work(Blow blow, int i) {
    double xA = (double) blow.points[i].x - blow.centerA.x;
    double yA = (double) blow.points[i].y - blow.centerA.y;
    double xB = (double) blow.points[i].x - blow.centerB.x;
    double yB = (double) blow.points[i].y - blow.centerB.y;
    double wA = (double) blow.beforeA.w + blow.afterA.w;
    double wB = (double) blow.beforeB.w + blow.afterB.w;
    double ux =
        (double) blow.beforeB.x
            + blow.afterB.x
            - wB * yB
            - ((double) blow.beforeA.x + blow.afterA.x - wA * yA);
    double uy =
        (double) blow.beforeB.y
            + blow.afterB.y
            + wB * xB
            - ((double) blow.beforeA.y + blow.afterA.y + wA * xA);
    double jn = blow.normalImpulses[i];
    double jt = blow.tangentImpulses[i];
    return 0.5
        * (ux * (jn * blow.normal.x + jt * blow.normal.y)
            + uy * (jn * blow.normal.y - jt * blow.normal.x));
  }

  private Change changeOf(Body body) {
    Change change = changes.get(body);
    if (change == null) {
      change = new Change(body);
      changes.put(body, change);
    }
    return change;
  }

  /** Gives back what is due, group by group. */
  public void apply() {
    for (Change change : changes.values()) {
      change.root().gather(change);
    }
    double rise = 0;
    for (Change change : changes.values()) {
      if (change.root() == change) {
        rise += change.rise(change.share());
      }
    }
    // A contact that parted its bodies before another pressed them together gives energy, which the
    // other has taken in excess. The
    // rise of a parabola that starts at 0 shrinks at least as fast as its argument.
    double cut = rise > takenInAll ? takenInAll / rise : 1;
    for (Change change : changes.values()) {
      if (change.moves()) {
        change.apply(cut * change.root().share());
      }
    }
    changes.clear();
    solves.clear();
    takenInAll = 0;
  }

  /**
   * The change of a body's velocities if all that is due is given back; and, of the first of a
   * group, the sums over the group.
   */
  private static final class Change {
    private final Body body;
    private Change parent = this;
    private double vx;
    private double vy;
    private double w;
    private double taken;
    private double room;
    private double slope;
    private double curvature;

    Change(Body body) {
      this.body = body;
    }

    private double energy(double x, double y, double spin) {
      return 0.5 * (body.m_mass * (x * x + y * y) + body.m_I * spin * spin);
    }

    Change root() {
      Change c = this;
      while (c.parent != c) {
        c = c.parent;
      }
      return c;
    }

    boolean moves() {
      return body.m_invMass > 0f || body.m_invI > 0f;
    }

    double wayX(Vec2 from) {
      return body.m_sweep.c.x - from.x;
    }

    double wayY(Vec2 from) {
      return body.m_sweep.c.y - from.y;
    }

    void add(double px, double py, double x, double y) {
      vx += body.m_invMass * px;
      vy += body.m_invMass * py;
      w += body.m_invI * ((x - body.m_sweep.c.x) * py - (y - body.m_sweep.c.y) * px);
    }

    /** Adds a member to the sums: E(s) = E(0) + slope s + curvature s^2. */
    void gather(Change member) {
      Body b = member.body;
      double x = b.m_linearVelocity.x;
      double y = b.m_linearVelocity.y;
      double spin = b.m_angularVelocity;
      room += member.taken;
      slope += b.m_mass * (x * member.vx + y * member.vy) + b.m_I * spin * member.w;
      curvature += member.energy(member.vx, member.vy, member.w);
    }

    /** Largest s in [0, 1] with {@code E(s) - E(0) <= room}. */
    double share() {
      if (!(curvature > 0) || slope + curvature <= room) {
        return 1;
      }
      double s = (-slope + Math.sqrt(slope * slope + 4 * curvature * room)) / (2 * curvature);
      return Math.max(0, Math.min(1, s));
    }

    double rise(double share) {
      return Math.max(0, share * (slope + share * curvature));
    }

    void apply(double share) {
      body.setAwake(true);
      body.m_linearVelocity.x += (float) (share * vx);
      body.m_linearVelocity.y += (float) (share * vy);
      body.m_angularVelocity += (float) (share * w);
    }
  }
}
