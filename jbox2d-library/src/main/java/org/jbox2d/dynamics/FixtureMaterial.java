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
}
