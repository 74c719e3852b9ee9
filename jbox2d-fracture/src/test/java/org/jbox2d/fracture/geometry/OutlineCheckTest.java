package org.jbox2d.fracture.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.List;
import org.jbox2d.fracture.triangulation.DelaunayTriangulator;
import org.jbox2d.fracture.triangulation.TriangleMesh;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class OutlineCheckTest {
  static List<WktOutlines.Line> valid() throws IOException {
    return WktOutlines.read("valid.wkt");
  }

  static List<WktOutlines.Line> refused() throws IOException {
    return WktOutlines.read("refused.wkt");
  }

  @ParameterizedTest
  @MethodSource("valid")
  void acceptsValidOutlines(WktOutlines.Line line) {
    assertEquals(OutlineDefect.NONE, OutlineCheck.of(line.outline).defect());
  }

  @ParameterizedTest
  @MethodSource("refused")
  void namesTheDefectAndTheVertex(WktOutlines.Line line) {
    OutlineCheck check = OutlineCheck.of(line.outline);
    assertEquals(OutlineDefect.valueOf(line.words[0]), check.defect(), check.message());
    assertEquals(Integer.parseInt(line.words[1]), check.vertex(), check.message());
    assertTrue(check.message().contains("vertex " + line.words[1]), check.message());
  }

  @Test
  void ringsMayTouchInVerticesIfAllowed() {
    Outline touching =
        Outline.ofRings(new double[] {0, 0, 4, 0, 4, 4, 0, 4}, new double[] {0, 0, 1, 2, 2, 1});
    assertEquals(OutlineDefect.RINGS_MEET, OutlineCheck.of(touching).defect());
    assertEquals(OutlineDefect.NONE, OutlineCheck.ofTouching(touching).defect());
    Outline overlapping =
        Outline.ofRings(new double[] {0, 0, 4, 0, 4, 4, 0, 4}, new double[] {0, 0, 4, 0, 2, 1});
    assertEquals(OutlineDefect.RINGS_MEET, OutlineCheck.ofTouching(overlapping).defect());
  }

  /** Only its first vertex touches the outer ring, and that was all that was looked at. */
  @Test
  void holesThatTouchFromOutsideAreOutside() {
    Outline beside =
        Outline.ofRings(new double[] {0, 0, 4, 0, 4, 4, 0, 4}, new double[] {4, 4, 5, 6, 6, 5});
    assertEquals(OutlineDefect.HOLE_OUTSIDE, OutlineCheck.ofTouching(beside).defect());
    Outline within =
        Outline.ofRings(
            new double[] {0, 0, 9, 0, 9, 9, 0, 9},
            new double[] {1, 1, 1, 8, 8, 1},
            new double[] {1, 1, 2, 3, 3, 2});
    assertEquals(OutlineDefect.HOLE_IN_HOLE, OutlineCheck.ofTouching(within).defect());
  }

  /** The hole leaves the outer ring through vertices of both, which passed for touching. */
  @Test
  void ringsMayNotCrossInVertices() {
    double[] triangle = {0, 1, -1, 0, 2, -1};
    Outline out = Outline.ofRings(triangle, new double[] {0, 1, 0, 0, -1, 0, -1, 1});
    assertEquals(OutlineDefect.RINGS_MEET, OutlineCheck.ofTouching(out).defect());
    assertFalse(new DelaunayTriangulator().triangulate(out.normal(), new TriangleMesh()));
    Outline in = Outline.ofRings(triangle, new double[] {0, 1, 0.25, 0, -1, 0, 0, 0.5});
    assertEquals(OutlineDefect.NONE, OutlineCheck.ofTouching(in).defect());
    assertTrue(new DelaunayTriangulator().triangulate(in.normal(), new TriangleMesh()));
  }

  /** All vertices of the hole are vertices of the outer ring: only its edges tell where it is. */
  @Test
  void holesThatTouchWithAllVerticesAreInsideOrOutside() {
    double[] notched = {0, 0, 6, 0, 6, 6, 3, 2, 0, 6};
    Outline within = Outline.ofRings(notched, new double[] {0, 0, 6, 0, 3, 2});
    assertEquals(OutlineDefect.RINGS_MEET, OutlineCheck.ofTouching(within).defect());
    double[] twice = {0, 0, 3, -1, 6, 0, 6, 6, 3, 2, 0, 6};
    Outline inside = Outline.ofRings(twice, new double[] {0, 0, 6, 0, 3, 2});
    assertEquals(OutlineDefect.NONE, OutlineCheck.ofTouching(inside).defect());
    double[] deep = {0, 0, 6, 0, 6, 6, 4, 2, 3, 5, 2, 2, 0, 6};
    Outline outside = Outline.ofRings(deep, new double[] {6, 6, 3, 5, 0, 6});
    assertEquals(OutlineDefect.HOLE_OUTSIDE, OutlineCheck.ofTouching(outside).defect());
  }

  @Test
  void usedAgainItSaysTheSame() throws IOException {
    OutlineCheck used = new OutlineCheck();
    for (WktOutlines.Line line : refused()) {
      OutlineCheck fresh = OutlineCheck.of(line.outline);
      assertFalse(used.run(line.outline, false));
      assertEquals(fresh.message(), used.message());
      for (WktOutlines.Line good : valid()) {
        assertTrue(used.run(good.outline, false), good.toString());
        assertEquals(OutlineDefect.NONE, used.defect());
      }
    }
  }

  @Test
  void strictlyConvexRingsGoAroundOnceAndTurnOneWay() {
    double[] square = {0, 0, 2, 0, 2, 2, 0, 2};
    assertTrue(Rings.isStrictlyConvex(square, 0, 4));
    Rings.reverse(square, 0, 4);
    assertTrue(Rings.isStrictlyConvex(square, 0, 4));
    assertFalse(Rings.isStrictlyConvex(new double[] {0, 0, 2, 0, 4, 0, 2, 2}, 0, 4));
    assertFalse(Rings.isStrictlyConvex(new double[] {0, 0, 4, 0, 4, 4, 3, 1}, 0, 4));
    assertFalse(Rings.isStrictlyConvex(new double[] {0, 0, 4, 0}, 0, 2));
    double[] pentagram = new double[10];
    for (int i = 0; i < 5; i++) {
      pentagram[2 * i] = Math.cos(0.8 * Math.PI * i);
      pentagram[2 * i + 1] = Math.sin(0.8 * Math.PI * i);
    }
    assertFalse(Rings.isStrictlyConvex(pentagram, 0, 5));
  }
}
