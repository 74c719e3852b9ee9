package org.jbox2d.benchmarks.charts;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FractureChartsTest {
  @Test
  void writesHistogramsAndFigures(@TempDir Path directory)
      throws IOException, InterruptedException {
    new FractureCharts(new FractureCharts.Amount(0, 1, 70, 20, 1), directory).run();
    List<String> rows = Files.readAllLines(directory.resolve("fracture.csv"));
    assertEquals(8, rows.size());
    for (String row : rows.subList(1, rows.size())) {
      String[] cells = row.split(",");
      assertTrue(Integer.parseInt(cells[1]) > 0, row);
      double median = Double.parseDouble(cells[2]);
      assertTrue(median > 0 && median <= Double.parseDouble(cells[3]), row);
    }
    for (String name : List.of("fracture-time", "voronoi-time")) {
      String svg = Files.readString(directory.resolve(name + ".svg"));
      assertTrue(svg.trim().endsWith("</svg>"), name);
      List<String> bins = Files.readAllLines(directory.resolve(name + ".csv"));
      int sum = 0;
      for (String bin : bins.subList(1, bins.size())) {
        sum += Integer.parseInt(bin.split(",")[1]);
      }
      String wanted = name.equals("voronoi-time") ? "Voronoi" : "whole";
      String row = rows.stream().filter(r -> r.startsWith(wanted)).findFirst().orElseThrow();
      assertEquals(row.split(",")[1], String.valueOf(sum), name);
    }
  }
}
