package org.jbox2d.fracture.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.List;
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
}
