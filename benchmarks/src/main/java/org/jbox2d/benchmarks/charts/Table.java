package org.jbox2d.benchmarks.charts;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Rows of figures, written as comma-separated values. */
final class Table {
  private final List<String> lines = new ArrayList<>();

  Table(String... columns) {
    lines.add(String.join(",", columns));
  }

  void add(int size, double... figures) {
    add(Integer.toString(size), figures);
  }

  void add(int size, String label, double... figures) {
    add(size + "," + label, figures);
  }

  private void add(String start, double... figures) {
    StringBuilder line = new StringBuilder(start);
    for (double figure : figures) {
      line.append(',').append(String.format(Locale.ROOT, figure < 100 ? "%.3f" : "%.1f", figure));
    }
    lines.add(line.toString());
  }

  void write(Path file) throws IOException {
    Files.writeString(file, String.join("\n", lines) + "\n");
  }
}
