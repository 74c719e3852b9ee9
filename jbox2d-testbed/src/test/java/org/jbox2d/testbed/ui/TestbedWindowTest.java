package org.jbox2d.testbed.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.Color;
import java.awt.Component;
import java.awt.GraphicsEnvironment;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.WindowEvent;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.atomic.AtomicReference;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JSlider;
import javax.swing.JSpinner;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import org.jbox2d.testbed.paint.Layer;
import org.jbox2d.testbed.paint.Palette;
import org.jbox2d.testbed.paint.View;
import org.jbox2d.testbed.recording.Replay;
import org.jbox2d.testbed.scenes.Scene;
import org.jbox2d.testbed.scenes.Scenes;
import org.jbox2d.testbed.simulation.Setup;
import org.jbox2d.testbed.simulation.Simulation;
import org.jbox2d.testbed.simulation.Snapshot;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The window on a display, real or virtual, worked by a robot: each control by what it does. */
class TestbedWindowTest {
  /** The pyramid's top box: the last body made, at rest at this height. */
  private static final float TOP = 19.5f;

  @TempDir Path directory;

  private final BlockingQueue<Snapshot> snapshots = new LinkedBlockingQueue<>();
  private final WindowSettings settings = WindowSettings.forgotten();
  private TestbedWindow window;
  private Hand hand;

  @BeforeEach
  void open() throws Exception {
    assumeFalse(
        GraphicsEnvironment.isHeadless(),
        "the window needs a display; run the build under xvfb-run to test it");
    open("pyramid");
  }

  private void open(String scene) throws Exception {
    close();
    snapshots.clear();
    window =
        Hand.onEventThread(
            () ->
                TestbedWindow.create(
                    Setup.of(Scenes.named(scene), 1), settings, directory, snapshots::add));
    hand = new Hand(window, snapshots);
    hand.await(s -> true);
    // The panel is filled when the simulation has told what there is.
    hand.control("gravity-y", JSpinner.class);
    hand.until("the window is not shown", () -> window.canvas().isShowing());
    // A press gives the canvas the focus where there is no window manager to do so.
    for (int i = 0; i < 5 && !hasFocus(); i++) {
      Point corner = Hand.onEventThread(() -> window.canvas().getLocationOnScreen());
      hand.robot.mouseMove(corner.x + 3, corner.y + 3);
      hand.click();
      hand.robot.delay(100);
    }
    hand.until("the canvas does not get the focus", () -> window.canvas().isFocusOwner());
  }

  private boolean hasFocus() throws Exception {
    return Hand.onEventThread(() -> window.canvas().isFocusOwner());
  }

  @AfterEach
  void close() throws Exception {
    if (window != null) {
      SwingUtilities.invokeAndWait(() -> window.frame().dispose());
      window = null;
    }
  }

  private static int newest(Snapshot s) {
    return s.bodyCount() - 1;
  }

  private View view() throws Exception {
    return Hand.onEventThread(() -> window.canvas().view());
  }

  // --- The keys and buttons of the thesis

  /**
   * Presses the button on the top box until it is held. Without a window manager a press may be
   * lost while the window still settles; a hand would press again.
   */
  private void grabTop() throws Exception {
    for (int attempt = 0; attempt < 3; attempt++) {
      hand.moveTo(0, TOP);
      hand.robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
      hand.robot.waitForIdle();
      if (hand.soon(s -> s.lineCount() == 1)) {
        return;
      }
      hand.robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
    }
    fail("the top box cannot be held");
  }

  @Test
  void startsDragsABodyAndResets() throws Exception {
    hand.key(KeyEvent.VK_S);
    hand.await(s -> s.counts().steps() >= 5);

    grabTop();
    hand.moveTo(6, TOP + 2);
    Snapshot dragged = hand.await(s -> s.x(newest(s)) > 5f);
    assertEquals(1, dragged.lineCount(), "the mouse joint");
    hand.robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
    hand.await(s -> s.lineCount() == 0);
    // Let go beside the top, it falls onto the slope; how far down it comes to rest there is
    // chance.
    hand.await(s -> s.y(newest(s)) < TOP);

    hand.key(KeyEvent.VK_S);
    hand.key(KeyEvent.VK_R);
    Snapshot reset = hand.await(s -> s.counts().steps() == 0);
    assertEquals(0f, reset.x(newest(reset)));
    assertEquals(TOP, reset.y(newest(reset)));
  }

