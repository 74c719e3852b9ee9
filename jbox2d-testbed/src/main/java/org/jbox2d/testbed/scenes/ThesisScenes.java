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

/**
 * The scenes of the thesis (appendix B) that need no particles, with its sizes, speeds and
 * materials. They are meant for its 50 steps per second.
 */
final class ThesisScenes {
  private static final float HZ = 50f;
  private static final float BULLET_SPEED = 100f;
  private static final float ROUGH = 0.5f;

  private ThesisScenes() {}

  static List<Scene> all() {
    return List.of(
        Scene.of(
                "main",
                "Main scene",
                "A heavy disc at 100 m/s shatters a box of uniform material.",
                ThesisScenes::main)
            .at(HZ),
        Scene.of("cube", "Cube", "A tilted box falls and chips.", ThesisScenes::cube).at(HZ),
        Scene.of("circle", "Circle", "A disc falls and breaks.", ThesisScenes::circle).at(HZ),
        Scene.of(
                "rotated-body",
                "Rotated body",
                "A spinning beam breaks where it strikes the floor.",
                ThesisScenes::rotatedBody)
            .at(HZ),
        Scene.of(
                "static-body",
                "Static body",
                "A disc breaks the head of a static, concave body; the rest stays.",
                ThesisScenes::staticBody)
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

  private static void main(World world) {
    Stage stage = Stage.inBox(world);
    stage.box(0f, 5f, 5f, 5f, Stage.breakable(Stage.tuned(new Uniform(), 40f, 3f)));
    stage.shot(-30f, 5.3f, 1f, 5f, BULLET_SPEED, 0f);
  }

  private static void cube(World world) {
    Stage stage = Stage.inBox(world);
    Body cube = stage.box(10f, 10f, 2.5f, 2.5f, soft());
    cube.setTransform(new Vec2(10f, 10f), -0.6f);
  }

  private static void circle(World world) {
    Stage.inBox(world).disc(10f, 10f, 2.5f, soft());
  }

  private static FixtureDef soft() {
    return Stage.substance(1f, ROUGH, Stage.tuned(new Diffusion(), 8f));
  }

  private static void rotatedBody(World world) {
    Stage stage = Stage.inBox(world);
    Body beam = stage.box(10f, 20f, 1f, 10f, Stage.breakable(Stage.tuned(new Diffusion(), 32f)));
    beam.setAngularVelocity(10f);
  }

  private static void staticBody(World world) {
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
    stage.shot(-20f, 18f, 1f, 2f, BULLET_SPEED, 0f);
  }

  private static Scene material(
      String name, String title, String effect, Supplier<Material> substance) {
    return Scene.of(
            "material-" + name,
            "Material: " + title,
            "A heavy disc pierces a block: " + effect + ".",
            world -> block(world, substance.get()))
        .at(HZ);
  }

  private static void block(World world, Material material) {
    Stage stage = Stage.inBox(world);
    stage.box(0f, 10f, 5f, 10f, Stage.breakable(Stage.tuned(material, 20f)));
    stage.shot(-30f, 12f, 1f, 5f, BULLET_SPEED, 0f);
  }
}
