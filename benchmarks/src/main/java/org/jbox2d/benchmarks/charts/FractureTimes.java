package org.jbox2d.benchmarks.charts;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.World;
import org.jbox2d.fracture.FractureEvent;
import org.jbox2d.fracture.FractureListener;
import org.jbox2d.fracture.FractureProposal;
import org.jbox2d.fracture.FractureSystem;
import org.jbox2d.fracture.Material;

/**
 * Thread times of whole fractures, from the request to the last piece, as a listener sees them. All
 * fractures of a step are worked out together; each then counts with their mean.
 */
final class FractureTimes implements FractureListener {
  private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

  private final List<Double> micros = new ArrayList<>();
  private boolean kept;
  private World world;
  private long start;
  private long end;
  private int fractures;

  /** Returns the processor time that this thread has used, ns. */
  static long now() {
    return THREADS.getCurrentThreadCpuTime();
  }

  /** Sets whether what follows is kept. */
  void keep(boolean keep) {
    kept = keep;
  }

  /** Times the fractures of a world from now on. */
  void listenTo(World watched) {
    world = watched;
    fractures = 0;
    FractureSystem.of(world).setListener(this);
    world.addStepListener((w, dt) -> finishStep());
  }

  @Override
  public boolean allow(FractureProposal proposal) {
    if (fractures == 0 && start == 0) {
      start = now();
    }
    return true;
  }

  @Override
  public void action(Material material, float intensity, List<Body> fragments) {
    end = now();
    fractures++;
  }

  @Override
  public void fractured(FractureEvent event) {}

  private void finishStep() {
    for (int i = 0; i < fractures && kept; i++) {
      micros.add(1e-3 * (end - start) / fractures);
    }
    fractures = 0;
    start = 0;
  }

  /** Returns what was kept, the shortest first. */
  double[] microseconds() {
    double[] sorted = micros.stream().mapToDouble(Double::doubleValue).toArray();
    Arrays.sort(sorted);
    return sorted;
  }
}
