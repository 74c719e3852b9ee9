package org.jbox2d.testbed.paint;

import java.awt.BasicStroke;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.testbed.simulation.FractureTrace;
import org.jbox2d.testbed.simulation.Snapshot;

/** Draws what is not a body: boxes, contacts, centres, cells, numbers. */
final class DebugPainter {
  private static final double MARK_PIXELS = 4;
  private static final float LINE_PIXELS = 1f;
  private static final float STRONG_PIXELS = 1.5f;

  /** Length of the line for an impulse of 1 N s; it grows with the square root. */
  private static final double IMPULSE_PIXELS = 10;

  private static final Font FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 10);

  private final Palette palette;

  DebugPainter(Palette palette) {
    this.palette = palette;
  }

  void paint(Graphics2D g, Snapshot s, View view, Layers layers) {
    if (layers.has(Layer.BOXES)) {
      paintBoxes(g, s, view);
    }
    if (layers.has(Layer.CELLS) && s.lastFracture() != null) {
      paintFracture(g, s.lastFracture(), view);
    }
    if (layers.has(Layer.CONTACTS)) {
      paintContacts(g, s, view);
    }
    if (layers.has(Layer.CENTRES)) {
      paintCentres(g, s, view);
    }
    if (layers.has(Layer.IDS)) {
      paintIds(g, s, view);
    }
  }

  private void paintBoxes(Graphics2D g, Snapshot s, View view) {
    g.setColor(palette.box());
    g.setStroke(new BasicStroke(LINE_PIXELS));
    for (int i = 0; i < s.boxCount(); i++) {
      double left = view.toPictureX(s.box(i, 0));
      double low = view.toPictureY(s.box(i, 1));
      double right = view.toPictureX(s.box(i, 2));
      double high = view.toPictureY(s.box(i, 3));
      g.draw(new Rectangle2D.Double(left, high, right - left, low - high));
    }
  }

  private void paintFracture(Graphics2D g, FractureTrace fracture, View view) {
    g.setColor(palette.cell());
    g.setStroke(new BasicStroke(LINE_PIXELS));
    drawRings(g, fracture.cells(), view);
    g.setColor(palette.region());
    g.setStroke(new BasicStroke(STRONG_PIXELS));
    drawRings(g, fracture.regions(), view);
  }

  private static void drawRings(Graphics2D g, List<float[]> rings, View view) {
    Path2D path = new Path2D.Double();
    for (float[] ring : rings) {
      path.moveTo(view.toPictureX(ring[0]), view.toPictureY(ring[1]));
      for (int i = 2; i < ring.length; i += 2) {
        path.lineTo(view.toPictureX(ring[i]), view.toPictureY(ring[i + 1]));
      }
      path.closePath();
    }
    g.draw(path);
  }

  private void paintContacts(Graphics2D g, Snapshot s, View view) {
    g.setColor(palette.contact());
    g.setStroke(new BasicStroke(STRONG_PIXELS));
    for (int i = 0; i < s.contactCount(); i++) {
      double x = view.toPictureX(s.contact(i, 0));
      double y = view.toPictureY(s.contact(i, 1));
      double dx = s.contact(i, 2);
      double dy = s.contact(i, 3);
      double impulse = Math.hypot(dx, dy);
      double length = impulse > 0 ? IMPULSE_PIXELS * Math.sqrt(impulse) / impulse : 0;
      g.fill(mark(x, y));
      g.draw(new Line2D.Double(x, y, x + dx * length, y - dy * length));
    }
  }

  private void paintCentres(Graphics2D g, Snapshot s, View view) {
    g.setColor(palette.text());
    for (int i = 0; i < s.bodyCount(); i++) {
      if (s.outline(i).type != BodyType.STATIC) {
        g.fill(mark(view.toPictureX(s.centreX(i)), view.toPictureY(s.centreY(i))));
      }
    }
  }

  private static Ellipse2D mark(double x, double y) {
    return new Ellipse2D.Double(x - MARK_PIXELS / 2, y - MARK_PIXELS / 2, MARK_PIXELS, MARK_PIXELS);
  }

  private void paintIds(Graphics2D g, Snapshot s, View view) {
    g.setColor(palette.text());
    g.setFont(FONT);
    FontMetrics metrics = g.getFontMetrics();
    for (int i = 0; i < s.bodyCount(); i++) {
      if (s.outline(i).type != BodyType.STATIC || !s.outline(i).material.isEmpty()) {
        String id = Integer.toString(s.outline(i).id);
        float x = (float) view.toPictureX(s.centreX(i)) - metrics.stringWidth(id) / 2f;
        float y = (float) view.toPictureY(s.centreY(i)) + metrics.getAscent() / 2f;
        g.drawString(id, x, y);
      }
    }
  }
}