  @Test
  void rightDragPansAndTheWheelZoomsAboutThePointer() throws Exception {
    View before = view();
    Point at = hand.onScreen(5, 10);
    hand.robot.mouseMove(at.x, at.y);
    hand.robot.mousePress(InputEvent.BUTTON3_DOWN_MASK);
    hand.robot.mouseMove(at.x + 40, at.y + 20);
    hand.robot.mouseRelease(InputEvent.BUTTON3_DOWN_MASK);
    hand.robot.waitForIdle();
    View panned = view();
    assertEquals(before.centreX() - 40 / before.scale(), panned.centreX(), 1e-9);
    assertEquals(before.centreY() + 20 / before.scale(), panned.centreY(), 1e-9);

    hand.robot.mouseWheel(-3);
    hand.robot.waitForIdle();
    assertTrue(view().scale() > panned.scale() * 1.2);
    Point still = hand.onScreen(5, 10);
    assertEquals(at.x + 40, still.x, 1);
    assertEquals(at.y + 20, still.y, 1);

    hand.click("Whole scene");
    hand.until("the whole scene", () -> window.canvas().view().equals(before));
  }

  @Test
  void comboBoxLoadsAnotherScene() throws Exception {
    JComboBox<?> scenes = hand.control("scenes", JComboBox.class);
    SwingUtilities.invokeAndWait(() -> scenes.setSelectedItem(Scenes.named("dominoes")));
    Snapshot loaded = hand.await(s -> s.counts().scene().equals("dominoes"));
    assertEquals(0, loaded.counts().steps());
    hand.until("the title", () -> window.frame().getTitle().endsWith("Dominoes"));
  }

  // --- Time

  @Test
  void stepKeyAndButtonDoOneStepEach() throws Exception {
    hand.key(KeyEvent.VK_N);
    assertEquals(1, hand.await(s -> s.counts().steps() > 0).counts().steps());
    hand.click("Step");
    assertEquals(2, hand.await(s -> s.counts().steps() > 1).counts().steps());
  }

  @Test
  void startButtonStartsAndStops() throws Exception {
    hand.clickUntil("Start", "it does not start", () -> window.simulation().isGoing());
    hand.await(s -> s.counts().steps() >= 3);
    hand.key(KeyEvent.VK_SPACE);
    hand.until("it does not stop", () -> !window.simulation().isGoing());
  }

  /** A sixteenth of the speed is four steps a second; at full speed there would be sixty. */
  @Test
  void slowMotionDoesFewerStepsASecond() throws Exception {
    JComboBox<?> speeds = hand.control("speeds", JComboBox.class);
    SwingUtilities.invokeAndWait(() -> speeds.setSelectedIndex(speeds.getItemCount() - 1));
    long start = System.nanoTime();
    hand.key(KeyEvent.VK_S);
    hand.await(s -> s.counts().steps() >= 5);
    // Steps are never early: the first may come at once, each other a quarter second later.
    assertTrue(System.nanoTime() - start > 0.9e9, "four quarters of a second");
  }

  @Test
  void stepsBackAndGoesOnFromThere() throws Exception {
    for (int i = 0; i < 6; i++) {
      hand.key(KeyEvent.VK_N);
    }
    Snapshot fourth = hand.await(s -> s.counts().steps() == 4);
    hand.await(s -> s.counts().steps() == 6);
    hand.click("Back");
    hand.key(KeyEvent.VK_LEFT);
    hand.key(KeyEvent.VK_LEFT);
    JSlider timeline = hand.control("timeline", JSlider.class);
    hand.until("the timeline shows the past", () -> timeline.getValue() == 3);
    hand.key(KeyEvent.VK_N);
    Snapshot again = hand.await(s -> s.counts().steps() == 4);
    assertEquals(fourth.hash(), again.hash());
    assertEquals(again.hash(), window.simulation().latest().hash());
    assertEquals(4, window.simulation().pastCount());
  }

