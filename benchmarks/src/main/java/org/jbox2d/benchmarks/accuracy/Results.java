package org.jbox2d.benchmarks.accuracy;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.jbox2d.benchmarks.engines.Contender;
import org.jbox2d.benchmarks.engines.Setting;

/** Results of a run, in a file of comma-separated values. */
final class Results {
  static final String FILE = "accuracy.csv";
  private static final String HEAD = "scene,solver,level,hz,error,limit,failed,cost_ms";
  private static final int COST_COLUMN = 7;
  private static final int ERROR_COLUMN = 4;

  private final List<Result> rows = new ArrayList<>();

  void add(Result result) {
    rows.add(result);
  }

  List<Result> rows() {
    return rows;
  }

  void write(Path file) throws IOException {
    List<String> lines = new ArrayList<>();
    lines.add(HEAD);
    for (Result r : rows) {
      lines.add(
          String.format(
              Locale.ROOT,
              "%s,%s,%d,%d,%.3g,%s,%d,%.3g",
              r.scene().name(),
              r.solver().label,
              r.setting().level(),
              r.setting().hz(),
              r.error(),
              r.scene().limit(),
              r.failed() ? 1 : 0,
              r.cost()));
    }
    Files.writeString(file, String.join("\n", lines) + "\n");
  }

  /** Reads the results that are packed with this class. */
  static Results last() throws IOException {
    try (InputStream in = Results.class.getResourceAsStream(FILE)) {
      if (in == null) {
        throw new IOException("no results are packed: give a file, or measure");
      }
      return parse(new String(in.readAllBytes(), StandardCharsets.UTF_8).lines().toList(), FILE);
    }
  }

  /** Reads a file of a run. */
  static Results read(Path file) throws IOException {
    return parse(Files.readAllLines(file), file.toString());
  }

  /** Scenes that are no more are left out. */
  private static Results parse(List<String> lines, String file) throws IOException {
    Map<String, Scene> scenes = new LinkedHashMap<>();
    Suite.common().forEach(s -> scenes.put(s.name(), s));
    Suite.fracture().forEach(s -> scenes.put(s.name(), s));
    Results results = new Results();
    if (lines.isEmpty() || !lines.get(0).equals(HEAD)) {
      throw new IOException(file + " is not a file of results");
    }
    for (String line : lines.subList(1, lines.size())) {
      String[] c = line.split(",");
      Scene scene = scenes.get(c[0]);
      if (scene != null) {
        Setting setting = new Setting(Integer.parseInt(c[2]), Integer.parseInt(c[3]));
        results.add(
            new Result(
                scene,
                Contender.of(c[1]),
                setting,
                Double.parseDouble(c[ERROR_COLUMN]),
                Double.parseDouble(c[COST_COLUMN])));
      }
    }
    return results;
  }

  /** A summary of the scenes that all engines run, for each solver and setting. */
  List<Summary> summaries() {
    List<String> common = Suite.common().stream().map(Scene::name).toList();
    Map<String, List<Result>> groups = new LinkedHashMap<>();
    for (Result r : rows) {
      if (common.contains(r.scene().name())) {
        String key = r.solver().label + r.setting();
        groups.computeIfAbsent(key, k -> new ArrayList<>()).add(r);
      }
    }
    return groups.values().stream().map(Summary::of).toList();
  }
}
