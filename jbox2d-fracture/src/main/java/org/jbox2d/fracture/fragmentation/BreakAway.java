package org.jbox2d.fracture.fragmentation;

import java.util.Arrays;
import java.util.List;
import org.jbox2d.fracture.geometry.Outline;
import org.jbox2d.fracture.geometry.Predicates;
import org.jbox2d.fracture.geometry.Segments;

/**
 * Chooses the groups of pieces that break away (thesis, section 5.2). For each region of effect:
 *
 * <ol>
 *   <li>a group is <em>hit</em> if the region covers more than half of its area;
 *   <li>breadth first from the group at the contact point over common edges, hit groups are reached
 *       from hit groups; if the outline is not convex, only across edges whose middle is visible
 *       from the contact point, on a straight line inside the outline.
 * </ol>
 *
 * So what breaks away for one region is connected with the contact, and what is hidden behind a
 * concavity stays.
 */
final class BreakAway {
  private static final int NONE = -1;

  /**
   * Edges this near to the nearest one, relative to the extent of the outline, touch the contact as
   * well.
   */
  private static final double CONTACT_TOLERANCE = 1e-6;

  private PlanarMap map;
  private PieceGroups groups;
  private double[] xy;
  private Outline outline;
  private boolean[] breaks = new boolean[0];
  private boolean[] hit = new boolean[0];
  private int[] queue = new int[0];
  private int[] groupOfPiece = new int[0];
  private double[] ring = new double[64];
  private double[] overlap = new double[0];
  private double[] area = new double[0];

  /** For each group, by its number, whether it breaks away; valid until the next call. */
  boolean[] choose(
      PlanarMap planarMap,
      PieceGroups pieceGroups,
      RingTracer tracer,
      List<? extends RegionOfEffect> regions,
      double[] coordinates,
      Outline body) {
    map = planarMap;
    groups = pieceGroups;
    xy = coordinates;
    outline = body;
    int pieces = groups.pieceCount();
    ensure(pieces);
    Arrays.fill(breaks, 0, pieces, regions.isEmpty());
    if (regions.isEmpty()) {
      return breaks;
    }
    for (int p = 0; p < pieces; p++) {
      groupOfPiece[p] = groups.group(p);
    }
    tracer.trace(map, groupOfPiece, pieces, outline.vertexCount());
    boolean convex = isConvex();
    for (RegionOfEffect region : regions) {
      findHit(region, tracer);
      reach(region, convex);
    }
    return breaks;
  }

  private void ensure(int pieces) {
    if (breaks.length < pieces) {
      int size = 2 * pieces;
      breaks = new boolean[size];
      hit = new boolean[size];
      queue = new int[size];
      groupOfPiece = new int[size];
      overlap = new double[size];
      area = new double[size];
    }
  }

  private boolean isConvex() {
    if (outline.ringCount() > 1) {
      return false;
    }
    int n = outline.vertexCount();
    for (int i = 0; i < n; i++) {
      if (Predicates.orientation(outline.coordinates(), i, (i + 1) % n, (i + 2) % n) < 0) {
        return false;
      }
    }
    return true;
  }

  private void findHit(RegionOfEffect region, RingTracer tracer) {
    Arrays.fill(overlap, 0, groups.pieceCount(), 0);
    Arrays.fill(area, 0, groups.pieceCount(), 0);
    for (int r = 0; r < tracer.ringCount(); r++) {
      int size = copyRing(tracer, r);
      int group = tracer.ringClass(r);
      area[group] += org.jbox2d.fracture.geometry.Rings.signedArea(ring, 0, size);
      if (boxesOverlap(size, region)) {
        overlap[group] += region.overlap(ring, 0, size);
      }
    }
    for (int g = 0; g < groups.pieceCount(); g++) {
      hit[g] = overlap[g] > 0.5 * area[g];
    }
  }

  private int copyRing(RingTracer tracer, int r) {
    int size = tracer.ringEnd(r) - tracer.ringStart(r);
    if (ring.length < 2 * size) {
      ring = new double[4 * size];
    }
    for (int i = 0; i < size; i++) {
      int node = tracer.node(tracer.ringStart(r) + i);
      ring[2 * i] = xy[2 * node];
      ring[2 * i + 1] = xy[2 * node + 1];
    }
    return size;
  }

