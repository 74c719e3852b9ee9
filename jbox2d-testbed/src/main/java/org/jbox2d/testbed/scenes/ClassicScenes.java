package org.jbox2d.testbed.scenes;

import java.util.List;
import java.util.Random;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;
import org.jbox2d.dynamics.joints.DistanceJointDef;
import org.jbox2d.testbed.parameters.Parameter;
import org.jbox2d.testbed.parameters.Values;

/** Scenes that 2D engines are commonly tried by; nothing in them breaks. */
final class ClassicScenes {
  /** Friction of stacks, which slide apart on the thesis' 0.2. */
  private static final float ROUGH = 0.6f;

  private static final Parameter ROWS =
      SceneParameters.whole("rows", 1, 40, 20, "Rows of the pyramid.");
  private static final Parameter DOMINOES =
      SceneParameters.whole("dominoes", 1, 40, 30, "How many there are.");
  private static final Parameter SWUNG =
      SceneParameters.whole("swung", 1, 3, 1, "How many discs are swung.");
  private static final Parameter PLANKS =
      SceneParameters.whole("planks", 4, 40, 20, "Planks of the bridge.");
  private static final Parameter BOXES =
      SceneParameters.whole("boxes", 1, 400, 200, "Boxes in the drum.");
  private static final Parameter SPIN =
      SceneParameters.real("spin", "rad/s", -3, 3, 0.5, "How fast the drum turns.");
  private static final Parameter BODIES =
      SceneParameters.whole("bodies", 1, 450, 300, "How many fall.");

  private ClassicScenes() {}

  static List<Scene> all() {
    return List.of(
        Scene.of(
                "pyramid",
                "Pyramid",
                "Boxes in a pyramid stand and fall asleep.",
                ClassicScenes::pyramid,
                ROWS)
            .seen(0f, 11f, 48f, 26f),
        Scene.of(
                "dominoes",
                "Dominoes",
                "A rolling disc fells a row of dominoes.",
                ClassicScenes::dominoes,
                DOMINOES)
            .seen(0f, 11f, 84f, 30f),
        Scene.of(
                "newtons-cradle",
                "Newton's cradle",
                "A swung disc passes its momentum through a row of hanging discs.",
                ClassicScenes::newtonsCradle,
                SWUNG)
            .seen(0f, 9f, 40f, 22f),
        Scene.of(
                "bridge",
                "Bridge",
                "Boxes fall on a hanging bridge of hinged planks.",
                ClassicScenes::bridge,
                PLANKS)
            .seen(0f, 11f, 50f, 27f),
        Scene.of(
                "tumbler",
                "Tumbler",
                "A turning drum stirs boxes, which never come to rest.",
                ClassicScenes::tumbler,
                BOXES,
                SPIN)
            .seen(0f, 14f, 56f, 30f),
        Scene.of(
            "debris-pile",
            "Debris pile",
            "Boxes and discs of all sizes fall into a heap.",
            ClassicScenes::debrisPile,
            BODIES));
  }

  private static Script pyramid(World world, Values values) {
    Stage stage = Stage.inBox(world);
    int rows = values.whole(ROWS);
    float half = 0.5f;
    for (int row = 0; row < rows; row++) {
      for (int i = 0; i < rows - row; i++) {
        float x = (i - (rows - row - 1) / 2f) * 1.1f;
        stage.box(x, half + row * 2f * half, half, half, Stage.substance(1f, ROUGH, null));
      }
    }
    return Script.NONE;
  }

  private static Script dominoes(World world, Values values) {
    Stage stage = Stage.inBox(world);
    for (int i = 0; i < values.whole(DOMINOES); i++) {
      stage.box(-26f + 1.4f * i, 1.5f, 0.2f, 1.5f, Stage.substance(1f, ROUGH, null));
    }
    Body ball = stage.shot(-32f, 1f, 1f, 2f, 8f, 0f);
    ball.setAngularVelocity(-8f);
    return Script.NONE;
  }

