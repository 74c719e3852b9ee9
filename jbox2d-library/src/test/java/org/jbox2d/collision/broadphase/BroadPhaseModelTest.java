package org.jbox2d.collision.broadphase;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.BiConsumer;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.Tuple;
import org.jbox2d.callbacks.PairCallback;
import org.jbox2d.callbacks.TreeCallback;
import org.jbox2d.collision.AABB;
import org.jbox2d.collision.RayCastInput;
import org.jbox2d.common.Vec2;
import org.jbox2d.internal.PairSelection;

/** Random sequences of calls to a broad phase, beside a list of boxes searched by brute force. */
class BroadPhaseModelTest {
  private enum Kind {
    CREATE,
    MOVE,
    JUMP,
    DESTROY,
    TOUCH,
    MARK,
    FILTER,
    QUERY,
    RAY,
    PAIRS
  }

  /**
   * One call; numbers are in units of the scene's scale, {@code pick} chooses among the living
   * proxies.
   */
  private record Call(Kind kind, int pick, float x, float y, float width, float height) {}

  private record Proxy(AABB tight, Object userData) {}

  private record Bits(int categories, int mask) {
    static final Bits ALL = new Bits(-1, -1);

    boolean accepts(Bits other) {
      return (mask & other.categories) != 0;
    }
  }

  /** Receives pairs, and has no use for those whose categories do not collide. */
  private record Chooser(List<String> reported) implements PairCallback, PairSelection {
    @Override
    public void addPair(Object a, Object b) {
      reported.add(a + ", " + b);
    }

    @Override
    public boolean knows(int low, int high) {
      return false;
    }

    @Override
    public boolean goesByCategories() {
      return true;
    }
  }

  @Provide
  Arbitrary<List<Call>> calls() {
    Arbitrary<Kind> kinds =
        Arbitraries.frequency(
            Tuple.of(6, Kind.CREATE),
            Tuple.of(6, Kind.MOVE),
            Tuple.of(2, Kind.JUMP),
            Tuple.of(2, Kind.DESTROY),
            Tuple.of(1, Kind.TOUCH),
            Tuple.of(2, Kind.MARK),
            Tuple.of(2, Kind.FILTER),
            Tuple.of(2, Kind.QUERY),
            Tuple.of(2, Kind.RAY),
            Tuple.of(2, Kind.PAIRS));
    Arbitrary<Float> places = Arbitraries.floats().between(-10, 10);
    Arbitrary<Float> sizes = Arbitraries.floats().between(0, 4);
    return Combinators.combine(
            kinds, Arbitraries.integers().between(0, 1000), places, places, sizes, sizes)
        .as(Call::new)
        .list()
        .ofMinSize(20)
        .ofMaxSize(150);
  }

  @Provide
  Arbitrary<Float> scales() {
    return Arbitraries.of(0.01f, 1f, 100f, 1e5f);
  }

  @Property(tries = 300, seed = "31")
  void flatTreeAgreesWithBruteForce(
      @ForAll("calls") List<Call> calls, @ForAll("scales") float scale) {
    run(new DynamicTreeFlatNodes(), calls, scale);
  }

  @Property(tries = 50, seed = "32")
  void olderNameAgreesWithBruteForce(
      @ForAll("calls") List<Call> calls, @ForAll("scales") float scale) {
    run(new DynamicTree(), calls, scale);
  }

  @Property(tries = 100, seed = "33")
  void foreignStrategyAgreesWithBruteForce(
      @ForAll("calls") List<Call> calls, @ForAll("scales") float scale) {
    run(new ForeignStrategy(), calls, scale);
  }

  private static void run(BroadPhaseStrategy strategy, List<Call> calls, float scale) {
    Model model = new Model(strategy);
    boolean castsRays = !(strategy instanceof ForeignStrategy);
    for (Call call : calls) {
      if (call.kind == Kind.RAY && !castsRays) {
        continue;
      }
      model.apply(call, scale);
      model.check();
    }
  }

  private static final class Model {
    private final BroadPhaseStrategy strategy;
    private final BroadPhase broadPhase;
    private final TreeMap<Integer, Proxy> proxies = new TreeMap<>();
    private final Set<Integer> moved = new TreeSet<>();
    private final Set<Integer> obstacles = new TreeSet<>();
    private final TreeMap<Integer, Bits> filters = new TreeMap<>();
    private int created;

