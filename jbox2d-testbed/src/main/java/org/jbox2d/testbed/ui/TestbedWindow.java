package org.jbox2d.testbed.ui;

import com.formdev.flatlaf.FlatDarkLaf;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.KeyboardFocusManager;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.event.ActionEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.AbstractAction;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JSlider;
import javax.swing.JToolBar;
import javax.swing.KeyStroke;
import javax.swing.ScrollPaneConstants;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import javax.swing.text.JTextComponent;
import org.jbox2d.testbed.paint.Layer;
import org.jbox2d.testbed.parameters.Parameter;
import org.jbox2d.testbed.scenes.Scene;
import org.jbox2d.testbed.scenes.Scenes;
import org.jbox2d.testbed.simulation.Input;
import org.jbox2d.testbed.simulation.Setup;
import org.jbox2d.testbed.simulation.Snapshot;
import org.jbox2d.testbed.simulation.TimedInput;

/**
 * The window: scenes at the left, the world in the middle, parameters, layers and plots at the
 * right. Of the event thread alone; the simulation runs beside it on a {@link SimulationThread}.
 */
public final class TestbedWindow {
  private static final String START_HINT = "Press S to start";
  private static final int SIDE_WIDTH = 340;

  /** How often the timeline follows a run that goes, ms. */
  private static final int REFRESH = 100;

  private static final Dimension USUAL_SIZE = new Dimension(1440, 900);

  private final JFrame frame = new JFrame();
  private final JComboBox<Scene> scenes = new JComboBox<>(Scenes.all().toArray(new Scene[0]));
  private final JComboBox<Speed> speeds = new JComboBox<>(Speed.values());
  private final JSlider timeline = new JSlider(0, 0, 0);
  private final Timer refresh = new Timer(REFRESH, e -> followRun());
  private final JButton startStop;
  private final SceneList sceneList = new SceneList(this::choose);
  private final ParameterPanel parameters;
  private final LayerPanel layers = new LayerPanel(this::toggle);
  private final PlotPanel plots = new PlotPanel(this::figures);
  private final WorldCanvas canvas;
  private final SimulationThread simulation;
  private final Exports exports;
  private final WindowSettings settings;
  private final long seed;

  /** How many snapshots before the last one is shown. */
  private int back;

  /** Whether the simulation was at something long when it was last looked at. */
  private boolean wasBusy;

  /** Whether the program is changing a control itself. */
  private boolean quiet;

  private TestbedWindow(
      Setup setup, WindowSettings settings, Path exportsTo, Consumer<Snapshot> listener) {
    this.settings = settings;
    seed = setup.seed();
    // The canvas is made before the thread that repaints it, and is painted only later.
    canvas = new WorldCanvas(setup.scene().framing(), this::shown, this::interact);
    simulation =
        new SimulationThread(
            setup,
            snapshot -> {
              canvas.repaint();
              listener.accept(snapshot);
            },
            this::failed);
    exports = new Exports(exportsTo, canvas::setHint);
    parameters = new ParameterPanel(this::parameterChanged, canvas::requestFocusInWindow);
    startStop = button("Start", "Start or stop (S)", this::toggle);
    canvas.setLayers(settings.layers());
    buildFrame();
    bindKeys();
    showLayers();
    show(setup.scene());
    refresh.start();
  }

  /** Opens a window; it ends the program when closed. */
  public static void open(Setup setup, WindowSettings settings) {
    SwingUtilities.invokeLater(
        () -> {
          Path here = Path.of("").toAbsolutePath();
          TestbedWindow window = create(setup, settings, here, snapshot -> {});
          window.frame.setDefaultCloseOperation(JFrame.EXIT_ON_CLOSE);
        });
  }

  /** Makes and shows a window, on the event thread. */
  static TestbedWindow create(
      Setup setup, WindowSettings settings, Path exportsTo, Consumer<Snapshot> listener) {
    FlatDarkLaf.setup();
    return new TestbedWindow(setup, settings, exportsTo, listener);
  }

  // --- What the controls do

  private void toggle() {
    goOnFromWhatIsShown();
    simulation.setGoing(!simulation.isGoing());
    showGoing();
  }

