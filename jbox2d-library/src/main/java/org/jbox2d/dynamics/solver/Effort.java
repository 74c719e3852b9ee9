package org.jbox2d.dynamics.solver;

import static org.jbox2d.dynamics.solver.ContactConstraints.*;

/**
 * How many substeps an island needs, from what is known before it is solved: no more than a scene
 * needs. Each rule says how an error of {@link SoftStep} falls with their number n, and asks for as
 * many as bring it to what is allowed.
 *
 * <ul>
 *   <li><b>Loads on contacts.</b> A contact that carries the impulse P in a step gives way by
 *       {@code P / (m n)} times a time that follows from its softness, m its effective mass: much
 *       where a heavy body stands on a light one, or a high pile on its lowest.
 *   <li><b>Columns.</b> A contact of the width w that carries P holds a tilt as a spring does; a
 *       column of s bodies with that load at its foot buckles unless {@code n > s sqrt(P h / (2 m
 *       w))}, h the step: measured on stacks of 5 to 40 bodies, 0.2 to 2 m wide, a half to twice as
 *       high as wide, a little out of line, with gravities of 10 and 40 m/s^2 and substeps of 2 to
 *       33 ms.
 *   <li><b>Spin in contact.</b> A body that turns far in a substep meets its contacts where they no
 *       longer are; a wheel does not.
 *   <li><b>Cold contacts.</b> Where most contacts have not carried anything yet, there are no
 *       impulses to start from, and each substep passes them on by one contact.
 *   <li><b>Loads on joints.</b> One pass leaves an error of the order of {@code M / m g h^2} where
 *       the mass M may hang on joints of bodies of mass m, a chain with a weight at its end; it
 *       falls as the square of n. A chain of many links is such a weight by itself.
 *   <li><b>Swaying links.</b> A chain that touches nothing and that {@link HingeChains} solves at
 *       once bears its load with any n. But light links that bear much sway fast, at the frequency
 *       w, and substeps follow that up to {@code w h / n = 2} only, h the step. A weight of a
 *       thousand links on ten of half a metre that swings by half a radian tears them with two
 *       substeps, at 4.1, and does not with four, at 2.0; let go level, it pulls with three times
 *       its weight, and tears them with four, at 3.5, while eight, at 1.8, leave gaps of 6 cm. No
 *       more are asked for than by the rule above, and all of those where links are slack or have
 *       been struck.
 *   <li><b>Moments on welds.</b> One pass leaves an angle of {@code T h^2 s / 6 I} in a weld that
 *       bears the moment T, of s in a row: measured at the foot of beams of 3 to 12 parts, which
 *       sag by {@code 1.3 s^4 g h^2}.
 *   <li><b>Turning.</b> An arm r that turns by {@code w h} leaves its tangent by {@code r (w h)^2 /
 *       2}: joints follow that by iterations, so it must stay small.
 * </ul>
 *
 * The loads on contacts are those of the last step. All is computed in a fixed order, so it is as
 * deterministic as the step.
 */
public final class Effort {
  /** {@code 1 / (gamma m rate)} of the contacts, s; see {@link Softness} and {@link SoftStep}. */
  private static final float CONTACT_TIME = 1.5e-3f;

  /** Way that a contact may give, in slops. */
  private static final float CONTACT_SLOPS = 2f;

  /**
   * Contacts for each body up to which an island is a column; in walls and heaps there are two, and
   * in loose heaps more than one.
   */
  private static final float COLUMN_CONTACTS = 1.1f;

  /** The 2 of the bound for columns, with a margin: near the bound a stack sways for long. */
  private static final float COLUMN_FACTOR = 1.5f;

  /**
   * Share of the load that each end of a contact bears at least in a column that stands. What leans
   * or tumbles rests on one end.
   */
  private static final float UPRIGHT_SHARE = 0.2f;

  /** Substeps where most contacts carry nothing yet; no more than there are contacts. */
  private static final float COLD_SUBSTEPS = 4f;

  /** Turn of a body in contact that is allowed in a substep, rad. */
  private static final float MOST_TURN = 0.25f;

