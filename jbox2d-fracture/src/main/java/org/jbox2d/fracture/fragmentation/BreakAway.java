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
  private double[] overlap = new double[0];

  /** For each half-edge the group on its left, {@link #NONE} outside and for unused ones. */
  private int[] groupLeft = new int[0];

  /** For each half-edge the square of its distance from the contact. */
  private double[] squaredDistance = new double[0];

  /**
   * For each group, by its number, whether it breaks away; valid until the next call.
   *
   * @param coordinates of the nodes, in those of the outline
   * @param unitArea area, in the outline's coordinates, of the square of the map's unit
   */
  boolean[] choose(
      PlanarMap planarMap,
      PieceGroups pieceGroups,
      List<? extends RegionOfEffect> regions,
      double[] coordinates,
      Outline body,
      double unitArea) {
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
    for (int h = 0; h < map.halfEdgeCount(); h++) {
      int piece = map.piece(h);
      groupLeft[h] = piece == NONE ? NONE : groups.group(piece);
    }
    boolean convex = isConvex();
    for (RegionOfEffect region : regions) {
      findHit(region, unitArea);
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
      overlap = new double[size];
    }
    if (groupLeft.length < map.halfEdgeCount()) {
      int size = map.halfEdgeCount() + map.halfEdgeCount() / 2;
      groupLeft = new int[size];
      squaredDistance = new double[size / 2 + 1];
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

  /** Adds up the region's overlap with each group, an edge at a time for both of its sides. */
  private void findHit(RegionOfEffect region, double unitArea) {
    Arrays.fill(overlap, 0, groups.pieceCount(), 0);
    for (int h = 0; h < map.halfEdgeCount(); h += 2) {
      int left = groupLeft[h];
      int right = groupLeft[h + 1];
      if (left != right) {
        int a = 2 * map.origin(h);
        int b = 2 * map.origin(h + 1);
        double common = region.overlap(xy[a], xy[a + 1], xy[b], xy[b + 1]);
        if (left != NONE) {
          overlap[left] += common;
        }
        if (right != NONE) {
          overlap[right] -= common;
        }
      }
    }
    for (int g = 0; g < groups.pieceCount(); g++) {
      hit[g] = overlap[g] > 0.5 * unitArea * groups.area(g);
    }
  }

  // ---- from the contact inwards ----

  private void reach(RegionOfEffect region, boolean convex) {
    int end = enqueueContact(region);
    for (int k = 0; k < end; k++) {
      for (int p = queue[k]; p != NONE; p = groups.nextMember(p)) {
        for (int i = groups.edgeStart(p); i < groups.edgeEnd(p); i++) {
          int h = groups.edge(i);
          int across = groupLeft[h ^ 1];
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
    for (int h = 0; h < map.halfEdgeCount(); h += 2) {
      double distance = squaredDistance(h, region);
      squaredDistance[h >> 1] = distance;
      if (distance < nearest && (touchesContact(h, region) || touchesContact(h + 1, region))) {
        nearest = distance;
      }
    }
    double reach = Math.sqrt(nearest) + CONTACT_TOLERANCE * extent();
    int end = 0;
    for (int pass = 0; pass < 2 && end == 0; pass++) {
      for (int h = 0; h < map.halfEdgeCount(); h++) {
        if (squaredDistance[h >> 1] <= reach * reach && touchesContact(h, region)) {
          int own = groupLeft[h];
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
        int across = groupLeft[groups.edge(i) ^ 1];
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
    if (groupLeft[h] == NONE) {
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

  private double squaredDistance(int h, RegionOfEffect region) {
    return Segments.distanceSquared(
        xy, map.origin(h), map.destination(h), region.contactX(), region.contactY());
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
    boolean apart =
        Math.max(ax, bx) < Math.min(px, qx)
            || Math.max(px, qx) < Math.min(ax, bx)
            || Math.max(ay, by) < Math.min(py, qy)
            || Math.max(py, qy) < Math.min(ay, by);
    return !apart
        && Predicates.orientation(ax, ay, bx, by, px, py)
                * Predicates.orientation(ax, ay, bx, by, qx, qy)
            < 0
        && Predicates.orientation(px, py, qx, qy, ax, ay)
                * Predicates.orientation(px, py, qx, qy, bx, by)
            < 0;
  }
}
