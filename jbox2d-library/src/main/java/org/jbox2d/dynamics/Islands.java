package org.jbox2d.dynamics;

import java.util.Arrays;
import org.jbox2d.dynamics.contacts.Contact;
import org.jbox2d.dynamics.joints.Joint;
import org.jbox2d.dynamics.joints.JointEdge;
import org.jbox2d.dynamics.solver.JointKernels;

/**
 * Divides what moves into islands: bodies that are joined by touching contacts or joints, not
 * counting ways through static bodies. Islands are found anew each step by a disjoint-set forest
 * (Tarjan 1975; path halving, union by index so that the root is the first body of the island),
 * which costs about one visit of each contact.
 *
 * <p>An awake body wakes what it touches; so while contacts are linked, both the set of awake
 * bodies and the array of active contacts may grow.
 *
 * <p>The result lists contacts and joints grouped by island, islands numbered by their first body.
 */
final class Islands {
  /** Least number of contacts, or of joints of a kernel, that are dealt: a few for each part. */
  private static final int LEAST_DEALT = 64;

  /** Parts into which the joints of a kernel are dealt; with more it gets no faster. */
  private static final int JOINT_PARTS = 3;

  int count;

  /** Island of each slot. */
  int[] islandOf = new int[64];

  /**
   * Contacts to solve, grouped: those of island k are {@code [contactStart[k], contactStart[k +
   * 1])}.
   */
  Contact[] contacts = new Contact[64];

  int[] contactStart = new int[65];
  int contactCount;

  /** Slots grouped: those of island k are {@code [bodyStart[k], bodyStart[k + 1])}. */
  int[] bodies = new int[64];

  int[] bodyStart = new int[65];

  /** Whether a fixture of these contacts has a material. */
  boolean materials;

  /** Joints to solve, grouped like the contacts; within an island by kernel. */
  Joint[] joints = new Joint[16];

  int[] jointStart = new int[65];
  int jointCount;

  /** Bodies of these joints that do not move; one may occur several times. */
  Body[] stillBodies = new Body[16];

  int stillCount;

  /** Rises when joints, and what does not move of their bodies, are looked for anew. */
  int jointBuilds;

  private int slots;
  private int[] parent = new int[64];
  private Contact[] foundContacts = new Contact[64];

  /** A slot of each contact found; its complement if the other body does not move by itself. */
  private int[] foundContactSlot = new int[64];

  private Joint[] foundJoints = new Joint[16];
  private int[] foundJointSlot = new int[16];

  /** Kernels of the joints found. */
  private int[] foundJointKernel = new int[16];

  /** The sets of bodies that joints alone make, as of {@link AwakeSet#changes}. */
  private int[] jointParent = new int[64];

  private int jointChanges;

  /** Where the joints of each island and kernel begin, and how many have got their place. */
  private int[] jointKeyStart = new int[64];

  private int[] jointPlaced = new int[64];

  /** Contacts of each island between bodies that both move, and those that have got their place. */
  private int[] loose = new int[64];

  private int[] placed = new int[64];

  /** Contacts of each large island with bodies that do not move that have got their place. */
  private int[] held = new int[64];

  void build(AwakeSet awake, ContactManager manager) {
    if (!buildWithSameJoints(awake, manager)) {
      buildAnew(awake, manager);
    }
    number(awake.count);
    groupContacts();
    groupJoints();
    slots = awake.count;
  }

  /**
   * Links what is awake as joints did in the last step, and contacts on top of that; returns
   * whether that served.
   */
  private boolean buildWithSameJoints(AwakeSet awake, ContactManager manager) {
    if (jointCount == 0 || awake.changes != jointChanges) {
      return false;
    }
    contactCount = 0;
    materials = false;
    System.arraycopy(jointParent, 0, parent, 0, awake.count);
    for (int i = 0; i < manager.activeCount; i++) {
      if (!manager.apart[i]) {
        linkContact(manager.active[i]);
      }
    }
    // A body that a contact has woken may have joints.
    return awake.changes == jointChanges;
  }

  private void buildAnew(AwakeSet awake, ContactManager manager) {
    Arrays.fill(foundJoints, 0, jointCount, null);
    Arrays.fill(joints, 0, Math.min(joints.length, jointCount), null);
    Arrays.fill(stillBodies, 0, stillCount, null);
    jointBuilds++;
    contactCount = 0;
    jointCount = 0;
    stillCount = 0;
    materials = false;
    int linkedBodies = 0;
    int linkedContacts = 0;
    initSets(0, awake.count);
    while (linkedBodies < awake.count || linkedContacts < manager.activeCount) {
      for (; linkedBodies < awake.count; linkedBodies++) {
        linkJoints(awake.bodies[linkedBodies]);
      }
      if (linkedContacts == 0 && jointCount > 0) {
        keepJointSets(awake);
      }
      for (; linkedContacts < manager.activeCount; linkedContacts++) {
        if (!manager.apart[linkedContacts]) {
          linkContact(manager.active[linkedContacts]);
        }
      }
    }
    for (int i = 0; i < jointCount; i++) {
      foundJoints[i].m_islandFlag = false;
    }
  }

