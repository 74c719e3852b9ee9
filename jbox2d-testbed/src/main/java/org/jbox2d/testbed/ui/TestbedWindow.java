package org.jbox2d.testbed.ui;

import com.formdev.flatlaf.FlatDarkLaf;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.event.ActionEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.io.File;
import java.io.IOException;
import java.util.function.Consumer;
import javax.imageio.ImageIO;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JToolBar;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import org.jbox2d.testbed.paint.Layers;
import org.jbox2d.testbed.paint.Palette;
import org.jbox2d.testbed.paint.SnapshotPainter;
import org.jbox2d.testbed.scenes.Scene;
import org.jbox2d.testbed.scenes.Scenes;
import org.jbox2d.testbed.simulation.Input;
import org.jbox2d.testbed.simulation.Setup;
import org.jbox2d.testbed.simulation.Snapshot;

/**
 * The window: a tool bar and a canvas. Of the event thread alone; the simulation runs beside it on
 * a {@link SimulationThread}.
 */
public final class TestbedWindow {
  private static final String START_HINT = "Press S to start";

  private final JFrame frame = new JFrame();
  private final JComboBox<Scene> scenes = new JComboBox<>(Scenes.all().toArray(new Scene[0]));
  private final JComboBox<Speed> speeds = new JComboBox<>(Speed.values());
  private final JLabel shows = new JLabel();
  private final JButton startStop;
  private final WorldCanvas canvas;
  private final SimulationThread simulation;
  private final long seed;

  /** How many snapshots before the last one is shown. */
  private int back;

  private TestbedWindow(Setup setup, Consumer<Snapshot> listener) {
    seed = setup.seed();
    Scene scene = setup.scene();
    // The canvas is made before the thread that repaints it, and is painted only later.
    canvas = new WorldCanvas(scene.framing(), this::shown, this::stepMillis, this::interact);
    simulation =
        new SimulationThread(
            setup,
            snapshot -> {
              canvas.repaint();
              listener.accept(snapshot);
            },
            this::failed);
    startStop = button("Start", "Start or stop (S)", this::toggle);
    scenes.setSelectedItem(scene);
    buildFrame();
    bindKeys();
    show(scene);
  }

  /** Opens a window on a scene; it ends the program when closed. */
  public static void open(Setup setup) {
    SwingUtilities.invokeLater(
        () -> {
          TestbedWindow window = create(setup, snapshot -> {});
          window.frame.setDefaultCloseOperation(JFrame.EXIT_ON_CLOSE);
        });
  }

  /** Makes and shows a window, on the event thread. */
  static TestbedWindow create(Setup setup, Consumer<Snapshot> listener) {
    FlatDarkLaf.setup();
    return new TestbedWindow(setup, listener);
  }

  // --- What the controls do

  private void toggle() {
    simulation.setGoing(!simulation.isGoing());
    showGoing();
  }

  private void singleStep() {
    simulation.setGoing(false);
    simulation.singleStep();
    showGoing();
  }

  /**
   * Stops, and looks further back by a number of snapshots; forward beyond the last does a step.
   */
  private void look(int further) {
    if (back + further < 0) {
      singleStep();
      return;
    }
    simulation.setGoing(false);
    showGoing();
    back = Math.min(back + further, simulation.pastCount());
    canvas.setHint(back == 0 ? START_HINT : back + " steps back");
  }

  private void reset() {
    simulation.reset();
    showGoing();
  }

  private void sceneChosen() {
    Scene scene = (Scene) scenes.getSelectedItem();
    simulation.load(Setup.of(scene, seed));
    canvas.frame(scene.framing());
    show(scene);
    canvas.requestFocusInWindow();
  }

  private void speedChosen() {
    simulation.setSpeed(((Speed) speeds.getSelectedItem()).factor);
    canvas.requestFocusInWindow();
  }

  private void writePicture() {
    Snapshot snapshot = shown();
    if (snapshot == null) {
      return;
    }
    Snapshot.Counts counts = snapshot.counts();
    File file = new File(counts.scene() + "-" + counts.steps() + ".png").getAbsoluteFile();
    try {
      ImageIO.write(new SnapshotPainter(Palette.DARK).image(snapshot, canvas.view()), "png", file);
      canvas.setHint("Written to " + file);
    } catch (IOException e) {
      canvas.setHint("Could not write " + file + ": " + e.getMessage());
    }
  }

  // --- State shown

  private void show(Scene scene) {
    frame.setTitle("JBox2D testbed: " + scene.title());
    shows.setText(scene.shows());
    showGoing();
  }

  private void showGoing() {
    boolean going = simulation.isGoing();
    back = 0;
    startStop.setText(going ? "Stop" : "Start");
    canvas.setHint(going ? null : START_HINT);
  }

