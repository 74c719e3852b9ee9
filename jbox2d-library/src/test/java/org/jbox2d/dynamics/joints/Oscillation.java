package org.jbox2d.dynamics.joints;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleSupplier;

/** Measures a decaying oscillation about zero by its zero crossings and the peaks between them. */
final class Oscillation {
  private final List<Double> crossings = new ArrayList<>();
  private final List<Double> peaks = new ArrayList<>();

  Oscillation(JointScene scene, int steps, DoubleSupplier value) {
    double last = value.getAsDouble();
    double peak = Math.abs(last);
    for (int i = 1; i <= steps; i++) {
      scene.step(1);
      double now = value.getAsDouble();
      if (last * now < 0) {
        crossings.add((i - 1 + last / (last - now)) * JointScene.H);
        peaks.add(peak);
        peak = 0;
      }
      peak = Math.max(peak, Math.abs(now));
      last = now;
    }
  }

  int count() {
    return crossings.size();
  }

  /** Mean period between the first and the last of n crossings, s. */
  double period(int n) {
    return 2 * (crossings.get(n - 1) - crossings.get(0)) / (n - 1);
  }

  /** Damping ratio from the logarithmic decrement over n half periods. */
  double dampingRatio(int n) {
    double decrement = Math.log(peaks.get(1) / peaks.get(n + 1)) / n;
    return decrement / Math.hypot(Math.PI, decrement);
  }
}
