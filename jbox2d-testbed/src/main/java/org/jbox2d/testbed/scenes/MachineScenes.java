package org.jbox2d.testbed.scenes;

import java.util.List;
import org.jbox2d.collision.shapes.ChainShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.MathUtils;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;
import org.jbox2d.dynamics.joints.WheelJointDef;
import org.jbox2d.testbed.parameters.Parameter;
import org.jbox2d.testbed.parameters.Values;

/** Further scenes that 2D engines are commonly tried by: joints, motors, listeners, bullets. */
final class MachineScenes {
  private static final float ROUGH = 0.6f;

  private static final Parameter LEVELS =
      SceneParameters.whole("levels", 1, 7, 4, "Storeys of the house.");
  private static final Parameter MOTOR =
      SceneParameters.real("motor", "rad/s", -60, 60, 11, "Speed of the motor.");
  private static final Parameter HILLS =
      SceneParameters.real("hills", "m", 0, 3, 0.9, "How high the hills are.");
  private static final Parameter DOLLS = SceneParameters.whole("dolls", 1, 16, 8, "How many fall.");
  private static final Parameter LINKS =
      SceneParameters.whole("links", 4, 40, 20, "Links of each chain.");
  private static final Parameter BALLAST =
      SceneParameters.real("ballast", "kg/m^2", 0.2, 50, 4, "Density of what hangs on them.");
  private static final Parameter BELT =
      SceneParameters.real("belt", "m/s", 0, 20, 5, "Speed of the belts.");
  private static final Parameter THROW = SceneParameters.speed(20);
  private static final Parameter BULLET_SPEED = SceneParameters.speed(110);
  private static final Parameter BULLETS =
      SceneParameters.whole("bullets", 1, 80, 40, "How many are shot.");

  private MachineScenes() {}

  static List<Scene> all() {
    return List.of(
        Scene.of(
                "card-house",
                "House of cards",
                "Cards that lean on each other carry cards that lean on each other.",
                MachineScenes::cardHouse,
                LEVELS)
            .seen(0f, 6f, 30f, 16f),
        Scene.of(
                "car",
                "Car",
                "A car with sprung wheels drives over hills and through a heap of boxes.",
                MachineScenes::car,
                MOTOR,
                HILLS)
            .seen(0f, 9f, 80f, 26f),
        Scene.of(
                "ragdolls",
                "Ragdolls",
                "Dolls with limited joints tumble down a staircase.",
                MachineScenes::ragdolls,
                DOLLS)
            .seen(0f, 15f, 70f, 36f),
        Scene.of(
                "chains",
                "Chains",
                "Chains of small links carry heavy weights; one swings.",
                MachineScenes::chains,
                LINKS,
                BALLAST)
            .seen(0f, 14f, 60f, 32f),
        Scene.of(
                "conveyor",
                "Conveyor",
                "Belts that move their surface carry boxes down, from one to the next.",
                MachineScenes::conveyor,
                BELT)
            .seen(0f, 12f, 66f, 30f),
        Scene.of(
                "one-sided",
                "One-sided platforms",
                "Boxes fly up through platforms that hold only what comes from above.",
                MachineScenes::oneSided,
                THROW)
            .seen(0f, 12f, 60f, 32f),
        Scene.of(
                "bullets",
                "Bullets",
                "Bullets that are smaller than their way in a step meet thin walls.",
                MachineScenes::bullets,
                BULLET_SPEED,
                BULLETS)
            .seen(4f, 5f, 40f, 16f));
  }

