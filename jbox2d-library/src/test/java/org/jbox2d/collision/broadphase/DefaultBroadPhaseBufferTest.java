package org.jbox2d.collision.broadphase;

import static org.jbox2d.collision.broadphase.BroadPhaseModelTest.box;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.jbox2d.common.Vec2;
import org.junit.jupiter.api.Test;

class DefaultBroadPhaseBufferTest {
  private final DefaultBroadPhaseBuffer broadPhase =
      new DefaultBroadPhaseBuffer(new DynamicTreeFlatNodes());

  private List<String> pairs() {
    List<String> pairs = new ArrayList<>();
    broadPhase.updatePairs((a, b) -> pairs.add(a + "-" + b));
    return pairs;
  }

  @Test
  void newProxiesPairOnceWhateverTheNumberOfMoves() {
    int a = broadPhase.createProxy(box(0, 0, 1, 1), "a");
    broadPhase.createProxy(box(0.5f, 0, 1, 1), "b");
    broadPhase.moveProxy(a, box(5, 0, 1, 1), new Vec2(5, 0));
    broadPhase.moveProxy(a, box(0, 0, 1, 1), new Vec2(-5, 0));
    broadPhase.touchProxy(a);
    assertEquals(List.of("a-b"), pairs());
    assertEquals(List.of(), pairs());
  }

  @Test
  void touchedProxyReportsKnownPairsAgain() {
    broadPhase.createProxy(box(0, 0, 1, 1), "a");
    int b = broadPhase.createProxy(box(0.5f, 0, 1, 1), "b");
    pairs();
    broadPhase.touchProxy(b);
    assertEquals(List.of("a-b"), pairs());
  }

  @Test
  void destroyedProxyLeavesTheMoveBuffer() {
    broadPhase.createProxy(box(0, 0, 1, 1), "a");
    int b = broadPhase.createProxy(box(0, 0, 1, 1), "b");
    broadPhase.destroyProxy(b);
    assertEquals(List.of(), pairs());
    int c = broadPhase.createProxy(box(0, 0, 1, 1), "c");
    assertEquals(List.of("a-c"), pairs());
    broadPhase.destroyProxy(c);
    assertEquals(1, broadPhase.getProxyCount());
  }

  /** A failing callback must not lose the pairs that come after the one it failed at. */
  @Test
  void throwingCallbackLosesNoPairs() {
    for (String name : List.of("a", "b", "c")) {
      broadPhase.createProxy(box(0, 0, 1, 1), name);
    }
    assertThrows(
        IllegalStateException.class,
        () ->
            broadPhase.updatePairs(
                (a, b) -> {
                  throw new IllegalStateException();
                }));
    assertEquals(3, pairs().size());
  }

  @Test
  void orderOfPairsRepeats() {
    assertEquals(pairsOfRandomScene(), pairsOfRandomScene());
  }

  private static List<String> pairsOfRandomScene() {
    DefaultBroadPhaseBuffer scene = new DefaultBroadPhaseBuffer(new DynamicTree());
    Random random = new Random(77);
    List<String> pairs = new ArrayList<>();
    List<Integer> ids = new ArrayList<>();
    for (int i = 0; i < 300; i++) {
      ids.add(scene.createProxy(box(random.nextFloat() * 20, random.nextFloat() * 20, 1, 1), i));
    }
    for (int step = 0; step < 5; step++) {
      scene.updatePairs((a, b) -> pairs.add(a + "-" + b));
      for (int id : ids) {
        Vec2 to = new Vec2(random.nextFloat() * 20, random.nextFloat() * 20);
        scene.moveProxy(id, box(to.x, to.y, 1, 1), new Vec2());
      }
    }
    assertTrue(pairs.size() > 1000);
    return pairs;
  }

  @Test
  void refusesUnknownProxiesAndNoStrategy() {
    assertThrows(IllegalArgumentException.class, () -> new DefaultBroadPhaseBuffer(null));
    for (int id : new int[] {-1, 0, 99, Integer.MAX_VALUE}) {
      assertThrows(IllegalArgumentException.class, () -> broadPhase.touchProxy(id));
      assertThrows(IllegalArgumentException.class, () -> broadPhase.destroyProxy(id));
    }
    assertEquals(0, broadPhase.getProxyCount());
  }
}
