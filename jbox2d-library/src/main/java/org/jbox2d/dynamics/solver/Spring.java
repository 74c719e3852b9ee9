package org.jbox2d.dynamics.solver;

/**
 * Softness and bias of a spring-damper as a velocity constraint.
 *
 * <p>The impulse of a step is {@code P = -h (k C' + d v')}. With the velocities {@code v-} before
 * the step (and before its forces) and {@code v+} after it,
 *
 * <pre>
 *   C' = C + h (a v+ + b v-),   v' = c v+ + (1 - c) v-
 * </pre>
 *
 * so that {@code v+ + bias + gamma P = 0} with {@code 1/gamma = h (h k a + d c)} and {@code bias =
 * gamma h (k C + (h k b + d (1 - c)) v-)}; {@code k = m omega^2, d = 2 m zeta omega}, m the
 * effective mass (form of the constraint: Catto, "Soft constraints", GDC 2011).
 *
 * <p>{@code (a, b, c) = (1, 0, 1)} is implicit Euler, which damps by itself: it adds {@code omega h
 * / 2} to the damping ratio, 0.05 for 1 Hz at 60 steps a second. {@code (1/4, -1/4, 1/2)} is
 * Newmark's rule of average acceleration (Newmark 1959; Hughes, The Finite Element Method, 2000,
 * 9.1), which is as stable, adds no damping, has a period longer by {@code (omega h)^2 / 12}, and
 * rests where the load says; but what is too stiff for the step rings on. So the weight s of
 * implicit Euler grows with the frequency, {@code s = (omega h / pi)^2}, up to 1 at half the step
 * rate.
 */
final class Spring {
  private Spring() {}

  /**
   * Writes gamma to {@code at} and the bias to {@code at + 1}.
   *
   * @param inverseMass of the constraint, positive
   * @param frequency Hz, positive
   * @param error C, m or rad
   * @param before v-, of the constraint
   */
  static void soften(
      float[] f,
      int at,
      float inverseMass,
      float frequency,
      float dampingRatio,
      float h,
      float error,
      float before) {
    float omega = 2f * (float) Math.PI * frequency;
    float k = omega * omega / inverseMass;
    float d = 2f * dampingRatio * omega / inverseMass;
    float s = Math.min(1f, omega * h / (float) Math.PI);
    s *= s;
    float a = 0.25f + 0.75f * s;
    float b = 0.25f * (s - 1f);
    float c = 0.5f + 0.5f * s;
    float soft = h * (h * k * a + d * c);
    float gamma = soft > 0f ? 1f / soft : 0f;
    f[at] = gamma;
    f[at + 1] = gamma * h * (k * error + (h * k * b + d * (1f - c)) * before);
  }
}
