package org.jbox2d.testbed.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.GraphicsEnvironment;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import javax.imageio.ImageIO;
import org.jbox2d.testbed.scenes.Scenes;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ScreenshotsTest {
  @TempDir Path directory;

  /** Each shows bodies in the middle, the list at the left, and the panel at the right. */
  @Test
  void fiveScenesAreShown() throws Exception {
    assumeFalse(GraphicsEnvironment.isHeadless(), "pictures of the window need a display");
    Screenshots.write(directory);
    List<Path> files;
    try (var found = Files.list(directory)) {
      files = found.toList();
    }
    assertEquals(5, files.size());
    for (Path file : files) {
      String name = file.getFileName().toString();
      Scenes.named(name.substring(0, name.length() - ".png".length()));
      BufferedImage picture = ImageIO.read(file.toFile());
      int width = picture.getWidth();
      assertTrue(colours(picture, 0, 200) > 10, name + ": list");
      assertTrue(colours(picture, 250, width - 360) > 10, name + ": bodies");
      assertTrue(colours(picture, width - 330, width) > 10, name + ": panel");
    }
  }

  private static int colours(BufferedImage picture, int left, int right) {
    Set<Integer> colours = new HashSet<>();
    for (int x = left; x < right; x++) {
      for (int y = picture.getHeight() / 2; y < picture.getHeight() - 100; y++) {
        colours.add(picture.getRGB(x, y));
      }
    }
    return colours.size();
  }
}
