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
import org.jbox2d.fracture.FractureSystem;
import org.jbox2d.fracture.Material;
import org.jbox2d.testbed.paint.Palette;
import org.jbox2d.testbed.paint.SnapshotPainter;
import org.jbox2d.testbed.paint.View;
import org.jbox2d.testbed.simulation.MassBalance;
import org.jbox2d.testbed.simulation.Simulation;
import org.jbox2d.testbed.simulation.SnapshotTaker;

/** Runs a scene without a window, writes the files asked for, and says how it went. */
public final class HeadlessRunner {
  private static final int PNG_WIDTH = 1280;
  private static final int PNG_HEIGHT = 720;
  private static final int GIF_WIDTH = 640;
  private static final int GIF_HEIGHT = 360;

  /** How long a frame of an animation is shown, 1/100 s; 25 frames per second. */
  private static final int GIF_FRAME = 4;

  private static final double NANOS_PER_SECOND = 1e9;

  /** Long runs say how far they are this often, s. */
  private static final double PROGRESS_INTERVAL = 5;

  private final RunRequest request;
  private final PrintWriter out;
  private final SnapshotPainter painter = new SnapshotPainter(Palette.DARK);
  private Simulation run;
  private SnapshotTaker camera;
  private PhaseTimes phases;
  private double framesDue;
  private double slowestStep;

  private HeadlessRunner(RunRequest request, PrintWriter out) {
    this.request = request;
    this.out = out;
  }

  /**
   * Does what is asked for.
   *
   * @param out takes the report
   * @throws IOException if a file can't be written
   */
  public static void run(RunRequest request, PrintWriter out) throws IOException {
    new HeadlessRunner(request, out).run();
  }

  private void run() throws IOException {
    long start = System.nanoTime();
    run = new Simulation(request.scene(), request.hz(), request.seed());
    camera = new SnapshotTaker(run);
    phases = new PhaseTimes();
    if (!request.hashOnly()) {
      FractureSystem.of(run.world()).setListener(new FailureReport());
    }
    try (CsvLog csv = request.csv() == null ? null : new CsvLog(request.csv());
        GifAnimation gif =
            request.gif() == null ? null : new GifAnimation(request.gif(), GIF_FRAME)) {
      steps(csv, gif);
    }
    double seconds = (System.nanoTime() - start) / NANOS_PER_SECOND;
    if (request.png() != null) {
      View view = View.of(request.scene().framing(), PNG_WIDTH, PNG_HEIGHT);
      ImageIO.write(painter.image(camera.take(), view), "png", request.png().toFile());
    }
    report(seconds);
  }

  private void steps(CsvLog csv, GifAnimation gif) throws IOException {
    long lastProgress = System.nanoTime();
    for (int i = 0; i < request.steps(); i++) {
      if (gif != null) {
        addFrames(gif);
      }
      run.step();
      slowestStep = Math.max(slowestStep, run.stepMillis());
      phases.add(run.world().getProfile());
      if (csv != null) {
        csv.write(run);
      }
      if ((System.nanoTime() - lastProgress) / NANOS_PER_SECOND > PROGRESS_INTERVAL
          && !request.hashOnly()) {
        lastProgress = System.nanoTime();
        out.println("step " + run.steps() + " of " + request.steps());
        out.flush();
      }
    }
  }

  /** Adds a frame for each frame time that has begun: none or one, several at a low step rate. */
  private void addFrames(GifAnimation gif) throws IOException {
    View view = View.of(request.scene().framing(), GIF_WIDTH, GIF_HEIGHT);
    while (framesDue <= run.time()) {
      gif.add(painter.image(camera.take(), view));
      framesDue += GIF_FRAME / 100.0;
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
        request.scene().name(),
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
    if (request.profile()) {
      phases.print(out);
    }
    written("figures", request.csv());
    written("animation", request.gif());
    written("picture", request.png());
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