    Model(BroadPhaseStrategy strategy) {
      this.strategy = strategy;
      broadPhase = new DefaultBroadPhaseBuffer(strategy);
    }

    void apply(Call call, float scale) {
      if (proxies.isEmpty() && call.kind != Kind.CREATE) {
        return;
      }
      AABB box = box(call.x * scale, call.y * scale, call.width * scale, call.height * scale);
      switch (call.kind) {
        case CREATE -> create(box);
        case MOVE -> move(pick(call), new Vec2(0.01f * call.x * scale, 0.01f * call.y * scale));
        case JUMP -> jump(pick(call), box);
        case DESTROY -> destroy(pick(call));
        case TOUCH -> touch(pick(call));
        case MARK -> mark(pick(call), call.x > 0);
        case FILTER -> filter(pick(call), (int) (4 * call.width), (int) (4 * call.height));
        case QUERY -> {
          checkQuery(box);
          checkObstacles(box);
        }
        case RAY -> checkRay(box, 0.25f + call.width / 4);
        case PAIRS -> checkPairs(call.x > 0);
        default -> throw new AssertionError(call.kind);
      }
    }

    private int pick(Call call) {
      List<Integer> ids = new ArrayList<>(proxies.keySet());
      return ids.get(call.pick % ids.size());
    }

    private void create(AABB box) {
      Object userData = "proxy " + created++;
      int id = broadPhase.createProxy(box, userData);
      assertTrue(id >= 0);
      assertEquals(null, proxies.put(id, new Proxy(new AABB(box), userData)));
      moved.add(id);
      // The box is the caller's again.
      box.lowerBound.set(Float.NaN, Float.NaN);
    }

    private void move(int id, Vec2 displacement) {
      AABB box = new AABB(proxies.get(id).tight);
      box.lowerBound.addLocal(displacement);
      box.upperBound.addLocal(displacement);
      moveTo(id, box, displacement);
    }

    private void jump(int id, AABB box) {
      moveTo(id, box, box.lowerBound.sub(proxies.get(id).tight.lowerBound));
    }

    private void moveTo(int id, AABB box, Vec2 displacement) {
      int insertions = strategy.getInsertionCount();
      broadPhase.moveProxy(id, box, displacement);
      if (strategy.getInsertionCount() != insertions) {
        moved.add(id);
      }
      proxies.put(id, new Proxy(new AABB(box), proxies.get(id).userData));
    }

    private void destroy(int id) {
      broadPhase.destroyProxy(id);
      proxies.remove(id);
      moved.remove(id);
      obstacles.remove(id);
      filters.remove(id);
    }

    private void filter(int id, int categories, int mask) {
      broadPhase.setFilter(id, categories, mask);
      filters.put(id, new Bits(categories, mask));
    }

    private Bits bits(int id) {
      return filters.getOrDefault(id, Bits.ALL);
    }

    private void mark(int id, boolean isObstacle) {
      broadPhase.setObstacle(id, isObstacle);
      if (isObstacle) {
        obstacles.add(id);
      } else {
        obstacles.remove(id);
      }
    }

    private void touch(int id) {
      broadPhase.touchProxy(id);
      moved.add(id);
    }

    private void checkQuery(AABB box) {
      checkReports(box, proxies.keySet(), broadPhase::query);
    }

    private void checkObstacles(AABB box) {
      boolean knowsObstacles = !(strategy instanceof ForeignStrategy);
      checkReports(box, knowsObstacles ? obstacles : proxies.keySet(), broadPhase::queryObstacles);
    }

    /** Each of the candidates that overlaps the box is reported once, and nothing else. */
    private void checkReports(
        AABB box, Set<Integer> candidates, BiConsumer<TreeCallback, AABB> query) {
      SortedSet<Integer> expected = new TreeSet<>();
      for (int id : candidates) {
        if (AABB.testOverlap(broadPhase.getFatAABB(id), box)) {
          expected.add(id);
        }
      }
      List<Integer> reported = new ArrayList<>();
      query.accept(
          id -> {
            reported.add(id);
            return true;
          },
          box);
      assertEquals(expected, new TreeSet<>(reported));
      assertEquals(expected.size(), reported.size(), "a proxy was reported twice");
    }

