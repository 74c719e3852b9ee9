package org.jbox2d.testbed.ui;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.geom.Path2D;
import java.util.Locale;

/** A plot of how long the last steps took, under the overlay's text. */
final class StepPlot {
  /** Number of steps plotted, one pixel each. */
  static final int STEPS = 240;

  private static final int HEIGHT = 48;
  private static final int MARGIN = 10;
  private static final int PADDING = 8;
  private static final Color BACKGROUND = new Color(0x12, 0x15, 0x1b, 0xb8);
  private static final Color LINE = new Color(0x9fb4d6);
  private static final Font FONT = new Font(Font.MONOSPACED, Font.PLAIN, 11);

  private StepPlot() {}

  /**
   * Paints the plot; its top is the longest step.
   *
   * @param millis times, the newest first
   * @param top where to begin, pixels
   */
  static void paint(Graphics2D g, double[] millis, int top) {
    double most = 0;
    for (double m : millis) {
      most = Math.max(most, m);
    }
    if (most == 0) {
      return;
    }
    g.setColor(BACKGROUND);
    g.fillRoundRect(MARGIN, top, STEPS + 2 * PADDING, HEIGHT + 2 * PADDING, PADDING, PADDING);
    Path2D line = new Path2D.Double();
    double base = top + PADDING + HEIGHT;
    for (int i = 0; i < millis.length; i++) {
      double x = MARGIN + PADDING + STEPS - i;
      double y = base - HEIGHT * millis[i] / most;
      if (i == 0) {
        line.moveTo(x, y);
      } else {
        line.lineTo(x, y);
      }
    }
    g.setColor(LINE);
    g.draw(line);
    g.setFont(FONT);
    g.drawString(
        String.format(Locale.ROOT, "longest of %d steps: %.2f ms", millis.length, most),
        MARGIN + PADDING,
        top + PADDING + g.getFontMetrics().getAscent());
  }
}
