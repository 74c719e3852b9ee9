package org.jbox2d.testbed.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.Color;
import java.awt.GraphicsEnvironment;
import java.awt.Point;
import java.awt.Robot;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Predicate;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;
import org.jbox2d.testbed.paint.Palette;
import org.jbox2d.testbed.paint.View;
import org.jbox2d.testbed.scenes.Scenes;
import org.jbox2d.testbed.simulation.Setup;
import org.jbox2d.testbed.simulation.Snapshot;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The window on a display, real or virtual, worked by a robot. */
class TestbedWindowTest {
  /** A generous limit for a loaded machine; reached only if the test fails, s. */
  private static final long LIMIT = 30;

  /** What is waited for happens within so many snapshots, some 30 s of the scene, or never. */
  private static final int MOST_SNAPSHOTS = 1800;

  /** The pyramid's top box: the last body made, at rest at this height. */
  private static final float TOP = 19.5f;

  private final BlockingQueue<Snapshot> snapshots = new LinkedBlockingQueue<>();
  private TestbedWindow window;
  private Robot robot;

  @BeforeEach
  void open() throws Exception {
    assumeFalse(
        GraphicsEnvironment.isHeadless(),
        "the window needs a display; run the build under xvfb-run to test it");
    robot = new Robot();
    robot.setAutoDelay(20);
    window =
        onEventThread(
            () -> TestbedWindow.create(Setup.of(Scenes.named("pyramid"), 1), snapshots::add));
    await(s -> true);
    robot.waitForIdle();
    // A press gives the canvas the focus where there is no window manager to do so.
    Point corner = onScreen(20, 20);
    robot.mouseMove(corner.x, corner.y);
    click(InputEvent.BUTTON1_DOWN_MASK);
  }

  @AfterEach
  void close() throws Exception {
    if (window != null) {
      SwingUtilities.invokeAndWait(() -> window.frame().dispose());
    }
  }

  private static <T> T onEventThread(Supplier<T> action) throws Exception {
    AtomicReference<T> result = new AtomicReference<>();
    SwingUtilities.invokeAndWait(() -> result.set(action.get()));
    return result.get();
  }

  private Snapshot await(Predicate<Snapshot> wanted) throws InterruptedException {
    for (int i = 0; i < MOST_SNAPSHOTS; i++) {
      Snapshot snapshot = snapshots.poll(LIMIT, TimeUnit.SECONDS);
      assertNotNull(snapshot, "no further snapshot");
      if (wanted.test(snapshot)) {
        return snapshot;
      }
    }
    return fail("what was waited for did not happen within " + MOST_SNAPSHOTS + " snapshots");
  }

  /** Whether something happens within two seconds of the scene. */
  private boolean soon(Predicate<Snapshot> wanted) throws InterruptedException {
    for (int i = 0; i < 120; i++) {
      Snapshot snapshot = snapshots.poll(LIMIT, TimeUnit.SECONDS);
      assertNotNull(snapshot, "no further snapshot");
      if (wanted.test(snapshot)) {
        return true;
      }
    }
    return false;
  }

  /**
   * Presses the button on the top box until it is held. Without a window manager a press may be
   * lost while the window still settles; a hand would press again.
   */
  private void grabTop() throws Exception {
    for (int attempt = 0; attempt < 3; attempt++) {
      Point top = onScreen(0, TOP);
      robot.mouseMove(top.x, top.y);
      robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
      robot.waitForIdle();
      if (soon(s -> s.lineCount() == 1)) {
        return;
      }
      robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
    }
    fail("the top box cannot be held");
  }

  private Point onScreen(double x, double y) throws Exception {
    return onEventThread(
        () -> {
          View view = window.canvas().view();
          Point origin = window.canvas().getLocationOnScreen();
          return new Point(
              origin.x + (int) Math.round(view.toPictureX(x)),
              origin.y + (int) Math.round(view.toPictureY(y)));
        });
  }

