package org.jbox2d.collision.broadphase;

import static org.jbox2d.collision.broadphase.BroadPhaseModelTest.box;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.jbox2d.collision.AABB;
import org.jbox2d.collision.RayCastInput;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Vec2;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

class DynamicTreeFlatNodesTest {
  private final DynamicTreeFlatNodes tree = new DynamicTreeFlatNodes();

  /** Orders of insertion under which a naive tree degenerates to a list. */
  private enum Layout {
    ALONG_A_LINE {
      @Override
      AABB place(int i) {
        return box(i, 0, 1, 1);
      }
    },
    BACKWARDS_ALONG_A_DIAGONAL {
      @Override
      AABB place(int i) {
        return box(-2 * i, -2 * i, 1, 1);
      }
    },
    ROW_BY_ROW {
      @Override
      AABB place(int i) {
        return box(i % 100, i / 100, 1, 1);
      }
    },
    OUTWARDS_ON_BOTH_SIDES {
      @Override
      AABB place(int i) {
        return box(i % 2 == 0 ? i : -i, 0, 1, 1);
      }
    },
    NESTED {
      @Override
      AABB place(int i) {
        return box(-i, -i, 2 * i, 2 * i);
      }
    },
    ALL_AT_ONE_PLACE {
      @Override
      AABB place(int i) {
        return box(3, 4, 1, 1);
      }
    },
    EVER_LARGER_STEPS {
      @Override
      AABB place(int i) {
        return box((float) i * i * i, 0, 1, 1);
      }
    };

    abstract AABB place(int i);
  }

  @ParameterizedTest
  @EnumSource(Layout.class)
  void heightStaysLogarithmicForSortedInsertion(Layout layout) {
    int count = 10_000;
    for (int i = 0; i < count; i++) {
      tree.createProxy(layout.place(i), i);
    }
    tree.validate();
    assertTrue(
        tree.getHeight() <= heightLimit(count),
        () -> "height " + tree.getHeight() + " of " + count + " proxies");
  }

  /**
   * The height of a tree of which siblings' heights differ by at most 5: the fewest leaves of
   * height h are N(h) = N(h-1) + N(h-6). It is 34 for 10,000 leaves, where a perfect tree has 14.
   */
  private static int heightLimit(int leafCount) {
    List<Integer> fewest = new ArrayList<>(List.of(1, 2, 3, 4, 5, 6));
    int height = 0;
    while (fewest.get(height) <= leafCount) {
      height++;
      fewest.add(fewest.get(fewest.size() - 1) + fewest.get(fewest.size() - 6));
    }
    return height - 1;
  }

  @Test
  void heightStaysLogarithmicWhileAllProxiesMove() {
    int count = 2000;
    Random random = new Random(5);
    AABB[] boxes = new AABB[count];
    for (int i = 0; i < count; i++) {
      boxes[i] = box(i, 0, 1, 1);
      tree.createProxy(boxes[i], i);
    }
    int[] ids = new int[count];
    for (int i = 0; i < tree.m_userData.length; i++) {
      if (tree.m_userData[i] != null) {
        ids[(Integer) tree.m_userData[i]] = i;
      }
    }
    for (int step = 0; step < 20; step++) {
      for (int i = 0; i < count; i++) {
        Vec2 displacement = new Vec2(random.nextFloat() * 2 - 1, random.nextFloat() * 2 - 1);
        boxes[i].lowerBound.addLocal(displacement);
        boxes[i].upperBound.addLocal(displacement);
        tree.moveProxy(ids[i], boxes[i], displacement);
      }
    }
    tree.validate();
    assertTrue(tree.getHeight() <= heightLimit(count));
    assertTrue(tree.getHeight() < 20);
  }

  /**
   * A query that hits nothing of a regular field has to look at a few nodes only: the summed sizes
   * stay near the optimum.
   */
  @Test
  void treeOverAGridIsNearlyAsCheapAsAPerfectOne() {
    List<Integer> order = new ArrayList<>();
    for (int i = 0; i < 64 * 64; i++) {
      order.add(i);
    }
    java.util.Collections.shuffle(order, new Random(8));
    for (int i : order) {
      tree.createProxy(box(i % 64, i / 64, 0.8f, 0.8f), i);
    }
    assertTrue(tree.getAreaRatio() < 1.25f * perfectAreaRatio(), () -> "" + tree.getAreaRatio());
  }

