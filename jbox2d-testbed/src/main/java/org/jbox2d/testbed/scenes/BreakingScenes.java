package org.jbox2d.testbed.scenes;

import java.util.ArrayList;
import java.util.List;
import org.jbox2d.common.MathUtils;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;
import org.jbox2d.dynamics.joints.DistanceJointDef;
import org.jbox2d.fracture.Material;
import org.jbox2d.fracture.PolygonFixture;
import org.jbox2d.fracture.materials.Diffusion;
import org.jbox2d.fracture.materials.Glass;
import org.jbox2d.fracture.materials.Splinters;
import org.jbox2d.fracture.materials.Uniform;
import org.jbox2d.testbed.parameters.Parameter;
import org.jbox2d.testbed.parameters.Values;

/** Scenes in which one thing breaks: a pane, a wall, a vase. */
final class BreakingScenes {
  private static final float ROUGH = 0.6f;

  private static final Parameter PANE_SPEED = SceneParameters.speed(40);
  private static final Parameter ROWS = SceneParameters.whole("rows", 2, 20, 12, "Rows of bricks.");
  private static final Parameter BALL =
      SceneParameters.real("ball", "kg/m^2", 0.5, 20, 4, "Density of the ball.");
  private static final Parameter STOREYS =
      SceneParameters.whole("storeys", 1, 10, 6, "Storeys of the tower.");
  private static final Parameter TOWER_SPEED = SceneParameters.speed(50);
  private static final Parameter WEIGHT =
      SceneParameters.real("weight", "kg/m^2", 0.5, 20, 8, "Density of what falls.");
  private static final Parameter HEIGHT =
      SceneParameters.real("height", "m", 2, 50, 18, "How high it falls from.");
  private static final Parameter TILT =
      SceneParameters.real("tilt", "rad", -3, 3, 2.5, "How far it leans as it falls.");
  private static final Parameter HOLED_SPEED = SceneParameters.speed(60);

  private BreakingScenes() {}

  static List<Scene> all() {
    return List.of(
        Scene.of(
                "glass-pane",
                "Glass pane",
                "A ball goes through a static pane of glass.",
                BreakingScenes::glassPane,
                PANE_SPEED)
            .seen(0f, 10f, 50f, 27f),
        Scene.of(
                "brick-wall",
                "Brick wall",
                "A demolition ball swings into a wall of loose bricks; some break.",
                BreakingScenes::brickWall,
                ROWS,
                BALL)
            .seen(-4f, 13f, 56f, 32f),
        Scene.of(
                "tower",
                "Tower",
                "A ball knocks a storey out of a tower of slabs and pillars.",
                BreakingScenes::tower,
                STOREYS,
                TOWER_SPEED)
            .seen(0f, 14f, 60f, 33f),
        Scene.of(
                "planks",
                "Wooden planks",
                "Planks that lie on trestles splinter along the grain under falling weights.",
                BreakingScenes::planks,
                WEIGHT)
            .seen(0f, 9f, 52f, 28f),
        Scene.of(
                "vase",
                "Vase",
                "A vase of glass drops on a stone floor.",
                BreakingScenes::vase,
                HEIGHT,
                TILT)
            .seen(0f, 10f, 44f, 24f),
        Scene.of(
                "holes",
                "Concave and holed",
                "A ring, a star, a frame with windows and a horseshoe are shot at.",
                BreakingScenes::holes,
                HOLED_SPEED)
            .seen(0f, 11f, 76f, 34f));
  }

  private static Script glassPane(World world, Values values) {
    Stage stage = Stage.inBox(world);
    Material glass = Stage.tuned(new Glass(), 10f, 1f, 5f);
    stage.box(BodyType.STATIC, 0f, 8f, 0.4f, 8f, Stage.breakable(glass));
    stage.shot(-18f, 10f, 0.6f, 4f, values.real(PANE_SPEED), 3f);
    return Script.NONE;
  }

  private static Script brickWall(World world, Values values) {
    Stage stage = Stage.inBox(world);
    float halfWidth = 1f;
    float halfHeight = 0.5f;
    for (int row = 0; row < values.whole(ROWS); row++) {
      float shift = row % 2 == 0 ? 0f : halfWidth;
      for (int i = 0; i < 5; i++) {
        Material brick = Stage.tuned(new Uniform(), 30f, 1f, 1f);
        stage.box(
            -2f + shift + i * 2f * halfWidth,
            halfHeight + row * 2f * halfHeight,
            halfWidth,
            halfHeight,
            Stage.substance(1f, ROUGH, brick));
      }
    }
    float top = 26f;
    Body crane = stage.scenery(-6f, top + 0.5f, 4f, 0.5f);
    Body ball = stage.disc(-26f, top - 8f, 2f, Stage.projectile(values.real(BALL)));
    DistanceJointDef rope = new DistanceJointDef();
    rope.initialize(crane, ball, new Vec2(-6f, top), ball.getPosition());
    world.createJoint(rope);
    return Script.NONE;
  }

  private static Script tower(World world, Values values) {
    Stage stage = Stage.inBox(world);
    stackTower(stage, values.whole(STOREYS));
    stage.shot(-32f, 8f, 1.2f, 5f, values.real(TOWER_SPEED), 4f);
    return Script.NONE;
  }

  /** Slabs on three pillars each; a storey is 4.8 m high. */
  static void stackTower(Stage stage, int storeys) {
    float pillar = 2f;
    float slab = 0.4f;
    for (int storey = 0; storey < storeys; storey++) {
      float floor = storey * 2f * (pillar + slab);
      for (int side = -1; side <= 1; side++) {
        stage.box(side * 3.2f, floor + pillar, 0.4f, pillar, concrete());
      }
      stage.box(0f, floor + 2f * pillar + slab, 4f, slab, concrete());
    }
  }

