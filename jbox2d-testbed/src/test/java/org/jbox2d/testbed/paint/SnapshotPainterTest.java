package org.jbox2d.testbed.paint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.awt.image.BufferedImage;
import org.jbox2d.testbed.scenes.Scenes;
import org.jbox2d.testbed.simulation.Simulation;
import org.jbox2d.testbed.simulation.Snapshot;
import org.jbox2d.testbed.simulation.SnapshotTaker;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class SnapshotPainterTest {
  private static Snapshot snapshot(String scene) {
    return new SnapshotTaker(new Simulation(Scenes.named(scene), 60f, 1)).take();
  }

  private static int colour(BufferedImage image, View view, double x, double y) {
    return image.getRGB((int) view.toPictureX(x), (int) view.toPictureY(y));
  }

  @ParameterizedTest
  @EnumSource(Palette.class)
  void bodiesSceneryAndSpaceDiffer(Palette palette) {
    View view = new View(0, 10, 20, 1200, 800);
    BufferedImage image = new SnapshotPainter(palette).image(snapshot("main"), view);
    int box = colour(image, view, 1, 5);
    int floor = colour(image, view, 1, -1);
    int space = colour(image, view, 13, 13);
    assertEquals(palette.ground().getRGB(), space);
    assertNotEquals(space, box);
    assertNotEquals(space, floor);
    assertNotEquals(floor, box);
    // Upright: the box stands on the floor, between -5 and 5.
    assertEquals(box, colour(image, view, 4.8, 9.8));
    assertEquals(space, colour(image, view, 5.5, 9.8));
  }

  @Test
  void discIsRound() {
    View view = new View(-30, 5.3, 100, 400, 400);
    SnapshotPainter painter = new SnapshotPainter(Palette.LIGHT);
    BufferedImage image = painter.image(snapshot("main"), view);
    int disc = colour(image, view, -30, 5.3 + 0.9);
    assertNotEquals(Palette.LIGHT.ground().getRGB(), disc);
    assertEquals(disc, colour(image, view, -30.9, 5.3));
    assertEquals(Palette.LIGHT.ground().getRGB(), colour(image, view, -30.8, 5.3 + 0.8));
  }

  /** A static concave body of several parts has no edge where they meet, unless asked for. */
  @Test
  void partsAreSeenOnlyWhenAskedFor() {
    Snapshot snapshot = snapshot("static-body");
    View view = new View(14, 10, 30, 700, 700);
    SnapshotPainter painter = new SnapshotPainter(Palette.DARK);
    BufferedImage plain = painter.image(snapshot, view);
    BufferedImage parts = new BufferedImage(700, 700, BufferedImage.TYPE_INT_RGB);
    painter.paint(parts.createGraphics(), snapshot, view, Layers.USUAL.toggled(Layer.PARTS));
    // Well inside of the foot and of the column, which together are concave.
    int fill = colour(plain, view, 17.2, 1);
    int seenEdges = 0;
    for (double t = 0; t <= 1; t += 0.001) {
      double x = 10.5 + 7 * t;
      assertEquals(fill, colour(plain, view, x, 2 + 1e-3));
      double y = 0.5 + 19 * t;
      assertEquals(fill, colour(plain, view, 17.5, y));
      boolean edge =
          colour(parts, view, x, 2 + 1e-3) != fill || colour(parts, view, 17.5, y) != fill;
      seenEdges += edge ? 1 : 0;
    }
    assertNotEquals(0, seenEdges);
  }
}
