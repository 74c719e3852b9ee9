package org.jbox2d.benchmarks.charts;

import java.awt.BasicStroke;
import java.awt.Color;
import java.io.IOException;
import java.nio.file.Path;
import org.knowm.xchart.VectorGraphicsEncoder;
import org.knowm.xchart.VectorGraphicsEncoder.VectorGraphicsFormat;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.Styler.LegendPosition;
import org.knowm.xchart.style.lines.SeriesLines;
import org.knowm.xchart.style.markers.Marker;
import org.knowm.xchart.style.markers.SeriesMarkers;

/** A chart of lines with markers over a logarithmic axis. Ours is blue, a peer's orange. */
public final class Drawing {
  /** Of this project. */
  public static final Color OURS = new Color(0x1F5FA8);

  /** Of the peer that is compared most. */
  public static final Color PEER = new Color(0xD9661F);

  /** Of a third. */
  public static final Color THIRD = new Color(0x3B8F4A);

  /** Purple: a fourth thing. */
  public static final Color FOURTH = new Color(0x8A4FA3);

  private static final int WIDTH = 800;
  private static final int HEIGHT = 520;
  private static final float LINE = 2;
  private static final int MARKER = 8;
  private static final String WHOLE = "#,##0";
  private static final Color GRID = new Color(0xE4E4E4);

  private final XYChart chart;

  /** Creates an empty chart. */
  public Drawing(String title, String xTitle, String yTitle) {
    chart =
        new XYChartBuilder()
            .width(WIDTH)
            .height(HEIGHT)
            .title(title)
            .xAxisTitle(xTitle)
            .yAxisTitle(yTitle)
            .build();
    chart
        .getStyler()
        .setXAxisLogarithmic(true)
        .setXAxisDecimalPattern(WHOLE)
        .setPlotGridLinesColor(GRID)
        .setPlotGridLinesStroke(new BasicStroke(1))
        .setLegendPosition(LegendPosition.InsideNW)
        .setChartBackgroundColor(Color.WHITE)
        .setPlotBorderVisible(false)
        .setMarkerSize(MARKER);
  }

  /** Makes the vertical axis logarithmic too. */
  public Drawing logLog() {
    chart.getStyler().setYAxisLogarithmic(true).setYAxisDecimalPattern(WHOLE);
    return this;
  }

  /** Sets how numbers stand at the axes. */
  public Drawing numbers(String x, String y) {
    chart.getStyler().setXAxisDecimalPattern(x).setYAxisDecimalPattern(y);
    return this;
  }

  /** Makes the vertical axis logarithmic and sets its ends. */
  public Drawing logAbove(double low, double high) {
    chart.getStyler().setYAxisLogarithmic(true).setYAxisMin(low).setYAxisMax(high);
    return this;
  }

  /** Sets the ends of the horizontal axis. */
  public Drawing between(double low, double high) {
    chart.getStyler().setXAxisMin(low).setXAxisMax(high);
    return this;
  }

  /** Sets where the legend is. */
  public Drawing legend(LegendPosition position) {
    chart.getStyler().setLegendPosition(position);
    return this;
  }

  /** Adds a line; a dashed one has square markers. */
  public void line(String name, double[] x, double[] y, Color colour, boolean dashed) {
    XYSeries series = chart.addSeries(name, x, y);
    series.setLineColor(colour);
    series.setMarkerColor(colour);
    series.setMarker(dashed ? SeriesMarkers.SQUARE : SeriesMarkers.CIRCLE);
    series.setLineStyle(
        dashed
            ? new BasicStroke(
                LINE, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, new float[] {6, 4}, 0)
            : new BasicStroke(LINE));
  }

  /** Adds points that no line joins. */
  public void points(String name, double[] x, double[] y, Color colour, Marker marker) {
    XYSeries series = chart.addSeries(name, x, y);
    series.setLineStyle(SeriesLines.NONE);
    series.setMarkerColor(colour);
    series.setMarker(marker);
  }

  /** Adds a line without markers. */
  public void curve(String name, double[] x, double[] y, Color colour) {
    XYSeries series = chart.addSeries(name, x, y);
    series.setLineColor(colour);
    series.setMarker(SeriesMarkers.NONE);
    series.setLineStyle(new BasicStroke(LINE));
  }

  /** Writes the chart as SVG. */
  public void write(Path file) throws IOException {
    VectorGraphicsEncoder.saveVectorGraphic(chart, file.toString(), VectorGraphicsFormat.SVG);
  }
}
