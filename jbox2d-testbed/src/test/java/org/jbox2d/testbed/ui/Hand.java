package org.jbox2d.testbed.ui;

import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.fail;

import java.awt.Component;
import java.awt.Container;
import java.awt.Point;
import java.awt.Robot;
import java.awt.event.InputEvent;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import java.util.function.Predicate;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;
import org.jbox2d.testbed.paint.View;
import org.jbox2d.testbed.simulation.Snapshot;

/**
 * A robot's hand on a window: it presses keys and buttons at places of the world or on controls by
 * name, and waits for what comes of it. Everything it waits for is asked for again and again, up to
 * a limit; a press that the display has lost is pressed again.
 */
final class Hand {
  /** A generous limit for a loaded machine; reached only if the test fails, s. */
  private static final long LIMIT = 30;

  /** What is waited for happens within so many snapshots, some 30 s of the scene, or never. */
  private static final int MOST_SNAPSHOTS = 1800;

  /** Between two looks, ms. */
  private static final int PAUSE = 20;

  private static final int PRESSES = 5;

  private final TestbedWindow window;
  private final BlockingQueue<Snapshot> snapshots;
  final Robot robot;

  Hand(TestbedWindow window, BlockingQueue<Snapshot> snapshots) throws Exception {
    this.window = window;
    this.snapshots = snapshots;
    robot = new Robot();
    robot.setAutoDelay(20);
  }

  static <T> T onEventThread(Supplier<T> action) throws Exception {
    AtomicReference<T> result = new AtomicReference<>();
    SwingUtilities.invokeAndWait(() -> result.set(action.get()));
    return result.get();
  }

  // --- Waiting

  /** Waits for a snapshot, of those that nobody has waited for yet. */
  Snapshot await(Predicate<Snapshot> wanted) throws InterruptedException {
    for (int i = 0; i < MOST_SNAPSHOTS; i++) {
      Snapshot snapshot = snapshots.poll(LIMIT, TimeUnit.SECONDS);
      assertNotNull(snapshot, "no further snapshot");
      if (wanted.test(snapshot)) {
        return snapshot;
      }
    }
    return fail("what was waited for did not happen within " + MOST_SNAPSHOTS + " snapshots");
  }

  /** Whether something is seen of the run soon, in two seconds of a machine that is not loaded. */
  boolean soon(Predicate<Snapshot> wanted) {
    for (int i = 0; i < 100; i++) {
      if (wanted.test(window.simulation().latest())) {
        return true;
      }
      robot.delay(PAUSE);
    }
    return false;
  }

  /** Asks on the event thread until the answer is yes. */
  void until(String what, BooleanSupplier condition) throws Exception {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(LIMIT);
    while (!onEventThread(condition::getAsBoolean)) {
      if (System.nanoTime() > end) {
        fail(what);
      }
      robot.delay(PAUSE);
    }
  }

  // --- Pressing

  void key(int code) {
    robot.keyPress(code);
    robot.keyRelease(code);
    robot.waitForIdle();
  }

  void keyWith(int modifier, int code) {
    robot.keyPress(modifier);
    key(code);
    robot.keyRelease(modifier);
  }

  void click() {
    robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
    robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
    robot.waitForIdle();
  }

  void moveTo(double x, double y) throws Exception {
    Point at = onScreen(x, y);
    robot.mouseMove(at.x, at.y);
    robot.waitForIdle();
  }

  /** Clicks in the middle of the control of a name. */
  void click(String name) throws Exception {
    Point at = middleOf(control(name, Component.class));
    robot.mouseMove(at.x, at.y);
    click();
  }

  static Point middleOf(Component c) throws Exception {
    return onEventThread(
        () -> {
          Point at = c.getLocationOnScreen();
          return new Point(at.x + c.getWidth() / 2, at.y + c.getHeight() / 2);
        });
  }

  /**
   * Clicks on a control until something is so; it must be such that a further click does no harm.
   */
  void clickUntil(String name, String what, BooleanSupplier condition) throws Exception {
    for (int i = 0; i < PRESSES; i++) {
      click(name);
      for (int look = 0; look < 50; look++) {
        if (onEventThread(condition::getAsBoolean)) {
          return;
        }
        robot.delay(PAUSE);
      }
    }
    fail(what);
  }

  // --- Finding

  /** Returns the point of the screen of a world point. */
  Point onScreen(double x, double y) throws Exception {
    return onEventThread(
        () -> {
          View view = window.canvas().view();
          Point origin = window.canvas().getLocationOnScreen();
          return new Point(
              origin.x + (int) Math.round(view.toPictureX(x)),
              origin.y + (int) Math.round(view.toPictureY(y)));
        });
  }

  /** Returns the control of a name; waits until there is one. */
  <T extends Component> T control(String name, Class<T> type) throws Exception {
    until("there is no control " + name, () -> find(window.frame(), name) != null);
    return type.cast(onEventThread(() -> find(window.frame(), name)));
  }

  private static Component find(Container in, String name) {
    for (Component c : in.getComponents()) {
      if (name.equals(c.getName())) {
        return c;
      }
      Component inside = c instanceof Container ? find((Container) c, name) : null;
      if (inside != null) {
        return inside;
      }
    }
    return null;
  }
}
