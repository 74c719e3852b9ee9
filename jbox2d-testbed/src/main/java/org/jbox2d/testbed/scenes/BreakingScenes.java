package org.jbox2d.testbed.scenes;

import java.util.List;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;
import org.jbox2d.fracture.Material;
import org.jbox2d.fracture.materials.Diffusion;
import org.jbox2d.fracture.materials.Glass;
import org.jbox2d.fracture.materials.Uniform;

/** Further scenes in which things break. */
final class BreakingScenes {
  private static final float ROUGH = 0.6f;

  private BreakingScenes() {}

  static List<Scene> all() {
    return List.of(
        Scene.of(
                "glass-pane",
                "Glass pane",
                "A ball goes through a static pane of glass.",
                BreakingScenes::glassPane)
            .seen(0f, 10f, 50f, 27f),
        Scene.of(
                "brick-wall",
                "Brick wall",
                "A wrecking ball hits a wall of loose bricks; some break.",
                BreakingScenes::brickWall)
            .seen(0f, 10f, 50f, 27f),
        Scene.of(
                "tower",
                "Tower",
                "A ball knocks a storey out of a tower of slabs and pillars.",
                BreakingScenes::tower)
            .seen(0f, 14f, 60f, 33f));
  }

  private static void glassPane(World world) {
    Stage stage = Stage.inBox(world);
    Material glass = Stage.tuned(new Glass(), 10f, 1f, 5f);
    stage.box(BodyType.STATIC, 0f, 8f, 0.4f, 8f, Stage.breakable(glass));
    stage.shot(-18f, 10f, 0.6f, 4f, 40f, 3f);
  }

  private static void brickWall(World world) {
    Stage stage = Stage.inBox(world);
    float halfWidth = 1f;
    float halfHeight = 0.5f;
    for (int row = 0; row < 12; row++) {
      float shift = row % 2 == 0 ? 0f : halfWidth;
      for (int i = 0; i < 5; i++) {
        Material brick = Stage.tuned(new Uniform(), 30f, 1f, 1f);
        stage.box(
            -4f + shift + i * 2f * halfWidth,
            halfHeight + row * 2f * halfHeight,
            halfWidth,
            halfHeight,
            Stage.substance(1f, ROUGH, brick));
      }
    }
    stage.shot(-25f, 6f, 1.5f, 4f, 35f, 3f);
  }

  private static void tower(World world) {
    Stage stage = Stage.inBox(world);
    float pillar = 2f;
    float slab = 0.4f;
    for (int storey = 0; storey < 6; storey++) {
      float floor = storey * 2f * (pillar + slab);
      for (int side = -1; side <= 1; side++) {
        stage.box(side * 3.2f, floor + pillar, 0.4f, pillar, concrete());
      }
      stage.box(0f, floor + 2f * pillar + slab, 4f, slab, concrete());
    }
    stage.shot(-32f, 8f, 1.2f, 5f, 50f, 4f);
  }

  private static FixtureDef concrete() {
    return Stage.substance(1f, ROUGH, Stage.tuned(new Diffusion(), 40f, 1f, 1.5f));
  }
}