  /**
   * Error of a chain's end for each {@code M / m g h^2}: measured on chains of ten links with ends
   * of 1 to 1000 times a link's mass.
   */
  private static final float JOINT_FACTOR = 8f;

  /** Error of joints under load that is allowed, in slops. */
  private static final float JOINT_SLOPS = 8f;

  /** Phase by which a link that is solved at once may sway in a substep, rad; half the bound. */
  private static final float MOST_SWAY = 1f;

  /** Mass ratio that a joint of an island stands for, whatever the masses. */
  private static final float LENGTH_SHARE = 0.1f;

  /** Least number where there are joints: a beam of welds sags by what one pass leaves. */
  private static final float JOINT_SUBSTEPS = 3f;

  /** Angle in a weld that is allowed, rad. */
  private static final float WELD_ANGLE = 0.02f;

  /** The 6 of the rule for welds. */
  private static final float WELD_FACTOR = 6f;

  /** Way off the tangent that is allowed in a substep, in slops. */
  private static final float BEND_SLOPS = 0.1f;

  private final SolverBodies bodies;
  private final ContactConstraints contacts;
  private final JointRows joints;
  private final HingeChains chains;
  private final ChainSway sway;

  /** Substeps that a column asks for, as {@link #ofContacts} has found. */
  public float tall;

  /**
   * Substeps that speed asks for, rather than loads, as {@link #ofContacts} and {@link #ofJoints}
   * have found.
   */
  public float fast;

  public Effort(SolverBodies bodies, ContactConstraints contacts, JointRows joints) {
    this.bodies = bodies;
    this.contacts = contacts;
    this.joints = joints;
    chains = new HingeChains(bodies, joints);
    sway = new ChainSway(bodies, joints, chains);
  }

  /**
   * Returns the substeps that contacts {@code [c0, c1)} between a number of bodies ask for, but for
   * those in {@link #tall} and {@link #fast}; each may be 0, or huge.
   */
  public float ofContacts(int c0, int c1, int bodyCount, StepConfig step) {
    float[] d = contacts.vel;
    float[] v = bodies.vel;
    float worst = 0f;
    float spin = 0f;
    int idle = 0;
    for (int i = c0; i < c1; i++) {
      int o = V_STRIDE * i;
      float spinA = Math.abs(v[SolverBodies.STRIDE * contacts.bodyA[i] + 2]);
      float spinB = Math.abs(v[SolverBodies.STRIDE * contacts.bodyB[i] + 2]);
      spin = spinA > spin && !contacts.isRoundAt(i, contacts.bodyA[i]) ? spinA : spin;
      spin = spinB > spin && !contacts.isRoundAt(i, contacts.bodyB[i]) ? spinB : spin;
      float impulse = d[o + POINT + NORMAL_IMPULSE];
      if (contacts.manifoldPoints[i] == 2) {
        impulse += d[o + POINT + POINT_STRIDE + NORMAL_IMPULSE];
      }
      idle += impulse > 0f ? 0 : 1;
      worst = Math.max(worst, impulse * (d[o + INV_MASS_A] + d[o + INV_MASS_B]));
    }
    float loaded = CONTACT_TIME * worst / (CONTACT_SLOPS * step.linearSlop);
    fast = spin * step.dt / MOST_TURN;
    float cold = 2 * idle > c1 - c0 ? Math.min(COLD_SUBSTEPS, c1 - c0) : 0f;
    boolean column = c1 - c0 < COLUMN_CONTACTS * bodyCount;
    tall = column ? ofColumn(c0, c1, bodyCount, step) : 0f;
    return Math.max(cold, loaded);
  }

