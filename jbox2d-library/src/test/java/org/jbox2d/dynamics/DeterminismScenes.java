package org.jbox2d.dynamics;

import org.jbox2d.common.Vec2;

/** Runs the scenes of the test of determinism and prints their hashes, in a JVM of its own. */
final class DeterminismScenes {
  private DeterminismScenes() {}

  /** Prints the hash of each scene on one line. */
  public static void main(String[] arguments) {
    StringBuilder line = new StringBuilder();
    for (long hash : hashes(Integer.parseInt(arguments[0]), null)) {
      line.append(hash).append(' ');
    }
    System.out.println(line.toString().trim());
  }

  /**
   * Returns the hash of each scene after some steps.
   *
   * @param beside stepped between the steps of each scene; may be {@code null}
   */
  static long[] hashes(int steps, World beside) {
    World[] worlds = {Make.debris(80, 42), Make.pyramid(8), Make.tumbler(80), Make.bullets(40, 4)};
    long[] hashes = new long[worlds.length];
    for (int k = 0; k < worlds.length; k++) {
      World world = worlds[k];
      for (int i = 0; i < steps; i++) {
        world.step(Make.STEP, 8, 3);
        if (beside != null) {
          beside.step(0.01f, 4, 2);
        }
        if (i == steps / 2) {
          disturb(world);
        }
        hashes[k] = hashes[k] * 31 + StateHash.of(world);
      }
    }
    return hashes;
  }

  /** Births, deaths and pushes belong to what must be reproducible. */
  private static void disturb(World world) {
    Body second = world.getBodyList().getNext();
    second.applyLinearImpulse(new Vec2(1f, 3f), second.getWorldCenter());
    world.destroyBody(world.getBodyList());
    Make.disc(world, 0.1f, 6f, 0.4f).setLinearVelocity(new Vec2(0f, -8f));
  }
}
