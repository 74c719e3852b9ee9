package org.jbox2d.testbed.ui;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.JComponent;
import javax.swing.SwingUtilities;
import org.jbox2d.testbed.paint.Layers;
import org.jbox2d.testbed.paint.Palette;
import org.jbox2d.testbed.paint.SnapshotPainter;
import org.jbox2d.testbed.paint.View;
import org.jbox2d.testbed.scenes.Scene.Framing;
import org.jbox2d.testbed.simulation.Input;
import org.jbox2d.testbed.simulation.Input.Action;
import org.jbox2d.testbed.simulation.Snapshot;

/**
 * Shows the last snapshot and turns what the mouse does into changes of the view, or into commands
 * for the simulation. Of the event thread alone.
 */
final class WorldCanvas extends JComponent {
  /** Factor of a click of the wheel. */
  private static final double WHEEL_FACTOR = 1.15;

  private static final Color CUT = new Color(0xe5484d);

  private static final long serialVersionUID = 1L;

  private final transient SnapshotPainter painter = new SnapshotPainter(Palette.DARK);
  private final transient Supplier<Snapshot> source;
  private final transient Consumer<Input> commands;
  private transient Framing framing;
  private transient View view;
  private Point mouse = new Point();

  /** Where a cut has begun, or {@code null}. */
  private Point cutStart;

  private String hint;
  private transient Layers layers = Layers.USUAL;
  private boolean overlay = true;

  /** Whether the user has not moved the view, so that the whole scene is to stay in sight. */
  private boolean untouched;

  /**
   * A canvas.
   *
   * @param source gives the snapshot to show, or {@code null} while there is none
   * @param commands takes what is to be done to the world
   */
  WorldCanvas(Framing framing, Supplier<Snapshot> source, Consumer<Input> commands) {
    this.source = source;
    this.commands = commands;
    setPreferredSize(new Dimension(760, 700));
    setFocusable(true);
    setOpaque(true);
    frame(framing);
    Mouse handler = new Mouse();
    addMouseListener(handler);
    addMouseMotionListener(handler);
    addMouseWheelListener(handler);
    addComponentListener(
        new ComponentAdapter() {
          @Override
          public void componentResized(ComponentEvent e) {
            fit();
          }
        });
  }

  /** Shows all of a part of the world. */
  void frame(Framing whole) {
    framing = whole;
    untouched = true;
    Dimension size = getWidth() > 0 ? getSize() : getPreferredSize();
    view = View.of(framing, size.width, size.height);
    repaint();
  }

  /** Shows all of the scene again. */
  void frameAgain() {
    frame(framing);
  }

  /** Shows a line at the top, or none if {@code null}. */
  void setHint(String hint) {
    this.hint = hint;
    repaint();
  }

  /** Returns the line at the top, or {@code null}. */
  String hint() {
    return hint;
  }

  /** Sets what is shown. */
  void setLayers(Layers layers) {
    this.layers = layers;
    repaint();
  }

  /** Returns what is shown. */
  Layers layers() {
    return layers;
  }

  /** Shows or hides the text at the left. */
  void toggleOverlay() {
    overlay = !overlay;
    repaint();
  }

  /** Returns how the world is mapped to the canvas. */
  View view() {
    return view;
  }

  /** Throws a disc at the pointer. */
  void shootAtPointer() {
    float x = worldX(mouse.x);
    float y = worldY(mouse.y);
    commands.accept(Input.at(Action.THROW, x, y));
  }

  /** Breaks what is at the pointer. */
  void breakAtPointer() {
    float x = worldX(mouse.x);
    float y = worldY(mouse.y);
    commands.accept(Input.at(Action.BREAK, x, y));
  }

  /** Sets off an explosion at the pointer. */
  void explodeAtPointer() {
    float x = worldX(mouse.x);
    float y = worldY(mouse.y);
    commands.accept(Input.at(Action.EXPLODE, x, y));
  }

  private void fit() {
    if (getWidth() > 0 && getHeight() > 0) {
      if (untouched) {
        frameAgain();
      } else {
        view = view.resized(getWidth(), getHeight());
        repaint();
      }
    }
  }

  private float worldX(int x) {
    return (float) view.toWorldX(x);
  }

  private float worldY(int y) {
    return (float) view.toWorldY(y);
  }

  @Override
  protected void paintComponent(Graphics graphics) {
    Snapshot snapshot = source.get();
    if (snapshot == null) {
      graphics.setColor(Color.BLACK);
      graphics.fillRect(0, 0, getWidth(), getHeight());
      return;
    }
    Graphics2D g = (Graphics2D) graphics.create();
    painter.paint(g, snapshot, view, layers);
    if (overlay) {
      Overlay.paint(
          g,
          Overlay.lines(snapshot.counts(), view, view.toWorldX(mouse.x), view.toWorldY(mouse.y)));
    }
    if (cutStart != null) {
      g.setColor(CUT);
      g.drawLine(cutStart.x, cutStart.y, mouse.x, mouse.y);
    }
    if (hint != null) {
      Overlay.paintHint(g, hint, getWidth());
    }
    g.dispose();
  }

  /** Left drags bodies, throws or cuts, right drags the view, the wheel zooms about the pointer. */
  private final class Mouse extends MouseAdapter {
    private boolean holding;

    @Override
    public void mousePressed(MouseEvent e) {
      requestFocusInWindow();
      mouse = e.getPoint();
      if (!SwingUtilities.isLeftMouseButton(e)) {
        return;
      }
      if (e.isShiftDown()) {
        shootAtPointer();
        return;
      }
      if (e.isControlDown()) {
        cutStart = e.getPoint();
        return;
      }
      holding = true;
      float x = worldX(e.getX());
      float y = worldY(e.getY());
      commands.accept(Input.at(Action.GRAB, x, y));
    }

    @Override
    public void mouseReleased(MouseEvent e) {
      if (!SwingUtilities.isLeftMouseButton(e)) {
        return;
      }
      if (cutStart != null) {
        cut(worldX(cutStart.x), worldY(cutStart.y), worldX(e.getX()), worldY(e.getY()));
        cutStart = null;
      }
      if (holding) {
        holding = false;
        commands.accept(Input.release());
      }
    }

    private void cut(float x1, float y1, float x2, float y2) {
      commands.accept(Input.cut(x1, y1, x2, y2));
    }

    @Override
    public void mouseDragged(MouseEvent e) {
      if (SwingUtilities.isRightMouseButton(e)) {
        untouched = false;
        view = view.dragged(e.getX() - mouse.x, e.getY() - mouse.y);
      }
      mouse = e.getPoint();
      if (holding) {
        float x = worldX(e.getX());
        float y = worldY(e.getY());
        commands.accept(Input.at(Action.DRAG, x, y));
      }
      repaint();
    }

    @Override
    public void mouseMoved(MouseEvent e) {
      mouse = e.getPoint();
      repaint();
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent e) {
      double factor = StrictMath.pow(WHEEL_FACTOR, -e.getPreciseWheelRotation());
      untouched = false;
      view = view.zoomed(factor, e.getX(), e.getY());
      repaint();
    }
  }
}
