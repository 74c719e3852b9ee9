package org.jbox2d.testbed.ui;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.jbox2d.testbed.scenes.Scene;
import org.jbox2d.testbed.simulation.Simulation;
import org.jbox2d.testbed.simulation.Snapshot;
import org.jbox2d.testbed.simulation.SnapshotTaker;

/**
 * The thread that owns the run. Nobody else touches it: others queue commands, which run between
 * two steps in the order queued, and read the last snapshot, which is immutable.
 *
 * <p>While it goes, it does as many steps per second as the scene is meant for, times the speed. If
 * steps take longer than that, simulated time falls behind; it is not caught up.
 */
final class SimulationThread {
  private static final double NANOS_PER_SECOND = 1e9;

  /** Backlog after which time is given up rather than caught up, s: a few frames. */
  private static final double MAX_BACKLOG = 0.1;

  /** How far back snapshots are kept, simulated s. */
  private static final float PAST_SECONDS = 10f;

  private final BlockingQueue<Runnable> commands = new LinkedBlockingQueue<>();
  private final Consumer<Snapshot> listener;
  private final Thread thread;

  /** The last snapshots, the newest first. Guarded by itself. */
  private final Deque<Snapshot> past = new ArrayDeque<>();

  private volatile boolean going;
  private volatile boolean closed;

  // Of the thread alone from here.
  private Simulation run;
  private SnapshotTaker camera;
  private Interaction interaction;
  private double speed = 1;
  private long nextStep;

  /** Whether the run has no snapshot yet; until it has, the last of the run before is shown. */
  private boolean fresh;

  /**
   * Builds a scene and starts the thread; the run itself does not go yet.
   *
   * @param listener hears of each snapshot, on this thread
   * @param onFailure hears of what ended the thread, on this thread
   */
  SimulationThread(
      Scene scene,
      float hz,
      long seed,
      Consumer<Snapshot> listener,
      Consumer<Throwable> onFailure) {
    this.listener = listener;
    load(scene, hz, seed);
    thread = new Thread(this::loop, "simulation");
    thread.setDaemon(true);
    thread.setUncaughtExceptionHandler((t, e) -> onFailure.accept(e));
    thread.start();
  }

  // --- For any thread

  /** Returns the state after the last step or command; {@code null} before there is one. */
  Snapshot latest() {
    return past(0);
  }

  /** Returns the state a number of snapshots before the last, or the oldest that is kept. */
  Snapshot past(int back) {
    synchronized (past) {
      Iterator<Snapshot> snapshots = past.iterator();
      Snapshot found = null;
      for (int i = 0; i <= back && snapshots.hasNext(); i++) {
        found = snapshots.next();
      }
      return found;
    }
  }

  /** Returns how long the last steps took, ms, the newest first. */
  double[] recentStepMillis(int most) {
    synchronized (past) {
      return past.stream().limit(most).mapToDouble(s -> s.counts().stepMillis()).toArray();
    }
  }

  /** Returns how far back snapshots are kept. */
  int pastCount() {
    synchronized (past) {
      return Math.max(0, past.size() - 1);
    }
  }

  /** Returns whether the run goes. */
  boolean isGoing() {
    return going;
  }

  /** Lets the run go or stop. */
  void setGoing(boolean go) {
    going = go;
    submit(() -> nextStep = System.nanoTime());
  }

  /** Replaces the run by a new one, and stops it. */
  void load(Scene scene, float hz, long seed) {
    going = false;
    submit(() -> replace(new Simulation(scene, hz, seed)));
  }

  /** Builds the scene anew; it goes on if it went. */
  void reset() {
    submit(() -> replace(new Simulation(run.scene(), run.hz(), run.seed())));
  }

  /** Does one step. */
  void singleStep() {
    submit(
        () -> {
          run.step();
          publish();
        });
  }

  /** Sets how much simulated time passes in a second. */
  void setSpeed(double factor) {
    submit(() -> speed = factor);
  }

  /** Queues what the user does to the world. */
  void interact(Consumer<Interaction> action) {
    submit(() -> action.accept(interaction));
  }

  /** Ends the thread. */
  void close() {
    closed = true;
    submit(() -> {});
  }

  private void submit(Runnable command) {
    commands.add(command);
  }

  // --- Of the thread alone

  private void replace(Simulation simulation) {
    fresh = true;
    run = simulation;
    camera = new SnapshotTaker(run);
    interaction = new Interaction(run);
    nextStep = System.nanoTime();
  }

  private void loop() {
    try {
      while (!closed) {
        if (runCommands() | stepIfDue()) {
          publish();
        }
      }
    } catch (InterruptedException e) {
      // Somebody wants the thread to end; nothing is left half done.
      Thread.currentThread().interrupt();
    }
  }

  private void publish() {
    Snapshot snapshot = camera.take();
    remember(snapshot);
    listener.accept(snapshot);
  }

  private void remember(Snapshot snapshot) {
    synchronized (past) {
      if (fresh) {
        past.clear();
        fresh = false;
      }
      Snapshot last = past.peekFirst();
      if (last != null && last.counts().steps() == snapshot.counts().steps()) {
        // A command changed the state between steps.
        past.removeFirst();
      }
      past.addFirst(snapshot);
      while (past.size() > PAST_SECONDS * run.hz()) {
        past.removeLast();
      }
    }
  }

  /** Waits until there is a command or a step is due. */
  private boolean runCommands() throws InterruptedException {
    Runnable command =
        going ? commands.poll(nextStep - System.nanoTime(), TimeUnit.NANOSECONDS) : commands.take();
    boolean any = command != null;
    while (command != null) {
      command.run();
      command = commands.poll();
    }
    return any;
  }

  private boolean stepIfDue() {
    long now = System.nanoTime();
    if (!going || now < nextStep) {
      return false;
    }
    run.step();
    nextStep += (long) (NANOS_PER_SECOND / (run.hz() * speed));
    if (System.nanoTime() - nextStep > MAX_BACKLOG * NANOS_PER_SECOND) {
      nextStep = System.nanoTime();
    }
    return true;
  }
}
