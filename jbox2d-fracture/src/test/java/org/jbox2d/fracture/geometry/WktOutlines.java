package org.jbox2d.fracture.geometry;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/** Outlines from text files in which each line is some words, then a polygon as WKT. */
public final class WktOutlines {
  private WktOutlines() {}

  /** A line: its words and its outline. */
  public static final class Line {
    public final String[] words;
    public final Outline outline;

    Line(String[] words, Outline outline) {
      this.words = words;
      this.outline = outline;
    }

    @Override
    public String toString() {
      return String.join(" ", words);
    }
  }

  public static List<Line> read(String name) throws IOException {
    List<Line> lines = new ArrayList<>();
    try (BufferedReader reader =
        new BufferedReader(
            new InputStreamReader(
                WktOutlines.class.getResourceAsStream("/org/jbox2d/fracture/outlines/" + name),
                StandardCharsets.UTF_8))) {
      for (String line = reader.readLine(); line != null; line = reader.readLine()) {
        int polygon = line.indexOf("POLYGON");
        if (!line.startsWith("#") && polygon > 0) {
          lines.add(
              new Line(
                  line.substring(0, polygon).trim().split(" "), parse(line.substring(polygon))));
        }
      }
    }
    return lines;
  }

  private static Outline parse(String wkt) {
    String[] rings = wkt.substring(wkt.indexOf("((") + 2, wkt.indexOf("))")).split("\\), *\\(");
    double[][] xy = new double[rings.length][];
    for (int r = 0; r < rings.length; r++) {
      String[] points = rings[r].split(", *");
      xy[r] = new double[2 * (points.length - 1)];
      for (int i = 0; i + 1 < points.length; i++) {
        String[] point = points[i].trim().split(" ");
        xy[r][2 * i] = Double.parseDouble(point[0]);
        xy[r][2 * i + 1] = Double.parseDouble(point[1]);
      }
    }
    return Outline.ofRings(xy);
  }
}
