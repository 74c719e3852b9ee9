package org.jbox2d.fracture.assembly;

import java.util.ArrayList;
import java.util.List;
import org.jbox2d.collision.Distance;
import org.jbox2d.collision.Distance.SimplexCache;
import org.jbox2d.collision.DistanceInput;
import org.jbox2d.collision.DistanceOutput;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.Settings;
import org.jbox2d.dynamics.Fixture;

/**
 * Finds what still hangs together: remainders and the body's other fixtures are joined where they
 * touch. Other fixtures that touched nothing even before, held to the body by being of it, stay
 * with the largest part.
 */
final class Clusters {
  /**
   * Shapes this many slops apart still count as touching: fixtures of one body are seldom placed
   * exactly edge to edge.
   */
  private static final float TOUCHING_SLOPS = 2f;

  private final List<Cluster> nodes = new ArrayList<>();
  private final List<Shape[]> shapes = new ArrayList<>();
  private final Distance distance = new Distance();
  private final SimplexCache cache = new SimplexCache();
  private final DistanceInput input = new DistanceInput();
  private final DistanceOutput output = new DistanceOutput();

  private Clusters() {
    input.useRadii = false;
  }

  static List<Cluster> of(Plan plan) {
    if (plan.breakable.fixtures.size() == plan.request.body.m_fixtureCount) {
      return apart(plan);
    }
    return new Clusters().find(plan);
  }

  /** If all of the body broke, each remainder is a cluster. */
  private static List<Cluster> apart(Plan plan) {
    List<Cluster> clusters = new ArrayList<>(plan.remainders.size());
    for (Piece remainder : plan.remainders) {
      Cluster cluster = new Cluster();
      cluster.remainders.add(remainder);
      clusters.add(cluster);
    }
    largestFirst(clusters, plan.request.fixture.getDensity());
    return clusters;
  }

  /**
   * Returns the cluster of the largest mass, the first of several, or {@code null} if there is
   * none.
   */
  static Cluster largest(List<Cluster> clusters) {
    return clusters.isEmpty() ? null : clusters.get(0);
  }

  private List<Cluster> find(Plan plan) {
    for (Piece remainder : plan.remainders) {
      Cluster node = new Cluster();
      node.remainders.add(remainder);
      nodes.add(node);
      shapes.add(remainder.getParts());
    }
    for (List<Fixture> group : otherGroups(plan)) {
      Cluster node = new Cluster();
      node.others.add(group);
      nodes.add(node);
      shapes.add(shapesOf(group));
    }
    List<Cluster> clusters = unite();
    largestFirst(clusters, plan.request.fixture.getDensity());
    gatherLoose(clusters, plan);
    return clusters;
  }

  private static List<List<Fixture>> otherGroups(Plan plan) {
    List<List<Fixture>> groups = new ArrayList<>();
    for (Fixture f = plan.request.body.getFixtureList(); f != null; f = f.getNext()) {
      if (!plan.breakable.fixtures.contains(f)) {
        groupOf(f, groups).add(f);
      }
    }
    return groups;
  }

  private static List<Fixture> groupOf(Fixture f, List<List<Fixture>> groups) {
    if (f.getCompound() != null) {
      for (List<Fixture> group : groups) {
        if (group.get(0).getCompound() == f.getCompound()) {
          return group;
        }
      }
    }
    List<Fixture> group = new ArrayList<>();
    groups.add(group);
    return group;
  }

  private static Shape[] shapesOf(List<Fixture> group) {
    Shape[] out = new Shape[group.size()];
    for (int i = 0; i < out.length; i++) {
      out[i] = group.get(i).getShape();
    }
    return out;
  }

  private List<Cluster> unite() {
    int n = nodes.size();
    List<Cluster> clusters = new ArrayList<>();
    boolean[] seen = new boolean[n];
    List<Integer> open = new ArrayList<>();
    for (int start = 0; start < n; start++) {
      if (seen[start]) {
        continue;
      }
      Cluster cluster = new Cluster();
      clusters.add(cluster);
      seen[start] = true;
      open.add(start);
      while (!open.isEmpty()) {
        int i = open.remove(open.size() - 1);
        cluster.remainders.addAll(nodes.get(i).remainders);
        cluster.others.addAll(nodes.get(i).others);
        for (int j = 0; j < n; j++) {
          if (!seen[j] && touch(i, j)) {
            seen[j] = true;
            open.add(j);
          }
        }
      }
    }
    return clusters;
  }

  /** Remainders of one fracture are apart by construction: they share a vertex at most. */
  private boolean touch(int i, int j) {
    if (!nodes.get(i).remainders.isEmpty() && !nodes.get(j).remainders.isEmpty()) {
      return false;
    }
    for (Shape a : shapes.get(i)) {
      for (Shape b : shapes.get(j)) {
        if (touch(a, b)) {
          return true;
        }
      }
    }
    return false;
  }

  private boolean touch(Shape a, Shape b) {
    for (int k = 0; k < a.getChildCount(); k++) {
      for (int l = 0; l < b.getChildCount(); l++) {
        input.proxyA.set(a, k);
        input.proxyB.set(b, l);
        cache.count = 0;
        distance.distance(output, cache, input);
        float reach = radius(a) + radius(b) + TOUCHING_SLOPS * Settings.linearSlop;
        if (output.distance <= reach) {
          return true;
        }
      }
    }
    return false;
  }

  /** The radius of a circle is its extent; that of a polygon is only its skin. */
  private static float radius(Shape shape) {
    return shape instanceof CircleShape ? shape.m_radius : 0f;
  }

  private static void largestFirst(List<Cluster> clusters, float density) {
    int best = 0;
    for (int i = 1; i < clusters.size(); i++) {
      if (clusters.get(i).mass(density) > clusters.get(best).mass(density)) {
        best = i;
      }
    }
    if (best > 0) {
      clusters.add(0, clusters.remove(best));
    }
  }

  /**
   * Clusters without a remainder that did not touch what broke are loose only in appearance; they
   * stay with the largest.
   */
  private void gatherLoose(List<Cluster> clusters, Plan plan) {
    for (int i = clusters.size() - 1; i > 0; i--) {
      Cluster cluster = clusters.get(i);
      if (cluster.remainders.isEmpty() && !touchedBroken(cluster, plan)) {
        clusters.get(0).others.addAll(cluster.others);
        clusters.remove(i);
      }
    }
  }

  private boolean touchedBroken(Cluster cluster, Plan plan) {
    for (List<Fixture> group : cluster.others) {
      for (Fixture f : group) {
        for (Fixture broken : plan.breakable.fixtures) {
          if (touch(f.getShape(), broken.getShape())) {
            return true;
          }
        }
      }
    }
    return false;
  }
}
