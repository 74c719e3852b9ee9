package org.jbox2d.fracture;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;
import org.jbox2d.dynamics.joints.DistanceJointDef;
import org.jbox2d.dynamics.joints.RevoluteJointDef;
import org.jbox2d.fracture.materials.Bricks;
import org.jbox2d.fracture.materials.Diffusion;
import org.jbox2d.fracture.materials.FunctionMaterial;
import org.jbox2d.fracture.materials.Glass;
import org.jbox2d.fracture.materials.Radial;
import org.jbox2d.fracture.materials.Splinters;
import org.jbox2d.fracture.materials.Uniform;

/** A random scene, and what happens to it: targets, bullets, and commands. */
final class FuzzScene {
  final World world;
  final float dt;
  private final Random random;
  private final List<Body> targets = new ArrayList<>();
  private final float size;

  FuzzScene(long seed) {
    random = new Random(seed);
    world = new World(random.nextBoolean() ? new Vec2(0f, -9.81f) : new Vec2());
    dt = 1f / new int[] {30, 50, 60, 120, 240}[random.nextInt(5)];
    size = logUniform(0.1f, 20f);
    if (random.nextInt(3) > 0) {
      Body floor = Range.body(world, BodyType.STATIC, 0f, -2.2f * size - 1f);
      Range.fixture(floor, Range.box(30f * size, 1f), 0f, null);
    }
    int count = 1 + random.nextInt(3);
    for (int i = 0; i < count; i++) {
      target(4.4f * size * i);
    }
    if (targets.size() > 1 && random.nextInt(3) == 0) {
      join(targets.get(0), targets.get(1));
    }
    int bullets = 1 + random.nextInt(3);
    for (int i = 0; i < bullets; i++) {
      bullet();
    }
  }

  private float uniform(float low, float high) {
    return low + (high - low) * random.nextFloat();
  }

  private float logUniform(float low, float high) {
    return (float) (low * Math.pow(high / low, random.nextDouble()));
  }

  private Material material() {
    Material m = kind();
    m.m_rigidity = logUniform(0.001f, 30f) * size * size;
    m.m_shattering = logUniform(0.1f, 3f) * size;
    m.m_radius = logUniform(0.1f, 3f) * size;
    int fragments = random.nextInt(4);
    if (fragments == 0) {
      m.m_fragments = null;
    } else if (fragments == 1) {
      m.m_fragments = m.copy();
      m.m_fragments.m_rigidity *= 4f;
    }
    return m;
  }

  private Material kind() {
    switch (random.nextInt(7)) {
      case 0:
        return new Uniform();
      case 1:
        return new Diffusion();
      case 2:
        return new Glass();
      case 3:
        return new Radial();
      case 4:
        Splinters splinters = new Splinters();
        splinters.setAngle(uniform(-4f, 4f));
        splinters.setSlenderness(logUniform(1f, 20f));
        return splinters;
      case 5:
        Bricks bricks = new Bricks();
        bricks.setAngle(random.nextBoolean() ? 0f : uniform(-4f, 4f));
        bricks.setSlenderness(logUniform(1f, 5f));
        return bricks;
      default:
        return lattice();
    }
  }

  /** Sites of a regular lattice with some of them twice: the hard case of Voronoi diagrams. */
  private Material lattice() {
    float pitch = logUniform(0.1f, 1f) * size;
    return new FunctionMaterial(
        (d, v, r) -> {
          Vec2[] sites = new Vec2[50];
          for (int i = 0; i < sites.length; i++) {
            int k = i % 49;
            sites[i] = new Vec2(d.x + pitch * (k % 7 - 3), d.y + pitch * (k / 7 - 3));
          }
          return sites;
        });
  }

  private void target(float x) {
    BodyDef def = new BodyDef();
    int type = random.nextInt(5);
    def.type = type == 0 ? BodyType.STATIC : type == 1 ? BodyType.KINEMATIC : BodyType.DYNAMIC;
    def.position.set(x + uniform(-0.1f, 0.1f) * size, uniform(-0.2f, 1f) * size);
    def.angle = random.nextBoolean() ? 0f : uniform(-6f, 6f);
    def.angularVelocity = type > 1 && random.nextBoolean() ? uniform(-3f, 3f) : 0f;
    def.fixedRotation = random.nextInt(10) == 0;
    Body body = world.createBody(def);
    Vec2 offset =
        random.nextInt(4) > 0
            ? new Vec2()
            : new Vec2(uniform(-50f, 50f) * size, uniform(-50f, 50f) * size);
    FixtureDef f = new FixtureDef();
    f.density = logUniform(0.1f, 10f);
    f.friction = uniform(0f, 1f);
    f.restitution = random.nextBoolean() ? 0f : uniform(0f, 1f);
    f.material = material();
    fill(body, f, offset);
    if (body.getType() == BodyType.DYNAMIC || !offset.equals(new Vec2())) {
      Vec2 center = body.getWorldPoint(offset);
      Vec2 origin = body.getPosition();
      body.setTransform(
          new Vec2(2f * origin.x - center.x, 2f * origin.y - center.y), body.getAngle());
    }
    targets.add(body);
  }