  @Test
  void rightArrowGoesForwardThroughThePastAndThenSteps() throws Exception {
    for (int i = 0; i < 3; i++) {
      hand.key(KeyEvent.VK_N);
    }
    hand.await(s -> s.counts().steps() == 3);
    JSlider timeline = hand.control("timeline", JSlider.class);
    hand.key(KeyEvent.VK_LEFT);
    hand.until("one back", () -> timeline.getMaximum() - timeline.getValue() == 1);
    hand.key(KeyEvent.VK_RIGHT);
    hand.until("now", () -> timeline.getMaximum() == timeline.getValue());
    hand.key(KeyEvent.VK_RIGHT);
    hand.await(s -> s.counts().steps() == 4);
  }

  // --- What is done to the world

  @Test
  void shiftClickAndKeyThrowADisc() throws Exception {
    int bodies = window.simulation().latest().bodyCount();
    hand.moveTo(10, 15);
    hand.robot.keyPress(KeyEvent.VK_SHIFT);
    hand.click();
    hand.robot.keyRelease(KeyEvent.VK_SHIFT);
    assertEquals(bodies + 1, hand.await(s -> s.bodyCount() != bodies).bodyCount());
    hand.key(KeyEvent.VK_B);
    assertEquals(bodies + 2, hand.await(s -> s.bodyCount() != bodies + 1).bodyCount());
  }

  @Test
  void keysBreakAndBlastAndADragCuts() throws Exception {
    open("main");
    int bodies = window.simulation().latest().bodyCount();
    hand.moveTo(0, 9);
    hand.key(KeyEvent.VK_X);
    assertEquals(1, hand.await(s -> s.bodyCount() > bodies).counts().fractures());

    hand.key(KeyEvent.VK_R);
    hand.await(s -> s.bodyCount() == bodies);
    hand.moveTo(-6, 5);
    hand.key(KeyEvent.VK_E);
    assertTrue(hand.await(s -> s.bodyCount() > bodies).counts().fractures() > 0);

    hand.key(KeyEvent.VK_R);
    hand.await(s -> s.bodyCount() == bodies);
    hand.moveTo(-8, 4);
    hand.robot.keyPress(KeyEvent.VK_CONTROL);
    hand.robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
    hand.moveTo(8, 6);
    hand.robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
    hand.robot.keyRelease(KeyEvent.VK_CONTROL);
    assertEquals(bodies + 1, hand.await(s -> s.bodyCount() != bodies).bodyCount());
  }

  // --- Scenes

  @Test
  void searchFindsScenesAndEnterTakesTheFirst() throws Exception {
    JTextField search = hand.control("search", JTextField.class);
    hand.clickUntil("search", "the field has no focus", search::isFocusOwner);
    // Letters that are keys of the window, too, and must not act on it here.
    for (int key : new int[] {KeyEvent.VK_C, KeyEvent.VK_R, KeyEvent.VK_A, KeyEvent.VK_D}) {
      hand.key(key);
    }
    hand.key(KeyEvent.VK_L);
    hand.key(KeyEvent.VK_E);
    hand.until(
        "the cradle alone is found",
        () -> window.sceneList().found().equals(List.of(Scenes.named("newtons-cradle"))));
    assertEquals("pyramid", window.simulation().latest().counts().scene());
    hand.key(KeyEvent.VK_ENTER);
    hand.await(s -> s.counts().scene().equals("newtons-cradle"));
    hand.until("the focus is back", () -> window.canvas().isFocusOwner());
    assertEquals(0, Files.list(directory).count(), "no file was written while typing");
  }

  @Test
  void clickInTheListLoadsTheScene() throws Exception {
    // The list is longer than what is seen of it.
    Component seenPart = hand.control("scene list", Component.class).getParent();
    Point list = Hand.onEventThread(seenPart::getLocationOnScreen);
    Scene seen = null;
    for (int i = 0; i < 5 && seen == null; i++) {
      // A place without a scene that is on already.
      hand.robot.mouseMove(list.x + 30, list.y + 12 + 60 * i);
      hand.click();
      hand.robot.delay(100);
      String now = window.simulation().latest().counts().scene();
      seen = now.equals("pyramid") ? null : Scenes.named(now);
    }
    assertTrue(seen != null, "no click loaded a scene");
    String title = seen.title();
    hand.until("the title follows", () -> window.frame().getTitle().endsWith(title));
  }

