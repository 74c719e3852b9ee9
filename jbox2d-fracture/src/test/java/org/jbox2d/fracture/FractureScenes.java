package org.jbox2d.fracture;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;
import org.jbox2d.fracture.materials.Diffusion;
import org.jbox2d.fracture.materials.Glass;
import org.jbox2d.fracture.materials.Splinters;

/** Scenes of the test of determinism; {@code main} prints their hashes, in a JVM of its own. */
final class FractureScenes {
  static final int COUNT = 3;

  private FractureScenes() {}

  /** Prints the hash of each scene after the given number of steps, on one line. */
  public static void main(String[] arguments) {
    StringBuilder line = new StringBuilder();
    for (int scene = 0; scene < COUNT; scene++) {
      line.append(run(scene, Integer.parseInt(arguments[0]))).append(' ');
    }
    System.out.println(line.toString().trim());
  }

  /** Returns a hash over all steps of a scene. */
  static long run(int scene, int steps) {
    World world = make(scene);
    long hash = 17;
    for (int i = 0; i < steps; i++) {
      world.step(1f / 60f, 8, 3);
      hash = hash * 31 + hash(world);
    }
    return hash * 31 + FractureSystem.of(world).getFractureCount();
  }

  static World make(int scene) {
    World world = new World(new Vec2(0f, -9.81f));
    FractureSystem.of(world).setSeed(42 + scene);
    FractureSystem.of(world).setBodyLimit(120);
    Body floor = Range.body(world, BodyType.STATIC, 0f, -11f);
    Range.fixture(floor, Range.box(60f, 1f), 0f, null);
    switch (scene) {
      case 0:
        Range.wall(world, BodyType.DYNAMIC, 5f, tuned(new Splinters(), 40f, 3f));
        Range.disc(world, -20f, 0f, 1f, 5f, 100f, 2f);
        break;
      case 1:
        concave(world);
        Range.disc(world, -15f, -3f, 0.7f, 5f, 80f, 4f);
        break;
      default:
        Range.wall(world, BodyType.DYNAMIC, 3f, tuned(new Diffusion(), 8f, 1.5f))
            .setAngularVelocity(2f);
        break;
    }
    return world;
  }

  private static void concave(World world) {
    Vec2[] hook = {
      new Vec2(-2f, 6f), new Vec2(-2f, -6f), new Vec2(4f, -6f), new Vec2(4f, 0f),
      new Vec2(2f, 0f), new Vec2(2f, -4f), new Vec2(0f, -4f), new Vec2(0f, 6f)
    };
    FixtureDef def = new FixtureDef();
    def.density = 1f;
    def.material = tuned(new Glass(), 20f, 0.8f);
    Range.body(world, BodyType.STATIC, 0f, -4f).createFixture(def, new PolygonFixture(hook));
  }

  private static Material tuned(Material m, float rigidity, float shattering) {
    m.m_rigidity = rigidity;
    m.m_shattering = shattering;
    return m;
  }

  /** A hash over the bits of all bodies' states. */
  static long hash(World world) {
    long hash = world.getContactCount();
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      hash = mix(hash, b.getPosition().x);
      hash = mix(hash, b.getPosition().y);
      hash = mix(hash, b.getAngle());
      hash = mix(hash, b.getLinearVelocity().x);
      hash = mix(hash, b.getLinearVelocity().y);
      hash = mix(hash, b.getAngularVelocity());
      hash = mix(hash, b.getMass());
      hash = hash * 31 + (b.isAwake() ? 1 : 0);
    }
    return hash;
  }

  private static long mix(long hash, float value) {
    return SiteRandom.mix(hash, Float.floatToRawIntBits(value));
  }
}
