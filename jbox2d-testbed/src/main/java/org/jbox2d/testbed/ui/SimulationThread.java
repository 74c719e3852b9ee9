package org.jbox2d.testbed.ui;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.Iterator;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.jbox2d.testbed.simulation.Input;
import org.jbox2d.testbed.simulation.Setup;
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

  /** Steps whose numbers are kept: some ten minutes. */
  private static final int MOST_FIGURES = 40_000;

  private final BlockingQueue<Runnable> commands = new LinkedBlockingQueue<>();
  private final Consumer<Snapshot> listener;
  private final Thread thread;

  /** The last snapshots, the newest first. Guarded by itself. */
  private final Deque<Snapshot> past = new ArrayDeque<>();

  /** Numbers of each step of the run, the oldest first. Guarded by {@link #past}. */
  private final List<Snapshot.Counts> figures = new ArrayList<>();

  /** What a long command is at; {@code null} if none runs. */
  private volatile String busy;

  private volatile boolean going;
  private volatile boolean closed;

  // Of the thread alone from here.
  private Simulation run;
  private SnapshotTaker camera;
  private boolean withBoxes;
  private boolean withContacts;
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
  SimulationThread(Setup setup, Consumer<Snapshot> listener, Consumer<Throwable> onFailure) {
    this.listener = listener;
    load(setup);
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

  /** Returns the snapshots that are kept, the oldest first. */
  List<Snapshot> pastUpTo(int back) {
    synchronized (past) {
      List<Snapshot> kept = new ArrayList<>(past);
      Collections.reverse(kept);
      return kept.subList(0, Math.max(0, kept.size() - back));
    }
  }

  /** Returns the numbers of the last steps, the newest last. */
  List<Snapshot.Counts> figures(int most) {
    synchronized (past) {
      int from = Math.max(0, figures.size() - most);
      return new ArrayList<>(figures.subList(from, figures.size()));
    }
  }

  /** Returns how far back snapshots are kept. */
  int pastCount() {
    synchronized (past) {
      return Math.max(0, past.size() - 1);
    }
  }

  /** Returns what a long command is at; {@code null} if none runs. */
  String busy() {
    return busy;
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
  void load(Setup setup) {
    going = false;
    submit(() -> replace(new Simulation(setup)));
  }

  /** Builds the scene anew, with the parameters of now; it goes on if it went. */
  void reset() {
    submit(() -> replace(new Simulation(run.setupNow())));
  }

  /** Sets a parameter; one of the scene builds it anew. */
  void set(String parameter, double value) {
    submit(
        () -> {
          if (run.isOfScene(parameter)) {
            replace(new Simulation(run.setupNow().with(parameter, value)));
          } else {
            run.apply(Input.set(parameter, value));
          }
        });
  }

  /**
   * Makes a state of the past the present one, and stops there: builds the scene again and does the
   * same steps and inputs again, which is exact, but takes as long as they took. What came later is
   * forgotten.
   */
  void goBackTo(int step) {
    going = false;
    submit(() -> rewind(step));
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
  void apply(Input input) {
    submit(
        () -> {
          run.apply(input);
          // Whether or not a snapshot is taken before the next command.
          camera.note();
        });
  }

  /** Sets what snapshots have that not every picture shows; ten seconds of all of it are large. */
  void setDetails(boolean boxes, boolean contacts) {
    submit(
        () -> {
          withBoxes = boxes;
          withContacts = contacts;
          tellCamera();
        });
  }

  /** Queues a look at the run, between two steps. */
  void look(Consumer<Simulation> action) {
    submit(() -> action.accept(run));
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
    show(simulation, new SnapshotTaker(simulation));
    fresh = true;
  }

  private void show(Simulation simulation, SnapshotTaker taker) {
    run = simulation;
    camera = taker;
    tellCamera();
    nextStep = System.nanoTime();
  }

  private void tellCamera() {
    camera.setWithBoxes(withBoxes);
    camera.setWithContacts(withContacts);
  }

  private void rewind(int step) {
    SnapshotTaker[] taker = new SnapshotTaker[1];
    int last = Math.min(step, run.steps());
    Simulation again =
        Simulation.repeat(
            run.setup(),
            run.inputs(),
            last,
            r -> {
              busy = "Going back: step " + r.steps() + " of " + last + " again";
              if (taker[0] == null) {
                taker[0] = new SnapshotTaker(r);
              }
              taker[0].note();
            });
    synchronized (past) {
      past.removeIf(snapshot -> snapshot.counts().steps() > again.steps());
      figures.removeIf(counts -> counts.steps() > again.steps());
    }
    show(again, taker[0]);
    busy = null;
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
        figures.clear();
        fresh = false;
      }
      Snapshot last = past.peekFirst();
      if (last != null && last.counts().steps() == snapshot.counts().steps()) {
        // A command changed the state between steps.
        past.removeFirst();
        figures.remove(figures.size() - 1);
      }
      figures.add(snapshot.counts());
      if (figures.size() > MOST_FIGURES) {
        figures.subList(0, MOST_FIGURES / 4).clear();
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