  private static FixtureDef concrete() {
    return Stage.substance(1f, ROUGH, Stage.tuned(new Diffusion(), 40f, 1f, 1.5f));
  }

  private static Script planks(World world, Values values) {
    Stage stage = Stage.inBox(world);
    for (int i = -1; i <= 1; i++) {
      float x = 16f * i;
      stage.scenery(x - 5f, 2f, 0.5f, 2f);
      stage.scenery(x + 5f, 2f, 0.5f, 2f);
      for (int layer = 0; layer < 3; layer++) {
        Splinters wood = Stage.tuned(new Splinters(), 45f, 1.2f, 3f);
        wood.setAngle(0f);
        stage.box(x, 4.35f + 0.7f * layer, 6.5f, 0.35f, Stage.substance(0.7f, ROUGH, wood));
      }
      FixtureDef iron = Stage.substance(values.real(WEIGHT), ROUGH, null);
      stage.box(x + 1.5f * i, 14f + 3f * i, 1.2f, 1.2f, iron);
    }
    return Script.NONE;
  }

  /** The profile of a vase, right half, from the foot up: distance from the axis, and height. */
  private static final float[][] OUTSIDE = {
    {1.6f, 0f}, {1.2f, 0.8f}, {2.4f, 2.2f}, {2.9f, 3.6f}, {2.5f, 5f}, {1.4f, 6.2f}, {1.9f, 7.2f}
  };

  /** The same of its hollow. */
  private static final float[][] INSIDE = {
    {0.7f, 1.3f}, {1.95f, 2.4f}, {2.4f, 3.6f}, {2.05f, 4.8f}, {0.95f, 6.1f}, {1.45f, 7.2f}
  };

  private static Script vase(World world, Values values) {
    Stage stage = Stage.inBox(world);
    List<Vec2> outline = new ArrayList<>();
    for (float[] p : OUTSIDE) {
      outline.add(new Vec2(p[0], p[1]));
    }
    for (int i = INSIDE.length - 1; i >= 0; i--) {
      outline.add(new Vec2(INSIDE[i][0], INSIDE[i][1]));
    }
    for (int i = outline.size() - 1; i >= 0; i--) {
      outline.add(new Vec2(-outline.get(i).x, outline.get(i).y));
    }
    PolygonFixture vase = new PolygonFixture(outline.toArray(new Vec2[0]));
    Material glass = Stage.tuned(new Glass(), 4f, 1f, 6f);
    stage.whole(0f, values.real(HEIGHT), values.real(TILT), vase, Stage.breakable(glass));
    return Script.NONE;
  }

  private static Script holes(World world, Values values) {
    Stage stage = Stage.inBox(world);
    stage.whole(
        -27f, 4.1f, 0f, new PolygonFixture(circle(4f, 24), circle(2.2f, 16)), stone(new Glass()));
    stage.whole(-9f, 4.6f, 0f, new PolygonFixture(star(4.8f, 2.2f, 6)), stone(new Uniform()));
    PolygonFixture frame =
        new PolygonFixture(
            rectangle(-4f, -4f, 4f, 4f),
            rectangle(-3f, -3f, -0.5f, -0.5f),
            rectangle(0.5f, -3f, 3f, -0.5f),
            rectangle(-3f, 0.5f, -0.5f, 3f),
            rectangle(0.5f, 0.5f, 3f, 3f));
    stage.whole(9f, 4.1f, 0f, frame, stone(new Diffusion()));
    stage.whole(27f, 1f, 0f, new PolygonFixture(horseshoe(4.2f, 2.4f, 12)), stone(new Uniform()));
    for (int i = 0; i < 4; i++) {
      float x = -27f + 18f * i;
      stage.shot(x - 1f, 26f + 4f * i, 0.8f, 4f, 2f, -values.real(HOLED_SPEED));
    }
    return Script.NONE;
  }

  private static FixtureDef stone(Material material) {
    return Stage.substance(1f, ROUGH, Stage.tuned(material, 30f, 2f, 2.5f));
  }

  private static Vec2 polar(float radius, float angle) {
    return new Vec2(radius * MathUtils.cos(angle), radius * MathUtils.sin(angle));
  }

  private static Vec2[] circle(float radius, int n) {
    Vec2[] ring = new Vec2[n];
    for (int i = 0; i < n; i++) {
      ring[i] = polar(radius, MathUtils.TWOPI * i / n);
    }
    return ring;
  }

  private static Vec2[] star(float outer, float inner, int points) {
    Vec2[] ring = new Vec2[2 * points];
    for (int i = 0; i < ring.length; i++) {
      ring[i] = polar(i % 2 == 0 ? outer : inner, MathUtils.PI * i / points + 0.5f);
    }
    return ring;
  }

  private static Vec2[] rectangle(float left, float low, float right, float high) {
    return new Vec2[] {
      new Vec2(left, low), new Vec2(right, low), new Vec2(right, high), new Vec2(left, high)
    };
  }

  /** Half a ring that stands on its ends. */
  private static Vec2[] horseshoe(float outer, float inner, int n) {
    Vec2[] ring = new Vec2[2 * n];
    for (int i = 0; i < n; i++) {
      float angle = -0.2f + (MathUtils.PI + 0.4f) * i / (n - 1);
      ring[i] = polar(outer, angle);
      ring[2 * n - 1 - i] = polar(inner, angle);
    }
    return ring;
  }
}