    private void checkRay(AABB box, float maxFraction) {
      RayCastInput ray = new RayCastInput();
      ray.p1.set(box.lowerBound);
      ray.p2.set(box.upperBound);
      ray.maxFraction = maxFraction;
      Set<Integer> reported = new TreeSet<>();
      broadPhase.raycast(
          (input, id) -> {
            assertEquals(maxFraction, input.maxFraction);
            assertTrue(reported.add(id), "a proxy was reported twice");
            return -1;
          },
          ray);
      for (int id : proxies.keySet()) {
        AABB fat = broadPhase.getFatAABB(id);
        if (meets(ray, fat, 0)) {
          assertTrue(reported.contains(id), () -> "ray missed proxy " + id);
        } else if (!meets(ray, fat, 1e-5)) {
          assertTrue(!reported.contains(id), () -> "ray is far from proxy " + id);
        }
      }
    }

    /**
     * Clips the ray's parameter to the box's slabs, the box grown by a part of the coordinates, in
     * double arithmetic.
     */
    private static boolean meets(RayCastInput ray, AABB box, double relativeSlack) {
      double[] from = {ray.p1.x, ray.p1.y};
      double[] to = {ray.p2.x, ray.p2.y};
      double[] min = {box.lowerBound.x, box.lowerBound.y};
      double[] max = {box.upperBound.x, box.upperBound.y};
      double enter = 0;
      double leave = ray.maxFraction;
      for (int k = 0; k < 2; k++) {
        double slack = relativeSlack * (Math.abs(from[k]) + Math.abs(to[k]) + 1e-3);
        double d = to[k] - from[k];
        if (d == 0) {
          if (from[k] < min[k] - slack || from[k] > max[k] + slack) {
            return false;
          }
          continue;
        }
        double a = (min[k] - slack - from[k]) / d;
        double b = (max[k] + slack - from[k]) / d;
        enter = Math.max(enter, Math.min(a, b));
        leave = Math.min(leave, Math.max(a, b));
      }
      return enter <= leave;
    }

    /** Checks that all pairs are found, or all that are of use if asked for those alone. */
    private void checkPairs(boolean chosen) {
      SortedSet<String> expected = new TreeSet<>();
      SortedSet<String> useful = new TreeSet<>();
      SortedSet<String> useless = new TreeSet<>();
      for (int a : proxies.keySet()) {
        for (int b : proxies.tailMap(a, false).keySet()) {
          AABB fatA = new AABB(broadPhase.getFatAABB(a));
          boolean overlap = AABB.testOverlap(fatA, broadPhase.getFatAABB(b));
          assertEquals(overlap, broadPhase.testOverlap(a, b));
          if (overlap && (moved.contains(a) || moved.contains(b))) {
            String pair = proxies.get(a).userData + ", " + proxies.get(b).userData;
            expected.add(pair);
            if (bits(a).accepts(bits(b)) && bits(b).accepts(bits(a))) {
              useful.add(pair);
            } else if (!bits(a).accepts(bits(b)) && !bits(b).accepts(bits(a))) {
              useless.add(pair);
            }
          }
        }
      }
      List<String> reported = new ArrayList<>();
      if (chosen) {
        broadPhase.updatePairs(new Chooser(reported));
        assertTrue(reported.containsAll(useful), "a pair was left out");
        assertTrue(expected.containsAll(reported), "a pair does not overlap, or has not moved");
        if (!(strategy instanceof ForeignStrategy)) {
          assertTrue(Collections.disjoint(useless, reported), "a pair is of no use");
        }
      } else {
        broadPhase.updatePairs((a, b) -> reported.add(a + ", " + b));
        assertEquals(expected, new TreeSet<>(reported));
      }
      int found = reported.size();
      assertEquals(new TreeSet<>(reported).size(), found, "a pair was reported twice");
      broadPhase.updatePairs((a, b) -> reported.add("again"));
      assertEquals(found, reported.size(), "pairs were reported again");
      moved.clear();
    }

    void check() {
      assertEquals(proxies.size(), broadPhase.getProxyCount());
      assertEquals(strategy.computeHeight(), strategy.getHeight());
      if (strategy instanceof DynamicTreeFlatNodes tree) {
        tree.validate();
      }
      if (strategy instanceof DynamicTree tree) {
        tree.validate();
      }
      proxies.forEach(
          (id, proxy) -> {
            assertTrue(broadPhase.getFatAABB(id).contains(proxy.tight), "left its box");
            assertSame(proxy.userData, broadPhase.getUserData(id));
          });
    }
  }

  static AABB box(float x, float y, float width, float height) {
    return new AABB(new Vec2(x, y), new Vec2(x + width, y + height));
  }
}
