package org.jbox2d.dynamics.joints;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.World;
import org.jbox2d.dynamics.solver.JointRows;
import org.jbox2d.pooling.IWorldPool;

/**
 * A constraint between bodies. Made by {@link World#createJoint}.
 *
 * <p>A joint is the record between steps: parameters and kept impulses. In a step it writes these
 * into a row of the solver ({@link #gather}) and reads the impulses back ({@link #scatter}). Where
 * nothing else decides what it writes, the row is kept: then the joint writes it again after a
 * {@link #change} alone, and its impulses are in the row until they are read. A joint that has
 * handed out one of its vectors, such as a local anchor, writes its row in each step from then on.
 */
public abstract class Joint {
  /** Neighbours in the world's list of joints. */
  public Joint m_prev;

  /** See {@link #m_prev}. */
  public Joint m_next;

  /** Node in the list of body A. */
  public JointEdge m_edgeA;

  /** Node in the list of body B. */
  public JointEdge m_edgeB;

  /** Engine-internal: already met in this step. */
  public boolean m_islandFlag;

  /** Whatever the user keeps here. */
  public Object m_userData;

  /** The bodies. */
  protected Body m_bodyA;

  /** See {@link #m_bodyA}. */
  protected Body m_bodyB;

  /** The world's pool. */
  protected IWorldPool pool;

  private final JointType type;
  private final boolean collideConnected;

  /** The rows in which its row is kept, with the impulses of the last step; else {@code null}. */
  private JointRows keptIn;

  private int keptRow;

  /** See {@link #expose}. */
  private boolean exposed;

  /** Takes over what all definitions have. */
  protected Joint(IWorldPool worldPool, JointDef def) {
    pool = worldPool;
    type = def.type;
    m_bodyA = def.bodyA;
    m_bodyB = def.bodyB;
    collideConnected = def.collideConnected;
    m_userData = def.userData;
    m_edgeA = new JointEdge();
    m_edgeB = new JointEdge();
  }

  /**
   * Makes the joint of a definition. Called by the world.
   *
   * @throws IllegalArgumentException if the definition's type is unknown or a value in it is not
   *     allowed
   */
  public static Joint create(World world, JointDef def) {
    return JointFactory.create(world, def);
  }

  /** Lets go of what the joint holds. Called by the world. */
  public static void destroy(Joint joint) {
    joint.destructor();
  }

  /** Lets go of what the joint holds. */
  public void destructor() {}

  /** Returns the kind of joint. */
  public JointType getType() {
    return type;
  }

  /** Returns the first body. */
  public final Body getBodyA() {
    return m_bodyA;
  }

  /** Returns the second body. */
  public final Body getBodyB() {
    return m_bodyB;
  }

  /** Writes the world anchor on body A to {@code out}. */
  public abstract void getAnchorA(Vec2 out);

  /** Writes the world anchor on body B to {@code out}. */
  public abstract void getAnchorB(Vec2 out);

  /** Writes the force on body B at its anchor to {@code out}, N. */
  public abstract void getReactionForce(float inv_dt, Vec2 out);

  /** Returns the torque on body B, N m. */
  public abstract float getReactionTorque(float inv_dt);

  /** Returns the next joint of the world's list, or {@code null}. */
  public Joint getNext() {
    return m_next;
  }

  /** Returns the user data. */
  public Object getUserData() {
    return m_userData;
  }

  /** Sets the user data. */
  public void setUserData(Object data) {
    m_userData = data;
  }

  /** Returns whether the two bodies collide with each other. */
  public final boolean getCollideConnected() {
    return collideConnected;
  }

  /** Returns whether both bodies are active. */
  public boolean isActive() {
    return m_bodyA.isActive() && m_bodyB.isActive();
  }

  /** Whether the joint is in the world: false while it is made and once it was destroyed. */
  final boolean isLinked() {
    return m_edgeA.joint == this;
  }

  /** Engine-internal: on how many bodies the joint acts. They share an island. */
  public int bodyCount() {
    return 2;
  }

  /**
   * Engine-internal: one of the bodies on which the joint acts, {@code i} in {@code [0,
   * bodyCount())}.
   */
  public Body body(int i) {
    return i == 0 ? m_bodyA : m_bodyB;
  }

  /** Engine-internal: another body with the same frame takes the place of one. */
  public void replaceBody(Body from, Body to) {
    if (m_bodyA == from) {
      m_bodyA = to;
    } else if (m_bodyB == from) {
      m_bodyB = to;
    }
  }

  /** Engine-internal: place of this joint's kernel among the kernels. */
  public abstract int kernelOrder();

  /**
   * Engine-internal: appends this joint's row. The slots of its bodies are their {@link
   * Body#m_islandIndex}.
   *
   * @return the row
   */
  public abstract int gather(JointRows rows);

  /** Engine-internal: reads the impulses back from the row. */
  public abstract void scatter(JointRows rows, int row);

  /**
   * Engine-internal: keeps the row that was just written, if it is of a kind that can be kept: then
   * it need not be written again as long as the joint does not say so ({@link JointRows#due}) and
   * slots and centres of mass of its bodies stay the same, and it is read by the joint itself.
   *
   * @return whether it is kept
   */
  public final boolean keepRow(JointRows rows, int row) {
    boolean kept = !exposed && isRowConstant();
    keptIn = kept ? rows : null;
    keptRow = row;
    return kept;
  }

  /** Engine-internal: the joint's row will be overwritten. */
  public final void takeBackRow() {
    readImpulses();
    keptIn = null;
  }

  /**
   * Whether what the joint writes depends on nothing but its bodies' slots and centres of mass,
   * {@link org.jbox2d.common.Settings#linearSlop}, and what changes after {@link #change} or {@link
   * #expose} alone: on no velocities, as springs do.
   */
  boolean isRowConstant() {
    return false;
  }

  /** Must come before each change of what {@link #gather} writes, impulses among it. */
  final void change() {
    JointRows rows = keptIn;
    if (rows != null) {
      takeBackRow();
      rows.addDue(keptRow);
    }
  }

  /**
   * Must come before a vector that {@link #gather} writes is handed out: whoever has got it may
   * change it in any step from now on.
   */
  final void expose() {
    change();
    exposed = true;
  }

  /** Must come before impulses are looked at. */
  final void readImpulses() {
    if (keptIn != null) {
      scatter(keptIn, keptRow);
    }
  }
}
