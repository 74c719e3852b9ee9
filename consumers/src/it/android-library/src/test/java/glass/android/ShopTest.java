package glass.android;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.jbox2d.dynamics.Body;
import org.junit.jupiter.api.Test;

class ShopTest {
  @Test
  void ballBreaksTheWindow() {
    List<Body> pieces = new ArrayList<>();
    Shop shop = new Shop((material, intensity, fragments) -> pieces.addAll(fragments));
    shop.throwBall(-8, 3);
    for (int frame = 0; frame < 120; frame++) {
      shop.advance(1f / 60);
    }
    assertTrue(pieces.size() > 3, pieces.size() + " pieces");
  }
}