  /**
   * Summed perimeters over the outermost when a grid of 64 x 64 unit cells is halved alternately in
   * x and y.
   */
  private static float perfectAreaRatio() {
    float total = 0;
    float width = 64;
    float height = 64;
    for (int count = 1; count <= 64 * 64; count *= 2) {
      total += count * (width + height) / (64 + 64);
      if (width >= height) {
        width /= 2;
      } else {
        height /= 2;
      }
    }
    return total;
  }

  @Test
  void enlargedBoxIsGrownByMarginAndStretchedAlongTheMotion() {
    int id = tree.createProxy(box(0, 0, 1, 2), null);
    assertBox(-0.1f, -0.1f, 1.1f, 2.1f, tree.getFatAABB(id));
    assertTrue(tree.moveProxy(id, box(0.5f, -0.25f, 1, 2), new Vec2(0.5f, -0.25f)));
    assertBox(0.4f, -0.85f, 2.6f, 1.85f, tree.getFatAABB(id));
  }

  @Test
  void enlargedBoxIsStretchedByHalfItsSizeAtMost() {
    int id = tree.createProxy(box(0, 0, 1, 2), null);
    assertTrue(tree.moveProxy(id, box(30, -1, 1, 2), new Vec2(30, -1)));
    assertBox(29.9f, -2.6f, 32.6f, 1.1f, tree.getFatAABB(id));
  }

  private static void assertBox(float minX, float minY, float maxX, float maxY, AABB box) {
    assertEquals(minX, box.lowerBound.x, 1e-6f);
    assertEquals(minY, box.lowerBound.y, 1e-6f);
    assertEquals(maxX, box.upperBound.x, 1e-6f);
    assertEquals(maxY, box.upperBound.y, 1e-6f);
  }

  @Test
  void smallMotionKeepsTheEnlargedBox() {
    int id = tree.createProxy(box(0, 0, 1, 1), null);
    float step = Settings.aabbExtension / 2;
    assertFalse(tree.moveProxy(id, box(step, 0, 1, 1), new Vec2(step, 0)));
    assertBox(-0.1f, -0.1f, 1.1f, 1.1f, tree.getFatAABB(id));
    assertTrue(tree.moveProxy(id, box(3 * step, 0, 1, 1), new Vec2(2 * step, 0)));
  }

  /**
   * Symptom: a body that came to rest after a fast flight collects pairs far away for as long as it
   * rests.
   */
  @Test
  void boxOfAProxyThatWasFastReachesNoFurtherThanHalfItsSize() {
    int id = tree.createProxy(box(0, 0, 1, 1), null);
    tree.moveProxy(id, box(50, 0, 1, 1), new Vec2(50, 0));
    tree.moveProxy(id, box(50, 0, 1, 1), new Vec2(0, 0));
    assertEquals(52.1f, tree.getFatAABB(id).upperBound.x, 1e-4f);
  }

  /** Symptom: a long body that was turned upright keeps the pairs all along where it lay. */
  @Test
  void boxThatHasBecomeMuchTooLargeShrinks() {
    int id = tree.createProxy(box(0, 0, 5, 5), null);
    assertTrue(tree.moveProxy(id, box(2, 2, 1, 1), new Vec2(0, 0)));
    assertBox(1.9f, 1.9f, 3.1f, 3.1f, tree.getFatAABB(id));
    assertFalse(tree.moveProxy(id, box(2, 2, 1, 1), new Vec2(0, 0)));
  }

  @Test
  void emptyTreeAnswersEverything() {
    assertEquals(0, tree.getHeight());
    assertEquals(0, tree.computeHeight());
    assertEquals(0, tree.getMaxBalance());
    assertEquals(0, tree.getAreaRatio());
    tree.query(id -> fail(id), box(-1, -1, 2, 2));
    tree.raycast((input, id) -> fail(id) ? 1 : 0, ray(0, 0, 1, 1));
    tree.validate();
    int id = tree.createProxy(box(0, 0, 1, 1), "a");
    tree.destroyProxy(id);
    assertEquals(-1, tree.m_root);
    assertNull(tree.m_userData[id]);
    tree.query(other -> fail(other), box(-1, -1, 2, 2));
  }

