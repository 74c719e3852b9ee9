package org.jbox2d.testbed.paint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.jbox2d.testbed.scenes.Scene;
import org.jbox2d.testbed.scenes.Scenes;
import org.junit.jupiter.api.Test;

class ViewTest {
  /** Rounding of doubles over pictures of a few thousand pixels, m. */
  private static final double ROUNDING = 1e-6;

  private static final View VIEW = new View(3, 17, 14, 1280, 720);

  @Property(seed = "41")
  void zoomKeepsThePointUnderThePointer(
      @ForAll @DoubleRange(min = 0.01, max = 100) double factor,
      @ForAll @IntRange(max = 1280) int x,
      @ForAll @IntRange(max = 720) int y) {
    View zoomed = VIEW.zoomed(factor, x, y);
    assertEquals(VIEW.toWorldX(x), zoomed.toWorldX(x), ROUNDING);
    assertEquals(VIEW.toWorldY(y), zoomed.toWorldY(y), ROUNDING);
  }

  @Property(seed = "42")
  void mappingIsUndoneByItsInverse(
      @ForAll @DoubleRange(min = -100, max = 100) double x,
      @ForAll @DoubleRange(min = -100, max = 100) double y) {
    assertEquals(x, VIEW.toWorldX(VIEW.toPictureX(x)), ROUNDING);
    assertEquals(y, VIEW.toWorldY(VIEW.toPictureY(y)), ROUNDING);
  }

  @Test
  void draggingMovesTheWorldWithThePointer() {
    View dragged = VIEW.dragged(30, -20);
    assertEquals(VIEW.toPictureX(5) + 30, dragged.toPictureX(5), ROUNDING);
    assertEquals(VIEW.toPictureY(5) - 20, dragged.toPictureY(5), ROUNDING);
  }

  @Test
  void worldYIsUp() {
    assertTrue(VIEW.toPictureY(10) < VIEW.toPictureY(0));
  }

  @Test
  void zoomHasBounds() {
    View far = VIEW.zoomed(0, 0, 0);
    assertTrue(far.scale() > 0);
    assertEquals(far.scale(), far.zoomed(1e-9, 0, 0).scale());
  }

  @Test
  void framingOfEachSceneIsVisible() {
    for (Scene scene : Scenes.all()) {
      View view = View.of(scene.framing(), 640, 480);
      double left = scene.framing().centreX() - scene.framing().width() / 2;
      double top = scene.framing().centreY() + scene.framing().height() / 2;
      assertTrue(view.toPictureX(left) > -0.01, scene.name());
      assertTrue(view.toPictureY(top) > -0.01, scene.name());
    }
  }
}