  private boolean boxesOverlap(int size, RegionOfEffect region) {
    double minX = Double.POSITIVE_INFINITY;
    double minY = Double.POSITIVE_INFINITY;
    double maxX = Double.NEGATIVE_INFINITY;
    double maxY = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < size; i++) {
      minX = Math.min(minX, ring[2 * i]);
      maxX = Math.max(maxX, ring[2 * i]);
      minY = Math.min(minY, ring[2 * i + 1]);
      maxY = Math.max(maxY, ring[2 * i + 1]);
    }
    return minX < region.maxX()
        && maxX > region.minX()
        && minY < region.maxY()
        && maxY > region.minY();
  }

  // ---- from the contact inwards ----

  private void reach(RegionOfEffect region, boolean convex) {
    int end = enqueueContact(region);
    for (int k = 0; k < end; k++) {
      for (int p = queue[k]; p != NONE; p = groups.nextMember(p)) {
        for (int i = groups.edgeStart(p); i < groups.edgeEnd(p); i++) {
          int h = groups.edge(i);
          int across = groups.acrossGroup(h);
          if (across != NONE && hit[across] && (convex || isVisible(h, region))) {
            hit[across] = false;
            breaks[across] = true;
            queue[end++] = across;
          }
        }
      }
    }
  }

  /**
   * Queues the hit groups at the contact point, or, if none there is hit, the hit ones next to
   * them.
   */
  private int enqueueContact(RegionOfEffect region) {
    double nearest = Double.POSITIVE_INFINITY;
    for (int h = 0; h < map.halfEdgeCount(); h++) {
      if (touchesContact(h, region)) {
        nearest = Math.min(nearest, distance(h, region));
      }
    }
    double reach = nearest + CONTACT_TOLERANCE * extent();
    int end = 0;
    for (int pass = 0; pass < 2 && end == 0; pass++) {
      for (int h = 0; h < map.halfEdgeCount(); h++) {
        if (touchesContact(h, region) && distance(h, region) <= reach) {
          int own = groups.group(map.piece(h));
          end = pass == 0 ? enqueue(own, end) : enqueueNeighbours(own, end);
        }
      }
    }
    return end;
  }

  private int enqueue(int group, int end) {
    if (!hit[group]) {
      return end;
    }
    hit[group] = false;
    breaks[group] = true;
    queue[end] = group;
    return end + 1;
  }

  private int enqueueNeighbours(int group, int queued) {
    int end = queued;
    for (int p = group; p != NONE; p = groups.nextMember(p)) {
      for (int i = groups.edgeStart(p); i < groups.edgeEnd(p); i++) {
        int across = groups.acrossGroup(groups.edge(i));
        if (across != NONE) {
          end = enqueue(across, end);
        }
      }
    }
    return end;
  }

  /**
   * Whether h bounds a piece that has the contact on its side: always for the outline, left of h
   * for a cut.
   */
  private boolean touchesContact(int h, RegionOfEffect region) {
    if (map.isUnused(h) || map.piece(h) == NONE) {
      return false;
    }
    int a = map.origin(h);
    int b = map.destination(h);
    return map.outlineEdge(h) != NONE
        || Predicates.orientation(
                xy[2 * a],
                xy[2 * a + 1],
                xy[2 * b],
                xy[2 * b + 1],
                region.contactX(),
                region.contactY())
            >= 0;
  }

  private double distance(int h, RegionOfEffect region) {
    return Math.sqrt(
        Segments.distanceSquared(
            xy, map.origin(h), map.destination(h), region.contactX(), region.contactY()));
  }

  private double extent() {
    double minX = outline.x(0);
    double maxX = minX;
    for (int i = 1; i < outline.ringEnd(0); i++) {
      minX = Math.min(minX, outline.x(i));
      maxX = Math.max(maxX, outline.x(i));
    }
    return maxX - minX;
  }

  /**
   * Whether the middle of h is seen from the contact point: no edge of the outline crosses the line
   * between them.
   */
  private boolean isVisible(int h, RegionOfEffect region) {
    int a = map.origin(h);
    int b = map.destination(h);
    double mx = 0.5 * (xy[2 * a] + xy[2 * b]);
    double my = 0.5 * (xy[2 * a + 1] + xy[2 * b + 1]);
    for (int r = 0; r < outline.ringCount(); r++) {
      int last = outline.ringEnd(r) - 1;
      for (int i = outline.ringStart(r); i < outline.ringEnd(r); i++) {
        if (crosses(last, i, region.contactX(), region.contactY(), mx, my)) {
          return false;
        }
        last = i;
      }
    }
    return true;
  }

  private boolean crosses(int i, int j, double px, double py, double qx, double qy) {
    double ax = outline.x(i);
    double ay = outline.y(i);
    double bx = outline.x(j);
    double by = outline.y(j);
    return Predicates.orientation(ax, ay, bx, by, px, py)
                * Predicates.orientation(ax, ay, bx, by, qx, qy)
            < 0
        && Predicates.orientation(px, py, qx, qy, ax, ay)
                * Predicates.orientation(px, py, qx, qy, bx, by)
            < 0;
  }
}