  // --- Parameters

  @Test
  void parameterOfTheSolverActsAtOnce() throws Exception {
    JSpinner gravity = hand.control("gravity-y", JSpinner.class);
    SwingUtilities.invokeAndWait(() -> gravity.setValue(30.0));
    hand.key(KeyEvent.VK_S);
    Snapshot risen = hand.await(s -> s.y(newest(s)) > TOP + 1);
    assertEquals("pyramid", risen.counts().scene());
  }

  @Test
  void parameterOfTheSceneBuildsItAnew() throws Exception {
    int bodies = window.simulation().latest().bodyCount();
    JSpinner rows = hand.control("rows", JSpinner.class);
    SwingUtilities.invokeAndWait(() -> rows.setValue(5.0));
    assertEquals(bodies - 210 + 15, hand.await(s -> s.bodyCount() != bodies).bodyCount());
    // A reset keeps it, the defaults do not.
    hand.key(KeyEvent.VK_N);
    hand.await(s -> s.counts().steps() == 1);
    hand.key(KeyEvent.VK_R);
    assertEquals(bodies - 195, hand.await(s -> s.counts().steps() == 0).bodyCount());
    hand.click("Defaults");
    hand.await(s -> s.bodyCount() == bodies);
  }

  @Test
  void sliderAndNumberFollowEachOther() throws Exception {
    JSlider slider = hand.control("shot-speed slider", JSlider.class);
    JSpinner number = hand.control("shot-speed", JSpinner.class);
    SwingUtilities.invokeAndWait(() -> slider.setValue(slider.getMaximum()));
    assertEquals(200.0, number.getValue());
    SwingUtilities.invokeAndWait(() -> number.setValue(1.0));
    assertEquals(0, slider.getValue());
    AtomicReference<Double> speed = new AtomicReference<>();
    window.simulation().look(run -> speed.set(run.value(run.parameter("shot-speed"))));
    hand.until("the run has the value", () -> speed.get() != null);
    assertEquals(1.0, speed.get());
  }

  @Test
  void solverAndSwitchesAreSet() throws Exception {
    JComboBox<?> solver = hand.control("solver", JComboBox.class);
    SwingUtilities.invokeAndWait(() -> solver.setSelectedItem("soft-step"));
    JCheckBox sleeping = hand.control("sleeping", JCheckBox.class);
    SwingUtilities.invokeAndWait(sleeping::doClick);
    AtomicReference<String> set = new AtomicReference<>();
    window
        .simulation()
        .look(run -> set.set(run.world().getSolver() + ", " + run.world().isSleepingAllowed()));
    hand.until("the run tells", () -> set.get() != null);
    assertEquals("soft step, 4 substeps, false", set.get());
  }

  @Test
  void materialOfAThingThatBreaksIsSet() throws Exception {
    open("cube");
    int bodies = window.simulation().latest().bodyCount();
    JSpinner rigidity = hand.control("rigidity", JSpinner.class);
    SwingUtilities.invokeAndWait(() -> rigidity.setValue(500.0));
    hand.key(KeyEvent.VK_S);
    // By then it has fallen, and would have broken at its own 8 N s.
    Snapshot fallen = hand.await(s -> s.counts().steps() >= 100);
    assertEquals(0, fallen.counts().fractures(), "it is too hard to break");
    hand.key(KeyEvent.VK_S);
    hand.click("Defaults");
    hand.await(s -> s.counts().steps() == 0);
    hand.key(KeyEvent.VK_S);
    assertTrue(hand.await(s -> s.counts().fractures() > 0).bodyCount() >= bodies);
  }

  // --- Layers, and what is seen

