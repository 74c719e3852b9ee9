package org.jbox2d.benchmarks.charts;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.jbox2d.fracture.voronoi.VoronoiDiagram;
import org.jbox2d.testbed.scenes.Scenes;
import org.jbox2d.testbed.simulation.Simulation;

/**
 * Measures whole fractures in the thesis' scenes, the first one of a JVM, Voronoi diagrams of 256
 * sites, and the steps of the glass scene, and draws histograms like the thesis' figures 6.1 and
 * 6.5: {@code java -cp benchmarks/target/benchmarks.jar org.jbox2d.benchmarks.charts.FractureCharts
 * [directory]}. Figures and charts go to docs/charts unless told otherwise.
 */
public final class FractureCharts {
  private static final String[] SCENES = {
    "main",
    "cube",
    "circle",
    "rotated-body",
    "static-body",
    "material-uniform",
    "material-diffusion",
    "material-glass"
  };

  /** The scenes are meant for 50 Hz. */
  private static final float HZ = 50f;

  private static final int DIAGRAM_SITES = 256;

  /** Bodies from which on a step of the glass scene counts as one of its 500 pieces. */
  private static final int MANY_BODIES = 300;

  private static final String MICROSECONDS = "thread time, microseconds";

  /**
   * How much is done.
   *
   * @param warm seeds of runs before the first that counts
   * @param measured seeds of runs that count
   * @param steps steps of a run
   * @param diagrams Voronoi diagrams that count; as many before them do not
   * @param children JVMs started for the first fracture of each kind
   */
  record Amount(int warm, int measured, int steps, int diagrams, int children) {
    /** Fractures get faster until some 30 seeds, of 160 fractures each, have been compiled. */
    static Amount full() {
      return new Amount(30, 12, 200, 2500, 5);
    }
  }

  private final Amount amount;
  private final Path directory;
  private final List<String> lines = new ArrayList<>();

  FractureCharts(Amount amount, Path directory) {
    this.amount = amount;
    this.directory = directory;
  }

  /** Measures and writes everything. */
  public static void main(String[] args) throws IOException, InterruptedException {
    System.setProperty("java.awt.headless", "true");
    Path directory = Path.of(args.length > 0 ? args[0] : "docs/charts");
    new FractureCharts(Amount.full(), directory).run();
  }

  void run() throws IOException, InterruptedException {
    Files.createDirectories(directory);
    lines.add("what,count,median,p99,most,unit");
    first();
    fractures();
    diagrams();
    glassSteps();
    Files.write(directory.resolve("fracture.csv"), lines);
  }

  // --- The first fracture of a JVM ---

  private void first() throws IOException, InterruptedException {
    for (String material : new String[] {"uniform", "glass"}) {
      for (String start : new String[] {"cold", "warmed-up"}) {
        double[] millis = new double[amount.children];
        for (int i = 0; i < millis.length; i++) {
          millis[i] = child(material, start);
        }
        tell("first fracture of a JVM; " + material + "; " + start, millis, "ms");
      }
    }
  }

  private static double child(String material, String start)
      throws IOException, InterruptedException {
    Process child =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp",
                System.getProperty("java.class.path"),
                FirstFracture.class.getName(),
                material,
                start)
            .redirectError(ProcessBuilder.Redirect.INHERIT)
            .start();
    String printed =
        new String(child.getInputStream().readAllBytes(), StandardCharsets.UTF_8).trim();
    if (child.waitFor() != 0) {
      throw new IOException("the JVM for the first fracture failed: " + printed);
    }
    return Double.parseDouble(printed);
  }

  // --- Whole fractures ---

  private void fractures() throws IOException {
    FractureTimes times = new FractureTimes();
    for (int seed = 1; seed <= amount.warm + amount.measured; seed++) {
      times.keep(seed > amount.warm);
      for (String scene : SCENES) {
        Simulation run = new Simulation(Scenes.named(scene), HZ, seed);
        times.listenTo(run.world());
        for (int i = 0; i < amount.steps; i++) {
          run.step();
        }
      }
    }
    double[] all = times.microseconds();
    tell("whole fracture; scenes of the thesis", all, "us");
    double most = Math.min(1000, 1.05 * all[all.length - 1]);
    new HistogramDrawing("Whole fractures in the scenes of the thesis, warm", MICROSECONDS)
        .write(all, most, directory.resolve("fracture-time"));
  }

  // --- Diagrams ---

  private void diagrams() throws IOException {
    VoronoiDiagram diagram = new VoronoiDiagram();
    double[] micros = new double[amount.diagrams];
    for (int i = 0; i < 2 * micros.length; i++) {
      double[] sites = Inputs.points(DIAGRAM_SITES, i);
      long start = FractureTimes.now();
      diagram.compute(sites, DIAGRAM_SITES, 0, 0, 1, 1);
      if (i >= micros.length) {
        micros[i - micros.length] = 1e-3 * (FractureTimes.now() - start);
      }
    }
    Arrays.sort(micros);
    tell("Voronoi diagram of 256 sites", micros, "us");
    new HistogramDrawing("Voronoi diagrams of 256 sites, warm", MICROSECONDS)
        .write(micros, 2 * micros[micros.length / 2], directory.resolve("voronoi-time"));
  }

  // --- Steps ---

  /** Steps of the glass scene while it has hundreds of pieces. */
  private void glassSteps() {
    List<Double> millis = new ArrayList<>();
    int bodies = 0;
    for (int seed = 1; seed <= amount.measured; seed++) {
      Simulation run = new Simulation(Scenes.named("material-glass"), HZ, seed);
      for (int i = 0; i < amount.steps; i++) {
        int before = run.world().getBodyCount();
        long start = FractureTimes.now();
        run.step();
        if (before >= MANY_BODIES) {
          millis.add(1e-6 * (FractureTimes.now() - start));
          bodies = Math.max(bodies, before);
        }
      }
    }
    double[] sorted = millis.stream().mapToDouble(Double::doubleValue).toArray();
    tell("step of the glass scene; " + MANY_BODIES + " to " + bodies + " bodies", sorted, "ms");
  }

  // --- Figures ---

  private void tell(String what, double[] values, String unit) {
    Arrays.sort(values);
    String line =
        values.length == 0
            ? what + ",0,,,," + unit
            : String.format(
                Locale.ROOT,
                "%s,%d,%.3f,%.3f,%.3f,%s",
                what,
                values.length,
                quantile(values, 0.5),
                quantile(values, 0.99),
                values[values.length - 1],
                unit);
    lines.add(line);
    System.out.println(line);
  }

  static double quantile(double[] sorted, double share) {
    return sorted[(int) Math.min(sorted.length - 1, share * sorted.length)];
  }
}