  private static boolean fail(int id) {
    throw new AssertionError("reported " + id);
  }

  @Test
  void queryEndsWhenTheCallbackSaysSo() {
    createRow(10);
    int[] calls = {0};
    tree.query(id -> ++calls[0] < 3, box(-100, -100, 200, 200));
    assertEquals(3, calls[0]);
  }

  @Test
  void infiniteBoxFindsAll() {
    createRow(10);
    int[] calls = {0};
    float all = Float.POSITIVE_INFINITY;
    tree.query(id -> ++calls[0] > 0, new AABB(new Vec2(-all, -all), new Vec2(all, all)));
    assertEquals(10, calls[0]);
  }

  /**
   * For each proxy that a query finds, each neighbour that a query from within finds, and each that
   * a ray finds from there.
   */
  @Test
  void searchesNestInCallbacks() {
    createRow(40);
    int[] innermost = {0};
    List<Integer> outer = new ArrayList<>();
    tree.query(
        id -> {
          outer.add(id);
          tree.query(
              inner -> {
                tree.raycast(
                    (input, hit) -> {
                      innermost[0]++;
                      return -1;
                    },
                    ray(-1, 0.5f, 100, 0.5f));
                return true;
              },
              tree.getFatAABB(id));
          return true;
        },
        box(-1, -1, 100, 3));
    assertEquals(40, outer.size());
    assertEquals(40, outer.stream().distinct().count());
    assertEquals(40 * 40, innermost[0]);
  }

  @Test
  void aThrowingCallbackLeavesTheTreeUsable() {
    createRow(10);
    AABB all = box(-100, -100, 200, 200);
    assertThrows(AssertionError.class, () -> tree.query(id -> fail(id), all));
    assertThrows(
        AssertionError.class,
        () -> tree.raycast((input, id) -> fail(id) ? 1 : 0, ray(-1, 0.5f, 100, 0.5f)));
    int[] calls = {0};
    tree.query(id -> ++calls[0] > 0, all);
    assertEquals(10, calls[0]);
  }

  @Test
  void rayMeetsNearProxiesFirstAndIsClipped() {
    createRow(100);
    List<Integer> hits = new ArrayList<>();
    tree.raycast(
        (input, id) -> {
          hits.add((Integer) tree.getUserData(id));
          float entry = (tree.getFatAABB(id).lowerBound.x - input.p1.x) / 1000;
          assertTrue(entry <= input.maxFraction * 1.0001f);
          return Math.max(entry, 1e-3f);
        },
        ray(-10, 0.5f, 990, 0.5f));
    assertEquals(List.of(0), hits);
  }

  @Test
  void rayEndsAtZeroAndIgnoresNegativeAndIsNeverLengthened() {
    createRow(20);
    int[] calls = {0};
    tree.raycast((input, id) -> ++calls[0] == 4 ? 0 : -1, ray(-1, 0.5f, 100, 0.5f));
    assertEquals(4, calls[0]);
    List<Integer> hits = new ArrayList<>();
    tree.raycast(
        (input, id) -> {
          hits.add((Integer) tree.getUserData(id));
          return hits.size() == 1 ? 0.03f : 1;
        },
        ray(-1, 0.5f, 99, 0.5f));
    // Clipped to x <= 2 by the first; the boxes 0 and 1 begin before that, and box 2 at 3.9.
    assertTrue(hits.size() <= 2 && !hits.contains(2), hits::toString);
  }

