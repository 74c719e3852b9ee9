package org.jbox2d.fracture;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.fracture.assembly.Piece;
import org.jbox2d.fracture.assembly.Plan;
import org.jbox2d.fracture.fragmentation.ImpactRegion;
import org.jbox2d.fracture.geometry.Outline;
import org.jbox2d.fracture.impact.Request;

/**
 * A fracture that has happened. All bodies share the frame of the old one: origin, angle and local
 * coordinates are the same.
 */
public final class FractureEvent {
  /** Vertices of a region's outline. */
  private static final int REGION_VERTICES = 48;

  private final FractureCause cause;
  private final Request request;
  private final Plan plan;
  private final List<Body> remainders;
  private final List<Body> splinters;

  FractureEvent(FractureCause cause, Plan plan, List<Body> bodies) {
    this.cause = cause;
    this.plan = plan;
    request = plan.request;
    int stay = bodies.size() - plan.splinterCount();
    remainders = Collections.unmodifiableList(new ArrayList<>(bodies.subList(0, stay)));
    splinters = Collections.unmodifiableList(new ArrayList<>(bodies.subList(stay, bodies.size())));
  }

  /** Returns what made the body break. */
  public FractureCause cause() {
    return cause;
  }

  /**
   * Returns the body that broke. It is the first of the remainders if something stayed; else it has
   * been destroyed.
   */
  public Body body() {
    return request.body;
  }

  /** Returns the material by which it broke; {@code null} for a cut. */
  public Material material() {
    return request.material;
  }

  /** Returns the impulse of the blow, N s; 0 for a cut. */
  public float intensity() {
    return request.intensity;
  }

  /** Returns where the hardest blow struck, in the frame of the body, m, as a new vector. */
  public Vec2 point() {
    return request.hardest().point.clone();
  }

  /**
   * Returns the sites whose Voronoi cells it broke along, in the frame of the body, m, as new
   * vectors; none for a cut, or where a body came loose as a whole.
   */
  public List<Vec2> sites() {
    List<Vec2> sites = new ArrayList<>(plan.sites.length / 2);
    for (int i = 0; i < plan.sites.length; i += 2) {
      sites.add(new Vec2((float) plan.sites[i], (float) plan.sites[i + 1]));
    }
    return sites;
  }

  /**
   * Returns the outlines of the regions in which cells broke away, one for each blow, in the frame
   * of the body, m, as new vectors; none where there are no {@link #sites()}.
   */
  public List<Vec2[]> regions() {
    List<Vec2[]> outlines = new ArrayList<>(plan.regions.size());
    for (ImpactRegion region : plan.regions) {
      double[] xy = region.boundary(REGION_VERTICES);
      Vec2[] outline = new Vec2[REGION_VERTICES];
      for (int i = 0; i < REGION_VERTICES; i++) {
        outline[i] = new Vec2((float) xy[2 * i], (float) xy[2 * i + 1]);
      }
      outlines.add(outline);
    }
    return outlines;
  }

  /**
   * Returns the limit because of which it broke into fewer pieces than its material would have
   * made, or {@code null}.
   */
  public FractureLimit limit() {
    return plan.limit;
  }

  /** Returns the bodies of what stayed. */
  public List<Body> remainders() {
    return remainders;
  }

  /** Returns the bodies of what broke away. */
  public List<Body> splinters() {
    return splinters;
  }

  /**
   * Returns the outlines of the pieces of a body, in the frame of the old body, which is its own
   * too: for each piece its outer ring, counter-clockwise, then its holes, clockwise. With it a
   * game can map the texture of the old body onto the pieces. Empty for fixtures that have never
   * broken.
   */
  public static List<List<Vec2[]>> outlinesOf(Body body) {
    List<List<Vec2[]>> outlines = new ArrayList<>();
    List<Piece> seen = new ArrayList<>();
    for (Fixture f = body.getFixtureList(); f != null; f = f.getNext()) {
      if (f.getCompound() instanceof Piece && !seen.contains((Piece) f.getCompound())) {
        Piece piece = (Piece) f.getCompound();
        seen.add(piece);
        outlines.add(ringsOf(piece.outline));
      }
    }
    return outlines;
  }

  private static List<Vec2[]> ringsOf(Outline outline) {
    List<Vec2[]> rings = new ArrayList<>();
    for (int r = 0; r < outline.ringCount(); r++) {
      Vec2[] ring = new Vec2[outline.ringEnd(r) - outline.ringStart(r)];
      for (int i = 0; i < ring.length; i++) {
        int v = outline.ringStart(r) + i;
        ring[i] = new Vec2((float) outline.x(v), (float) outline.y(v));
      }
      rings.add(ring);
    }
    return rings;
  }
}
