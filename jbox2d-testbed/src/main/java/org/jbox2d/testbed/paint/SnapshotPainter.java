package org.jbox2d.testbed.paint;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.image.BufferedImage;
import org.jbox2d.testbed.simulation.BodyOutline;
import org.jbox2d.testbed.simulation.Snapshot;

/**
 * Draws a snapshot: filled shapes with their outlines, bodies of several parts without the edges
 * between them, joints as lines, and more in {@link Layers}. Reads nothing but the snapshot.
 */
public final class SnapshotPainter {
  private static final float EDGE_PIXELS = 1.1f;
  private static final float JOINT_PIXELS = 1.5f;
  private static final double GRID_METRES = 10;

  /** Below this many pixels between its lines the grid is left out. */
  private static final double GRID_MIN_PIXELS = 24;

  private final Palette palette;
  private final DebugPainter debug;
  private final Path2D.Double area = new Path2D.Double(Path2D.WIND_NON_ZERO);
  private final Path2D.Double edges = new Path2D.Double();

  /** A painter with the given colours. */
  public SnapshotPainter(Palette palette) {
    this.palette = palette;
    debug = new DebugPainter(palette);
  }

  /** Returns a picture of a snapshot. */
  public BufferedImage image(Snapshot snapshot, View view) {
    return image(snapshot, view, Layers.USUAL);
  }

  /** Returns a picture of a snapshot with the given layers. */
  public BufferedImage image(Snapshot snapshot, View view, Layers layers) {
    BufferedImage image =
        new BufferedImage(view.width(), view.height(), BufferedImage.TYPE_INT_RGB);
    Graphics2D g = image.createGraphics();
    paint(g, snapshot, view, layers);
    g.dispose();
    return image;
  }

  /** Paints a snapshot over the whole view. */
  public void paint(Graphics2D g, Snapshot snapshot, View view, Layers layers) {
    g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    g.setColor(palette.ground());
    g.fillRect(0, 0, view.width(), view.height());
    paintGrid(g, view);
    g.setStroke(new BasicStroke(EDGE_PIXELS, BasicStroke.CAP_BUTT, BasicStroke.JOIN_BEVEL));
    for (int i = 0; i < snapshot.bodyCount(); i++) {
      paintBody(g, snapshot, i, view, layers);
    }
    if (layers.has(Layer.JOINTS)) {
      paintJoints(g, snapshot, view);
    }
    debug.paint(g, snapshot, view, layers);
  }

  private void paintGrid(Graphics2D g, View view) {
    if (view.scale() * GRID_METRES < GRID_MIN_PIXELS) {
      return;
    }
    g.setColor(palette.grid());
    g.setStroke(new BasicStroke(1f));
    double left = Math.ceil(view.toWorldX(0) / GRID_METRES) * GRID_METRES;
    for (double x = left; view.toPictureX(x) < view.width(); x += GRID_METRES) {
      g.draw(new Line2D.Double(view.toPictureX(x), 0, view.toPictureX(x), view.height()));
    }
    double low = Math.ceil(view.toWorldY(view.height()) / GRID_METRES) * GRID_METRES;
    for (double y = low; view.toPictureY(y) > 0; y += GRID_METRES) {
      g.draw(new Line2D.Double(0, view.toPictureY(y), view.width(), view.toPictureY(y)));
    }
  }

  private void paintBody(Graphics2D g, Snapshot s, int body, View view, Layers layers) {
    BodyOutline outline = s.outline(body);
    Placement at = new Placement(s, body, view);
    if (!at.sees(outline)) {
      return;
    }
    boolean inner = layers.has(Layer.PARTS);
    area.reset();
    edges.reset();
    for (int p = 0; p < outline.partCount(); p++) {
      addPart(outline, p, at, inner);
    }
    boolean lively = s.isAwake(body) || !layers.has(Layer.SLEEPING);
    Color fill = palette.fill(outline, lively);
    if (layers.has(Layer.SHAPES)) {
      g.setColor(fill);
      g.fill(area);
      if (outline.partCount() > 1) {
        // Anti-aliasing leaves a hair's breadth of the ground between parts that share an edge.
        g.draw(area);
      }
    }
    g.setColor(layers.has(Layer.SHAPES) ? palette.edge(outline, fill) : fill);
    // One closed path is drawn faster than as many single lines.
    g.draw(outline.isOnePolygon() ? area : edges);
  }

  private void addPart(BodyOutline outline, int part, Placement at, boolean inner) {
    int from = outline.start(part);
    int to = outline.start(part + 1);
    if (to - from == 1) {
      addCircle(outline, from, outline.radius(part), at);
      return;
    }
    boolean filled = to - from > 2;
    for (int i = from; i < to; i++) {
      double x = at.x(outline, i);
      double y = at.y(outline, i);
      if (filled && i == from) {
        area.moveTo(x, y);
      } else if (filled) {
        area.lineTo(x, y);
      }
      boolean last = i + 1 == to;
      if ((inner || !outline.isInner(i)) && (filled || !last)) {
        int next = last ? from : i + 1;
        edges.moveTo(x, y);
        edges.lineTo(at.x(outline, next), at.y(outline, next));
      }
    }
    if (filled) {
      area.closePath();
    }
  }

  /** A circle has a line from its centre, by which its turning is seen. */
  private void addCircle(BodyOutline outline, int vertex, float radius, Placement at) {
    double x = at.x(outline, vertex);
    double y = at.y(outline, vertex);
    double r = radius * at.view.scale();
    Ellipse2D circle = new Ellipse2D.Double(x - r, y - r, 2 * r, 2 * r);
    area.append(circle, false);
    edges.append(circle, false);
    edges.moveTo(x, y);
    edges.lineTo(x + r * at.cos, y - r * at.sin);
  }

  private void paintJoints(Graphics2D g, Snapshot s, View view) {
    g.setColor(palette.joint());
    g.setStroke(new BasicStroke(JOINT_PIXELS));
    for (int i = 0; i < s.lineCount(); i++) {
      g.draw(
          new Line2D.Double(
              view.toPictureX(s.line(i, 0)),
              view.toPictureY(s.line(i, 1)),
              view.toPictureX(s.line(i, 2)),
              view.toPictureY(s.line(i, 3))));
    }
  }

  /** Where a body is in the picture. */
  private static final class Placement {
    final View view;
    final double cos;
    final double sin;
    private final double px;
    private final double py;

    Placement(Snapshot s, int body, View view) {
      this.view = view;
      cos = s.cos(body);
      sin = s.sin(body);
      px = s.x(body);
      py = s.y(body);
    }

    /** Whether any of a body may be in the picture. */
    boolean sees(BodyOutline outline) {
      double r = outline.reach() * view.scale();
      double x = view.toPictureX(px);
      double y = view.toPictureY(py);
      return x + r >= 0 && y + r >= 0 && x - r <= view.width() && y - r <= view.height();
    }

    double x(BodyOutline outline, int vertex) {
      return view.toPictureX(px + cos * outline.x(vertex) - sin * outline.y(vertex));
    }

    double y(BodyOutline outline, int vertex) {
      return view.toPictureY(py + sin * outline.x(vertex) + cos * outline.y(vertex));
    }
  }
}
