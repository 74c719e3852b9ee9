package org.jbox2d.testbed.ui;

import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.jbox2d.testbed.paint.View;
import org.jbox2d.testbed.simulation.Snapshot;

/** The text at the left of the window: controls, pointer, view, and numbers of the run. */
final class Overlay {
  private static final Font FONT = new Font(Font.MONOSPACED, Font.PLAIN, 12);
  private static final Font HINT_FONT = new Font(Font.SANS_SERIF, Font.BOLD, 18);
  private static final Color BACKGROUND = new Color(0x12, 0x15, 0x1b, 0xb8);
  private static final Color KEY = new Color(0x9fb4d6);
  private static final Color VALUE = new Color(0xe4e8ef);
  private static final int MARGIN = 10;
  private static final int PADDING = 8;
  private static final int COLUMN = 112;

  private static final String[][] CONTROLS = {
    {"s, space", "start / stop"},
    {"n", "single step"},
    {"r", "reset"},
    {"left drag", "move a body"},
    {"right drag", "pan"},
    {"wheel", "zoom"},
    {"f", "whole scene"},
    {"shift+click, b", "throw a disc"},
    {"ctrl+drag", "cut"},
    {"x", "break at the pointer"},
    {"e", "explosion"},
    {"left, right", "back / forward"},
    {"1 ... 9", "layers"},
    {"h", "hide this text"},
  };

  private Overlay() {}

  /** Returns the lines, each a key and a value; an empty key for a gap. */
  static List<String[]> lines(Snapshot.Counts counts, View view, double mouseX, double mouseY) {
    List<String[]> lines = new ArrayList<>(List.of(CONTROLS));
    lines.add(new String[] {"", ""});
    lines.add(line("mouse", "%.2f, %.2f m", mouseX, mouseY));
    lines.add(line("centre", "%.2f, %.2f m", view.centreX(), view.centreY()));
    lines.add(line("zoom", "%.1f px/m", view.scale()));
    lines.add(new String[] {"", ""});
    lines.add(line("bodies", "%d", counts.bodies()));
    lines.add(line("fixtures", "%d", counts.fixtures()));
    lines.add(line("contacts", "%d", counts.contacts()));
    lines.add(line("particles", "%d", counts.particles()));
    lines.add(line("fractures", "%d", counts.fractures()));
    lines.add(line("time", "%.2f s", counts.time()));
    lines.add(line("step", "%.2f ms", counts.phases().step()));
    return lines;
  }

  private static String[] line(String key, String format, Object... values) {
    return new String[] {key, String.format(Locale.ROOT, format, values)};
  }

  /** Paints lines on a translucent ground. */
  static void paint(Graphics2D g, List<String[]> lines) {
    g.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    g.setFont(FONT);
    FontMetrics metrics = g.getFontMetrics();
    int height = metrics.getHeight();
    int width = 0;
    for (String[] line : lines) {
      width = Math.max(width, COLUMN + metrics.stringWidth(line[1]));
    }
    g.setColor(BACKGROUND);
    g.fillRoundRect(
        MARGIN, MARGIN, width + 2 * PADDING, lines.size() * height + 2 * PADDING, PADDING, PADDING);
    int y = MARGIN + PADDING + metrics.getAscent();
    for (String[] line : lines) {
      g.setColor(KEY);
      g.drawString(line[0], MARGIN + PADDING, y);
      g.setColor(VALUE);
      g.drawString(line[1], MARGIN + PADDING + COLUMN, y);
      y += height;
    }
  }

  /** Paints a line in the middle, near the top. */
  static void paintHint(Graphics2D g, String hint, int width) {
    g.setFont(HINT_FONT);
    FontMetrics metrics = g.getFontMetrics();
    int textWidth = metrics.stringWidth(hint);
    int x = (width - textWidth) / 2;
    int y = 3 * MARGIN + metrics.getAscent();
    g.setColor(BACKGROUND);
    g.fillRoundRect(
        x - 2 * PADDING,
        y - metrics.getAscent() - PADDING,
        textWidth + 4 * PADDING,
        metrics.getHeight() + 2 * PADDING,
        PADDING,
        PADDING);
    g.setColor(VALUE);
    g.drawString(hint, x, y);
  }
}
