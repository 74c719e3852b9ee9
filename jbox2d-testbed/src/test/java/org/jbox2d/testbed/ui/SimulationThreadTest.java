package org.jbox2d.testbed.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.jbox2d.testbed.parameters.Values;
import org.jbox2d.testbed.scenes.Scene;
import org.jbox2d.testbed.scenes.Scenes;
import org.jbox2d.testbed.simulation.Input;
import org.jbox2d.testbed.simulation.Input.Action;
import org.jbox2d.testbed.simulation.Setup;
import org.jbox2d.testbed.simulation.Snapshot;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** The thread beside the window; it needs no display. */
class SimulationThreadTest {
  /** A generous limit for a loaded machine; reached only if the test fails, s. */
  private static final long LIMIT = 30;

  private final BlockingQueue<Snapshot> snapshots = new LinkedBlockingQueue<>();
  private final Scene scene = Scenes.named("dominoes");
  private final SimulationThread thread =
      new SimulationThread(Setup.of(scene, 1), snapshots::add, Throwable::printStackTrace);

  @AfterEach
  void close() {
    thread.close();
  }

  private Snapshot await(Predicate<Snapshot> wanted) throws InterruptedException {
    for (; ; ) {
      Snapshot snapshot = snapshots.poll(LIMIT, TimeUnit.SECONDS);
      assertNotNull(snapshot, "no further snapshot");
      if (wanted.test(snapshot)) {
        return snapshot;
      }
    }
  }

  @Test
  void stopsAtTheStartAndStepsWhenTold() throws InterruptedException {
    assertEquals(0, await(s -> true).counts().steps());
    thread.singleStep();
    thread.singleStep();
    assertEquals(1, await(s -> s.counts().steps() > 0).counts().steps());
    assertEquals(2, await(s -> s.counts().steps() > 1).counts().steps());
    assertFalse(thread.isGoing());
  }

  @Test
  void goesUntilStopped() throws InterruptedException {
    thread.setGoing(true);
    await(s -> s.counts().steps() >= 5);
    thread.setGoing(false);
    thread.look(run -> {});
    thread.reset();
    await(s -> s.counts().steps() == 0);
    thread.singleStep();
    assertEquals(1, await(s -> true).counts().steps());
  }

  @Test
  void resetBuildsTheSameSceneAnew() throws InterruptedException {
    Snapshot start = await(s -> true);
    thread.setGoing(true);
    await(s -> s.counts().steps() >= 3);
    thread.setGoing(false);
    thread.reset();
    Snapshot again = await(s -> s.counts().steps() == 0);
    assertEquals(start.bodyCount(), again.bodyCount());
    for (int i = 0; i < start.bodyCount(); i++) {
      assertEquals(start.x(i), again.x(i));
      assertEquals(start.y(i), again.y(i));
    }
  }

  @Test
  void pastSnapshotsAreKeptForTenSeconds() throws InterruptedException {
    await(s -> true);
    for (int i = 0; i < 700; i++) {
      thread.singleStep();
    }
    await(s -> s.counts().steps() == 700);
    assertEquals(700, thread.past(0).counts().steps());
    assertEquals(650, thread.past(50).counts().steps());
    assertEquals(599, thread.pastCount());
    assertEquals(101, thread.past(100_000).counts().steps());
    thread.reset();
    await(s -> s.counts().steps() == 0);
    assertEquals(0, thread.pastCount());
  }

  @Test
  void thrownDiscIsInTheNextSnapshot() throws InterruptedException {
    int bodies = await(s -> true).bodyCount();
    thread.apply(Input.at(Action.THROW, 0, 10));
    Snapshot after = await(s -> true);
    assertEquals(bodies + 1, after.bodyCount());
    // The newest body is painted last; it starts to the left of its target.
    assertEquals(10f, after.y(bodies));
    assertEquals(-25f, after.x(bodies));
  }

  @Test
  void draggedBodyFollowsThePointerAndIsLetGo() throws InterruptedException {
    await(s -> true);
    // The disc of the scene rests on the floor at x = -32.
    int disc = snapshotIndexOfDisc();
    thread.apply(Input.at(Action.GRAB, -32, 1));
    thread.apply(Input.at(Action.DRAG, -32, 20));
    for (int i = 0; i < 120; i++) {
      thread.singleStep();
    }
    Snapshot held = await(s -> s.counts().steps() == 120);
    assertEquals(1, held.lineCount());
    assertEquals(20f, held.y(disc), 0.5f);
    thread.apply(Input.release());
    thread.singleStep();
    assertEquals(0, await(s -> s.counts().steps() == 121).lineCount());
  }

  @Test
  void boxIsStruckCutAndBlownUp() throws InterruptedException {
    thread.load(new Setup(Scenes.named("main"), 60f, 1, Values.NONE));
    Snapshot whole = await(s -> s.counts().scene().equals("main"));
    thread.apply(Input.at(Action.BREAK, 0, 9));
    Snapshot struck = await(s -> true);
    assertEquals(1, struck.counts().fractures());
    assertNotEquals(whole.bodyCount(), struck.bodyCount());

    thread.reset();
    await(s -> s.bodyCount() == whole.bodyCount());
    thread.apply(Input.cut(-6, 4, 6, 6));
    assertEquals(whole.bodyCount() + 1, await(s -> true).bodyCount());

    thread.reset();
    await(s -> s.bodyCount() == whole.bodyCount());
    thread.apply(Input.at(Action.EXPLODE, -6, 5));
    assertTrue(await(s -> true).bodyCount() > whole.bodyCount());
  }

  /** Back to a state that had been changed by hand, and on from there in another way. */
  @Test
  void goesBackToAStateOfThePastAndOnFromThere() throws InterruptedException {
    thread.load(Setup.of(Scenes.named("main"), 1));
    for (int i = 0; i < 60; i++) {
      if (i == 30) {
        thread.apply(Input.at(Action.BREAK, 0, 9));
      }
      thread.singleStep();
    }
    await(s -> s.counts().steps() == 60);
    Snapshot then = thread.past(20);
    assertEquals(40, then.counts().steps());
    thread.goBackTo(40);
    Snapshot again = await(s -> s.counts().steps() == 40);
    assertEquals(then.hash(), again.hash());
    assertEquals(40, thread.latest().counts().steps());
    assertEquals(39, thread.past(1).counts().steps());
    for (int i = 0; i < then.bodyCount(); i++) {
      assertEquals(then.outline(i).id, again.outline(i).id);
    }
    thread.apply(Input.at(Action.THROW, 0, 9));
    thread.singleStep();
    assertEquals(
        then.bodyCount() + 1,
        await(s -> s.counts().steps() == 41).counts().bodies(),
        "a disc more");
  }

  @Test
  void parameterOfTheWorldActsAtOnce() throws InterruptedException {
    await(s -> true);
    int disc = snapshotIndexOfDisc();
    float resting = thread.latest().y(disc);
    thread.set("gravity-y", 20);
    for (int i = 0; i < 60; i++) {
      thread.singleStep();
    }
    assertTrue(await(s -> s.counts().steps() == 60).y(disc) > resting + 5f);
    thread.reset();
    thread.singleStep();
    thread.singleStep();
    Snapshot kept = await(s -> s.counts().steps() == 2);
    assertTrue(kept.y(disc) > resting, "a reset keeps the parameter");
  }

  private int snapshotIndexOfDisc() {
    Snapshot snapshot = thread.latest();
    for (int i = 0; i < snapshot.bodyCount(); i++) {
      if (snapshot.outline(i).radius(0) > 0f) {
        return i;
      }
    }
    throw new AssertionError("no disc");
  }
}