  /** Notes the sets that joints alone make. */
  private void keepJointSets(AwakeSet awake) {
    if (jointParent.length < awake.count) {
      jointParent = new int[parent.length];
    }
    for (int i = 0; i < awake.count; i++) {
      jointParent[i] = find(i);
    }
    jointChanges = awake.changes;
  }

  /** Makes each of some bodies a set of its own; {@link #link} does so for those it wakes. */
  private void initSets(int from, int to) {
    if (to > parent.length) {
      parent = Arrays.copyOf(parent, to + (to >> 1));
    }
    for (int i = from; i < to; i++) {
      parent[i] = i;
    }
  }

  private int find(int i) {
    int[] p = parent;
    while (p[i] != i) {
      p[i] = p[p[i]];
      i = p[i];
    }
    return i;
  }

  private void union(int a, int b) {
    int ra = find(a);
    int rb = find(b);
    if (ra < rb) {
      parent[rb] = ra;
    } else {
      parent[ra] = rb;
    }
  }

  private void linkContact(Contact c) {
    int flags = c.m_flags;
    int needed = Contact.TOUCHING_FLAG | Contact.ENABLED_FLAG | Contact.SOLID_FLAG;
    if ((flags & needed) != needed) {
      return;
    }
    int slot = link(c.m_bodyA, -1);
    slot = link(c.m_bodyB, slot);
    if (slot < 0) {
      return;
    }
    if (contactCount == foundContacts.length) {
      foundContacts = Arrays.copyOf(foundContacts, 2 * contactCount);
      foundContactSlot = Arrays.copyOf(foundContactSlot, 2 * contactCount);
    }
    materials |= (flags & Contact.WATCHED_FLAG) != 0;
    foundContacts[contactCount] = c;
    boolean holds = c.m_bodyA.m_type != BodyType.DYNAMIC || c.m_bodyB.m_type != BodyType.DYNAMIC;
    foundContactSlot[contactCount++] = holds ? ~slot : slot;
  }

  private void linkJoints(Body body) {
    for (JointEdge edge = body.m_jointList; edge != null; edge = edge.next) {
      Joint joint = edge.joint;
      if (joint.m_islandFlag || !joint.isActive()) {
        continue;
      }
      int slot = -1;
      for (int i = 0; i < joint.bodyCount(); i++) {
        Body b = joint.body(i);
        slot = link(b, slot);
        if (b.awakeIndex < 0) {
          addStill(b);
        }
      }
      if (slot < 0) {
        continue;
      }
      joint.m_islandFlag = true;
      if (jointCount == foundJoints.length) {
        foundJoints = Arrays.copyOf(foundJoints, 2 * jointCount);
        foundJointSlot = Arrays.copyOf(foundJointSlot, 2 * jointCount);
        foundJointKernel = Arrays.copyOf(foundJointKernel, 2 * jointCount);
      }
      foundJointKernel[jointCount] = joint.kernelOrder();
      foundJoints[jointCount] = joint;
      foundJointSlot[jointCount++] = slot;
    }
  }

  private void addStill(Body body) {
    if (stillCount == stillBodies.length) {
      stillBodies = Arrays.copyOf(stillBodies, 2 * stillCount);
    }
    stillBodies[stillCount++] = body;
  }

  /**
   * Wakes a body that can move and unites its set with that of {@code slot}; returns the slot of
   * either, -1 for neither.
   */
  private int link(Body body, int slot) {
    if (body.awakeIndex < 0) {
      if (body.m_type == BodyType.STATIC) {
        return slot;
      }
      body.setAwake(true);
      initSets(body.awakeIndex, body.awakeIndex + 1);
    }
    if (slot >= 0) {
      union(slot, body.awakeIndex);
    }
    return body.awakeIndex;
  }

  private void number(int n) {
    if (n > islandOf.length) {
      islandOf = new int[n + (n >> 1)];
    }
    count = 0;
    for (int i = 0; i < n; i++) {
      int root = find(i);
      islandOf[i] = root == i ? count++ : islandOf[root];
    }
    if (count + 1 > contactStart.length) {
      contactStart = new int[count + 1 + (count >> 1)];
      jointStart = new int[count + 1 + (count >> 1)];
    }
  }

  /**
   * Counting sort by island; stable but for large ones, in which contacts between moving bodies are
   * {@link #dealt}. Those with what does not move come last there, so that iterations which end too
   * early leave bodies in each other rather than in floors and walls.
   */
  private void groupContacts() {
    if (contacts.length < contactCount) {
      contacts = new Contact[foundContacts.length];
    }
    countContacts();
    for (int i = 0; i < contactCount; i++) {
      boolean holds = foundContactSlot[i] < 0;
      int k = islandOf[slotOf(i)];
      int start = contactStart[k];
      int place;
      if (contactStart[k + 1] - start < LEAST_DEALT) {
        place = placed[k]++;
      } else if (holds) {
        place = loose[k] + held[k]++;
      } else {
        place = dealt(placed[k]++, loose[k], 2);
      }
      contacts[start + place] = foundContacts[i];
    }
  }