  @ParameterizedTest
  @ValueSource(floats = {0.01f, 1, 1e5f})
  void rayAlongAnEdgeOfTheBoxOrFromInsideMeetsIt(float scale) {
    int id = tree.createProxy(box(-scale, -2 * scale, 2 * scale, 4 * scale), null);
    AABB fat = new AABB(tree.getFatAABB(id));
    float top = fat.upperBound.y;
    assertTrue(isHit(ray(-9 * scale - 1, top, 9 * scale + 1, top)));
    assertTrue(isHit(ray(fat.lowerBound.x, 9 * scale, fat.lowerBound.x, -9 * scale)));
    assertTrue(isHit(ray(0, 0, 0, 0.5f * scale)));
    assertTrue(isHit(ray(0, 0, 0, 0)), "a ray of length 0 is a point");
    assertFalse(isHit(ray(9 * scale + 1, 9 * scale + 1, 9 * scale + 1, 9 * scale + 1)));
    assertFalse(isHit(ray(3 * scale + 1, 0, 9 * scale + 1, 0)), "the box lies behind");
    assertFalse(isHit(ray(-9 * scale - 1, 0, -5 * scale - 1, 0)), "the ray ends before the box");
  }

  private boolean isHit(RayCastInput ray) {
    boolean[] hit = {false};
    tree.raycast(
        (input, id) -> {
          hit[0] = true;
          return 0;
        },
        ray);
    return hit[0];
  }

  @Test
  void refusesWhatIsNoBox() {
    float inf = Float.POSITIVE_INFINITY;
    int id = tree.createProxy(box(0, 0, 1, 1), null);
    for (AABB bad :
        List.of(
            box(Float.NaN, 0, 1, 1),
            box(0, Float.NaN, 1, 1),
            box(0, 0, inf, 1),
            box(0, -inf, 1, 1),
            box(0, 0, -1, 1),
            box(0, 0, 1, -0.1f))) {
      assertNames(bad, () -> tree.createProxy(bad, null));
      assertNames(bad, () -> tree.moveProxy(id, bad, new Vec2()));
    }
    Vec2 far = new Vec2(Float.NaN, 0);
    assertThrows(IllegalArgumentException.class, () -> tree.moveProxy(id, box(9, 9, 1, 1), far));
    assertThrows(IllegalArgumentException.class, () -> tree.moveProxy(id, box(0, 0, 1, 1), far));
    assertThrows(
        IllegalArgumentException.class, () -> tree.query(other -> true, box(0, Float.NaN, 1, 1)));
    assertThrows(
        IllegalArgumentException.class, () -> tree.raycast((input, other) -> 1, ray(0, 0, inf, 1)));
    tree.validate();
    assertBox(-0.1f, -0.1f, 1.1f, 1.1f, tree.getFatAABB(id));
  }

  private static void assertNames(AABB bad, Runnable call) {
    String message = assertThrows(IllegalArgumentException.class, call::run).getMessage();
    assertTrue(message.contains(bad.upperBound.toString()), message);
  }

  @Test
  void refusesIdsThatAreNoProxy() {
    createRow(3);
    int destroyed = tree.createProxy(box(0, 0, 1, 1), null);
    tree.destroyProxy(destroyed);
    for (int id : new int[] {-1, destroyed, tree.m_root, 1000}) {
      assertThrows(IllegalArgumentException.class, () -> tree.destroyProxy(id));
      assertThrows(IllegalArgumentException.class, () -> tree.getFatAABB(id));
      assertThrows(IllegalArgumentException.class, () -> tree.getUserData(id));
      assertThrows(
          IllegalArgumentException.class, () -> tree.moveProxy(id, box(0, 0, 1, 1), new Vec2()));
    }
    tree.validate();
  }

  @Test
  void largestFiniteBoxesAreHeld() {
    float max = Float.MAX_VALUE;
    int huge = tree.createProxy(new AABB(new Vec2(-max, -max), new Vec2(max, max)), "huge");
    createRow(20);
    tree.moveProxy(
        huge, new AABB(new Vec2(-max, 0), new Vec2(max, 0)), new Vec2(1e37f, Float.MIN_VALUE));
    tree.validate();
    int[] calls = {0};
    tree.query(id -> ++calls[0] > 0, box(1e30f, 0, 1, 1));
    assertEquals(1, calls[0]);
  }

  private void createRow(int count) {
    for (int i = 0; i < count; i++) {
      tree.createProxy(box(2 * i, 0, 1, 1), i);
    }
  }

  private static RayCastInput ray(float x1, float y1, float x2, float y2) {
    RayCastInput ray = new RayCastInput();
    ray.p1.set(x1, y1);
    ray.p2.set(x2, y2);
    ray.maxFraction = 1;
    return ray;
  }
}
