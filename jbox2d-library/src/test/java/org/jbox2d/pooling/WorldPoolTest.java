package org.jbox2d.pooling;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.Set;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.contacts.Contact;
import org.jbox2d.pooling.arrays.FloatArray;
import org.jbox2d.pooling.normal.DefaultWorldPool;
import org.junit.jupiter.api.Test;

class WorldPoolTest {

  private final IWorldPool pool = new DefaultWorldPool(2, 2);

  @Test
  void objectsOutAtOneTimeAreDistinctAndComeBack() {
    Set<Object> out = Collections.newSetFromMap(new IdentityHashMap<>());
    Vec2 first = pool.popVec2();
    out.add(first);
    for (Vec2 v : pool.popVec2(5)) {
      out.add(v);
    }
    out.add(pool.popVec2());
    assertEquals(7, out.size());
    pool.pushVec2(1);
    pool.pushVec2(5);
    pool.pushVec2(1);
    assertSame(first, pool.popVec2());
    assertThrows(IllegalArgumentException.class, () -> pool.pushVec2(2));
  }

  @Test
  void everyTypeHasItsSupply() {
    assertNotSame(pool.popVec3(), pool.popVec3());
    assertNotSame(pool.popMat22(), pool.popMat22());
    assertNotSame(pool.popMat33(), pool.popMat33());
    assertNotSame(pool.popAABB(), pool.popAABB());
    assertNotSame(pool.popRot(), pool.popRot());
    assertEquals(3, pool.popVec3(3).length);
    assertEquals(3, pool.popMat22(3).length);
    assertEquals(3, pool.popAABB(3).length);
    pool.pushVec3(5);
    pool.pushMat22(5);
    pool.pushMat33(2);
    pool.pushAABB(5);
    pool.pushRot(2);
    assertNotNull(pool.getCollision());
    assertNotNull(pool.getDistance());
    assertNotNull(pool.getTimeOfImpact());
  }

  @Test
  void contactsComeBack() {
    Contact contact = pool.getPolyContactStack().pop();
    assertNotSame(contact, pool.getPolyContactStack().pop());
    pool.getPolyContactStack().push(contact);
    assertSame(contact, pool.getPolyContactStack().pop());
  }

  @Test
  void arraysAreKeptByLength() {
    assertSame(pool.getFloatArray(3), pool.getFloatArray(3));
    assertSame(pool.getIntArray(3), pool.getIntArray(3));
    assertEquals(0, pool.getIntArray(0).length);
    Vec2[] vectors = pool.getVec2Array(4);
    assertEquals(4, vectors.length);
    assertNotSame(vectors[0], vectors[3]);
    IllegalArgumentException e =
        assertThrows(IllegalArgumentException.class, () -> new FloatArray().get(-1));
    assertTrue(e.getMessage().endsWith("-1"));
  }
}
