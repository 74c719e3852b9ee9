package org.jbox2d.benchmarks.scenes;

import java.util.Random;
import org.jbox2d.benchmarks.SceneFactory;
import org.jbox2d.benchmarks.SteppedScene;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.World;

/**
 * The scenes, each defined once. Those with a name of the Box2D 3 benchmark program follow its
 * published layout (number, size and place of bodies).
 */
public final class Catalogue implements SceneFactory {
  private static final float GRAVITY = -10f;
  private static final float DEBRIS_RADIUS = 0.25f;

  @Override
  public SteppedScene build(String name) {
    switch (name) {
      case "large_pyramid":
        return largePyramid();
      case "many_pyramids":
        return manyPyramids();
      case "debris":
        return debris();
      case "tumbler":
        return tumbler();
      case "smash":
        return smash();
      case "joint_grid":
        return JointedScenes.jointGrid();
      case "spinner":
        return JointedScenes.spinner();
      case "bullet_hail":
        return new BulletHailScene();
      case "create_destroy":
        return new CreateDestroyScene();
      case "raycast":
        return new RayScene(debris());
      case "sleeping":
        return sleeping();
      default:
        throw new IllegalArgumentException("no scene is called " + name);
    }
  }

  /**
   * The world of a scene that consists of a world alone, for engines that copy it.
   *
   * @throws IllegalArgumentException if the scene does something besides stepping a world
   */
  public World buildWorld(String name) {
    SteppedScene scene = build(name);
    if (scene.getClass() != WorldScene.class) {
      throw new IllegalArgumentException(name + " is more than a world");
    }
    return ((WorldScene) scene).world;
  }

  private static WorldScene largePyramid() {
    WorldScene scene = new WorldScene(GRAVITY);
    WorldScene.fix(scene.body(BodyType.STATIC, 0f, -1f), WorldScene.box(100f, 1f), 0f, 0.6f);
    scene.pyramid(100, 0.5f, -50f, 0f);
    return scene;
  }

  private static WorldScene manyPyramids() {
    int rows = 20;
    int columns = 20;
    int base = 10;
    float half = 0.5f;
    float rowHeight = 2f * half * (base + 1f);
    float width = 2f * half * (base + 1f);
    float groundHalf = 0.5f * columns * width;
    WorldScene scene = new WorldScene(GRAVITY);
    Body ground = scene.body(BodyType.STATIC, 0f, 0f);
    for (int row = 0; row < rows; row++) {
      float y = row * rowHeight;
      WorldScene.fix(
          ground, WorldScene.box(groundHalf, 0.5f * half, 0f, y - 0.5f * half, 0f), 0f, 0.6f);
      for (int column = 0; column < columns; column++) {
        scene.pyramid(base, half, -groundHalf + column * width + half, y);
      }
    }
    return scene;
  }

  private static WorldScene debris() {
    WorldScene scene = new WorldScene(GRAVITY);
    scene.container(11f, 40f);
    Random random = new Random(1);
    for (int i = 0; i < 2000; i++) {
      float x = -9.75f + 0.5f * (i % 40);
      float y = 0.5f + 0.5f * (i / 40);
      WorldScene.fix(
          scene.body(BodyType.DYNAMIC, x, y), Polygons.random(random, DEBRIS_RADIUS), 1f, 0.5f);
    }
    return scene;
  }

  private static WorldScene tumbler() {
    WorldScene scene = new WorldScene(GRAVITY);
    scene.body(BodyType.STATIC, 0f, 0f);
    Body drum = scene.body(BodyType.KINEMATIC, 0f, 10f);
    WorldScene.fix(drum, WorldScene.box(0.5f, 10f, 10f, 0f, 0f), 50f, 0.6f);
    WorldScene.fix(drum, WorldScene.box(0.5f, 10f, -10f, 0f, 0f), 50f, 0.6f);
    WorldScene.fix(drum, WorldScene.box(10f, 0.5f, 0f, 10f, 0f), 50f, 0.6f);
    WorldScene.fix(drum, WorldScene.box(10f, 0.5f, 0f, -10f, 0f), 50f, 0.6f);
    drum.setAngularVelocity((float) Math.toRadians(25.0));
    PolygonShape box = WorldScene.box(0.125f, 0.125f);
    int side = 45;
    for (int i = 0; i < side * side; i++) {
      float x = -0.2f * side + 0.4f * (i % side);
      float y = 10f - 0.2f * side + 0.4f * (i / side);
      WorldScene.fix(scene.body(BodyType.DYNAMIC, x, y), box, 1f, 0.6f);
    }
    return scene;
  }

  private static WorldScene smash() {
    WorldScene scene = new WorldScene(0f);
    Body hammer = scene.body(BodyType.DYNAMIC, -20f, 0f);
    WorldScene.fix(hammer, WorldScene.box(4f, 4f), 8f, 0.6f);
    hammer.setLinearVelocity(new Vec2(40f, 0f));
    float size = 0.4f;
    PolygonShape box = WorldScene.box(0.5f * size, 0.5f * size);
    for (int i = 0; i < 120; i++) {
      for (int j = 0; j < 80; j++) {
        float x = 30f + (i - 60) * size;
        float y = (j - 40) * size;
        WorldScene.fix(scene.body(BodyType.DYNAMIC, x, y), box, 1f, 0.6f);
      }
    }
    return scene;
  }

  private static WorldScene sleeping() {
    WorldScene scene = new WorldScene(GRAVITY);
    scene.world.setSleepingAllowed(true);
    WorldScene.fix(scene.body(BodyType.STATIC, 0f, -1f), WorldScene.box(2000f, 1f), 0f, 0.6f);
    PolygonShape box = WorldScene.box(0.25f, 0.25f);
    for (int i = 0; i < 5000; i++) {
      WorldScene.fix(scene.body(BodyType.DYNAMIC, 0.75f * (i - 2500), 0.25f), box, 1f, 0.6f);
    }
    return scene;
  }
}