  /** No more bodies can stand on a contact than there are, nor than make up its load. */
  private float ofColumn(int c0, int c1, int bodyCount, StepConfig step) {
    float[] d = contacts.vel;
    float[] p = contacts.pos;
    float weight = step.dt * gravity(step);
    float worst = 0f;
    for (int i = c0; i < c1; i++) {
      if (contacts.manifoldPoints[i] == 2) {
        int o = V_STRIDE * i;
        float impulse1 = d[o + POINT + NORMAL_IMPULSE];
        float impulse2 = d[o + POINT + POINT_STRIDE + NORMAL_IMPULSE];
        float impulse = impulse1 + impulse2;
        if (Math.min(impulse1, impulse2) < UPRIGHT_SHARE * impulse) {
          continue;
        }
        float load = impulse * Math.max(d[o + INV_MASS_A], d[o + INV_MASS_B]);
        float storeys = load < bodyCount * weight ? load / weight : bodyCount;
        int po = P_STRIDE * i;
        float dx = p[po + P2X] - p[po + P1X];
        float dy = p[po + P2Y] - p[po + P1Y];
        float width = (float) Math.sqrt(dx * dx + dy * dy);
        worst = Math.max(worst, storeys * storeys * load / Math.max(width, step.linearSlop));
      }
    }
    return (float) Math.sqrt(worst * step.dt / COLUMN_FACTOR);
  }

  private static float gravity(StepConfig step) {
    float x = step.gravityX;
    float y = step.gravityY;
    return (float) Math.sqrt(x * x + y * y);
  }

  /**
   * Returns the substeps that joints {@code [j0, j1)} between bodies {@code slots[b0, b1)} ask for;
   * may be huge. What their speed asks for raises {@link #fast}.
   *
   * @param touching whether there are contacts
   * @param most substeps that the island may have; where the number of joints alone asks for them,
   *     they are not looked at
   */
  public float ofJoints(
      int j0, int j1, int[] slots, int b0, int b1, boolean touching, int most, StepConfig step) {
    float weight =
        gravity(step) * step.dt * step.dt * JOINT_FACTOR / (JOINT_SLOPS * step.linearSlop);
    float length = LENGTH_SHARE * (j1 - j0);
    if (weight * length >= most * most) {
      return most;
    }
    float light = 0f;
    float heavy = Float.MAX_VALUE;
    float bend = 0f;
    float twist = 0f;
    for (int r = j0; r < j1; r++) {
      for (int k = 0; k < joints.bodyCount[r]; k++) {
        float m = bodies.mass[SolverBodies.STRIDE * joints.bodies[joints.bodyAt[r] + k]];
        light = Math.max(light, m);
        heavy = m > 0f ? Math.min(heavy, m) : heavy;
      }
      bend = Math.max(bend, joints.kernel[r].bend(joints, r, bodies));
      twist = Math.max(twist, joints.kernel[r].twist(joints, r, bodies));
    }
    float loaded = weight * Math.max(light / heavy, length);
    if (!touching && loaded > JOINT_SUBSTEPS * JOINT_SUBSTEPS) {
      chains.findUneven(j0, j1, slots, b0, b1);
      if (chains.areThere()) {
        float others = weight * ratioOfOthers(j0, j1, heavy);
        loaded = Math.min(loaded, Math.max(others, ofChains(step)));
      }
    }
    float bent = bend * step.dt * step.dt / (2f * BEND_SLOPS * step.linearSlop);
    float twisted = twist * step.dt * (j1 - j0) / (WELD_FACTOR * WELD_ANGLE);
    fast = Math.max(fast, (float) Math.sqrt(bent));
    return Math.max(JOINT_SUBSTEPS, (float) Math.sqrt(Math.max(twisted, loaded)));
  }

  /**
   * Returns the mass ratio, or what their number stands for, of the joints that are not solved at
   * once: the heaviest body of all may hang on them.
   *
   * @param heavy its inverse mass
   */
  private float ratioOfOthers(int j0, int j1, float heavy) {
    float light = 0f;
    int count = 0;
    for (int r = j0; r < j1; r++) {
      if (!chains.has(r)) {
        count++;
        for (int k = 0; k < joints.bodyCount[r]; k++) {
          int slot = joints.bodies[joints.bodyAt[r] + k];
          light = Math.max(light, bodies.mass[SolverBodies.STRIDE * slot]);
        }
      }
    }
    return Math.max(light / heavy, LENGTH_SHARE * count);
  }

  /** Returns the square of the substeps that chains ask for. */
  private float ofChains(StepConfig step) {
    float h = step.dt / MOST_SWAY;
    return sway.square(gravity(step), step) * h * h;
  }
}
