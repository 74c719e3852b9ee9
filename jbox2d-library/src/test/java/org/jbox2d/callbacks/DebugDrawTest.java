package org.jbox2d.callbacks;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.ArrayList;
import java.util.List;
import org.jbox2d.common.Color3f;
import org.jbox2d.common.OBBViewportTransform;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;
import org.junit.jupiter.api.Test;

class DebugDrawTest {

  private final List<String> drawn = new ArrayList<>();
  private final DebugDraw draw = new Recorder();

  @Test
  void polygonsAreClosedLinesOfSegments() {
    Vec2[] vertices = {new Vec2(0, 0), new Vec2(1, 0), new Vec2(0, 1), new Vec2(9, 9)};
    draw.drawPolygon(vertices, 3, Color3f.RED);
    assertEquals(List.of("(0.0,0.0)(1.0,0.0)", "(1.0,0.0)(0.0,1.0)", "(0.0,1.0)(0.0,0.0)"), drawn);
    drawn.clear();
    draw.drawPolygon(vertices, 2, Color3f.RED);
    assertEquals(List.of("(0.0,0.0)(1.0,0.0)"), drawn);
    drawn.clear();
    draw.drawPolygon(vertices, 1, Color3f.RED);
    assertEquals(List.of("(0.0,0.0)(0.0,0.0)"), drawn);
    drawn.clear();
    draw.drawPolygon(vertices, 0, Color3f.RED);
    assertEquals(List.of(), drawn);
  }

  @Test
  void turnedCirclesShowTheirAxis() {
    draw.drawCircle(new Vec2(1, 2), 3, new Vec2(0, 1), Color3f.RED);
    assertEquals(List.of("circle (1.0,2.0) 3.0", "(1.0,2.0)(1.0,5.0)"), drawn);
  }

  @Test
  void flagsAreBitsOfTheNewerRelease() {
    draw.setFlags(DebugDraw.e_shapeBit | DebugDraw.e_aabbBit);
    draw.appendFlags(DebugDraw.e_jointBit);
    draw.clearFlags(DebugDraw.e_aabbBit);
    assertEquals(6, draw.getFlags());
  }

  @Test
  void coordinatesGoThroughTheTransform() {
    OBBViewportTransform view = new OBBViewportTransform();
    view.setExtents(100, 100);
    draw.setViewportTransform(view);
    draw.setCamera(1, 2, 10);
    assertSame(view, draw.getViewportTranform());
    assertEquals(new Vec2(110, 120), draw.getWorldToScreen(2, 4));
    assertEquals(new Vec2(110, 120), draw.getWorldToScreen(new Vec2(2, 4)));
    assertEquals(new Vec2(2, 4), draw.getScreenToWorld(110, 120));
    Vec2 inPlace = new Vec2(110, 120);
    draw.getScreenToWorldToOut(inPlace, inPlace);
    assertEquals(new Vec2(2, 4), inPlace);
    draw.getWorldToScreenToOut(inPlace, inPlace);
    assertEquals(draw.getWorldToScreen(2, 4), inPlace);
    assertEquals(draw.getScreenToWorld(inPlace), draw.getScreenToWorld(110, 120));
  }

  @Test
  void stringsMayBePlacedByAVector() {
    draw.drawString(new Vec2(3, 4), "text", Color3f.WHITE);
    assertEquals(List.of("text 3.0 4.0"), drawn);
  }

  private final class Recorder extends DebugDraw {
    @Override
    public void drawPoint(Vec2 argPoint, float argRadiusOnScreen, Color3f argColor) {}

    @Override
    public void drawSolidPolygon(Vec2[] vertices, int vertexCount, Color3f color) {}

    @Override
    public void drawCircle(Vec2 center, float radius, Color3f color) {
      drawn.add("circle " + center + " " + radius);
    }

    @Override
    public void drawSolidCircle(Vec2 center, float radius, Vec2 axis, Color3f color) {}

    @Override
    public void drawSegment(Vec2 p1, Vec2 p2, Color3f color) {
      drawn.add("" + p1 + p2);
    }

    @Override
    public void drawTransform(Transform xf) {}

    @Override
    public void drawString(float x, float y, String s, Color3f color) {
      drawn.add(s + " " + x + " " + y);
    }
  }
}
