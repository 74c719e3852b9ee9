package org.jbox2d.testbed.scenes;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.MathUtils;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;
import org.jbox2d.fracture.FractureSystem;
import org.jbox2d.fracture.PolygonFixture;
import org.jbox2d.fracture.materials.Bricks;
import org.jbox2d.fracture.materials.Diffusion;
import org.jbox2d.fracture.materials.Splinters;
import org.jbox2d.fracture.materials.Uniform;
import org.jbox2d.testbed.parameters.Parameter;
import org.jbox2d.testbed.parameters.Values;

/** Scenes in which much breaks, over time. */
final class DisasterScenes {
  private static final float ROUGH = 0.6f;

  private static final Parameter PROJECTILES =
      SceneParameters.whole("projectiles", 1, 24, 12, "How many come.");
  private static final Parameter SPEED = SceneParameters.speed(45);
  private static final Parameter STOREYS =
      SceneParameters.whole("storeys", 1, 10, 6, "Storeys of the tower.");
  private static final Parameter CHARGE =
      SceneParameters.real("charge", "N s/m", 1, 1000, 160, "Impulse of an explosion at 1 m.");
  private static final Parameter LOAD =
      SceneParameters.real("load", "kg/m^2", 0.5, 20, 3, "Density of what falls on the bridge.");
  private static final Parameter DROPS =
      SceneParameters.whole("drops", 1, 300, 80, "How many stones fall.");
  private static final Parameter PIECES =
      SceneParameters.whole("pieces", 10, 2000, 1000, "Stones behind the dam.");

  private DisasterScenes() {}

  static List<Scene> all() {
    return List.of(
        Scene.of(
                "asteroid",
                "Asteroid",
                "Projectiles from all sides tear at an asteroid, without gravity.",
                DisasterScenes::asteroid,
                PROJECTILES,
                SPEED)
            .seen(0f, 30f, 84f, 62f),
        Scene.of(
                "tower-blast",
                "Tower under explosions",
                "Four explosions, a second apart, bring down a tower.",
                DisasterScenes::towerBlast,
                STOREYS,
                CHARGE)
            .seen(0f, 14f, 60f, 33f),
        Scene.of(
                "breaking-bridge",
                "Breaking bridge",
                "Blocks fall on a bridge whose planks break; what is left hangs on its hinges.",
                DisasterScenes::breakingBridge,
                LOAD)
            .seen(0f, 11f, 50f, 27f),
        Scene.of(
                "rain-on-roofs",
                "Rain on roofs",
                "Stones rain on houses: roofs splinter, walls break in bricks.",
                DisasterScenes::rainOnRoofs,
                DROPS)
            .seen(0f, 14f, 78f, 36f),
        Scene.of(
                "avalanche",
                "Avalanche",
                "A boulder breaks a dam, and a thousand stones slide down the slope behind it.",
                DisasterScenes::avalanche,
                PIECES)
            .seen(0f, 18f, 84f, 46f));
  }

  private static Script asteroid(World world, Values values) {
    world.setGravity(new Vec2());
    Stage stage = Stage.inBox(world);
    stage.scenery(0f, 62f, 40f, 2f);
    Random random = new Random(11);
    Vec2[] outline = new Vec2[28];
    for (int i = 0; i < outline.length; i++) {
      float radius = 7f + 3f * random.nextFloat();
      outline[i] = polar(radius, MathUtils.TWOPI * i / outline.length);
    }
    Diffusion rock = Stage.tuned(new Diffusion(), 60f, 2.5f, 3.5f);
    Body body =
        stage.whole(0f, 30f, 0f, new PolygonFixture(outline), Stage.substance(1f, ROUGH, rock));
    body.setAngularVelocity(0.3f);
    int n = values.whole(PROJECTILES);
    float speed = values.real(SPEED);
    for (int i = 0; i < n; i++) {
      float angle = MathUtils.TWOPI * i / n + 0.1f;
      Vec2 away = polar(1f, angle);
      float distance = 17f + 11f * (i % 4) / 3f;
      stage.shot(
          distance * away.x,
          30f + distance * away.y,
          0.7f + 0.1f * (i % 3),
          5f,
          -speed * away.x,
          -speed * away.y);
    }
    return Script.NONE;
  }

  private static Vec2 polar(float radius, float angle) {
    return new Vec2(radius * MathUtils.cos(angle), radius * MathUtils.sin(angle));
  }

  private static Script towerBlast(World world, Values values) {
    Stage stage = Stage.inBox(world);
    BreakingScenes.stackTower(stage, values.whole(STOREYS));
    float charge = values.real(CHARGE);
    float[][] places = {{-5.5f, 2f}, {5.5f, 7f}, {0f, 12f}, {-1f, 1.5f}};
    return step -> {
      int second = step / 60;
      if (step % 60 == 0 && second >= 1 && second <= places.length) {
        float[] place = places[second - 1];
        FractureSystem.of(world).explode(new Vec2(place[0], place[1]), 14f, charge);
      }
    };
  }

