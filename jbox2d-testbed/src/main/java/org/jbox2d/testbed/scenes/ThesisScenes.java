package org.jbox2d.testbed.scenes;

import java.util.List;
import java.util.function.Supplier;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;
import org.jbox2d.fracture.Material;
import org.jbox2d.fracture.PolygonFixture;
import org.jbox2d.fracture.materials.Diffusion;
import org.jbox2d.fracture.materials.Glass;
import org.jbox2d.fracture.materials.Uniform;
import org.jbox2d.testbed.parameters.Parameter;
import org.jbox2d.testbed.parameters.Values;

/**
 * The scenes of the thesis (appendix B) that need no particles, with its sizes, speeds and
 * materials. They are meant for its 50 steps per second.
 */
final class ThesisScenes {
  private static final float HZ = 50f;
  private static final float BULLET_SPEED = 100f;
  private static final float ROUGH = 0.5f;

  private static final Parameter SPEED = SceneParameters.speed(BULLET_SPEED);
  private static final Parameter DENSITY = SceneParameters.density(5);
  private static final Parameter SIZE =
      SceneParameters.real("size", "m", 1, 10, 5, "Half the width of the box.");
  private static final Parameter HEIGHT =
      SceneParameters.real("height", "m", 4, 50, 10, "How high it falls from.");
  private static final Parameter SPIN =
      SceneParameters.real("spin", "rad/s", -30, 30, 10, "How fast the beam turns.");

  private ThesisScenes() {}

  static List<Scene> all() {
    return List.of(
        Scene.of(
                "main",
                "Main scene",
                "A heavy disc at 100 m/s shatters a box of uniform material.",
                ThesisScenes::main,
                SPEED,
                DENSITY,
                SIZE)
            .at(HZ),
        Scene.of("cube", "Cube", "A tilted box falls and chips.", ThesisScenes::cube, HEIGHT)
            .at(HZ),
        Scene.of("circle", "Circle", "A disc falls and breaks.", ThesisScenes::circle, HEIGHT)
            .at(HZ),
        Scene.of(
                "rotated-body",
                "Rotated body",
                "A spinning beam breaks where it strikes the floor.",
                ThesisScenes::rotatedBody,
                SPIN)
            .at(HZ),
        Scene.of(
                "static-body",
                "Static body",
                "A disc breaks the head of a static, concave body; the rest stays.",
                ThesisScenes::staticBody,
                SPEED)
            .at(HZ),
        material(
            "uniform", "Uniform", "the size of splinters is the same everywhere", Uniform::new),
        material(
            "diffusion",
            "Diffusion",
            "splinters are finer the nearer to the impact",
            Diffusion::new),
        material("glass", "Glass", "cracks run in rings about the impact", Glass::new));
  }

  private static Script main(World world, Values values) {
    Stage stage = Stage.inBox(world);
    float half = values.real(SIZE);
    stage.box(0f, half, half, half, Stage.breakable(Stage.tuned(new Uniform(), 40f, 3f)));
    stage.shot(-30f, 5.3f, 1f, values.real(DENSITY), values.real(SPEED), 0f);
    return Script.NONE;
  }

  private static Script cube(World world, Values values) {
    Stage stage = Stage.inBox(world);
    stage.tilted(10f, values.real(HEIGHT), -0.6f, 2.5f, 2.5f, soft());
    return Script.NONE;
  }

  private static Script circle(World world, Values values) {
    Stage.inBox(world).disc(10f, values.real(HEIGHT), 2.5f, soft());
    return Script.NONE;
  }

  private static FixtureDef soft() {
    return Stage.substance(1f, ROUGH, Stage.tuned(new Diffusion(), 8f));
  }

  private static Script rotatedBody(World world, Values values) {
    Stage stage = Stage.inBox(world);
    Body beam = stage.box(10f, 20f, 1f, 10f, Stage.breakable(Stage.tuned(new Diffusion(), 32f)));
    beam.setAngularVelocity(values.real(SPIN));
    return Script.NONE;
  }

  private static Script staticBody(World world, Values values) {
    Stage stage = Stage.inBox(world);
    Vec2[] outline = {
      new Vec2(0f, 3.7f),
      new Vec2(6.3f, 3.7f),
      new Vec2(6.3f, 16f),
      new Vec2(3.8f, 16f),
      new Vec2(3.7f, 20f),
      new Vec2(8.2f, 20f),
      new Vec2(8.2f, 0f),
      new Vec2(0f, 0f)
    };
    stage
        .body(BodyType.STATIC, 10f, 0f, 0f)
        .createFixture(
            Stage.breakable(Stage.tuned(new Diffusion(), 32f)), new PolygonFixture(outline));
    stage.shot(-20f, 18f, 1f, 2f, values.real(SPEED), 0f);
    return Script.NONE;
  }

  private static Scene material(
      String name, String title, String effect, Supplier<Material> substance) {
    return Scene.of(
            "material-" + name,
            "Material: " + title,
            "A heavy disc pierces a block: " + effect + ".",
            (world, values) -> block(world, values, substance.get()),
            SPEED,
            DENSITY)
        .at(HZ);
  }

  private static Script block(World world, Values values, Material material) {
    Stage stage = Stage.inBox(world);
    stage.box(0f, 10f, 5f, 10f, Stage.breakable(Stage.tuned(material, 20f)));
    stage.shot(-30f, 12f, 1f, values.real(DENSITY), values.real(SPEED), 0f);
    return Script.NONE;
  }
}
