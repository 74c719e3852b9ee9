package org.jbox2d.testbed.headless;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import javax.imageio.ImageIO;
import org.jbox2d.dynamics.Body;
import org.jbox2d.fracture.FractureFailure;
import org.jbox2d.fracture.FractureListener;
import org.jbox2d.fracture.Material;
import org.jbox2d.testbed.export.CsvLog;
import org.jbox2d.testbed.export.GifAnimation;
import org.jbox2d.testbed.paint.Palette;
import org.jbox2d.testbed.paint.SnapshotPainter;
import org.jbox2d.testbed.paint.View;
import org.jbox2d.testbed.recording.Divergence;
import org.jbox2d.testbed.recording.RecordingWriter;
import org.jbox2d.testbed.recording.Replay;
import org.jbox2d.testbed.simulation.MassBalance;
import org.jbox2d.testbed.simulation.Simulation;
import org.jbox2d.testbed.simulation.SnapshotTaker;

/** Runs a scene without a window, writes the files asked for, and says how it went. */
public final class HeadlessRunner {
  private static final int PNG_WIDTH = 1280;
  private static final int PNG_HEIGHT = 720;
  private static final int GIF_WIDTH = 640;
  private static final int GIF_HEIGHT = 360;

  private static final double NANOS_PER_SECOND = 1e9;

  private final RunRequest request;
  private final PrintWriter out;
  private final Progress progress;
  private final SnapshotPainter painter = new SnapshotPainter(Palette.DARK);
  private Simulation run;
  private SnapshotTaker camera;
  private PhaseTimes phases;
  private double framesDue;
  private double slowestStep;
  private Divergence divergence;

  private HeadlessRunner(RunRequest request, PrintWriter out, PrintWriter err) {
    this.request = request;
    this.out = out;
    progress = new Progress(err, request.replay() == null ? request.steps() : -1);
  }

  /**
   * Does what is asked for.
   *
   * @param out takes the report
   * @param err takes the progress of long runs
   * @return where the run went another way than the recording it repeats, or {@code null}
   * @throws IOException if a file can't be read or written
   */
  public static Divergence run(RunRequest request, PrintWriter out, PrintWriter err)
      throws IOException {
    HeadlessRunner runner = new HeadlessRunner(request, out, err);
    try (Replay replay = request.replay() == null ? null : new Replay(request.replay())) {
      runner.run(replay);
    }
    return runner.divergence;
  }

  private void run(Replay replay) throws IOException {
    long start = System.nanoTime();
    run = new Simulation(replay == null ? request.setup() : replay.setup());
    camera = new SnapshotTaker(run);
    phases = new PhaseTimes();
    if (!request.hashOnly()) {
      run.setFractureListener(new FailureReport());
    }
    try (CsvLog csv = request.csv() == null ? null : new CsvLog(request.csv());
        RecordingWriter recording =
            request.record() == null ? null : new RecordingWriter(request.record(), run);
        GifAnimation gif = request.gif() == null ? null : new GifAnimation(request.gif())) {
      while (divergence == null && more(replay)) {
        step(csv, gif, recording);
        divergence = replay == null ? null : replay.check(run);
      }
    }
    double seconds = (System.nanoTime() - start) / NANOS_PER_SECOND;
    if (request.png() != null) {
      View view = View.of(run.scene().framing(), PNG_WIDTH, PNG_HEIGHT);
      ImageIO.write(painter.image(camera.take(), view), "png", request.png().toFile());
    }
    report(seconds);
  }

  private boolean more(Replay replay) throws IOException {
    return replay == null ? run.steps() < request.steps() : replay.prepare(run);
  }

  private void step(CsvLog csv, GifAnimation gif, RecordingWriter recording) throws IOException {
    if (gif != null) {
      addFrames(gif);
    }
    run.step();
    slowestStep = Math.max(slowestStep, run.stepMillis());
    phases.add(run.world().getProfile());
    if (csv != null) {
      csv.write(run.counts());
    }
    if (recording != null) {
      recording.step(run);
    }
    progress.step(run.steps());
  }

  /** Adds a frame for each frame time that has begun: none or one, several at a low step rate. */
  private void addFrames(GifAnimation gif) throws IOException {
    View view = View.of(run.scene().framing(), GIF_WIDTH, GIF_HEIGHT);
    while (framesDue <= run.time()) {
      gif.add(painter.image(camera.take(), view));
      framesDue += GifAnimation.FRAME_SECONDS;
    }
  }

  private void report(double seconds) {
    if (request.hashOnly()) {
      out.printf("%016x%n", run.hash());
      out.flush();
      return;
    }
    MassBalance balance = run.massBalance();
    out.printf(
        Locale.ROOT,
        "%s: %d steps at %s Hz, seed %d: %d bodies, %d fixtures, %d contacts, %d fractures"
            + " (%d given up), breakable mass %.6g kg -> %.6g kg (off by %.1e), hash %016x,"
            + " %.2f s, slowest step %.2f ms%n",
        run.scene().name(),
        run.steps(),
        Float.toString(run.hz()),
        run.seed(),
        run.world().getBodyCount(),
        run.fixtureCount(),
        run.world().getContactCount(),
        run.fractureCount(),
        run.fractureFailures(),
        balance.atStart(),
        balance.now(),
        balance.relativeError(),
        run.hash(),
        seconds,
        slowestStep);
    if (request.replay() != null && divergence == null) {
      out.println("every step is as in the recording " + request.replay());
    }
    if (request.profile()) {
      phases.print(out);
    }
    written("figures", request.csv());
    written("animation", request.gif());
    written("picture", request.png());
    written("recording", request.record());
    out.flush();
  }

  private void written(String what, Path file) {
    if (file != null) {
      out.println(what + " written to " + file.toAbsolutePath().normalize());
    }
  }

  /** Prints the fractures that were given up, with their input. */
  private final class FailureReport implements FractureListener {
    @Override
    public void action(Material material, float intensity, List<Body> fragments) {}

    @Override
    public void failed(FractureFailure failure) {
      out.println("step " + run.steps() + ": " + failure);
    }
  }
}
