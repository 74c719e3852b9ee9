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
 * its sites and the regions in which they broke away. They are worked out when somebody asks for
 * them first: few do, and it takes longer than the fracture. Immutable otherwise; any thread may
 * ask.
 */
public final class FractureTrace {
  private final FractureEvent event;
  private final Transform frame;
  private final AABB bounds;
  private List<float[]> cells;
  private List<float[]> regions;

  private FractureTrace(FractureEvent event, Transform frame, AABB bounds) {
    this.event = event;
    this.frame = frame;
    this.bounds = bounds;
  }

  /** Returns the trace of a fracture; {@code null} if it was not along cells. */
  static FractureTrace of(FractureEvent event) {
    if (event.sites().isEmpty()) {
      return null;
    }
    List<Body> bodies = new ArrayList<>(event.remainders());
    bodies.addAll(event.splinters());
    return new FractureTrace(event, new Transform(bodies.get(0).getTransform()), boundsOf(bodies));
  }

  private List<float[]> makeRegions() {
    List<float[]> made = new ArrayList<>();
    for (Vec2[] region : event.regions()) {
      float[] ring = new float[2 * region.length];
      for (int i = 0; i < region.length; i++) {
        Vec2 p = Transform.mul(frame, region[i]);
        ring[2 * i] = p.x;
        ring[2 * i + 1] = p.y;
      }
      made.add(ring);
    }
    return made;
  }

  private List<float[]> makeCells() {
    List<Vec2> sites = new ArrayList<>();
    for (Vec2 site : event.sites()) {
      sites.add(Transform.mul(frame, site));
    }
    return Cells.within(bounds, sites);
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
  public synchronized List<float[]> cells() {
    if (cells == null) {
      cells = makeCells();
    }
    return cells;
  }

  /** Returns the regions, like {@link #cells}. */
  public synchronized List<float[]> regions() {
    if (regions == null) {
      regions = makeRegions();
    }
    return regions;
  }
}
