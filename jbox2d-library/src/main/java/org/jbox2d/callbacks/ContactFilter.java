package org.jbox2d.callbacks;

import org.jbox2d.dynamics.Filter;
import org.jbox2d.dynamics.Fixture;

/** Decides which fixtures collide. Extend it to decide otherwise than by {@link Filter}. */
public class ContactFilter {
  /** The default filter. */
  public ContactFilter() {}

  /**
   * Returns whether two fixtures collide: by their common group if they have one, else by
   * categories and masks.
   */
  public boolean shouldCollide(Fixture fixtureA, Fixture fixtureB) {
    Filter a = fixtureA.m_filter;
    Filter b = fixtureB.m_filter;
    if (a.groupIndex != 0 && a.groupIndex == b.groupIndex) {
      return a.groupIndex > 0;
    }
    return (a.maskBits & b.categoryBits) != 0 && (b.maskBits & a.categoryBits) != 0;
  }
}