  private void fill(Body body, FixtureDef def, Vec2 offset) {
    switch (random.nextInt(5)) {
      case 0:
        body.createFixture(shaped(def, disc(offset, uniform(0.5f, 2f) * size)));
        break;
      case 1:
        body.createFixture(shaped(def, convex(offset)));
        break;
      case 2:
        body.createFixture(def, star(offset, false));
        break;
      case 3:
        body.createFixture(def, star(offset, true));
        break;
      default:
        body.createFixture(shaped(def, box(offset.x, offset.y, 1f, 1.8f)));
        def.material = random.nextBoolean() ? def.material : material();
        body.createFixture(shaped(def, box(offset.x + 1.4f * size, offset.y, 0.4f, 0.6f)));
        def.material = random.nextBoolean() ? null : def.material;
        body.createFixture(
            shaped(def, disc(new Vec2(offset.x, offset.y + 2.1f * size), 0.3f * size)));
        break;
    }
  }

  private static FixtureDef shaped(FixtureDef def, Shape shape) {
    def.shape = shape;
    return def;
  }

  private static CircleShape disc(Vec2 center, float radius) {
    CircleShape shape = new CircleShape();
    shape.m_p.set(center);
    shape.m_radius = radius;
    return shape;
  }

  private PolygonShape box(float x, float y, float halfWidth, float halfHeight) {
    PolygonShape shape = new PolygonShape();
    shape.setAsBox(halfWidth * size, halfHeight * size, new Vec2(x, y), 0f);
    return shape;
  }

  private PolygonShape convex(Vec2 offset) {
    int n = 3 + random.nextInt(6);
    Vec2[] vertices = new Vec2[n];
    double turn = random.nextDouble();
    for (int i = 0; i < n; i++) {
      double a = 2 * Math.PI * (i + turn + 0.4 * random.nextDouble()) / n;
      vertices[i] = onRay(offset, a, 2f * size);
    }
    PolygonShape shape = new PolygonShape();
    shape.set(vertices, n);
    return shape;
  }

  /** A star-shaped outline, with a hole in the middle if wanted, in either orientation. */
  private PolygonFixture star(Vec2 offset, boolean hole) {
    int n = 5 + random.nextInt(12);
    Vec2[] outer = new Vec2[n];
    double way = random.nextBoolean() ? 1 : -1;
    for (int i = 0; i < n; i++) {
      double a = way * 2 * Math.PI * (i + 0.6 * random.nextDouble()) / n;
      outer[i] = onRay(offset, a, uniform(0.7f, 2f) * size);
    }
    if (!hole) {
      return new PolygonFixture(outer);
    }
    Vec2[] inner = new Vec2[4];
    for (int i = 0; i < inner.length; i++) {
      inner[i] = onRay(offset, 0.3 + i * Math.PI / 2, 0.15f * size);
    }
    return new PolygonFixture(outer, new Vec2[][] {inner});
  }

  private static Vec2 onRay(Vec2 center, double angle, float radius) {
    return new Vec2(
        center.x + (float) (radius * Math.cos(angle)),
        center.y + (float) (radius * Math.sin(angle)));
  }

  private void join(Body a, Body b) {
    if (random.nextBoolean()) {
      DistanceJointDef def = new DistanceJointDef();
      def.initialize(a, b, a.getWorldCenter().clone(), b.getWorldCenter().clone());
      world.createJoint(def);
    } else {
      RevoluteJointDef def = new RevoluteJointDef();
      def.initialize(a, b, a.getWorldCenter().clone());
      world.createJoint(def);
    }
  }

  private void bullet() {
    float x = -uniform(3.5f, 6f) * size;
    float y = uniform(-1f, 2f) * size;
    float speed = logUniform(1f, 300f);
    float radius = uniform(0.1f, 0.6f) * size;
    Body bullet = Range.disc(world, x, y, radius, logUniform(0.3f, 10f), speed, uniform(-2f, 2f));
    bullet.setBullet(random.nextBoolean());
    bullet.setAngularVelocity(uniform(-5f, 5f));
  }

  /** Now and then a command from outside, as a game gives it between two steps. */
  void disturb(int step) {
    if (random.nextInt(25) != 0) {
      return;
    }
    FractureSystem system = FractureSystem.of(world);
    Body body = world.getBodyList();
    for (int i = random.nextInt(world.getBodyCount()); i > 0; i--) {
      body = body.getNext();
    }
    Vec2 p = new Vec2(body.getWorldCenter());
    Vec2 aside = new Vec2(uniform(-3f, 3f) * size, uniform(-3f, 3f) * size);
    Fixture fixture = body.getFixtureList();
    switch (random.nextInt(3)) {
      case 0:
        system.explode(p.add(aside), uniform(1f, 8f) * size, logUniform(0.01f, 30f) * size);
        break;
      case 1:
        if (body.getType() == BodyType.DYNAMIC) {
          system.cut(body, p.sub(aside), p.add(aside));
        }
        break;
      default:
        if (fixture != null) {
          system.strike(fixture, p, aside.mul(logUniform(0.1f, 30f) * size));
        }
        break;
    }
  }
}