  private static Script cardHouse(World world, Values values) {
    Stage stage = Stage.inBox(world);
    float half = 1.5f;
    float thick = 0.05f;
    float lean = 0.38f;
    int levels = values.whole(LEVELS);
    float gap = 0.01f;
    // The inner corners of a pair meet in the ridge; a card lies over the ridges of each two pairs.
    float dx = half * MathUtils.sin(lean) + thick * MathUtils.cos(lean);
    float storey = 2f * (half * MathUtils.cos(lean) + thick * MathUtils.sin(lean));
    float spacing = 4f * dx + gap;
    for (int level = 0; level < levels; level++) {
      float y = level * (storey + 2f * thick);
      int pairs = levels - level;
      for (int i = 0; i < pairs; i++) {
        float x = (i - 0.5f * (pairs - 1)) * spacing;
        for (int side = -1; side <= 1; side += 2) {
          stage.tilted(x + side * dx, y + 0.5f * storey, side * lean, thick, half, card());
        }
        if (i > 0) {
          stage.box(x - 0.5f * spacing, y + storey + thick, 0.5f * spacing - gap, thick, card());
        }
      }
    }
    return Script.NONE;
  }

  private static FixtureDef card() {
    return Stage.substance(1f, 0.9f, null);
  }

  private static Script car(World world, Values values) {
    Stage stage = Stage.inBox(world);
    terrain(stage, values.real(HILLS));
    for (int row = 0; row < 4; row++) {
      stage.box(18f, 0.5f + row, 0.5f, 0.5f, Stage.substance(0.3f, ROUGH, null));
    }
    float x = -33f;
    float speed = values.real(MOTOR);
    Body chassis = stage.body(BodyType.DYNAMIC, x, 3.4f, 0f);
    Vec2[] outline = {
      new Vec2(-2.6f, -0.6f),
      new Vec2(2.6f, -0.6f),
      new Vec2(2.6f, 0.1f),
      new Vec2(0.6f, 1.1f),
      new Vec2(-2f, 1.1f),
      new Vec2(-2.6f, 0.4f)
    };
    PolygonShape shape = new PolygonShape();
    shape.set(outline, outline.length);
    FixtureDef body = Stage.substance(1f, Stage.FRICTION, null);
    body.shape = shape;
    chassis.createFixture(body);
    wheel(stage, chassis, x - 1.7f, speed);
    wheel(stage, chassis, x + 1.7f, speed);
    return Script.NONE;
  }

  private static void terrain(Stage stage, float height) {
    Vec2[] line = new Vec2[48];
    for (int i = 0; i < line.length; i++) {
      float x = -39f + 78f * i / (line.length - 1);
      boolean level = x < -28f || x > 14f;
      float y = level ? 0f : height * (1f - MathUtils.cos((x + 28f) * MathUtils.TWOPI / 10.5f));
      line[i] = new Vec2(x, y);
    }
    ChainShape chain = new ChainShape();
    chain.createChain(line, line.length);
    FixtureDef ground = Stage.substance(0f, ROUGH, null);
    ground.shape = chain;
    stage.body(BodyType.STATIC, 0f, 0f, 0f).createFixture(ground);
  }

  private static void wheel(Stage stage, Body chassis, float x, float speed) {
    Body wheel = stage.disc(x, 2.4f, 0.9f, Stage.substance(1f, 0.9f, null));
    WheelJointDef spring = new WheelJointDef();
    spring.initialize(chassis, wheel, wheel.getPosition(), new Vec2(0f, 1f));
    spring.motorSpeed = -speed;
    spring.maxMotorTorque = 40f;
    spring.enableMotor = true;
    spring.frequencyHz = 4f;
    spring.dampingRatio = 0.7f;
    stage.world.createJoint(spring);
  }

  private static Script ragdolls(World world, Values values) {
    Stage stage = Stage.inBox(world);
    for (int i = 0; i < 8; i++) {
      float height = 8f - i;
      stage.scenery(-30f + 5f * i, 0.5f * height, 2.5f, 0.5f * height);
    }
    for (int i = 0; i < values.whole(DOLLS); i++) {
      Vec2 push = new Vec2(7f, 0f);
      new Ragdoll(stage, i + 1, push).at(-27f + 4f * (i % 4), 14f + 7f * (i / 4), 0.3f * i);
    }
    return Script.NONE;
  }

