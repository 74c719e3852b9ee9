package org.jbox2d.fracture.assembly;

import java.util.ArrayList;
import java.util.List;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.dynamics.joints.Joint;
import org.jbox2d.dynamics.joints.JointEdge;

/** Finds the piece of a broken body that holds a joint's anchor. */
final class AnchorSearch {
  private final Body old;
  private final Cluster kept;
  private final Plan plan;
  private final List<Cluster> clusters;
  private final List<Body> made;

  /**
   * A search.
   *
   * @param made the bodies of all clusters but the kept one, in their order, then those of the
   *     splinters
   */
  AnchorSearch(Body old, Cluster kept, Plan plan, List<Cluster> clusters, List<Body> made) {
    this.old = old;
    this.kept = kept;
    this.plan = plan;
    this.clusters = clusters;
    this.made = made;
  }

  /** Returns a body's joints, as a list that stays as it is while they are moved. */
  List<Joint> jointsOf(Body body) {
    List<Joint> joints = new ArrayList<>();
    for (JointEdge edge = body.getJointList(); edge != null; edge = edge.next) {
      joints.add(edge.joint);
    }
    return joints;
  }

  /**
   * Returns the new body that holds the anchor, or {@code null} if the joint stays with the old
   * one.
   */
  Body bodyAtAnchor(Joint joint) {
    Vec2 anchor = new Vec2();
    if (joint.getBodyA() == old) {
      joint.getAnchorA(anchor);
    } else {
      joint.getAnchorB(anchor);
    }
    Vec2 p = old.getLocalPoint(anchor);
    int index = 0;
    for (Cluster cluster : clusters) {
      if (cluster == kept) {
        if (holds(cluster, p, anchor)) {
          return null;
        }
        continue;
      }
      if (holds(cluster, p, anchor)) {
        return made.get(index);
      }
      index++;
    }
    for (Piece splinter : plan.splinters) {
      if (splinter.contains(p.x, p.y)) {
        return made.get(index);
      }
      index++;
    }
    return null;
  }

  private static boolean holds(Cluster cluster, Vec2 local, Vec2 world) {
    for (Piece piece : cluster.remainders) {
      if (piece.contains(local.x, local.y)) {
        return true;
      }
    }
    for (List<Fixture> group : cluster.others) {
      for (Fixture f : group) {
        if (f.testPoint(world)) {
          return true;
        }
      }
    }
    return false;
  }
}
