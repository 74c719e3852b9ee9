package org.jbox2d.pooling.normal;

import java.util.ArrayDeque;
import org.jbox2d.collision.AABB;
import org.jbox2d.collision.Collision;
import org.jbox2d.collision.Distance;
import org.jbox2d.collision.TimeOfImpact;
import org.jbox2d.common.Mat22;
import org.jbox2d.common.Mat33;
import org.jbox2d.common.Rot;
import org.jbox2d.common.Vec2;
import org.jbox2d.common.Vec3;
import org.jbox2d.dynamics.contacts.Contact;
import org.jbox2d.dynamics.contacts.ShapeContact;
import org.jbox2d.pooling.IDynamicStack;
import org.jbox2d.pooling.IWorldPool;
import org.jbox2d.pooling.arrays.FloatArray;
import org.jbox2d.pooling.arrays.IntArray;
import org.jbox2d.pooling.arrays.Vec2Array;

/** The pool that a world makes if it is given none. */
public class DefaultWorldPool implements IWorldPool {
  private final OrderedStack<Vec2> vec2;
  private final OrderedStack<Vec3> vec3;
  private final OrderedStack<Mat22> mat22;
  private final OrderedStack<Mat33> mat33;
  private final OrderedStack<AABB> aabbs;
  private final OrderedStack<Rot> rot;
  private final IDynamicStack<Contact> contacts = new ContactStack();
  private final FloatArray floats = new FloatArray();
  private final IntArray ints = new IntArray();
  private final Vec2Array vectors = new Vec2Array();
  private final Collision collision;
  private final TimeOfImpact timeOfImpact;
  private final Distance distance;

  /**
   * A pool.
   *
   * @param argSize objects of each type to begin with
   * @param argContainerSize not used; kept for source compatibility
   */
  public DefaultWorldPool(int argSize, int argContainerSize) {
    vec2 = new OrderedStack<>(argSize, Vec2::new, Vec2[]::new);
    vec3 = new OrderedStack<>(argSize, Vec3::new, Vec3[]::new);
    mat22 = new OrderedStack<>(argSize, Mat22::new, Mat22[]::new);
    mat33 = new OrderedStack<>(argSize, Mat33::new, Mat33[]::new);
    aabbs = new OrderedStack<>(argSize, AABB::new, AABB[]::new);
    rot = new OrderedStack<>(argSize, Rot::new, Rot[]::new);
    distance = new Distance();
    collision = new Collision(this);
    timeOfImpact = new TimeOfImpact(this);
  }

  @Override
  public final IDynamicStack<Contact> getPolyContactStack() {
    return contacts;
  }

  @Override
  public final IDynamicStack<Contact> getCircleContactStack() {
    return contacts;
  }

  @Override
  public final IDynamicStack<Contact> getPolyCircleContactStack() {
    return contacts;
  }

  @Override
  public IDynamicStack<Contact> getEdgeCircleContactStack() {
    return contacts;
  }

  @Override
  public IDynamicStack<Contact> getEdgePolyContactStack() {
    return contacts;
  }

  @Override
  public IDynamicStack<Contact> getChainCircleContactStack() {
    return contacts;
  }

  @Override
  public IDynamicStack<Contact> getChainPolyContactStack() {
    return contacts;
  }

  @Override
  public final Vec2 popVec2() {
    return vec2.pop();
  }

  @Override
  public final Vec2[] popVec2(int num) {
    return vec2.pop(num);
  }

  @Override
  public final void pushVec2(int num) {
    vec2.push(num);
  }

  @Override
  public final Vec3 popVec3() {
    return vec3.pop();
  }

  @Override
  public final Vec3[] popVec3(int num) {
    return vec3.pop(num);
  }

  @Override
  public final void pushVec3(int num) {
    vec3.push(num);
  }

  @Override
  public final Mat22 popMat22() {
    return mat22.pop();
  }

  @Override
  public final Mat22[] popMat22(int num) {
    return mat22.pop(num);
  }

  @Override
  public final void pushMat22(int num) {
    mat22.push(num);
  }

  @Override
  public final Mat33 popMat33() {
    return mat33.pop();
  }

  @Override
  public final void pushMat33(int num) {
    mat33.push(num);
  }

  @Override
  public final AABB popAABB() {
    return aabbs.pop();
  }

  @Override
  public final AABB[] popAABB(int num) {
    return aabbs.pop(num);
  }

  @Override
  public final void pushAABB(int num) {
    aabbs.push(num);
  }

  @Override
  public final Rot popRot() {
    return rot.pop();
  }

  @Override
  public final void pushRot(int num) {
    rot.push(num);
  }

  @Override
  public final Collision getCollision() {
    return collision;
  }

  @Override
  public final TimeOfImpact getTimeOfImpact() {
    return timeOfImpact;
  }

  @Override
  public final Distance getDistance() {
    return distance;
  }

  @Override
  public final float[] getFloatArray(int argLength) {
    return floats.get(argLength);
  }

  @Override
  public final int[] getIntArray(int argLength) {
    return ints.get(argLength);
  }

  @Override
  public final Vec2[] getVec2Array(int argLength) {
    return vectors.get(argLength);
  }

  /** Contacts of every kind of pair are the same class. */
  private final class ContactStack implements IDynamicStack<Contact> {
    private final ArrayDeque<Contact> free = new ArrayDeque<>();

    @Override
    public Contact pop() {
      Contact c = free.poll();
      return c == null ? new ShapeContact(DefaultWorldPool.this) : c;
    }

    @Override
    public void push(Contact argObject) {
      free.push(argObject);
    }
  }
}
