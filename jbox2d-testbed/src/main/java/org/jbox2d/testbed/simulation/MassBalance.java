package org.jbox2d.testbed.simulation;

import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.Set;
import org.jbox2d.collision.shapes.MassData;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.dynamics.World;

/**
 * The mass of everything that can break, or is a piece of it, against what it was at the start.
 *
 * <p>Masses are summed over fixtures, density times area, so that static bodies count with what
 * they would weigh. What is not breakable at the start (projectiles, scenery) is left out by body:
 * a body without material is never replaced, while the splinters of a body may have no material.
 */
public final class MassBalance {
  private final World world;
  private final Set<Body> unbreakable = Collections.newSetFromMap(new IdentityHashMap<>());
  private final MassData scratch = new MassData();
  private final double atStart;

  MassBalance(World world) {
    this.world = world;
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      if (!isBreakable(b)) {
        unbreakable.add(b);
      }
    }
    atStart = now();
  }

  private static boolean isBreakable(Body body) {
    for (Fixture f = body.getFixtureList(); f != null; f = f.getNext()) {
      if (f.getMaterial() != null) {
        return true;
      }
    }
    return false;
  }

  /** Leaves a body out that came later and does not break. */
  public void leaveOut(Body body) {
    unbreakable.add(body);
  }

  /** Returns the mass at the start, kg. */
  public double atStart() {
    return atStart;
  }

  /** Returns the mass now, kg. */
  public double now() {
    double sum = 0;
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      if (!unbreakable.contains(b)) {
        sum += massOf(b, scratch);
      }
    }
    return sum;
  }

  /** Returns how far the mass is off, relative to that at the start; 0 if nothing can break. */
  public double relativeError() {
    return atStart > 0 ? Math.abs(now() - atStart) / atStart : 0;
  }

  static double massOf(Body body, MassData scratch) {
    double sum = 0;
    for (Fixture f = body.getFixtureList(); f != null; f = f.getNext()) {
      if (f.getDensity() > 0f) {
        f.getMassData(scratch);
        sum += scratch.mass;
      }
    }
    return sum;
  }
}
