package org.jbox2d.testbed.ui;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Path2D;
import java.util.List;
import java.util.Locale;
import java.util.function.Supplier;
import java.util.function.ToDoubleFunction;
import javax.swing.JComponent;
import javax.swing.Timer;
import org.jbox2d.testbed.simulation.Phases;
import org.jbox2d.testbed.simulation.Snapshot.Counts;

/** Plots of the last steps: their time by phase, energy, and mass. */
final class PlotPanel extends JComponent {
  /** Steps that are plotted. */
  static final int STEPS = 300;

  private static final long serialVersionUID = 1L;
  private static final int PLOT_HEIGHT = 62;
  private static final int CAPTION = 28;
  private static final int GAP = 6;

  /** The plots need no more than this, and leave the event thread to the canvas, ms. */
  private static final int REFRESH = 100;

  private static final Font FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 11);
  private static final Color GROUND = new Color(0x12151b);
  private static final Color TEXT = new Color(0xb8c0cf);

  /** Phases from the bottom of the stack upwards. */
  private enum Phase {
    COLLIDE("collide", 0x5b8def, Phases::collide),
    SOLVE("solve", 0x4fb477, Phases::solve),
    BROADPHASE("broad", 0x9a86c9, Phases::broadphase),
    CONTINUOUS("impacts", 0xe5b84d, Phases::continuous),
    BREAKING("breaking", 0xe5484d, Phases::breaking);

    final String title;
    final Color colour;
    final ToDoubleFunction<Phases> millis;

    Phase(String title, int colour, ToDoubleFunction<Phases> millis) {
      this.title = title;
      this.colour = new Color(colour);
      this.millis = millis;
    }
  }

  private static final Color KINETIC = new Color(0xe5b84d);
  private static final Color POTENTIAL = new Color(0x5b8def);
  private static final Color MASS = new Color(0x4fb477);

  private final transient Supplier<List<Counts>> source;

  /** Shows the numbers that a source gives, the newest last. */
  PlotPanel(Supplier<List<Counts>> source) {
    this.source = source;
    int height = 3 * (CAPTION + PLOT_HEIGHT + GAP) + CAPTION / 2;
    setPreferredSize(new Dimension(280, height));
    setMinimumSize(new Dimension(120, height));
    Timer timer = new Timer(REFRESH, e -> repaint());
    addHierarchyListener(
        e -> {
          if (isShowing()) {
            timer.start();
          } else {
            timer.stop();
          }
        });
  }

  @Override
  protected void paintComponent(Graphics graphics) {
    Graphics2D g = (Graphics2D) graphics.create();
    g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    g.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    g.setFont(FONT);
    List<Counts> figures = source.get();
    if (!figures.isEmpty()) {
      int y = paintTimes(g, figures, GAP);
      y = paintEnergy(g, figures, y);
      paintMass(g, figures, y);
    }
    g.dispose();
  }

  private int paintTimes(Graphics2D g, List<Counts> figures, int top) {
    double most = 0;
    for (Counts c : figures) {
      most = Math.max(most, c.phases().step());
    }
    int y = caption(g, top, String.format(Locale.ROOT, "Step time, at most %.2f ms", most));
    int x = GAP;
    for (Phase phase : Phase.values()) {
      x = legend(g, x, y, phase.title, phase.colour);
    }
    y = ground(g, y + GAP);
    double[] base = new double[figures.size()];
    for (Phase phase : Phase.values()) {
      Path2D area = new Path2D.Double();
      area.moveTo(toX(figures, 0), toY(y, base[0], 0, most));
      for (int i = 1; i < base.length; i++) {
        area.lineTo(toX(figures, i), toY(y, base[i], 0, most));
      }
      for (int i = base.length - 1; i >= 0; i--) {
        base[i] += phase.millis.applyAsDouble(figures.get(i).phases());
        area.lineTo(toX(figures, i), toY(y, base[i], 0, most));
      }
      g.setColor(phase.colour);
      g.fill(area);
    }
    return y + GAP;
  }

  private int paintEnergy(Graphics2D g, List<Counts> figures, int top) {
    Counts last = figures.get(figures.size() - 1);
    double kinetic = last.totals().kineticEnergy();
    double potential = last.totals().potentialEnergy();
    int y = caption(g, top, String.format(Locale.ROOT, "Energy, now %.4g J", kinetic + potential));
    int x = legend(g, GAP, y, "kinetic", KINETIC);
    x = legend(g, x, y, "potential", POTENTIAL);
    legend(g, x, y, "sum", TEXT);
    y = ground(g, y + GAP);
    double least = 0;
    double most = 0;
    for (Counts c : figures) {
      double k = c.totals().kineticEnergy();
      double p = c.totals().potentialEnergy();
      least = Math.min(least, p);
      most = Math.max(most, Math.max(k + p, Math.max(k, p)));
    }
    line(g, figures, y, least, most, KINETIC, c -> c.totals().kineticEnergy());
    line(g, figures, y, least, most, POTENTIAL, c -> c.totals().potentialEnergy());
    line(
        g,
        figures,
        y,
        least,
        most,
        TEXT,
        c -> c.totals().kineticEnergy() + c.totals().potentialEnergy());
    return y + GAP;
  }

  private void paintMass(Graphics2D g, List<Counts> figures, int top) {
    double now = figures.get(figures.size() - 1).totals().mass();
    String text = String.format(Locale.ROOT, "Mass, now %.6g kg", now);
    int y = ground(g, caption(g, top, text) - CAPTION / 2 + GAP);
    double most = 0;
    for (Counts c : figures) {
      most = Math.max(most, c.totals().mass());
    }
    line(g, figures, y, 0, 1.1 * most, MASS, c -> c.totals().mass());
  }

  private int caption(Graphics2D g, int top, String text) {
    g.setColor(TEXT);
    g.drawString(text, GAP, top + g.getFontMetrics().getAscent());
    return top + CAPTION;
  }

  private int legend(Graphics2D g, int x, int y, String text, Color colour) {
    g.setColor(colour);
    g.fillRect(x, y - 7, 7, 7);
    g.drawString(text, x + 10, y);
    return x + 16 + g.getFontMetrics().stringWidth(text);
  }

  /** Paints the ground of a plot; returns its lower end. */
  private int ground(Graphics2D g, int top) {
    g.setColor(GROUND);
    g.fillRect(GAP, top, getWidth() - 2 * GAP, PLOT_HEIGHT);
    g.setStroke(new BasicStroke(1.2f));
    return top + PLOT_HEIGHT;
  }

  private void line(
      Graphics2D g,
      List<Counts> figures,
      int base,
      double least,
      double most,
      Color colour,
      ToDoubleFunction<Counts> value) {
    Path2D line = new Path2D.Double();
    line.moveTo(toX(figures, 0), toY(base, value.applyAsDouble(figures.get(0)), least, most));
    for (int i = 1; i < figures.size(); i++) {
      double v = value.applyAsDouble(figures.get(i));
      line.lineTo(toX(figures, i), toY(base, v, least, most));
    }
    g.setColor(colour);
    g.draw(line);
  }

  private double toX(List<Counts> figures, int i) {
    double back = figures.size() - 1.0 - i;
    return getWidth() - GAP - back * (getWidth() - 2 * GAP) / STEPS;
  }

  private static double toY(int base, double value, double least, double most) {
    return most > least ? base - PLOT_HEIGHT * (value - least) / (most - least) : base;
  }
}
