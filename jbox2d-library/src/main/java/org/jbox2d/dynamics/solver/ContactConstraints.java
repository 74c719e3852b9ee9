package org.jbox2d.dynamics.solver;

import java.util.Arrays;

/**
 * The contact constraints of a step as flat records, in the order in which they are solved.
 *
 * <p>A velocity record ({@link #vel}, stride {@link #V_STRIDE}) holds what the velocity kernel
 * reads, a position record ({@link #pos}, stride {@link #P_STRIDE}) what the position kernel reads.
 * Velocity constraints are written along the normal {@code n} (from A to B) and the tangent {@code
 * t = (n.y, -n.x)}; with arms {@code rA, rB} from the centres of mass to the point, the relative
 * speed along {@code n} is
 *
 * <pre>  vn = n . (vB - vA) + wB (rB x n) - wA (rA x n)</pre>
 *
 * so that only the cross products are stored, not the arms.
 */
public final class ContactConstraints {
  public static final int V_STRIDE = 28;

  // Velocity record: shared part.
  public static final int INV_MASS_A = 0;
  public static final int INV_I_A = 1;
  public static final int INV_MASS_B = 2;
  public static final int INV_I_B = 3;
  public static final int NX = 4;
  public static final int NY = 5;
  public static final int FRICTION = 6;
  public static final int TANGENT_SPEED = 7;

  /** First of the two point blocks, and the length of one. */
  public static final int POINT = 8;

  public static final int POINT_STRIDE = 8;

  // Within a point block: cross products of the arms with normal and tangent, effective mass along
  // the tangent, the speed the normal constraint aims at (restitution), and the impulses.
  public static final int RN_A = 0;
  public static final int RN_B = 1;
  public static final int RT_A = 2;
  public static final int RT_B = 3;
  public static final int TANGENT_MASS = 4;
  public static final int BIAS = 5;
  public static final int NORMAL_IMPULSE = 6;
  public static final int TANGENT_IMPULSE = 7;

  // Inverse of the (symmetric) matrix of the normals: of both points, or M11 alone of the one.
  public static final int M11 = 24;
  public static final int M12 = 25;
  public static final int M22 = 26;
  public static final int RESTITUTION = 27;

  public static final int K_STRIDE = 3;

  // Block record: the matrix of the two normals itself. It is read only where one of them does not
  // push, so it is kept apart from what each iteration streams through the cache.
  public static final int K11 = 0;
  public static final int K12 = 1;
  public static final int K22 = 2;

  public static final int S_STRIDE = 8;

  // Substep record, for solvers with substeps: separation of each point in the current substep (m);
  // impulses summed over the substeps, along the normal for each point, along the tangent for both;
  // change of the normal impulses for each unit of friction that keeps both normal speeds, and the
  // effective mass along the tangent that goes with it.
  public static final int S_SEPARATION = 0;
  public static final int S_NORMAL_SUM = 2;
  public static final int S_TANGENT_SUM = 4;
  public static final int S_HOLD = 5;
  public static final int S_HELD_TANGENT_MASS = 7;

  // The same two places, for a contact of one point: change of its separation with the square of
  // the turns of A and B.
  public static final int S_CURVE_A = 5;
  public static final int S_CURVE_B = 6;

  public static final int P_STRIDE = 16;

  // Position record. Local points are relative to the centre of mass of their body. CIRCLES: the
  // plane point is the centre of
  // A's circle, point 1 that of B's. Faces: normal and plane belong to the reference body, the
  // points to the other.
  public static final int LOCAL_NX = 0;
  public static final int LOCAL_NY = 1;
  public static final int PLANE_X = 2;
  public static final int PLANE_Y = 3;
  public static final int P1X = 4;
  public static final int P1Y = 5;
  public static final int P2X = 6;
  public static final int P2Y = 7;
  public static final int RADIUS_A = 8;
  public static final int RADIUS_B = 9;
  public static final int P_INV_MASS_A = 10;
  public static final int P_INV_I_A = 11;
  public static final int P_INV_MASS_B = 12;
  public static final int P_INV_I_B = 13;

  /** Overlap at rest, skins and slop together, for solvers with substeps, m. */
  public static final int P_REST = 14;

  /** Radius of a circle that touches a face, 0 where polygons touch, m. */
  public static final int P_ROUND = 15;

  /** How far from a body's centre of mass a disc may be to turn on the spot, over its radius. */
  private static final float CENTRED = 1e-3f;

  /** Kinds of manifold, as the position kernel tells them apart. */
  public static final int CIRCLES = 0;

  public static final int FACE_A = 1;
  public static final int FACE_B = 2;

  public int count;
  public int[] bodyA = new int[0];
  public int[] bodyB = new int[0];

  /** 1 or 2 points that the velocity kernel solves; 0 if the contact is left out. */
  public int[] pointCount = new int[0];

  /** 1 or 2 points of the manifold; may exceed {@link #pointCount} where the two are redundant. */
  public int[] manifoldPoints = new int[0];

  public int[] kind = new int[0];

  /**
   * For solvers with substeps: whether the one point is at a vertex. Such a contact begins to act
   * where the bodies would rest: seen before that, it would hold back what rolls past.
   */
  public boolean[] corner = new boolean[0];

  public float[] vel = new float[0];
  public float[] pos = new float[0];
  public float[] block = new float[0];
  public float[] sub = new float[0];

  /**
   * Whether the body in a slot touches here with a disc about its centre of mass, so that turning
   * moves nothing of the contact. For solvers with substeps.
   */
  boolean isRoundAt(int i, int slot) {
    int o = P_STRIDE * i;
    if (slot == bodyA[i]) {
      return kind[i] == CIRCLES
          ? isCentred(o + PLANE_X, pos[o + RADIUS_A])
          : kind[i] == FACE_B && isCentred(o + P1X, pos[o + P_ROUND]);
    }
    return kind[i] == CIRCLES
        ? isCentred(o + P1X, pos[o + RADIUS_B])
        : kind[i] == FACE_A && isCentred(o + P1X, pos[o + P_ROUND]);
  }

  private boolean isCentred(int o, float radius) {
    float most = CENTRED * radius;
    return pos[o] * pos[o] + pos[o + 1] * pos[o + 1] < most * most;
  }

  public void ensureCapacity(int n) {
    if (n <= bodyA.length) {
      return;
    }
    int capacity = Math.max(64, Math.max(n, bodyA.length + (bodyA.length >> 1)));
    bodyA = Arrays.copyOf(bodyA, capacity);
    bodyB = Arrays.copyOf(bodyB, capacity);
    pointCount = Arrays.copyOf(pointCount, capacity);
    manifoldPoints = Arrays.copyOf(manifoldPoints, capacity);
    kind = Arrays.copyOf(kind, capacity);
    corner = Arrays.copyOf(corner, capacity);
    vel = Arrays.copyOf(vel, V_STRIDE * capacity);
    pos = Arrays.copyOf(pos, P_STRIDE * capacity);
    block = Arrays.copyOf(block, K_STRIDE * capacity);
    sub = Arrays.copyOf(sub, S_STRIDE * capacity);
  }

  /** Whether contacts {@code [from, to)} are all between bodies that can be moved. */
  public boolean areLoose(int from, int to) {
    // The last ones are mostly those with what does not move.
    for (int i = to - 1; i >= from; i--) {
      int c = V_STRIDE * i;
      if (vel[c + INV_MASS_A] == 0f || vel[c + INV_MASS_B] == 0f) {
        return false;
      }
    }
    return true;
  }
}
