package org.jbox2d.callbacks;

/** Hears of the nodes of a dynamic tree whose boxes overlap a query. */
public interface TreeCallback {

  /**
   * A box overlaps the query.
   *
   * @param proxyId the node
   * @return whether the query goes on
   */
  boolean treeCallback(int proxyId);
}
