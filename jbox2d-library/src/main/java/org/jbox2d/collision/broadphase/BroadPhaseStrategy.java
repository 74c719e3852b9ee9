package org.jbox2d.collision.broadphase;

import org.jbox2d.callbacks.DebugDraw;
import org.jbox2d.callbacks.TreeCallback;
import org.jbox2d.callbacks.TreeRayCastCallback;
import org.jbox2d.collision.AABB;
import org.jbox2d.collision.RayCastInput;
import org.jbox2d.common.Vec2;

/**
 * A spatial index of proxies: boxes, each enlarged a little so that it stays valid while what it
 * stands for moves slightly. {@link DynamicTreeFlatNodes} is the engine's own.
 */
public interface BroadPhaseStrategy {
  /**
   * Adds a proxy.
   *
   * @param aabb tight box, finite, lower bound not above upper bound; copied
   * @param userData any object, null included
   * @return the id of the proxy, 0 or more; ids of destroyed proxies are used again
   */
  int createProxy(AABB aabb, Object userData);

  /** Removes a proxy. */
  void destroyProxy(int proxyId);

  /**
   * Tells of a moved proxy.
   *
   * @param aabb the tight box now; copied
   * @param displacement how far it moved since the last call: the enlarged box is stretched to
   *     where the proxy is heading
   * @return whether the enlarged box had to change, so that there may be new overlaps
   */
  boolean moveProxy(int proxyId, AABB aabb, Vec2 displacement);

  /** What the proxy was created with. */
  Object getUserData(int proxyId);

  /** The enlarged box of a proxy, to be read only; valid until the next call about this proxy. */
  AABB getFatAABB(int proxyId);

  /**
   * Reports each proxy whose enlarged box touches or overlaps the box, until the callback returns
   * false.
   */
  void query(TreeCallback callback, AABB aabb);

  /**
   * Reports the proxies whose enlarged boxes the ray from p1 to p1 + maxFraction (p2 - p1) may
   * meet.
   *
   * @param callback returns 0 to end, a positive fraction to clip the ray there, anything else to
   *     go on unclipped. A fraction beyond the present end never lengthens the ray again
   */
  void raycast(TreeRayCastCallback callback, RayCastInput input);

  /** The height of the index counted anew: 0 if it is empty or holds one proxy. */
  int computeHeight();

  /** The height of the index: 0 if it is empty or holds one proxy. */
  int getHeight();

  /** The greatest difference of height of two siblings. */
  int getMaxBalance();

  /**
   * The summed perimeters of all boxes of the index over that of the outermost; 0 if it is empty.
   */
  float getAreaRatio();

  /** Draws the index, the whole of it. */
  void drawTree(DebugDraw draw);

  /**
   * Number of enlarged boxes given to proxies so far, new ones and those that moved; a strategy
   * that does not count returns 0.
   */
  default int getInsertionCount() {
    return 0;
  }
}
