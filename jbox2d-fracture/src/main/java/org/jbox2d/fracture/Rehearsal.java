package org.jbox2d.fracture;

import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;
import org.jbox2d.fracture.materials.Glass;
import org.jbox2d.fracture.materials.Uniform;

/**
 * Discs that break boxes where nobody sees it. Nothing of it is left but classes that are loaded
 * and code that is compiled.
 */
final class Rehearsal {
  /** Says whether the first material of a program brings about a rehearsal; true by default. */
  static final String PROPERTY = "org.jbox2d.fracture.rehearsal";

  /** Half the side of the boxes, in slops, so that it can be done whatever the engine's scale. */
  private static final float HALF_SIDE_IN_SLOPS = 400f;

  /** Half sides that the disc flies in a second, if the engine lets it. */
  private static final float SPEED = 20f;

  /** A thirtieth of the disc's momentum over half side squared times speed: pieces break too. */
  private static final float RIGIDITY = 0.006f;

  /** Enough for the methods that take the time to be compiled. */
  private static final int ROUNDS = 30;

  private static final int STEPS = 4;
  private static final float DT = 1f / 60f;

  /**
   * The JVM initializes this class once, when it is first asked for. A material that is made in the
   * rehearsal finds the class being initialized by its own thread, and passes; one made by another
   * thread meanwhile waits. Nothing that is initialized on the way makes materials, so that no two
   * threads can wait for each other.
   */
  private static final class First {
    static final boolean DONE = rehearse();

    private First() {}

    private static boolean rehearse() {
      boolean wanted = !"false".equals(System.getProperty(PROPERTY));
      if (wanted) {
        new Rehearsal().play(new Uniform(), 0, 1);
      }
      return wanted;
    }
  }

  /** Breaks one box if this has not been done before; returns whether it was ever done. */
  static boolean first() {
    return First.DONE;
  }

  void run() {
    for (int i = 0; i < ROUNDS; i++) {
      play(i % 2 == 0 ? new Uniform() : new Glass(), i, Integer.MAX_VALUE);
    }
  }

  /**
   * Breaks a box and its pieces.
   *
   * @param enough number of fractures after which it ends
   * @return number of fractures
   */
  int play(Material material, long seed, int enough) {
    float half = HALF_SIDE_IN_SLOPS * Settings.linearSlop;
    float speed = Math.min(SPEED * half, 0.9f * Settings.maxTranslation / DT);
    material.m_rigidity = RIGIDITY * half * half * speed;
    material.m_shattering = 0.25f * half;
    material.m_radius = half;
    World world = new World(new Vec2(0f, -9.81f));
    FractureSystem system = FractureSystem.of(world);
    system.setSeed(seed);
    system.setMinimumArea(0f);
    body(world, 0f, square(half), material);
    CircleShape disc = new CircleShape();
    disc.m_radius = 0.25f * half;
    body(world, -1.255f * half, disc, null).setLinearVelocity(new Vec2(speed, 0f));
    for (int i = 0; i < STEPS && system.getFractureCount() < enough; i++) {
      world.step(DT, 8, 3);
    }
    return system.getFractureCount();
  }

  /** A square, or its left lower half if the engine's polygons have no room for four corners. */
  private static PolygonShape square(float half) {
    PolygonShape shape = new PolygonShape();
    Vec2[] corners = {
      new Vec2(-half, half), new Vec2(-half, -half), new Vec2(half, -half), new Vec2(half, half)
    };
    shape.set(corners, Math.min(corners.length, Settings.maxPolygonVertices));
    return shape;
  }

  private static Body body(World world, float x, Shape shape, Material material) {
    BodyDef def = new BodyDef();
    def.type = BodyType.DYNAMIC;
    def.position.set(x, 0f);
    Body body = world.createBody(def);
    FixtureDef fixture = new FixtureDef();
    fixture.shape = shape;
    fixture.density = 1f;
    fixture.material = material;
    body.createFixture(fixture);
    return body;
  }
}