  /** Called on the simulation's thread. */
  private void failed(Throwable e) {
    e.printStackTrace();
    SwingUtilities.invokeLater(() -> canvas.setHint("The simulation failed: " + e));
  }

  private Snapshot shown() {
    return simulation == null ? null : simulation.past(back);
  }

  private double[] stepMillis() {
    return simulation.recentStepMillis(StepPlot.STEPS);
  }

  private void interact(Input input) {
    simulation.apply(input);
  }

  // --- Layout

  private void buildFrame() {
    scenes.setRenderer(new SceneRenderer());
    scenes.setMaximumRowCount(Scenes.all().size());
    scenes.setToolTipText("The scene");
    scenes.setName("scenes");
    scenes.addActionListener(e -> sceneChosen());
    speeds.setToolTipText("Simulated time per second");
    speeds.setName("speeds");
    speeds.addActionListener(e -> speedChosen());
    JToolBar bar = new JToolBar();
    bar.setFloatable(false);
    addCompact(bar, scenes);
    bar.addSeparator();
    bar.add(startStop);
    bar.add(button("Step", "A single step (N)", this::singleStep));
    bar.add(button("Reset", "Build the scene anew (R)", this::reset));
    bar.add(button("Whole scene", "Show the whole scene (F)", canvas::frameAgain));
    bar.add(button("Picture", "Write a picture to the working directory (P)", this::writePicture));
    bar.addSeparator();
    addCompact(bar, speeds);
    bar.addSeparator();
    bar.add(shows);
    frame.add(bar, BorderLayout.NORTH);
    frame.add(canvas, BorderLayout.CENTER);
    frame.addWindowListener(
        new WindowAdapter() {
          @Override
          public void windowClosed(WindowEvent e) {
            simulation.close();
          }
        });
    frame.setDefaultCloseOperation(JFrame.DISPOSE_ON_CLOSE);
    frame.pack();
    frame.setLocationRelativeTo(null);
    frame.setVisible(true);
    canvas.requestFocusInWindow();
  }

  private static void addCompact(JToolBar bar, JComboBox<?> box) {
    box.setMaximumSize(box.getPreferredSize());
    bar.add(box);
  }

  /** Buttons take no focus: the space bar starts and stops. */
  private static JButton button(String text, String tip, Runnable action) {
    JButton button = new JButton(text);
    button.setToolTipText(tip);
    button.setName(text);
    button.setFocusable(false);
    button.addActionListener(e -> action.run());
    return button;
  }

  private void bindKeys() {
    bind("S", this::toggle);
    bind("SPACE", this::toggle);
    bind("N", this::singleStep);
    bind("R", this::reset);
    bind("B", canvas::shootAtPointer);
    bind("X", canvas::breakAtPointer);
    bind("E", canvas::explodeAtPointer);
    bind("F", canvas::frameAgain);
    bind("P", this::writePicture);
    bind("LEFT", () -> look(1));
    bind("RIGHT", () -> look(-1));
    bind("1", () -> canvas.changeLayers(Layers::toggledParts));
    bind("2", () -> canvas.changeLayers(Layers::toggledContacts));
    bind("3", () -> canvas.changeLayers(Layers::toggledCentres));
  }

  private void bind(String key, Runnable run) {
    Action action =
        new AbstractAction() {
          @Override
          public void actionPerformed(ActionEvent e) {
            run.run();
          }
        };
    canvas.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).put(KeyStroke.getKeyStroke(key), key);
    canvas.getActionMap().put(key, action);
  }

  // --- For tests

  JComboBox<Scene> scenes() {
    return scenes;
  }

  JFrame frame() {
    return frame;
  }

  WorldCanvas canvas() {
    return canvas;
  }

  SimulationThread simulation() {
    return simulation;
  }

  /** How much simulated time passes in a second. */
  private enum Speed {
    FULL("full speed", 1),
    HALF("1/2", 1 / 2.0),
    QUARTER("1/4", 1 / 4.0),
    EIGHTH("1/8", 1 / 8.0),
    SIXTEENTH("1/16", 1 / 16.0);

    private final String label;
    private final double factor;

    Speed(String label, double factor) {
      this.label = label;
      this.factor = factor;
    }

    @Override
    public String toString() {
      return label;
    }
  }

  /** Names scenes, and says what they show in a tooltip. */
  private static final class SceneRenderer extends DefaultListCellRenderer {
    @Override
    public Component getListCellRendererComponent(
        JList<?> list, Object value, int index, boolean selected, boolean focus) {
      super.getListCellRendererComponent(list, value, index, selected, focus);
      if (value instanceof Scene scene) {
        setText(scene.title());
        setToolTipText(scene.shows());
      }
      return this;
    }
  }
}