  private void singleStep() {
    goOnFromWhatIsShown();
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
    } else {
      lookBack(back + further);
    }
  }

  private void lookBack(int steps) {
    simulation.setGoing(false);
    showGoing();
    back = Math.min(steps, simulation.pastCount());
    showTimeline();
    canvas.setHint(back <= 0 ? START_HINT : back + " steps back; go on from here, or forward");
  }

  /** Whoever looks back and then acts wants to act then, not now. */
  private void goOnFromWhatIsShown() {
    Snapshot then = shown();
    if (back > 0 && then != null) {
      back = 0;
      simulation.goBackTo(then.counts().steps());
    }
  }

  private void reset() {
    back = 0;
    simulation.reset();
    showGoing();
  }

  private void choose(Scene scene) {
    simulation.load(Setup.of(scene, seed));
    settings.remember(scene);
    canvas.frame(scene.framing());
    show(scene);
    canvas.requestFocusInWindow();
  }

  private void chooseAgain() {
    choose((Scene) scenes.getSelectedItem());
  }

  private void speedChosen() {
    simulation.setSpeed(((Speed) speeds.getSelectedItem()).factor);
    canvas.requestFocusInWindow();
  }

  private void interact(Input input) {
    goOnFromWhatIsShown();
    simulation.apply(input);
  }

  private void parameterChanged(Parameter parameter, double value) {
    goOnFromWhatIsShown();
    simulation.set(parameter.name(), value);
  }

  private void toggle(Layer layer) {
    canvas.setLayers(canvas.layers().toggled(layer));
    settings.remember(canvas.layers());
    showLayers();
  }

  // --- Files

  private void writePicture() {
    Snapshot snapshot = shown();
    if (snapshot != null) {
      exports.picture(snapshot, canvas.view(), canvas.layers());
    }
  }

  private void writeAnimation() {
    List<Snapshot> past = simulation.pastUpTo(back);
    if (!past.isEmpty()) {
      exports.animation(past, canvas.view(), canvas.layers());
    }
  }

  private void writeFigures() {
    List<Snapshot.Counts> figures = simulation.figures(Integer.MAX_VALUE);
    if (!figures.isEmpty()) {
      exports.figures(figures);
    }
  }

  private void writeRecording() {
    simulation.look(
        run -> {
          Snapshot.Counts counts = run.counts();
          Setup setup = run.setup();
          List<TimedInput> inputs = List.copyOf(run.inputs());
          SwingUtilities.invokeLater(() -> exports.recording(counts, setup, inputs));
        });
  }

  // --- State shown

  private void show(Scene scene) {
    frame.setTitle("JBox2D testbed: " + scene.title());
    quietly(() -> scenes.setSelectedItem(scene));
    sceneList.show(scene);
    back = 0;
    showGoing();
    simulation.look(
        run -> {
          List<Parameter> all = run.parameters();
          double[] values = all.stream().mapToDouble(run::value).toArray();
          SwingUtilities.invokeLater(
              () -> parameters.show(all, parameter -> values[all.indexOf(parameter)]));
        });
  }

  private void showGoing() {
    boolean going = simulation.isGoing();
    back = 0;
    showTimeline();
    startStop.setText(going ? "Stop" : "Start");
    canvas.setHint(going ? null : START_HINT);
  }

  private void followRun() {
    showTimeline();
    String busy = simulation.busy();
    if (busy != null) {
      canvas.setHint(busy);
    } else if (wasBusy) {
      canvas.setHint(simulation.isGoing() ? null : START_HINT);
    }
    wasBusy = busy != null;
  }

  /** The right end is now. */
  void showTimeline() {
    if (!timeline.getValueIsAdjusting()) {
      quietly(
          () -> {
            timeline.setMaximum(simulation.pastCount());
            timeline.setValue(timeline.getMaximum() - back);
          });
    }
  }

  private void showLayers() {
    layers.show(canvas.layers());
    simulation.setDetails(canvas.layers().has(Layer.BOXES), canvas.layers().has(Layer.CONTACTS));
  }

  private void quietly(Runnable change) {
    boolean before = quiet;
    quiet = true;
    change.run();
    quiet = before;
  }

  /** Called on the simulation's thread. */
  private void failed(Throwable e) {
    e.printStackTrace();
    SwingUtilities.invokeLater(() -> canvas.setHint("The simulation failed: " + e));
  }

  private Snapshot shown() {
    return simulation == null ? null : simulation.past(back);
  }

  private List<Snapshot.Counts> figures() {
    return simulation.figures(PlotPanel.STEPS);
  }

  // --- Layout

  private void buildFrame() {
    frame.add(toolBar(), BorderLayout.NORTH);
    frame.add(sceneList, BorderLayout.WEST);
    JPanel middle = new JPanel(new BorderLayout());
    middle.add(canvas, BorderLayout.CENTER);
    timeline.setName("timeline");
    timeline.setToolTipText("Look back over the last ten seconds (left, right)");
    timeline.setFocusable(false);
    timeline.addChangeListener(
        e -> {
          if (!quiet) {
            lookBack(timeline.getMaximum() - timeline.getValue());
          }
        });
    middle.add(timeline, BorderLayout.SOUTH);
    frame.add(middle, BorderLayout.CENTER);
    frame.add(side(), BorderLayout.EAST);
    frame.addWindowListener(new Closing());
    frame.setDefaultCloseOperation(JFrame.DISPOSE_ON_CLOSE);
    place();
    frame.setVisible(true);
    canvas.requestFocusInWindow();
  }

  private JToolBar toolBar() {
    scenes.setMaximumRowCount(Scenes.all().size());
    scenes.setToolTipText("The scene");
    scenes.setName("scenes");
    scenes.setFocusable(false);
    scenes.addActionListener(
        e -> {
          if (!quiet) {
            chooseAgain();
          }
        });
    speeds.setToolTipText("Simulated time per second");
    speeds.setName("speeds");
    speeds.setFocusable(false);
    speeds.addActionListener(e -> speedChosen());
    JToolBar bar = new JToolBar();
    bar.setFloatable(false);
    addCompact(bar, scenes);
    bar.addSeparator();
    bar.add(startStop);
    bar.add(button("Back", "A step back (left)", () -> look(1)));
    bar.add(button("Step", "A single step (N)", this::singleStep));
    bar.add(button("Reset", "Build the scene anew, parameters kept (R)", this::reset));
    bar.add(button("Defaults", "The scene as it is meant (D)", this::chooseAgain));
    addCompact(bar, speeds);
    bar.addSeparator();
    bar.add(button("Whole scene", "Show the whole scene (F)", canvas::frameAgain));
    bar.addSeparator();
    bar.add(new JLabel("Write: "));
    bar.add(button("Picture", "A picture of what is shown (P)", this::writePicture));
    bar.add(button("Animation", "The last ten seconds (G)", this::writeAnimation));
    bar.add(button("Figures", "A line for each step (C)", this::writeFigures));
    bar.add(button("Recording", "What repeats the run: --replay (V)", this::writeRecording));
    return bar;
  }

  private JPanel side() {
    JScrollPane scroll =
        new JScrollPane(
            parameters,
            ScrollPaneConstants.VERTICAL_SCROLLBAR_AS_NEEDED,
            ScrollPaneConstants.HORIZONTAL_SCROLLBAR_NEVER);
    JPanel side = new JPanel(new BorderLayout());
    side.add(scroll, BorderLayout.CENTER);
    JPanel below = new JPanel(new BorderLayout());
    below.add(layers, BorderLayout.NORTH);
    below.add(plots, BorderLayout.CENTER);
    side.add(below, BorderLayout.SOUTH);
    side.setPreferredSize(new Dimension(SIDE_WIDTH, 700));
    return side;
  }

  /** Where it was the last time, if that is still on a screen. */
  private void place() {
    Dimension screen = Toolkit.getDefaultToolkit().getScreenSize();
    Rectangle bounds = settings.bounds();
    if (bounds != null && new Rectangle(screen).contains(bounds)) {
      frame.setBounds(bounds);
      return;
    }
    frame.setSize(
        Math.min(USUAL_SIZE.width, screen.width), Math.min(USUAL_SIZE.height, screen.height));
    frame.setLocationRelativeTo(null);
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
    bind("D", this::chooseAgain);
    bind("B", canvas::shootAtPointer);
    bind("X", canvas::breakAtPointer);
    bind("E", canvas::explodeAtPointer);
    bind("F", canvas::frameAgain);
    bind("H", canvas::toggleOverlay);
    bind("P", this::writePicture);
    bind("G", this::writeAnimation);
    bind("C", this::writeFigures);
    bind("V", this::writeRecording);
    bind("LEFT", () -> look(1));
    bind("RIGHT", () -> look(-1));
    for (Layer layer : Layer.values()) {
      bind(LayerPanel.key(layer), () -> toggle(layer));
    }
  }

  /** Keys of the window are not those of who is typing into a field. */
  private void bind(String key, Runnable run) {
    canvas.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).put(KeyStroke.getKeyStroke(key), key);
    canvas
        .getActionMap()
        .put(
            key,
            new AbstractAction() {
              private static final long serialVersionUID = 1L;

              @Override
              public void actionPerformed(ActionEvent e) {
                Component focus =
                    KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
                if (!(focus instanceof JTextComponent)) {
                  run.run();
                }
              }
            });
  }

  // --- For tests and pictures

  JFrame frame() {
    return frame;
  }

  WorldCanvas canvas() {
    return canvas;
  }

  SceneList sceneList() {
    return sceneList;
  }

  SimulationThread simulation() {
    return simulation;
  }

  private final class Closing extends WindowAdapter {
    @Override
    public void windowClosing(WindowEvent e) {
      settings.remember(frame.getBounds());
    }

    @Override
    public void windowClosed(WindowEvent e) {
      refresh.stop();
      simulation.close();
      exports.close();
    }
  }
}