  private static Script breakingBridge(World world, Values values) {
    Stage stage = Stage.inBox(world);
    float height = 8f;
    float half = 1.2f;
    int planks = 12;
    Body before = stage.scenery(-planks * half - 2f, height / 2f, 2f, height / 2f);
    float x = -planks * half;
    for (int i = 0; i < planks; i++) {
      Splinters wood = Stage.tuned(new Splinters(), 20f, 1.4f, 1.2f);
      Body plank =
          stage.box(x + half, height - 0.25f, half, 0.25f, Stage.substance(1.5f, ROUGH, wood));
      plank.setAngularDamping(1f);
      stage.hinge(before, plank, x, height - 0.25f);
      before = plank;
      x += 2f * half;
    }
    Body end = stage.scenery(planks * half + 2f, height / 2f, 2f, height / 2f);
    stage.hinge(before, end, x, height - 0.25f);
    for (int i = 0; i < 6; i++) {
      FixtureDef iron = Stage.substance(values.real(LOAD), ROUGH, null);
      stage.box(-7.5f + 3f * i, 14f + 4f * (i % 3), 0.8f, 0.8f, iron);
    }
    return Script.NONE;
  }

  /** Stones wait out of the world, inactive, until their time comes. */
  private static Script rainOnRoofs(World world, Values values) {
    Stage stage = Stage.inBox(world);
    for (int i = -1; i <= 1; i++) {
      house(stage, 24f * i);
    }
    Random random = new Random(5);
    List<Body> waiting = new ArrayList<>();
    for (int i = 0; i < values.whole(DROPS); i++) {
      float x = -34f + 68f * random.nextFloat();
      float size = 0.35f + 0.4f * random.nextFloat();
      Body stone = stage.disc(x, 40f, size, Stage.substance(3f, ROUGH, null));
      stone.setLinearVelocity(new Vec2(0f, -12f));
      stone.setActive(false);
      waiting.add(stone);
    }
    return step -> {
      if (step % 3 == 0 && step / 3 < waiting.size()) {
        waiting.get(step / 3).setActive(true);
      }
    };
  }

  private static void house(Stage stage, float x) {
    for (int side = -1; side <= 1; side += 2) {
      Bricks bricks = Stage.tuned(new Bricks(), 60f, 1.5f, 1.5f);
      stage.box(x + side * 5f, 4f, 0.6f, 4f, Stage.substance(1f, ROUGH, bricks));
    }
    stage.box(x, 8.3f, 6.2f, 0.3f, Stage.substance(1f, ROUGH, shingles()));
    // A roof of two rafters that lean against each other in the ridge.
    float pitch = 0.5f;
    float half = 3.3f;
    float low = 8.6f;
    Body[] rafters = new Body[2];
    for (int i = 0; i < 2; i++) {
      int side = 2 * i - 1;
      float middle = x + side * (half * MathUtils.cos(pitch) + 0.15f);
      float height = low + half * MathUtils.sin(pitch) + 0.27f;
      FixtureDef wood = Stage.substance(1f, 0.9f, shingles());
      rafters[i] = stage.tilted(middle, height, -side * pitch, half, 0.3f, wood);
    }
    stage.hinge(rafters[0], rafters[1], x, low + 2f * half * MathUtils.sin(pitch) + 0.27f);
  }

  private static Splinters shingles() {
    Splinters wood = Stage.tuned(new Splinters(), 25f, 1.2f, 1.2f);
    wood.setAngle(0f);
    return wood;
  }

  private static Script avalanche(World world, Values values) {
    Stage stage = Stage.inBox(world);
    stage.scenery(new Vec2(-39f, 0f), new Vec2(8f, 0f), new Vec2(-39f, 26f));
    Uniform stone = Stage.tuned(new Uniform(), 60f, 1.5f, 6f);
    stage.box(BodyType.STATIC, -12f, 15f, 0.8f, 5f, Stage.breakable(stone));
    Random random = new Random(3);
    int columns = 34;
    for (int i = 0; i < values.whole(PIECES); i++) {
      float x = -38f + i % columns * 0.73f + 0.05f * random.nextFloat();
      float ground = 26f * (8f - x) / 47f;
      pebble(stage, random, x, ground + 0.9f + i / columns * 0.75f);
    }
    stage.shot(20f, 12f, 1.6f, 6f, -34f, 8f);
    return Script.NONE;
  }

  /** A convex stone of 4 to 7 corners. */
  private static void pebble(Stage stage, Random random, float x, float y) {
    int n = 4 + random.nextInt(4);
    float turn = random.nextFloat();
    Vec2[] corners = new Vec2[n];
    for (int i = 0; i < n; i++) {
      corners[i] = polar(0.26f + 0.08f * random.nextFloat(), MathUtils.TWOPI * (i + turn) / n);
    }
    PolygonShape shape = new PolygonShape();
    shape.set(corners, n);
    FixtureDef substance = Stage.substance(1f, 0.3f, null);
    substance.shape = shape;
    stage.body(BodyType.DYNAMIC, x, y, 0f).createFixture(substance);
  }
}