  /** Counts the contacts of each island, and those between bodies that both move. */
  private void countContacts() {
    if (placed.length < count) {
      placed = new int[contactStart.length];
      loose = new int[contactStart.length];
      held = new int[contactStart.length];
    }
    Arrays.fill(contactStart, 0, count + 1, 0);
    Arrays.fill(placed, 0, count, 0);
    Arrays.fill(loose, 0, count, 0);
    Arrays.fill(held, 0, count, 0);
    for (int i = 0; i < contactCount; i++) {
      int k = islandOf[slotOf(i)];
      contactStart[k + 1]++;
      loose[k] += foundContactSlot[i] < 0 ? 0 : 1;
    }
    for (int k = 0; k < count; k++) {
      contactStart[k + 1] += contactStart[k];
    }
  }

  private int slotOf(int i) {
    int slot = foundContactSlot[i];
    return slot < 0 ? ~slot : slot;
  }

  /**
   * Place of the i-th of n contacts or joints of a large island.
   *
   * <p>Those made one after the other mostly share a body, so that each would have to wait for what
   * the one before did to it. So they are dealt in a few parts, as even as can be, that take turns:
   * the processor works on one of each at once. In a pyramid of 5,000 boxes sequential impulses
   * take a tenth less time for that, in a net of 10,000 hinges steps a twentieth.
   */
  static int dealt(int i, int n, int parts) {
    int less = n / parts;
    int longer = n % parts;
    int inLonger = longer * (less + 1);
    if (i < inLonger) {
      return i % (less + 1) * parts + i / (less + 1);
    }
    int rest = i - inLonger;
    return rest % less * parts + longer + rest / less;
  }

  /** Whether an island has contacts to solve. */
  boolean hasContacts(int island) {
    return contactStart[island] < contactStart[island + 1];
  }

  /** Whether an island has joints to solve. */
  boolean hasJoints(int island) {
    return jointStart[island] < jointStart[island + 1];
  }

  /** Fills in {@link #bodies}, for solvers that need them; counting sort by island, stable. */
  void groupBodies() {
    if (bodies.length < slots) {
      bodies = new int[islandOf.length];
    }
    if (bodyStart.length < contactStart.length) {
      bodyStart = new int[contactStart.length];
    }
    Arrays.fill(bodyStart, 0, count + 1, 0);
    for (int i = 0; i < slots; i++) {
      bodyStart[islandOf[i]]++;
    }
    sumToEnds(bodyStart, count);
    for (int i = slots - 1; i >= 0; i--) {
      bodies[--bodyStart[islandOf[i]]] = i;
    }
  }

  /** Counting sort by island and kernel; many joints are {@link #dealt}. */
  private void groupJoints() {
    if (jointCount == 0) {
      Arrays.fill(jointStart, 0, count + 1, 0);
      return;
    }
    if (joints.length < jointCount) {
      joints = new Joint[foundJoints.length];
    }
    countJoints(count * JointKernels.COUNT);
    for (int i = 0; i < jointCount; i++) {
      int k = jointKey(i);
      int start = jointKeyStart[k];
      int n = jointKeyStart[k + 1] - start;
      int place = jointPlaced[k]++;
      joints[start + (n < LEAST_DEALT ? place : dealt(place, n, JOINT_PARTS))] = foundJoints[i];
    }
    for (int k = 0; k <= count; k++) {
      jointStart[k] = jointKeyStart[k * JointKernels.COUNT];
    }
  }

  /** Finds where the joints of each key begin; there are so many keys. */
  private void countJoints(int keys) {
    if (jointKeyStart.length < keys + 1) {
      jointKeyStart = new int[keys + 1 + (keys >> 1)];
      jointPlaced = new int[jointKeyStart.length];
    }
    Arrays.fill(jointKeyStart, 0, keys + 1, 0);
    Arrays.fill(jointPlaced, 0, keys, 0);
    for (int i = 0; i < jointCount; i++) {
      jointKeyStart[jointKey(i) + 1]++;
    }
    for (int k = 0; k < keys; k++) {
      jointKeyStart[k + 1] += jointKeyStart[k];
    }
  }

  private int jointKey(int i) {
    return islandOf[foundJointSlot[i]] * JointKernels.COUNT + foundJointKernel[i];
  }

  /** Turns counts into the end of each group; entry n becomes the total. */
  private static void sumToEnds(int[] counts, int n) {
    int sum = 0;
    for (int k = 0; k < n; k++) {
      sum += counts[k];
      counts[k] = sum;
    }
    counts[n] = sum;
  }

  /**
   * Lets go of contacts, so that destroyed ones can be collected. Joints are kept until they
   * change.
   */
  void release() {
    Arrays.fill(contacts, 0, contactCount, null);
    Arrays.fill(foundContacts, 0, contactCount, null);
    contactCount = 0;
  }
}
