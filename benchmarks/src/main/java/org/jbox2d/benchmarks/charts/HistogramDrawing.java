package org.jbox2d.benchmarks.charts;

import java.awt.Color;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.knowm.xchart.CategoryChart;
import org.knowm.xchart.CategoryChartBuilder;
import org.knowm.xchart.VectorGraphicsEncoder;
import org.knowm.xchart.VectorGraphicsEncoder.VectorGraphicsFormat;

/** A histogram of times, with its bins as CSV; what lies beyond the last bin is counted in it. */
final class HistogramDrawing {
  private static final int BINS = 40;
  private static final int WIDTH = 800;
  private static final int HEIGHT = 420;

  /** One label on the axis for so many bins. */
  private static final int LABEL_EVERY = 5;

  private final String title;
  private final String unit;

  HistogramDrawing(String title, String unit) {
    this.title = title;
    this.unit = unit;
  }

  /** Writes the chart and its bins beside each other. */
  void write(double[] values, double most, Path file) throws IOException {
    int[] counts = new int[BINS];
    for (double value : values) {
      counts[(int) Math.min(BINS - 1, value * BINS / most)]++;
    }
    List<Double> from = new ArrayList<>();
    List<Integer> heights = new ArrayList<>();
    List<String> rows = new ArrayList<>();
    rows.add("from_us,count");
    for (int i = 0; i < BINS; i++) {
      from.add(i * most / BINS);
      heights.add(counts[i]);
      rows.add(String.format(Locale.ROOT, "%.1f,%d", i * most / BINS, counts[i]));
    }
    Files.write(file.resolveSibling(file.getFileName() + ".csv"), rows);
    CategoryChart chart =
        new CategoryChartBuilder()
            .width(WIDTH)
            .height(HEIGHT)
            .title(title)
            .xAxisTitle(unit)
            .yAxisTitle("count of " + values.length)
            .build();
    chart
        .getStyler()
        .setAvailableSpaceFill(0.98)
        .setLegendVisible(false)
        .setChartBackgroundColor(Color.WHITE)
        .setPlotBorderVisible(false)
        .setDecimalPattern("#,##0");
    chart.getStyler().setXAxisMaxLabelCount(BINS / LABEL_EVERY);
    chart.addSeries(title, from, heights).setFillColor(Drawing.OURS);
    VectorGraphicsEncoder.saveVectorGraphic(chart, file.toString(), VectorGraphicsFormat.SVG);
  }
}