  private BufferedImage canvas() throws Exception {
    return Hand.onEventThread(
        () -> {
          BufferedImage image =
              new BufferedImage(
                  window.canvas().getWidth(),
                  window.canvas().getHeight(),
                  BufferedImage.TYPE_INT_RGB);
          window.canvas().paint(image.createGraphics());
          return image;
        });
  }

  private static int differences(BufferedImage a, BufferedImage b) {
    int count = 0;
    // The text at the left has numbers that change.
    for (int x = a.getWidth() / 3; x < a.getWidth(); x++) {
      for (int y = a.getHeight() / 10; y < a.getHeight(); y++) {
        count += a.getRGB(x, y) == b.getRGB(x, y) ? 0 : 1;
      }
    }
    return count;
  }

  /** Each key shows or hides something that is seen, and its box follows. */
  @ParameterizedTest
  @EnumSource(Layer.class)
  void layerIsShownAndHidden(Layer layer) throws Exception {
    if (layer == Layer.PARTS || layer == Layer.CELLS) {
      open("main");
      hand.moveTo(1, 9);
      hand.key(KeyEvent.VK_X);
      hand.await(s -> s.counts().fractures() == 1);
    } else if (layer == Layer.JOINTS) {
      open("newtons-cradle");
    } else if (layer == Layer.SLEEPING) {
      open("card-house");
      hand.key(KeyEvent.VK_S);
      hand.await(s -> !s.isAwake(newest(s)));
      hand.key(KeyEvent.VK_S);
      hand.until("it stops", () -> !window.simulation().isGoing());
    } else {
      hand.key(KeyEvent.VK_N);
      hand.await(s -> s.counts().steps() == 1);
    }
    JCheckBox box = hand.control(layer.name(), JCheckBox.class);
    boolean shown = box.isSelected();
    hand.moveTo(0, 0.2);
    BufferedImage before = canvas();
    hand.key(KeyEvent.VK_1 + layer.ordinal());
    hand.until("the box follows", () -> box.isSelected() != shown);
    hand.until("nothing is seen of " + layer, () -> changed(before));
    hand.clickUntil(layer.name(), "the box switches back", () -> box.isSelected() == shown);
    assertEquals(shown, settings.layers().has(layer));
  }

  private boolean changed(BufferedImage before) {
    BufferedImage now =
        new BufferedImage(before.getWidth(), before.getHeight(), BufferedImage.TYPE_INT_RGB);
    window.canvas().paint(now.createGraphics());
    return differences(before, now) > 20;
  }

  @Test
  void bodiesAreSeen() throws Exception {
    Point box = hand.onScreen(0, 0.5);
    Color seen = hand.robot.getPixelColor(box.x, box.y);
    assertNotEquals(Palette.DARK.ground(), seen);
    Point air = hand.onScreen(18, 15);
    assertEquals(Palette.DARK.ground(), hand.robot.getPixelColor(air.x, air.y));
  }

  @Test
  void textIsHiddenAndShown() throws Exception {
    BufferedImage with = canvas();
    int ground = Palette.DARK.ground().getRGB();
    assertNotEquals(ground, with.getRGB(15, 15));
    hand.key(KeyEvent.VK_H);
    assertEquals(ground, canvas().getRGB(15, 15));
    hand.key(KeyEvent.VK_H);
    assertNotEquals(ground, canvas().getRGB(15, 15));
  }

  @Test
  void overlayTellsAllThatTheThesisHasThere() throws Exception {
    List<String> keys =
        Overlay.lines(window.simulation().latest().counts(), view(), 1, 2).stream()
            .map(line -> line[0])
            .toList();
    for (String key :
        List.of(
            "s, space",
            "r",
            "right drag",
            "left drag",
            "wheel",
            "mouse",
            "centre",
            "zoom",
            "bodies",
            "fixtures",
            "contacts",
            "particles")) {
      assertTrue(keys.contains(key), key);
    }
  }

  // --- Files

  private Path written(String ending) throws Exception {
    Path file = directory.resolve("pyramid-3" + ending);
    hand.until("no hint of " + file, () -> ("Written to " + file).equals(window.canvas().hint()));
    return file;
  }

