package org.jbox2d.benchmarks.accuracy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.jbox2d.benchmarks.engines.Contender;
import org.jbox2d.benchmarks.engines.Setting;

/**
 * Scene by setting of what fails, as SVG. All cells of a shade are one path: a chart of XChart with
 * as many cells takes megabytes.
 */
final class HeatMap {
  private static final int CELL = 9;
  private static final int ROW = 12;
  private static final int GAP = 8;
  private static final int LEFT = 150;
  private static final int TOP = 116;

  /** Greatest error over limit of each shade; the last is for all above. */
  private static final double[] BOUNDS = {0.1, 1, 10};

  private static final String[] SHADES = {"#2e7d32", "#b9dcb9", "#f2a97e", "#b3261e"};
  private static final String[] MEANINGS = {
    "a tenth of the limit or less", "holds", "fails", "ten times the limit or more"
  };

  private final Map<String, Map<String, Result>> byScene = new LinkedHashMap<>();
  private final List<Contender> solvers = new ArrayList<>();
  private final Map<Contender, List<Setting>> settings = new LinkedHashMap<>();

  HeatMap(List<Result> results) {
    for (Result r : results) {
      byScene
          .computeIfAbsent(r.scene().name(), k -> new LinkedHashMap<>())
          .put(key(r.solver(), r.setting()), r);
      List<Setting> own = settings.computeIfAbsent(r.solver(), k -> new ArrayList<>());
      if (!own.contains(r.setting())) {
        own.add(r.setting());
      }
    }
    solvers.addAll(settings.keySet());
    byScene.values().removeIf(row -> row.values().stream().noneMatch(Result::failed));
  }

  private static String key(Contender solver, Setting setting) {
    return solver.label + setting;
  }

  private static int shade(Result r) {
    int shade = 0;
    while (shade < BOUNDS.length && r.error() > BOUNDS[shade] * r.scene().limit()) {
      shade++;
    }
    return shade;
  }

  void write(Path file) throws IOException {
    StringBuilder[] paths = new StringBuilder[SHADES.length];
    for (int i = 0; i < paths.length; i++) {
      paths[i] = new StringBuilder();
    }
    StringBuilder text = new StringBuilder();
    int y = TOP;
    for (Map.Entry<String, Map<String, Result>> row : byScene.entrySet()) {
      label(text, LEFT - 4, y + CELL, "end", row.getKey());
      int x = LEFT;
      for (Contender solver : solvers) {
        for (Setting setting : settings.get(solver)) {
          Result r = row.getValue().get(key(solver, setting));
          if (r != null) {
            paths[shade(r)].append(
                String.format(Locale.ROOT, "M%d %dh%dv%dh-%dz", x, y, CELL - 1, ROW - 1, CELL - 1));
          }
          x += CELL;
        }
        x += GAP;
      }
      y += ROW;
    }
    int width = heads(text);
    StringBuilder svg = new StringBuilder();
    svg.append(
        String.format(
            Locale.ROOT,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\""
                + " font-family=\"sans-serif\" font-size=\"9\">%n"
                + "<rect width=\"100%%\" height=\"100%%\" fill=\"white\"/>%n",
            width,
            y + GAP));
    for (int i = 0; i < SHADES.length; i++) {
      svg.append("<path fill=\"").append(SHADES[i]).append("\" d=\"");
      svg.append(paths[i]).append("\"/>\n");
    }
    svg.append(text).append("</svg>\n");
    Files.writeString(file, svg.toString().replace(System.lineSeparator(), "\n"));
  }

  /** Names of solvers and settings, and the key; returns the width of all. */
  private int heads(StringBuilder text) {
    int x = LEFT;
    for (Contender solver : solvers) {
      label(text, x, 36, "start", solver.label);
      for (Setting setting : settings.get(solver)) {
        text.append(
            String.format(
                Locale.ROOT,
                "<text transform=\"translate(%d %d) rotate(-90)\" font-size=\"7\">%s @%d</text>%n",
                x + CELL - 2,
                TOP - 3,
                solver.describe(setting),
                setting.hz()));
        x += CELL;
      }
      x += GAP;
    }
    int at = LEFT;
    for (int i = 0; i < SHADES.length; i++) {
      text.append(
          String.format(
              Locale.ROOT,
              "<rect x=\"%d\" y=\"10\" width=\"%d\" height=\"%d\" fill=\"%s\"/>%n",
              at,
              CELL,
              CELL,
              SHADES[i]));
      label(text, at + CELL + 4, 10 + CELL - 1, "start", MEANINGS[i]);
      at += 150;
    }
    return Math.max(x, at);
  }

  private static void label(StringBuilder text, int x, int y, String anchor, String words) {
    text.append(
        String.format(
            Locale.ROOT,
            "<text x=\"%d\" y=\"%d\" text-anchor=\"%s\">%s</text>%n",
            x,
            y,
            anchor,
            words));
  }
}
