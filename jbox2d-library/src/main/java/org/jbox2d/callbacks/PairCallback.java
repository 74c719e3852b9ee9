package org.jbox2d.callbacks;

/** Receives the pairs of proxies that a broad phase finds. */
public interface PairCallback {
  /**
   * Two proxies' enlarged boxes overlap. Called while the broad phase works: create, move and
   * destroy no proxy here.
   *
   * @param proxyUserDataA what the proxy of the lower id was created with
   * @param proxyUserDataB what the other was created with
   */
  void addPair(Object proxyUserDataA, Object proxyUserDataB);
}