  private static Script newtonsCradle(World world, Values values) {
    Stage stage = Stage.inBox(world);
    float height = 15f;
    float length = 10f;
    Body beam = stage.scenery(0f, height + 0.5f, 8f, 0.5f);
    for (int i = 0; i < 7; i++) {
      // A hair's breadth between the discs lets them strike one after the other.
      float x = (i - 3) * 2.01f;
      boolean swung = i < values.whole(SWUNG);
      float discX = swung ? x - length * 0.8f : x;
      float discY = swung ? height - length * 0.6f : height - length;
      FixtureDef steel = Stage.substance(1f, 0f, null);
      steel.restitution = 1f;
      Body disc = stage.disc(discX, discY, 1f, steel);
      DistanceJointDef rod = new DistanceJointDef();
      rod.initialize(beam, disc, new Vec2(x, height), new Vec2(discX, discY));
      stage.world.createJoint(rod);
    }
    return Script.NONE;
  }

  private static Script bridge(World world, Values values) {
    Stage stage = Stage.inBox(world);
    float height = 8f;
    float half = 0.6f;
    int planks = values.whole(PLANKS);
    Body before = stage.scenery(-planks * half - 2f, height / 2f, 2f, height / 2f);
    float x = -planks * half;
    for (int i = 0; i < planks; i++) {
      Body plank = stage.box(x + half, height - 0.2f, half, 0.2f, Stage.substance(2f, ROUGH, null));
      plank.setAngularDamping(1f);
      stage.hinge(before, plank, x, height - 0.2f);
      before = plank;
      x += 2f * half;
    }
    Body end = stage.scenery(planks * half + 2f, height / 2f, 2f, height / 2f);
    stage.hinge(before, end, x, height - 0.2f);
    for (int i = 0; i < 12; i++) {
      stage.box(-6f + i % 6 * 2.2f, 12f + i / 6 * 3f, 0.7f, 0.7f, Stage.substance(1f, ROUGH, null));
    }
    return Script.NONE;
  }

  private static Script tumbler(World world, Values values) {
    Stage stage = Stage.inBox(world);
    Body drum = stage.body(BodyType.KINEMATIC, 0f, 14f, 0f);
    float half = 10f;
    float thick = 0.5f;
    wall(drum, half + thick, 0f, thick, half + 2f * thick);
    wall(drum, -half - thick, 0f, thick, half + 2f * thick);
    wall(drum, 0f, half + thick, half, thick);
    wall(drum, 0f, -half - thick, half, thick);
    drum.setAngularVelocity(values.real(SPIN));
    for (int i = 0; i < values.whole(BOXES); i++) {
      float x = -7f + i % 20 * 0.72f;
      float y = 8f + i / 20 * 0.9f;
      stage.box(x, y, 0.3f, 0.3f, Stage.plain());
    }
    return Script.NONE;
  }

  private static void wall(Body drum, float x, float y, float halfWidth, float halfHeight) {
    PolygonShape shape = new PolygonShape();
    shape.setAsBox(halfWidth, halfHeight, new Vec2(x, y), 0f);
    FixtureDef def = Stage.substance(0f, Stage.FRICTION, null);
    def.shape = shape;
    drum.createFixture(def);
  }

  private static Script debrisPile(World world, Values values) {
    Stage stage = Stage.inBox(world);
    Random random = new Random(7);
    for (int i = 0; i < values.whole(BODIES); i++) {
      float x = -13f + i % 15 * 1.9f + 0.3f * random.nextFloat();
      float y = 3f + i / 15 * 2f;
      float size = 0.3f + 0.5f * random.nextFloat();
      FixtureDef substance = Stage.substance(1f, ROUGH, null);
      if (i % 3 == 0) {
        stage.disc(x, y, size, substance);
      } else {
        Body box = stage.box(x, y, size, 0.3f + 0.4f * random.nextFloat(), substance);
        box.setTransform(new Vec2(x, y), 3f * random.nextFloat());
      }
    }
    return Script.NONE;
  }
}
