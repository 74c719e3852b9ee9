package org.jbox2d.testbed.simulation;

import java.util.ArrayList;
import java.util.List;
import org.jbox2d.collision.AABB;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.fracture.FractureEvent;

/**
 * What a fracture was made by, in world coordinates of the moment it happened: the Voronoi cells of
 * its sites and the regions in which they broke away. Immutable.
 */
public final class FractureTrace {
  private final List<float[]> cells;
  private final List<float[]> regions;

  private FractureTrace(List<float[]> cells, List<float[]> regions) {
    this.cells = cells;
    this.regions = regions;
  }

  /** Returns the trace of a fracture; {@code null} if it was not along cells. */
  static FractureTrace of(FractureEvent event) {
    if (event.sites().isEmpty()) {
      return null;
    }
    List<Body> bodies = new ArrayList<>(event.remainders());
    bodies.addAll(event.splinters());
    Transform frame = bodies.get(0).getTransform();
    List<float[]> regions = new ArrayList<>();
    for (Vec2[] region : event.regions()) {
      float[] ring = new float[2 * region.length];
      for (int i = 0; i < region.length; i++) {
        Vec2 p = Transform.mul(frame, region[i]);
        ring[2 * i] = p.x;
        ring[2 * i + 1] = p.y;
      }
      regions.add(ring);
    }
    List<Vec2> sites = new ArrayList<>();
    for (Vec2 site : event.sites()) {
      sites.add(Transform.mul(frame, site));
    }
    return new FractureTrace(Cells.within(boundsOf(bodies), sites), regions);
  }

  private static AABB boundsOf(List<Body> bodies) {
    AABB all = null;
    AABB one = new AABB();
    for (Body body : bodies) {
      for (Fixture f = body.getFixtureList(); f != null; f = f.getNext()) {
        f.getShape().computeAABB(one, body.getTransform(), 0);
        if (all == null) {
          all = new AABB(one);
        } else {
          all.combine(one);
        }
      }
    }
    return all;
  }

  /** Returns the cells, each a ring of interleaved world coordinates, m; not to be changed. */
  public List<float[]> cells() {
    return cells;
  }

  /** Returns the regions, like {@link #cells}. */
  public List<float[]> regions() {
    return regions;
  }
}
