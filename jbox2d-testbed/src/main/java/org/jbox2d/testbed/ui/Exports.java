package org.jbox2d.testbed.ui;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Consumer;
import javax.imageio.ImageIO;
import javax.swing.SwingUtilities;
import org.jbox2d.testbed.export.CsvLog;
import org.jbox2d.testbed.export.GifAnimation;
import org.jbox2d.testbed.paint.Layers;
import org.jbox2d.testbed.paint.Palette;
import org.jbox2d.testbed.paint.SnapshotPainter;
import org.jbox2d.testbed.paint.View;
import org.jbox2d.testbed.recording.RecordingWriter;
import org.jbox2d.testbed.simulation.Setup;
import org.jbox2d.testbed.simulation.Snapshot;
import org.jbox2d.testbed.simulation.TimedInput;

/**
 * Writes files on a thread of its own, one after the other, each named by the scene and the step.
 */
final class Exports {
  private static final int GIF_WIDTH = 640;

  private final Path directory;
  private final Consumer<String> report;
  private final ExecutorService thread =
      Executors.newSingleThreadExecutor(
          task -> {
            Thread t = new Thread(task, "export");
            t.setDaemon(true);
            return t;
          });

  /**
   * Exports to a directory.
   *
   * @param report hears how each went, on the event thread
   */
  Exports(Path directory, Consumer<String> report) {
    this.directory = directory;
    this.report = report;
  }

  /** A file to be written. */
  private interface Writing {
    void to(Path file) throws IOException;
  }

  private void write(Snapshot.Counts counts, String ending, Writing writing) {
    Path file = directory.resolve(counts.scene() + "-" + counts.steps() + ending);
    tell("Writing " + file.getFileName() + " ...");
    thread.execute(
        () -> {
          try {
            writing.to(file);
            tell("Written to " + file);
          } catch (IOException e) {
            tell("Could not write " + file + ": " + e.getMessage());
          }
        });
  }

  private void tell(String line) {
    SwingUtilities.invokeLater(() -> report.accept(line));
  }

  /** A picture of a snapshot. */
  void picture(Snapshot snapshot, View view, Layers layers) {
    write(
        snapshot.counts(),
        ".png",
        file ->
            ImageIO.write(
                new SnapshotPainter(Palette.DARK).image(snapshot, view, layers),
                "png",
                file.toFile()));
  }

  /** An animation of snapshots, the oldest first, in the time they took in the scene. */
  void animation(List<Snapshot> snapshots, View view, Layers layers) {
    Snapshot last = snapshots.get(snapshots.size() - 1);
    View small = view.scaledTo(GIF_WIDTH);
    write(
        last.counts(),
        ".gif",
        file -> {
          SnapshotPainter painter = new SnapshotPainter(Palette.DARK);
          try (GifAnimation gif = new GifAnimation(file)) {
            double due = snapshots.get(0).counts().time();
            for (Snapshot snapshot : snapshots) {
              for (; due <= snapshot.counts().time(); due += GifAnimation.FRAME_SECONDS) {
                gif.add(painter.image(snapshot, small, layers));
              }
            }
          }
        });
  }

  /** Figures of each step. */
  void figures(List<Snapshot.Counts> figures) {
    write(
        figures.get(figures.size() - 1),
        ".csv",
        file -> {
          try (CsvLog csv = new CsvLog(file)) {
            for (Snapshot.Counts counts : figures) {
              if (counts.steps() > 0) {
                csv.write(counts);
              }
            }
          }
        });
  }

  /** A recording that {@code --replay} takes. */
  void recording(Snapshot.Counts counts, Setup setup, List<TimedInput> inputs) {
    write(counts, ".rec", file -> RecordingWriter.write(file, setup, inputs, counts.steps()));
  }

  /** Lets what is being written end, and takes no more. */
  void close() {
    thread.shutdown();
  }
}
