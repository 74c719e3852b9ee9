package org.jbox2d.dynamics;

import org.jbox2d.dynamics.contacts.ContactEdge;
import org.jbox2d.dynamics.joints.Joint;
import org.jbox2d.dynamics.joints.JointDef;
import org.jbox2d.dynamics.joints.JointEdge;
import org.jbox2d.dynamics.joints.JointType;

/** The joints of a world: its list of them, and each body's. */
final class WorldJoints {
  /** The newest joint. */
  Joint list;

  int count;

  private final World world;

  WorldJoints(World world) {
    this.world = world;
  }

  /** See {@link World#createJoint}. */
  Joint create(JointDef def) {
    if (def.type != JointType.GEAR) {
      world.checkBody(def.bodyA, "JointDef.bodyA");
      world.checkBody(def.bodyB, "JointDef.bodyB");
    }
    Joint j = Joint.create(world, def);
    // A gear takes its bodies from the joints it couples.
    Body a = j.getBodyA();
    Body b = j.getBodyB();
    world.checkBody(a, "Joint.bodyA");
    j.m_next = list;
    if (list != null) {
      list.m_prev = j;
    }
    list = j;
    count++;
    link(j, j.m_edgeA, a, b);
    if (a != b) {
      link(j, j.m_edgeB, b, a);
    }
    if (!j.getCollideConnected()) {
      flagContactsBetween(a, b);
    }
    return j;
  }

  /** See {@link World#destroyJoint}. */
  void destroy(Joint joint) {
    if (joint.m_edgeA.joint != joint || joint.getBodyA().m_world != world) {
      throw new IllegalArgumentException("joint is not of this world, or was destroyed before");
    }
    if (joint.m_prev != null) {
      joint.m_prev.m_next = joint.m_next;
    } else {
      list = joint.m_next;
    }
    if (joint.m_next != null) {
      joint.m_next.m_prev = joint.m_prev;
    }
    Body a = joint.getBodyA();
    Body b = joint.getBodyB();
    a.setAwake(true);
    b.setAwake(true);
    unlink(joint.m_edgeA, a);
    if (a != b) {
      unlink(joint.m_edgeB, b);
    }
    joint.m_edgeA.joint = null;
    joint.m_edgeB.joint = null;
    joint.m_prev = null;
    joint.m_next = null;
    Joint.destroy(joint);
    count--;
    if (!joint.getCollideConnected()) {
      // Their bounds may overlap already, and must be met as if new.
      BodyContacts.touchProxies(a);
      BodyContacts.touchProxies(b);
    }
  }

  /** See {@link World#moveJoint}. */
  void move(Joint joint, Body from, Body to) {
    boolean atA = joint.getBodyA() == from;
    if (!atA && joint.getBodyB() != from) {
      throw new IllegalArgumentException("joint does not hold the body it is to be moved from");
    }
    JointEdge edge = atA ? joint.m_edgeA : joint.m_edgeB;
    Body other = atA ? joint.getBodyB() : joint.getBodyA();
    unlink(edge, from);
    joint.replaceBody(from, to);
    link(joint, edge, to, other);
    (atA ? joint.m_edgeB : joint.m_edgeA).other = to;
    from.setAwake(true);
    to.setAwake(true);
  }

  private void link(Joint j, JointEdge edge, Body body, Body other) {
    world.awake.changes++;
    edge.joint = j;
    edge.other = other;
    edge.prev = null;
    edge.next = body.m_jointList;
    if (body.m_jointList != null) {
      body.m_jointList.prev = edge;
    }
    body.m_jointList = edge;
  }

  private void unlink(JointEdge edge, Body body) {
    world.awake.changes++;
    if (edge.prev != null) {
      edge.prev.next = edge.next;
    } else {
      body.m_jointList = edge.next;
    }
    if (edge.next != null) {
      edge.next.prev = edge.prev;
    }
    edge.prev = null;
    edge.next = null;
  }

  private void flagContactsBetween(Body a, Body b) {
    for (ContactEdge edge = b.m_contactList; edge != null; edge = edge.next) {
      if (edge.other == a) {
        edge.contact.flagForFiltering();
        world.wakeForFiltering(edge.contact);
      }
    }
  }
}
