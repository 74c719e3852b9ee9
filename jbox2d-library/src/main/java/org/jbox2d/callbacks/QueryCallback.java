package org.jbox2d.callbacks;

import org.jbox2d.dynamics.Fixture;

/** Hears of the fixtures that a query finds. */
public interface QueryCallback {
  /**
   * A fixture whose bounds overlap the query's.
   *
   * @return whether to go on
   */
  boolean reportFixture(Fixture fixture);
}
