package org.jbox2d.fracture.hertelmehlhorn;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.jbox2d.fracture.fragmentation.OutlineKind;
import org.jbox2d.fracture.geometry.Outline;
import org.jbox2d.fracture.geometry.Predicates;
import org.junit.jupiter.api.Test;

class MinimumDecompositionTest {
  @Test
  void knownMinima() {
    assertEquals(1, MinimumDecomposition.parts(Outline.of(0, 0, 1, 0, 0, 1)));
    assertEquals(1, MinimumDecomposition.parts(Outline.of(0, 0, 0, 1, 1, 1, 1, 0)));
    assertEquals(1, MinimumDecomposition.parts(Outline.of(0, 0, 1, 0, 2, 0, 2, 1, 0, 1)));
    assertEquals(2, MinimumDecomposition.parts(Outline.of(0, 0, 2, 0, 2, 1, 1, 1, 1, 2, 0, 2)));
    // A plus needs three parts: one bar and two stubs.
    assertEquals(
        3,
        MinimumDecomposition.parts(
            Outline.of(1, 0, 2, 0, 2, 1, 3, 1, 3, 2, 2, 2, 2, 3, 1, 3, 1, 2, 0, 2, 0, 1, 1, 1)));
    assertThrows(
        IllegalArgumentException.class,
        () ->
            MinimumDecomposition.parts(
                Outline.ofRings(new double[] {0, 0, 9, 0, 0, 9}, new double[] {1, 1, 2, 1, 1, 2})));
  }

  /**
   * Bounds of Chazelle for r reflex vertices, and those of Hertel and Mehlhorn for their heuristic.
   */
  @Test
  void hertelMehlhornIsNearTheMinimum() {
    ConvexDecomposition decomposition = new ConvexDecomposition();
    double sum = 0;
    int cases = 60;
    for (int seed = 0; seed < cases; seed++) {
      Outline outline = OutlineKind.RANDOM.make(new Random(seed), 12 + seed % 17, 0).normal();
      int n = outline.vertexCount();
      int reflex = 0;
      for (int i = 0; i < n; i++) {
        int turn = Predicates.orientation(outline.coordinates(), i, (i + 1) % n, (i + 2) % n);
        reflex += turn < 0 ? 1 : 0;
      }
      int least = MinimumDecomposition.parts(outline);
      assertTrue(least >= (reflex + 1) / 2 + 1 && least <= 2 * reflex + 1, least + " of " + reflex);
      int parts = decomposition.decompose(outline, n, 0).parts().count();
      assertTrue(parts >= least && parts <= 2 * least, parts + " of " + least);
      sum += (double) parts / least;
    }
    assertTrue(sum / cases < 1.1, "parts over minimum: " + sum / cases);
  }
}
