package org.jbox2d.fracture.triangulation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import earcut4j.Earcut;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.jbox2d.fracture.fragmentation.OutlineKind;
import org.jbox2d.fracture.geometry.Outline;
import org.jbox2d.fracture.geometry.OutlineCheck;
import org.jbox2d.fracture.geometry.Predicates;
import org.jbox2d.fracture.geometry.WktOutlines;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class TriangulatorTest {
  private static final int CASES = 100;

  private static void check(Outline outline, TriangleMesh mesh) {
    double area = 0;
    double[] xy = outline.coordinates();
    for (int t = 0; t < mesh.triangleCount(); t++) {
      int a = mesh.vertex(3 * t);
      int b = mesh.vertex(3 * t + 1);
      int c = mesh.vertex(3 * t + 2);
      assertEquals(1, Predicates.orientation(xy, a, b, c));
      area +=
          0.5
              * ((xy[2 * b] - xy[2 * a]) * (xy[2 * c + 1] - xy[2 * a + 1])
                  - (xy[2 * b + 1] - xy[2 * a + 1]) * (xy[2 * c] - xy[2 * a]));
    }
    assertEquals(1, area / outline.area(), 1e-9);
    // Euler: n vertices and h holes make n + 2h - 2 triangles.
    int holes = outline.ringCount() - 1;
    assertEquals(outline.vertexCount() + 2 * holes - 2, mesh.triangleCount());
  }

  @ParameterizedTest
  @EnumSource(OutlineKind.class)
  void delaunayNeverFails(OutlineKind kind) {
    DelaunayTriangulator triangulator = new DelaunayTriangulator();
    TriangleMesh mesh = new TriangleMesh();
    for (int seed = 0; seed < CASES; seed++) {
      Random random = new Random(seed);
      Outline outline = kind.make(random, 3 + random.nextInt(100), random.nextInt(4)).normal();
      assertTrue(triangulator.triangulate(outline, mesh));
      check(outline, mesh);
    }
  }

  /** poly2tri may give up, but what it gives is right. */
  @ParameterizedTest
  @EnumSource(OutlineKind.class)
  void poly2triIsRightOrSaysThatItFailed(OutlineKind kind) {
    Poly2TriTriangulator triangulator = new Poly2TriTriangulator();
    TriangleMesh mesh = new TriangleMesh();
    int done = 0;
    for (int seed = 0; seed < CASES; seed++) {
      Random random = new Random(seed);
      Outline outline = kind.make(random, 3 + random.nextInt(60), random.nextInt(4)).normal();
      if (triangulator.triangulate(outline, mesh)) {
        check(outline, mesh);
        done++;
      }
    }
    assertTrue(done > CASES / 2, "done: " + done);
  }

  @Test
  void ringsMayTouchInVertices() {
    Outline outline =
        Outline.ofRings(
            new double[] {0, 0, 4, 0, 4, 4, 0, 4},
            new double[] {0, 0, 1, 2, 2, 1},
            new double[] {2, 1, 3, 3, 3, 1});
    TriangleMesh mesh = new TriangleMesh();
    assertTrue(new DelaunayTriangulator().triangulate(outline, mesh));
    double area = 0;
    double[] xy = outline.coordinates();
    for (int t = 0; t < mesh.triangleCount(); t++) {
      int a = mesh.vertex(3 * t);
      int b = mesh.vertex(3 * t + 1);
      int c = mesh.vertex(3 * t + 2);
      area +=
          0.5
              * ((xy[2 * b] - xy[2 * a]) * (xy[2 * c + 1] - xy[2 * a + 1])
                  - (xy[2 * b + 1] - xy[2 * a + 1]) * (xy[2 * c] - xy[2 * a]));
    }
    assertEquals(outline.area(), area, 1e-12);
  }

  /** Each was found at random and made smaller; a peer that no longer fails leaves the list. */
  @Test
  void knownFailuresOfThePeersAreTriangulated() throws IOException {
    TriangleMesh mesh = new TriangleMesh();
    for (WktOutlines.Line line : WktOutlines.read("peers.wkt")) {
      Outline outline = line.outline.normal();
      if (line.words[0].equals("poly2tri")) {
        assertFalse(new Poly2TriTriangulator().triangulate(outline, mesh), line.toString());
      } else {
        double off = earcutArea(outline) / outline.area() - 1;
        assertTrue(Math.abs(off) > 1e-6, line + ": " + off);
      }
      assertTrue(new DelaunayTriangulator().triangulate(outline, mesh), line.toString());
      int[] triangles = new int[mesh.halfEdgeCount()];
      for (int h = 0; h < triangles.length; h++) {
        triangles[h] = mesh.vertex(h);
      }
      double[] xy = outline.coordinates();
      for (int k = 0; k < triangles.length; k += 3) {
        assertEquals(
            1,
            Predicates.orientation(xy, triangles[k], triangles[k + 1], triangles[k + 2]),
            line.toString());
      }
      double rounding = 4 * Math.ulp(1.0);
      assertEquals(outline.area(), area(xy, triangles), 1e-12 * outline.area() + rounding);
    }
  }

  /** Of all triangles, in whatever orientation: overlaps count twice. */
  private static double earcutArea(Outline outline) {
    int[] holes = Arrays.copyOfRange(outline.ringStarts(), 1, outline.ringCount());
    double[] xy = Arrays.copyOf(outline.coordinates(), 2 * outline.vertexCount());
    List<Integer> triangles = Earcut.earcut(xy, holes.length == 0 ? null : holes, 2);
    return area(xy, triangles.stream().mapToInt(Integer::intValue).toArray());
  }

  private static double area(double[] xy, int[] triangles) {
    double sum = 0;
    for (int k = 0; k < triangles.length; k += 3) {
      int a = triangles[k];
      int b = triangles[k + 1];
      int c = triangles[k + 2];
      double twice =
          (xy[2 * b] - xy[2 * a]) * (xy[2 * c + 1] - xy[2 * a + 1])
              - (xy[2 * b + 1] - xy[2 * a + 1]) * (xy[2 * c] - xy[2 * a]);
      sum += 0.5 * Math.abs(twice);
    }
    return sum;
  }

  /**
   * The decomposition leaves it to the triangulator to find edges that meet: outlines spoiled by
   * one vertex that goes astray are taken if and only if the check finds nothing.
   */
  @ParameterizedTest
  @EnumSource(OutlineKind.class)
  void delaunayRefusesWhateverMeets(OutlineKind kind) {
    DelaunayTriangulator triangulator = new DelaunayTriangulator();
    assertTrue(triangulator.refusesCrossings());
    TriangleMesh mesh = new TriangleMesh();
    OutlineCheck check = new OutlineCheck();
    int refused = 0;
    for (int seed = 0; seed < 5 * CASES; seed++) {
      Random random = new Random(seed);
      Outline whole = kind.make(random, 3 + random.nextInt(40), random.nextInt(3));
      Outline outline = spoil(whole, random).normal();
      if (check.runButCrossings(outline, true)) {
        boolean valid = check.run(outline, true);
        assertEquals(valid, triangulator.triangulate(outline, mesh), kind + " " + seed);
        refused += valid ? 0 : 1;
      }
    }
    assertTrue(refused > CASES / 2, "refused: " + refused);
  }

  /** Puts a vertex elsewhere: anywhere, on another vertex, or into the middle of an edge. */
  private static Outline spoil(Outline outline, Random random) {
    double[] xy = outline.coordinates().clone();
    int n = outline.vertexCount();
    int v = random.nextInt(n);
    int a = random.nextInt(n);
    int b = (a + 1) % n;
    int where = random.nextInt(3);
    for (int k = 0; k < 2; k++) {
      xy[2 * v + k] =
          switch (where) {
            case 0 -> xy[2 * a + k];
            case 1 -> 0.5 * (xy[2 * a + k] + xy[2 * b + k]);
            default -> 2 * random.nextDouble() - 1;
          };
    }
    return new Outline(xy, outline.ringStarts());
  }
}
