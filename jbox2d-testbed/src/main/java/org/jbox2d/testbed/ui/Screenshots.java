package org.jbox2d.testbed.ui;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import javax.imageio.ImageIO;
import javax.swing.SwingUtilities;
import org.jbox2d.testbed.paint.Layer;
import org.jbox2d.testbed.paint.Layers;
import org.jbox2d.testbed.scenes.Scenes;
import org.jbox2d.testbed.simulation.Setup;
import org.jbox2d.testbed.simulation.Snapshot;

/** Pictures of the window itself in some scenes, for the documentation. */
public final class Screenshots {
  /** The longest that the scenes' steps may take, s. */
  private static final long LIMIT = 120;

  /**
   * A picture to take.
   *
   * @param scene name of the scene
   * @param steps after how many steps
   * @param layers what to show besides the bodies
   */
  private record Shot(String scene, int steps, Layer... layers) {}

  private static final List<Shot> SHOTS =
      List.of(
          new Shot("main", 45),
          new Shot("material-glass", 13, Layer.CELLS),
          new Shot("brick-wall", 225),
          new Shot("ragdolls", 110, Layer.CONTACTS, Layer.CENTRES),
          new Shot("avalanche", 200));

  private Screenshots() {}

  /**
   * Opens a window for each picture, and writes it into a directory as a PNG with the name of the
   * scene.
   *
   * @throws IOException if one can't be written, or the directory can't be made
   */
  public static void write(Path directory) throws IOException {
    Files.createDirectories(directory);
    try {
      for (Shot shot : SHOTS) {
        BufferedImage picture = take(shot);
        ImageIO.write(picture, "png", directory.resolve(shot.scene + ".png").toFile());
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("interrupted", e);
    } catch (InvocationTargetException e) {
      throw new IOException("the window failed: " + e.getCause(), e);
    }
  }

  private static BufferedImage take(Shot shot)
      throws InterruptedException, InvocationTargetException {
    BlockingQueue<Snapshot> snapshots = new LinkedBlockingQueue<>();
    TestbedWindow[] window = new TestbedWindow[1];
    SwingUtilities.invokeAndWait(
        () -> {
          WindowSettings settings = WindowSettings.forgotten();
          Layers layers = Layers.USUAL;
          for (Layer layer : shot.layers) {
            layers = layers.with(layer, true);
          }
          settings.remember(layers);
          window[0] =
              TestbedWindow.create(
                  Setup.of(Scenes.named(shot.scene), 1), settings, Path.of(""), snapshots::add);
        });
    for (int i = 0; i < shot.steps; i++) {
      window[0].simulation().singleStep();
    }
    Snapshot last = snapshots.poll(LIMIT, TimeUnit.SECONDS);
    while (last != null && last.counts().steps() < shot.steps) {
      last = snapshots.poll(LIMIT, TimeUnit.SECONDS);
    }
    BufferedImage[] picture = new BufferedImage[1];
    // What has been queued meanwhile, such as the layout of the panel, is done before the picture.
    SwingUtilities.invokeAndWait(
        () -> {
          window[0].canvas().setHint(null);
          window[0].showTimeline();
        });
    SwingUtilities.invokeAndWait(() -> picture[0] = pictureOf(window[0]));
    SwingUtilities.invokeAndWait(() -> window[0].frame().dispose());
    return picture[0];
  }

  private static BufferedImage pictureOf(TestbedWindow window) {
    var pane = window.frame().getRootPane();
    pane.validate();
    BufferedImage picture =
        new BufferedImage(pane.getWidth(), pane.getHeight(), BufferedImage.TYPE_INT_RGB);
    Graphics2D g = picture.createGraphics();
    pane.printAll(g);
    g.dispose();
    return picture;
  }
}
