package org.jbox2d.collision.broadphase;

import org.jbox2d.callbacks.DebugDraw;
import org.jbox2d.callbacks.PairCallback;
import org.jbox2d.callbacks.TreeCallback;
import org.jbox2d.callbacks.TreeRayCastCallback;
import org.jbox2d.collision.AABB;
import org.jbox2d.collision.RayCastInput;
import org.jbox2d.common.Vec2;

/**
 * Finds the pairs of proxies that may have begun to touch since it was last asked, and answers
 * spatial queries.
 */
public interface BroadPhase {
  /** The id that no proxy has. */
  int NULL_PROXY = -1;

  /**
   * Adds a proxy; its pairs are reported by the next {@link #updatePairs}.
   *
   * @param aabb tight box, finite, lower bound not above upper bound; copied
   * @param userData any object; what {@link PairCallback#addPair} gets
   * @return the id of the proxy; ids of destroyed proxies are used again
   */
  int createProxy(AABB aabb, Object userData);

  /** Removes a proxy; the caller removes its pairs. */
  void destroyProxy(int proxyId);

  /**
   * Tells of a moved proxy. If it has left its enlarged box, the next {@link #updatePairs} reports
   * its pairs.
   *
   * @param displacement how far it moved since the last call
   */
  void moveProxy(int proxyId, AABB aabb, Vec2 displacement);

  /**
   * Has the next {@link #updatePairs} report the proxy's pairs though it has not moved (its filter
   * changed, say).
   */
  void touchProxy(int proxyId);

  /** What the proxy was created with. */
  Object getUserData(int proxyId);

  /** The enlarged box of a proxy, to be read only; valid until the next call about this proxy. */
  AABB getFatAABB(int proxyId);

  /** Whether the enlarged boxes of two proxies touch or overlap. */
  boolean testOverlap(int proxyIdA, int proxyIdB);

  /**
   * Whether the boxes that two proxies were last created or moved with, not enlarged, are at most
   * {@code slack} (metres) apart. A broad phase that does not know them may answer as {@link
   * #testOverlap}.
   */
  default boolean testTightOverlap(int proxyIdA, int proxyIdB, float slack) {
    return testOverlap(proxyIdA, proxyIdB);
  }

  /** Whether the enlarged box of a proxy contains a box. */
  default boolean covers(int proxyId, AABB aabb) {
    return getFatAABB(proxyId).contains(aabb);
  }

  /**
   * Sets whether a proxy is an obstacle, which {@link #queryObstacles} looks for; at first it is
   * none. A broad phase that does not note it reports all proxies there.
   */
  default void setObstacle(int proxyId, boolean isObstacle) {}

  /**
   * Reports each obstacle whose enlarged box touches or overlaps the box, and perhaps proxies that
   * are none, until the callback returns false.
   */
  default void queryObstacles(TreeCallback callback, AABB aabb) {
    query(callback, aabb);
  }

  /**
   * Sets which collision categories a proxy is of, and which it collides with, as bits; at first
   * all. If the callback of {@link #updatePairs} says that it has no use for them, pairs may be
   * left out of which one does not collide with any category of the other.
   */
  default void setFilter(int proxyId, int categories, int mask) {}

  /** Number of proxies. */
  int getProxyCount();

  /**
   * Reports each pair of proxies whose enlarged boxes touch or overlap and of which at least one
   * was created, touched or has left its box since the last call: once, in an order that depends on
   * the calls made so far alone. Pairs known from earlier calls come again. The callback must
   * create, move or destroy no proxy. If it throws, the next call starts over.
   */
  void updatePairs(PairCallback callback);

  /**
   * Reports each proxy whose enlarged box touches or overlaps the box, until the callback returns
   * false.
   */
  void query(TreeCallback callback, AABB aabb);

  /** As {@link BroadPhaseStrategy#raycast}. */
  void raycast(TreeRayCastCallback callback, RayCastInput input);

  /** Height of the index of proxies. */
  int getTreeHeight();

  /** Greatest difference of height of two siblings in the index of proxies. */
  int getTreeBalance();

  /**
   * As {@link BroadPhaseStrategy#getAreaRatio}: the smaller, the fewer boxes a query has to look
   * at.
   */
  float getTreeQuality();

  /** Draws the index of proxies, the whole of it. */
  void drawTree(DebugDraw draw);
}
