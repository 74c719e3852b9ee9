package org.jbox2d.fracture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.common.Vec2;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PolygonTest {
  private static Polygon polygon(float... xy) {
    Polygon polygon = new Polygon();
    for (int i = 0; i < xy.length; i += 2) {
      polygon.add(new Vec2(xy[i], xy[i + 1]));
    }
    return polygon;
  }

  @Test
  void measuresOfARectangleFarFromTheOrigin() {
    Polygon rectangle = polygon(1000, 2000, 1000, 2002, 1006, 2002, 1006, 2000);
    assertEquals(12, rectangle.area(), 1e-9);
    assertTrue(rectangle.isClockwise());
    assertEquals(1003, rectangle.centroid().x, 0);
    assertEquals(2001, rectangle.centroid().y, 0);
    assertEquals(12 * (36 + 4) / 12.0, rectangle.secondMoment(), 1e-9);
  }

  @Test
  void normalisedIsCounterClockwiseAndBeginsWithTheSameVertex() {
    Polygon clockwise = polygon(0, 0, 0, 2, 3, 0);
    Polygon normal = clockwise.normalised();
    assertFalse(normal.isClockwise());
    assertEquals(3, normal.size());
    assertEquals(3, normal.get(1).x, 0);
    assertEquals(2, normal.get(2).y, 0);
    assertEquals(clockwise.area(), normal.area(), 0);
  }

  @Test
  void concaveAndCollinearVerticesAreValidInEitherOrientation() {
    polygon(0, 0, 1, 0, 2, 0, 2, 2, 1, 1, 0, 2).validate();
    polygon(0, 2, 1, 1, 2, 2, 2, 0, 1, 0, 0, 0).validate();
  }

  @ParameterizedTest
  @CsvSource({
    "'0 0 1 0', vertex 0",
    "'0 0 1 0 1 NaN', vertex 2",
    "'0 0 Infinity 0 1 1', vertex 1",
    "'0 0 1 0 1 0 0 1', vertex 1",
    "'0 0 2 2 2 0 0 2', vertex 0",
    "'0 0 4 0 4 4 2 0 0 4', vertex 0",
    "'0 0 1 0 2 0', vertex 0",
    "'0 0 4 0 2 2 4 4 0 4 2 2', vertex 2",
  })
  void invalidPolygonsAreRefusedAndNamed(String coordinates, String named) {
    String[] parts = coordinates.split(" ");
    float[] xy = new float[parts.length];
    for (int i = 0; i < parts.length; i++) {
      xy[i] = Float.parseFloat(parts[i]);
    }
    IllegalArgumentException refusal =
        assertThrows(IllegalArgumentException.class, () -> polygon(xy).validate());
    assertTrue(refusal.getMessage().contains(named), refusal.getMessage());
  }

  @Test
  void nullVerticesAreRefused() {
    assertThrows(IllegalArgumentException.class, () -> new Polygon(null));
    assertThrows(IllegalArgumentException.class, () -> new Polygon(new Vec2[] {null}));
    assertThrows(IllegalArgumentException.class, () -> new Polygon().add(null));
    assertThrows(IndexOutOfBoundsException.class, () -> new Polygon().get(0));
    assertThrows(IllegalArgumentException.class, () -> polygon(0, 0, 1, 1, 2, 2).centroid());
  }
}
