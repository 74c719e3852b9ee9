package org.jbox2d.collision.broadphase;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Random;
import org.jbox2d.callbacks.PairCallback;
import org.jbox2d.callbacks.TreeCallback;
import org.jbox2d.callbacks.TreeRayCastCallback;
import org.jbox2d.collision.AABB;
import org.jbox2d.collision.RayCastInput;
import org.jbox2d.common.Vec2;
import org.jbox2d.internal.LongHashSet;
import org.junit.jupiter.api.Test;

/**
 * A warm broad phase allocates nothing: moving, pairing, searching, and replacing proxies by
 * others.
 */
class BroadPhaseAllocationTest {
  private static final int PROXIES = 500;
  private static final float EXTENT = 40;

  private final ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
  private final Random random = new Random(3);
  private final BroadPhase broadPhase = new DefaultBroadPhaseBuffer(new DynamicTreeFlatNodes());
  private final int[] ids = new int[PROXIES];
  private final AABB box = new AABB();
  private final Vec2 displacement = new Vec2();
  private final RayCastInput ray = new RayCastInput();
  private final LongHashSet pairs = new LongHashSet();
  private int pairCount;
  private int hitCount;

  private final PairCallback countPair = (a, b) -> pairCount++;
  private final TreeRayCastCallback countHit =
      (input, id) -> {
        hitCount++;
        return -1;
      };
  private final TreeCallback castRay =
      id -> {
        broadPhase.raycast(countHit, ray);
        pairs.add(((long) id << 32) + hitCount % 64);
        return broadPhase.getFatAABB(id) != null;
      };

  @Test
  void warmStepAllocatesNothing() {
    for (int i = 0; i < PROXIES; i++) {
      place();
      ids[i] = broadPhase.createProxy(box, "same");
    }
    steps(300);
    long fewest = Long.MAX_VALUE;
    for (int round = 0; round < 5; round++) {
      long before = threads.getCurrentThreadAllocatedBytes();
      steps(20);
      long after = threads.getCurrentThreadAllocatedBytes();
      fewest = Math.min(fewest, after - before);
    }
    assertEquals(0, fewest, "bytes in 20 warm steps");
    assertTrue(pairCount > 0 && hitCount > 0 && pairs.size() == 0);
  }

  private void steps(int count) {
    for (int step = 0; step < count; step++) {
      for (int i = 0; i < PROXIES; i++) {
        place();
        displacement.set(random.nextFloat() - 0.5f, random.nextFloat() - 0.5f);
        broadPhase.moveProxy(ids[i], box, displacement);
      }
      for (int i = step % 10; i < PROXIES; i += 10) {
        broadPhase.destroyProxy(ids[i]);
        place();
        ids[i] = broadPhase.createProxy(box, "same");
      }
      broadPhase.updatePairs(countPair);
      place();
      ray.p1.set(box.lowerBound);
      place();
      ray.p2.set(box.lowerBound);
      ray.maxFraction = 1;
      broadPhase.query(castRay, box);
      pairs.clear();
    }
  }

  private void place() {
    float x = random.nextFloat() * EXTENT - EXTENT / 2;
    float y = random.nextFloat() * EXTENT - EXTENT / 2;
    box.lowerBound.set(x, y);
    box.upperBound.set(x + 1 + random.nextFloat(), y + 1 + random.nextFloat());
  }
}