  private static Script chains(World world, Values values) {
    Stage stage = Stage.inBox(world);
    float top = 26f;
    Body beam = stage.scenery(0f, top + 0.5f, 24f, 0.5f);
    for (int i = 0; i < 5; i++) {
      float x = -20f + 8f * i;
      boolean swings = i == 4;
      chain(stage, beam, x, top, swings, 0.8f + 0.4f * i, values);
    }
    return Script.NONE;
  }

  private static void chain(
      Stage stage, Body beam, float x, float top, boolean swings, float weight, Values values) {
    int links = values.whole(LINKS);
    float half = 0.5f * 16f / links;
    // A chain that swings starts level, to the right.
    float dx = swings ? 1f : 0f;
    float dy = swings ? 0f : -1f;
    Body before = beam;
    for (int i = 0; i < links; i++) {
      float along = (2 * i + 1) * half;
      FixtureDef steel = Stage.substance(4f, Stage.FRICTION, null);
      steel.filter.groupIndex = -1;
      Body link =
          stage.box(
              x + dx * along,
              top + dy * along,
              swings ? half : 0.12f,
              swings ? 0.12f : half,
              steel);
      stage.hinge(before, link, x + dx * (along - half), top + dy * (along - half));
      before = link;
    }
    float end = 2f * half * links;
    FixtureDef iron = Stage.substance(values.real(BALLAST), Stage.FRICTION, null);
    Body ball = stage.disc(x + dx * (end + weight), top + dy * (end + weight), weight, iron);
    stage.hinge(before, ball, x + dx * end, top + dy * end);
  }

  private static Script conveyor(World world, Values values) {
    Stage stage = Stage.inBox(world);
    float speed = values.real(BELT);
    Belts belts = new Belts();
    for (int i = 0; i < 3; i++) {
      int direction = i % 2 == 0 ? 1 : -1;
      Body belt = stage.scenery(-direction * 3f, 17f - 5.5f * i, 14f, 0.4f);
      belt.getFixtureList().setFriction(0.9f);
      belts.add(belt, direction * speed);
    }
    world.setContactListener(belts);
    for (int i = 0; i < 30; i++) {
      float size = 0.4f + 0.2f * (i % 4);
      stage.box(
          -15f + i % 6 * 2.4f, 20f + i / 6 * 2.5f, size, size, Stage.substance(1f, ROUGH, null));
    }
    return Script.NONE;
  }

  private static Script oneSided(World world, Values values) {
    Stage stage = Stage.inBox(world);
    OneSided filter = new OneSided();
    for (int i = 0; i < 3; i++) {
      filter.add(stage.scenery(0f, 5f + 5f * i, 18f - 4f * i, 0.25f), 5.25f + 5f * i);
    }
    world.setContactListener(filter);
    float speed = values.real(THROW);
    for (int i = 0; i < 16; i++) {
      Body box = stage.box(-15f + 2f * i, 1f, 0.5f, 0.5f, Stage.substance(1f, ROUGH, null));
      box.setLinearVelocity(new Vec2(0f, 0.55f * speed + 0.03f * speed * i));
    }
    return Script.NONE;
  }

  private static Script bullets(World world, Values values) {
    Stage stage = Stage.inBox(world);
    for (int i = 0; i < 8; i++) {
      float x = -4f + 2.5f * i;
      stage.box(x, 2.5f, 0.05f, 2.5f, Stage.substance(20f, ROUGH, null));
      stage.box(x, 5.05f, 0.6f, 0.05f, Stage.substance(20f, ROUGH, null));
    }
    int n = values.whole(BULLETS);
    for (int i = 0; i < n; i++) {
      FixtureDef lead = Stage.substance(8f, ROUGH, null);
      Body bullet = stage.disc(-34f + 0.5f * (i % 10), 0.3f + 0.11f * i, 0.1f, lead);
      bullet.setBullet(true);
      bullet.setLinearVelocity(new Vec2(values.real(BULLET_SPEED), 0f));
    }
    return Script.NONE;
  }
}
