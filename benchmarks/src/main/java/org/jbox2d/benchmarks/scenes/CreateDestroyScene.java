package org.jbox2d.benchmarks.scenes;

import java.util.ArrayDeque;
import java.util.Random;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;

/**
 * Births and deaths as a fracture makes them. Each frame one of 100 boxes on the ground is taken
 * out and 60 small polygons come in its place; those of 30 frames ago leave, and their box comes
 * back above the ground. So 1,800 pieces and 70 boxes are there at any time.
 */
final class CreateDestroyScene extends WorldScene {
  private static final int BOXES = 100;
  private static final int LIFE = 30;
  private static final int COLUMNS = 6;
  private static final int ROWS = 10;
  private static final float SPACING = 1.5f;
  private static final float HALF_WIDTH = 0.5f;
  private static final float HALF_HEIGHT = 0.75f;
  private static final float PIECE_RADIUS = 0.07f;

  private final PolygonShape box = box(HALF_WIDTH, HALF_HEIGHT);
  private final PolygonShape[] pieces = new PolygonShape[COLUMNS * ROWS];
  private final Body[] boxes = new Body[BOXES];
  private final ArrayDeque<Body[]> broken = new ArrayDeque<>();
  private int frame;

  CreateDestroyScene() {
    super(-10f);
    fix(body(BodyType.STATIC, 0f, -1f), box(0.5f * SPACING * BOXES + 10f, 1f), 0f, 0.6f);
    for (int i = 0; i < BOXES; i++) {
      placeBox(i);
    }
    Random random = new Random(2);
    for (int i = 0; i < pieces.length; i++) {
      pieces[i] = Polygons.random(random, PIECE_RADIUS);
    }
  }

  private void placeBox(int i) {
    boxes[i] = body(BodyType.DYNAMIC, left(i), HALF_HEIGHT);
    fix(boxes[i], box, 1f, 0.6f);
  }

  private static float left(int i) {
    return SPACING * (i - 0.5f * BOXES);
  }

  @Override
  public void step() {
    if (broken.size() == LIFE) {
      for (Body piece : broken.poll()) {
        world.destroyBody(piece);
      }
      placeBox(Math.floorMod(frame - LIFE, BOXES));
    }
    breakBox(frame % BOXES);
    frame++;
    super.step();
  }

  private void breakBox(int i) {
    float x = boxes[i].getPosition().x;
    float y = boxes[i].getPosition().y;
    world.destroyBody(boxes[i]);
    Body[] parts = new Body[pieces.length];
    float cellX = 2f * HALF_WIDTH / COLUMNS;
    float cellY = 2f * HALF_HEIGHT / ROWS;
    for (int k = 0; k < parts.length; k++) {
      float px = x - HALF_WIDTH + cellX * (k % COLUMNS + 0.5f);
      float py = y - HALF_HEIGHT + cellY * (k / COLUMNS + 0.5f);
      parts[k] = body(BodyType.DYNAMIC, px, py);
      fix(parts[k], pieces[k], 1f, 0.5f);
    }
    broken.add(parts);
  }
}
