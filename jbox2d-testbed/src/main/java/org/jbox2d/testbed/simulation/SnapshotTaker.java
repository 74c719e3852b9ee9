package org.jbox2d.testbed.simulation;

import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.Map;
import org.jbox2d.collision.AABB;
import org.jbox2d.collision.WorldManifold;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.dynamics.World;
import org.jbox2d.dynamics.contacts.Contact;
import org.jbox2d.dynamics.joints.Joint;

/**
 * Takes snapshots of one run, on the thread that steps it. Outlines are kept from one snapshot to
 * the next, so that a snapshot costs little more than a copy of the transforms.
 */
public final class SnapshotTaker {
  private static final float[] NONE = {};

  private final Simulation simulation;
  private final Vec2 anchor = new Vec2();
  private final WorldManifold manifold = new WorldManifold();
  private Map<Body, BodyOutline> known = new IdentityHashMap<>();
  private Map<Body, BodyOutline> seen = new IdentityHashMap<>();
  private int nextId;
  private boolean withBoxes;
  private boolean withContacts = true;

  /** Takes snapshots of the given run. */
  public SnapshotTaker(Simulation simulation) {
    this.simulation = simulation;
  }

  /** Sets whether snapshots have the boxes of the broad phase, which are many. */
  public void setWithBoxes(boolean with) {
    withBoxes = with;
  }

  /** Sets whether snapshots have the points of contact, which are more than all else together. */
  public void setWithContacts(boolean with) {
    withContacts = with;
  }

  /**
   * Gives new bodies their numbers, as {@link #take} does. Bodies have the same numbers in two runs
   * if in both one or the other is called after each step and each input.
   */
  public void note() {
    for (Body b = simulation.world().getBodyList(); b != null; b = b.getNext()) {
      outlineOf(b);
    }
    forgetUnseen();
  }

  /** Returns the state as it is now. */
  public Snapshot take() {
    World world = simulation.world();
    int n = world.getBodyCount();
    BodyOutline[] outlines = new BodyOutline[n];
    float[] transforms = new float[Snapshot.STRIDE * n];
    boolean[] awake = new boolean[n];
    float[] centres = new float[Snapshot.CENTRE * n];
    // The list has the newest first; painted in this order, the oldest lie at the bottom.
    int i = n;
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      i--;
      outlines[i] = outlineOf(b);
      awake[i] = b.isAwake();
      transforms[Snapshot.STRIDE * i] = b.m_xf.p.x;
      transforms[Snapshot.STRIDE * i + 1] = b.m_xf.p.y;
      transforms[Snapshot.STRIDE * i + 2] = b.m_xf.q.c;
      transforms[Snapshot.STRIDE * i + 3] = b.m_xf.q.s;
      centres[Snapshot.CENTRE * i] = b.getWorldCenter().x;
      centres[Snapshot.CENTRE * i + 1] = b.getWorldCenter().y;
    }
    forgetUnseen();
    return new Snapshot(
        simulation.counts(),
        outlines,
        transforms,
        awake,
        jointLines(world),
        withContacts ? contacts(world) : NONE,
        centres,
        withBoxes ? boxes(world) : NONE,
        simulation.lastFracture(),
        simulation.hash());
  }

  private BodyOutline outlineOf(Body body) {
    BodyOutline outline = known.get(body);
    if (outline == null) {
      outline = new BodyOutline(nextId++, body);
    } else if (!outline.isOf(body)) {
      outline = new BodyOutline(outline.id, body);
    }
    seen.put(body, outline);
    return outline;
  }

  private void forgetUnseen() {
    Map<Body, BodyOutline> last = known;
    known = seen;
    seen = last;
    seen.clear();
  }

  private float[] jointLines(World world) {
    float[] lines = new float[Snapshot.LINE * world.getJointCount()];
    int at = 0;
    for (Joint j = world.getJointList(); j != null; j = j.getNext()) {
      j.getAnchorA(anchor);
      lines[at++] = anchor.x;
      lines[at++] = anchor.y;
      j.getAnchorB(anchor);
      lines[at++] = anchor.x;
      lines[at++] = anchor.y;
    }
    return lines;
  }

  private static float[] boxes(World world) {
    float[] boxes = new float[Snapshot.BOX * world.getProxyCount()];
    int at = 0;
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      for (Fixture f = b.getFixtureList(); f != null && b.isActive(); f = f.getNext()) {
        for (int child = 0; child < f.getShape().getChildCount(); child++) {
          AABB box = f.getAABB(child);
          boxes[at++] = box.lowerBound.x;
          boxes[at++] = box.lowerBound.y;
          boxes[at++] = box.upperBound.x;
          boxes[at++] = box.upperBound.y;
        }
      }
    }
    return Arrays.copyOf(boxes, at);
  }

  private float[] contacts(World world) {
    // A contact has two points at most.
    float[] points = new float[Snapshot.CONTACT * 2 * world.getContactCount()];
    int at = 0;
    for (Contact c = world.getContactList(); c != null; c = c.getNext()) {
      if (!c.isTouching()) {
        continue;
      }
      c.getWorldManifold(manifold);
      for (int i = 0; i < c.getManifold().pointCount; i++) {
        float impulse = c.getManifold().points[i].normalImpulse;
        points[at++] = manifold.points[i].x;
        points[at++] = manifold.points[i].y;
        points[at++] = impulse * manifold.normal.x;
        points[at++] = impulse * manifold.normal.y;
      }
    }
    return Arrays.copyOf(points, at);
  }
}
