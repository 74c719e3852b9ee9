package org.jbox2d.dynamics;

/**
 * What a fixture is made of, as far as the engine is concerned: something that hears of each solved
 * contact of the fixture.
 *
 * <p>It is called while the world is locked; to change the world, use {@link World#defer}.
 */
public interface FixtureMaterial {
  /**
   * A contact of {@code fixture} has been solved. If both fixtures of the contact have a material,
   * that of fixture A is called first.
   *
   * @param fixture the fixture that has this material
   * @param solved impulses and velocities; valid only during the call
   */
  void contactSolved(Fixture fixture, SolvedContact solved);

  /**
   * Returns whether {@link #contactSolved} is to be called for a contact. In a heap nearly all
   * contacts carry what rests on them and no more; to say so here saves putting together what
   * became of them.
   *
   * @param fixture the fixture that has this material
   * @param normalImpulse sum of the normal impulses of the contact's points, N s
   */
  default boolean hears(Fixture fixture, float normalImpulse) {
    return true;
  }
}