  private void threeSteps() throws Exception {
    for (int i = 0; i < 3; i++) {
      hand.key(KeyEvent.VK_N);
    }
    hand.await(s -> s.counts().steps() == 3);
  }

  @Test
  void pictureIsWritten() throws Exception {
    threeSteps();
    hand.key(KeyEvent.VK_P);
    BufferedImage picture = ImageIO.read(written(".png").toFile());
    assertEquals(view().width(), picture.getWidth());
    assertEquals(view().height(), picture.getHeight());
  }

  @Test
  void animationIsWritten() throws Exception {
    threeSteps();
    hand.click("Animation");
    Path file = written(".gif");
    try (ImageInputStream in = ImageIO.createImageInputStream(file.toFile())) {
      ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
      reader.setInput(in);
      // Four states within 3/60 s: frames at 0 and at 1/25 s.
      assertEquals(2, reader.getNumImages(true));
      assertEquals(640, reader.read(0).getWidth());
      reader.dispose();
    }
  }

  @Test
  void figuresAreWritten() throws Exception {
    threeSteps();
    hand.key(KeyEvent.VK_C);
    List<String> lines = Files.readAllLines(written(".csv"));
    assertEquals(4, lines.size());
    assertTrue(lines.get(3).startsWith("3,0.05"), lines.get(3));
  }

  @Test
  void recordingIsWrittenAndRepeatsTheRun() throws Exception {
    hand.moveTo(10, 15);
    hand.key(KeyEvent.VK_B);
    hand.await(s -> s.bodyCount() == 214);
    threeSteps();
    hand.key(KeyEvent.VK_V);
    try (Replay replay = new Replay(written(".rec"))) {
      Simulation run = new Simulation(replay.setup());
      while (replay.prepare(run)) {
        run.step();
        assertNull(replay.check(run));
      }
      assertEquals(3, run.steps());
      assertEquals(window.simulation().latest().hash(), run.hash());
    }
  }

  @Test
  void whatCannotBeWrittenIsTold() throws Exception {
    Files.createDirectory(directory.resolve("pyramid-3.csv"));
    threeSteps();
    hand.click("Figures");
    hand.until(
        "the failure is not told",
        () ->
            window.canvas().hint() != null && window.canvas().hint().startsWith("Could not write"));
  }

  // --- What is remembered

  @Test
  void sceneLayersAndSizeAreRemembered() throws Exception {
    JComboBox<?> scenes = hand.control("scenes", JComboBox.class);
    SwingUtilities.invokeAndWait(() -> scenes.setSelectedItem(Scenes.named("tower")));
    hand.await(s -> s.counts().scene().equals("tower"));
    assertEquals(Scenes.named("tower"), settings.scene());
    hand.key(KeyEvent.VK_3);
    hand.until("contacts are shown", () -> window.canvas().layers().has(Layer.CONTACTS));
    Rectangle bounds = new Rectangle(40, 30, 1000, 700);
    SwingUtilities.invokeAndWait(() -> window.frame().setBounds(bounds));
    hand.until("the size", () -> window.canvas().getHeight() < 700);
    SwingUtilities.invokeAndWait(
        () ->
            window
                .frame()
                .dispatchEvent(new WindowEvent(window.frame(), WindowEvent.WINDOW_CLOSING)));
    open(settings.scene().name());
    assertEquals(bounds.getSize(), window.frame().getSize());
    assertTrue(window.canvas().layers().has(Layer.CONTACTS));
    assertFalse(window.canvas().layers().has(Layer.CENTRES));
  }

  @Test
  void parametersHaveDocumentationAndUnits() throws Exception {
    JSpinner gravity = hand.control("gravity-y", JSpinner.class);
    String labels =
        Hand.onEventThread(
            () -> {
              StringBuilder all = new StringBuilder();
              for (Component c : gravity.getParent().getComponents()) {
                all.append(c instanceof JLabel label ? label.getText() + "\n" : "");
              }
              return all.toString();
            });
    assertTrue(labels.contains("gravity-y [m/s^2]"), labels);
    assertEquals("Gravity upwards. -50 to 50 m/s^2", gravity.getToolTipText());
  }
}