  private View view() throws Exception {
    return onEventThread(() -> window.canvas().view());
  }

  private void key(int code) {
    robot.keyPress(code);
    robot.keyRelease(code);
    robot.waitForIdle();
  }

  private void click(int button) {
    robot.mousePress(button);
    robot.mouseRelease(button);
    robot.waitForIdle();
  }

  private static int newest(Snapshot s) {
    return s.bodyCount() - 1;
  }

  @Test
  void startsDragsABodyAndResets() throws Exception {
    key(KeyEvent.VK_S);
    await(s -> s.counts().steps() >= 5);

    grabTop();
    Point aside = onScreen(6, TOP + 2);
    robot.mouseMove(aside.x, aside.y);
    Snapshot dragged = await(s -> s.x(newest(s)) > 5f);
    assertEquals(1, dragged.lineCount(), "the mouse joint");
    robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
    await(s -> s.lineCount() == 0);
    // Let go beside the top, it falls onto the slope; how far down it comes to rest there is
    // chance.
    await(s -> s.y(newest(s)) < TOP);

    key(KeyEvent.VK_S);
    key(KeyEvent.VK_R);
    Snapshot reset = await(s -> s.counts().steps() == 0);
    assertEquals(0f, reset.x(newest(reset)));
    assertEquals(TOP, reset.y(newest(reset)));
  }

  @Test
  void singleStepKeyDoesOneStep() throws Exception {
    key(KeyEvent.VK_N);
    assertEquals(1, await(s -> s.counts().steps() > 0).counts().steps());
    key(KeyEvent.VK_N);
    assertEquals(2, await(s -> s.counts().steps() > 1).counts().steps());
  }

  @Test
  void rightDragPansAndTheWheelZoomsAboutThePointer() throws Exception {
    View before = view();
    Point at = onScreen(5, 10);
    robot.mouseMove(at.x, at.y);
    robot.mousePress(InputEvent.BUTTON3_DOWN_MASK);
    robot.mouseMove(at.x + 40, at.y + 20);
    robot.mouseRelease(InputEvent.BUTTON3_DOWN_MASK);
    robot.waitForIdle();
    View panned = view();
    assertEquals(before.centreX() - 40 / before.scale(), panned.centreX(), 1e-9);
    assertEquals(before.centreY() + 20 / before.scale(), panned.centreY(), 1e-9);

    robot.mouseWheel(-3);
    robot.waitForIdle();
    assertTrue(view().scale() > panned.scale() * 1.2);
    Point still = onScreen(5, 10);
    assertEquals(at.x + 40, still.x, 1);
    assertEquals(at.y + 20, still.y, 1);
  }

  @Test
  void comboBoxLoadsAnotherScene() throws Exception {
    SwingUtilities.invokeAndWait(() -> window.scenes().setSelectedItem(Scenes.named("dominoes")));
    Snapshot loaded = await(s -> s.counts().scene().equals("dominoes"));
    assertEquals(0, loaded.counts().steps());
    assertTrue(window.frame().getTitle().endsWith("Dominoes"));
  }

  @Test
  void shiftClickThrowsADisc() throws Exception {
    int bodies = window.simulation().latest().bodyCount();
    Point at = onScreen(10, 15);
    robot.mouseMove(at.x, at.y);
    robot.keyPress(KeyEvent.VK_SHIFT);
    click(InputEvent.BUTTON1_DOWN_MASK);
    robot.keyRelease(KeyEvent.VK_SHIFT);
    assertEquals(bodies + 1, await(s -> s.bodyCount() != bodies).bodyCount());
  }

  @Test
  void bodiesAreSeen() throws Exception {
    Point box = onScreen(0, 0.5);
    Color seen = robot.getPixelColor(box.x, box.y);
    assertNotEquals(Palette.DARK.ground(), seen);
    Point air = onScreen(18, 15);
    assertEquals(Palette.DARK.ground(), robot.getPixelColor(air.x, air.y));
  }
}
