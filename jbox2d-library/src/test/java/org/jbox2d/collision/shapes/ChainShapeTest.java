package org.jbox2d.collision.shapes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.common.Vec2;
import org.junit.jupiter.api.Test;

class ChainShapeTest {

  private final Vec2[] line = {new Vec2(0, 0), new Vec2(2, 0), new Vec2(3, 1), new Vec2(0, 3)};

  @Test
  void chainsAreOpenUntilGhostsAreSet() {
    ChainShape chain = new ChainShape();
    chain.createChain(line, 3);
    assertEquals(2, chain.getChildCount());
    assertEdge(chain, 0, null, line[0], line[1], line[2]);
    assertEdge(chain, 1, line[0], line[1], line[2], null);
    chain.setPrevVertex(new Vec2(-1, 0));
    chain.setNextVertex(new Vec2(4, 4));
    assertEdge(chain, 0, new Vec2(-1, 0), line[0], line[1], line[2]);
    assertEdge(chain, 1, line[0], line[1], line[2], new Vec2(4, 4));
  }

  @Test
  void loopsCloseWithTheirOwnVerticesAsGhosts() {
    ChainShape chain = new ChainShape();
    chain.createLoop(line, 4);
    assertEquals(4, chain.getChildCount());
    assertEquals(5, chain.m_count);
    for (int i = 0; i < 4; i++) {
      assertEdge(chain, i, line[(i + 3) % 4], line[i], line[(i + 1) % 4], line[(i + 2) % 4]);
    }
  }

  @Test
  void verticesAreCopied() {
    ChainShape chain = new ChainShape();
    chain.createLoop(line, 4);
    ChainShape copy = (ChainShape) chain.clone();
    line[0].set(9, 9);
    chain.m_vertices[1].set(9, 9);
    assertEquals(new Vec2(0, 0), chain.m_vertices[0]);
    assertEquals(new Vec2(2, 0), copy.m_vertices[1]);
    assertEquals(new Vec2(0, 3), copy.m_prevVertex);
    assertTrue(copy.m_hasNextVertex);
  }

  /** Programs fill the fields themselves, without the create methods. */
  @Test
  void verticesWrittenByHandCount() {
    ChainShape chain = new ChainShape();
    chain.m_vertices = line;
    chain.m_count = 4;
    assertEquals(3, ((ChainShape) chain.clone()).getChildCount());
    assertEdge(chain, 2, line[1], line[2], line[3], null);
  }

  @Test
  void clearedChainsAreEmptyAndCanBeSetAgain() {
    ChainShape chain = new ChainShape();
    assertEquals(0, chain.getChildCount());
    chain.createLoop(line, 4);
    chain.clear();
    assertEquals(0, chain.getChildCount());
    assertNull(chain.m_vertices);
    assertEquals(0, ((ChainShape) chain.clone()).getChildCount());
    chain.createChain(line, 2);
    assertFalse(chain.m_hasPrevVertex || chain.m_hasNextVertex);
    assertEquals(1, chain.getChildCount());
  }

  @Test
  void badInputIsNamedAndChangesNothing() {
    ChainShape chain = new ChainShape();
    chain.createChain(line, 2);
    assertRefused(": 1", () -> chain.createChain(line, 1));
    assertRefused(": 2", () -> chain.createLoop(line, 2));
    assertRefused(": 5", () -> chain.createChain(line, 5));
    Vec2[] repeated = {new Vec2(0, 0), new Vec2(1, 0), new Vec2(1.004f, 0), new Vec2(0, 3)};
    assertRefused("1 and 2", () -> chain.createChain(repeated, 4));
    Vec2[] closed = {new Vec2(0, 0), new Vec2(1, 0), new Vec2(1, 1), new Vec2(0, 0)};
    assertRefused("3 and 0", () -> chain.createLoop(closed, 4));
    Vec2[] infinite = {new Vec2(0, 0), new Vec2(1, Float.POSITIVE_INFINITY)};
    assertRefused("Infinity", () -> chain.createChain(infinite, 2));
    Vec2 nan = new Vec2(0, Float.NaN);
    assertRefused("NaN", () -> chain.setNextVertex(nan));
    assertRefused("NaN", () -> chain.setPrevVertex(nan));
    assertEquals(1, chain.getChildCount());
    assertFalse(chain.m_hasPrevVertex || chain.m_hasNextVertex);
  }

  private static void assertRefused(String named, Runnable call) {
    IllegalArgumentException e = assertThrows(IllegalArgumentException.class, call::run);
    assertTrue(e.getMessage().contains(named), e.getMessage());
  }

  private static void assertEdge(ChainShape chain, int index, Vec2 v0, Vec2 v1, Vec2 v2, Vec2 v3) {
    EdgeShape edge = new EdgeShape();
    chain.getChildEdge(edge, index);
    assertEquals(v1, edge.m_vertex1);
    assertEquals(v2, edge.m_vertex2);
    assertEquals(v0 != null, edge.m_hasVertex0);
    assertEquals(v3 != null, edge.m_hasVertex3);
    if (v0 != null) {
      assertEquals(v0, edge.m_vertex0);
    }
    if (v3 != null) {
      assertEquals(v3, edge.m_vertex3);
    }
  }
}
