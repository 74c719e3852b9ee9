package org.jbox2d.pooling;

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

/**
 * The supply of temporary objects of a world. The engine itself takes only the three algorithms
 * from it; the rest is for programs written for JBox2D. What is popped is pushed back in reverse
 * order.
 */
public interface IWorldPool {
  /** Returns a supply of contacts. */
  IDynamicStack<Contact> getPolyContactStack();

  /** Returns a supply of contacts. */
  IDynamicStack<Contact> getCircleContactStack();

  /** Returns a supply of contacts. */
  IDynamicStack<Contact> getPolyCircleContactStack();

  /** Returns a supply of contacts. */
  IDynamicStack<Contact> getEdgeCircleContactStack();

  /** Returns a supply of contacts. */
  IDynamicStack<Contact> getEdgePolyContactStack();

  /** Returns a supply of contacts. */
  IDynamicStack<Contact> getChainCircleContactStack();

  /** Returns a supply of contacts. */
  IDynamicStack<Contact> getChainPolyContactStack();

  /** Takes a Vec2; its value is undefined. */
  Vec2 popVec2();

  /** Takes several; their values are undefined. */
  Vec2[] popVec2(int num);

  /** Gives the last {@code num} back. */
  void pushVec2(int num);

  /** Takes a Vec3; its value is undefined. */
  Vec3 popVec3();

  /** Takes several; their values are undefined. */
  Vec3[] popVec3(int num);

  /** Gives the last {@code num} back. */
  void pushVec3(int num);

  /** Takes a Mat22; its value is undefined. */
  Mat22 popMat22();

  /** Takes several; their values are undefined. */
  Mat22[] popMat22(int num);

  /** Gives the last {@code num} back. */
  void pushMat22(int num);

  /** Takes a Mat33; its value is undefined. */
  Mat33 popMat33();

  /** Gives the last {@code num} back. */
  void pushMat33(int num);

  /** Takes a AABB; its value is undefined. */
  AABB popAABB();

  /** Takes several; their values are undefined. */
  AABB[] popAABB(int num);

  /** Gives the last {@code num} back. */
  void pushAABB(int num);

  /** Takes a Rot; its value is undefined. */
  Rot popRot();

  /** Gives the last {@code num} back. */
  void pushRot(int num);

  /** Returns the world's narrow phase. */
  Collision getCollision();

  /** Returns the world's time of impact algorithm. */
  TimeOfImpact getTimeOfImpact();

  /** Returns the world's distance algorithm. */
  Distance getDistance();

  /** Returns an array of the given length, the same for each call with that length. */
  float[] getFloatArray(int argLength);

  /** Returns an array of the given length, the same for each call with that length. */
  int[] getIntArray(int argLength);

  /** Returns an array of the given length, the same for each call with that length. */
  Vec2[] getVec2Array(int argLength);
}
