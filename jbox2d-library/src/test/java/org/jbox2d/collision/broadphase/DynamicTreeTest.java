package org.jbox2d.collision.broadphase;

import static org.jbox2d.collision.broadphase.BroadPhaseModelTest.box;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.TreeSet;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.jbox2d.callbacks.DebugDraw;
import org.jbox2d.collision.AABB;
import org.jbox2d.common.Color3f;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;
import org.junit.jupiter.api.Test;

class DynamicTreeTest {
  @Property(tries = 100, seed = "41")
  void rebuiltTreeIsPerfectlyBalancedAndHoldsTheSameProxies(
      @ForAll @IntRange(max = 200) int count, @ForAll Random random) {
    DynamicTree tree = new DynamicTree();
    List<Integer> ids = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      // Every other place is taken several times: equal centres must not upset the halving.
      float x = i % 2 == 0 ? random.nextInt(3) : 50 * random.nextFloat();
      ids.add(tree.createProxy(box(x, random.nextInt(3), random.nextFloat(), 1), "proxy " + i));
    }
    for (int i = 0; i < count / 4; i++) {
      tree.destroyProxy(ids.remove(random.nextInt(ids.size())));
    }
    List<String> before = contents(tree, ids);
    tree.rebuildBottomUp();
    tree.validate();
    assertEquals(before, contents(tree, ids));
    int perfect = ids.isEmpty() ? 0 : 32 - Integer.numberOfLeadingZeros(ids.size() - 1);
    assertEquals(perfect, tree.getHeight());
    assertTrue(tree.getMaxBalance() <= 1);
    AABB all = box(-1e3f, -1e3f, 2e3f, 2e3f);
    TreeSet<Integer> found = new TreeSet<>();
    tree.query(id -> found.add(id), all);
    assertEquals(new TreeSet<>(ids), found);
    for (int id : ids) {
      tree.moveProxy(id, box(random.nextFloat(), 5, 1, 1), new Vec2());
      tree.validate();
    }
  }

  private static List<String> contents(DynamicTree tree, List<Integer> ids) {
    List<String> contents = new ArrayList<>();
    for (int id : ids) {
      contents.add(id + " " + tree.getUserData(id) + " " + tree.getFatAABB(id));
    }
    return contents;
  }

  @Test
  void drawsTheBoxOfEachNode() {
    DynamicTree tree = new DynamicTree();
    Recorder drawn = new Recorder();
    tree.drawTree(drawn);
    assertEquals(0, drawn.outlines.size());
    for (int i = 0; i < 5; i++) {
      tree.createProxy(box(2 * i, 0, 1, 1), i);
    }
    new DefaultBroadPhaseBuffer(tree).drawTree(drawn);
    assertEquals(9, drawn.outlines.size());
    assertEquals(List.of(-0.1f, -0.1f, 9.1f, 1.1f), drawn.outlines.get(0), "the root first");
    assertTrue(drawn.outlines.contains(List.of(-0.1f, -0.1f, 1.1f, 1.1f)));
    assertThrows(IllegalArgumentException.class, () -> tree.nodes.drawTree(drawn, 9, 0, 1));
  }

  @Test
  void drawsNodesThatAreObjects() {
    DynamicTreeNode root = node(0, 4);
    root.child1 = node(0, 1);
    root.child2 = node(3, 4);
    Recorder drawn = new Recorder();
    new DynamicTree().drawTree(drawn, root, 0, 1);
    assertEquals(
        List.of(List.of(0f, 0f, 4f, 1f), List.of(0f, 0f, 1f, 1f), List.of(3f, 0f, 4f, 1f)),
        drawn.outlines);
  }

  private static DynamicTreeNode node(float minX, float maxX) {
    DynamicTreeNode node = new DynamicTreeNode(0);
    node.aabb.set(box(minX, 0, maxX - minX, 1));
    return node;
  }

  /** Keeps the bounds of each outline drawn. */
  private static final class Recorder extends DebugDraw {
    private final List<List<Float>> outlines = new ArrayList<>();

    @Override
    public void drawPolygon(Vec2[] vertices, int vertexCount, Color3f color) {
      assertEquals(4, vertexCount);
      Vec2 min = new Vec2(vertices[0]);
      Vec2 max = new Vec2(vertices[0]);
      for (Vec2 vertex : vertices) {
        min.set(Math.min(min.x, vertex.x), Math.min(min.y, vertex.y));
        max.set(Math.max(max.x, vertex.x), Math.max(max.y, vertex.y));
      }
      outlines.add(List.of(min.x, min.y, max.x, max.y));
    }

    @Override
    public void drawPoint(Vec2 argPoint, float argRadiusOnScreen, Color3f argColor) {}

    @Override
    public void drawSolidPolygon(Vec2[] vertices, int vertexCount, Color3f color) {}

    @Override
    public void drawCircle(Vec2 center, float radius, Color3f color) {}

    @Override
    public void drawSolidCircle(Vec2 center, float radius, Vec2 axis, Color3f color) {}

    @Override
    public void drawSegment(Vec2 p1, Vec2 p2, Color3f color) {}

    @Override
    public void drawTransform(Transform xf) {}

    @Override
    public void drawString(float x, float y, String s, Color3f color) {}
  }
}
