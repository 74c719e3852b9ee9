package glass;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.common.Vec2;
import org.junit.jupiter.api.Test;

class GlassGameTest {
  @Test
  void nothingBreaksByItself() {
    GlassGame game = new GlassGame();
    play(game);
    assertEquals(0, game.score());
  }

  @Test
  void ballBreaksGlass() {
    GlassGame game = new GlassGame();
    game.throwBall(new Vec2(-15, 4), new Vec2(50, 0));
    play(game);
    assertTrue(game.score() > 10, game.score() + " pieces");
    assertTrue(game.world().getBodyCount() > 10, game.world().getBodyCount() + " bodies");
  }

  @Test
  void twoGamesAreTheSame() {
    GlassGame one = new GlassGame();
    GlassGame other = new GlassGame();
    one.throwBall(new Vec2(-15, 4), new Vec2(50, 0));
    other.throwBall(new Vec2(-15, 4), new Vec2(50, 0));
    play(one);
    play(other);
    assertEquals(one.score(), other.score());
    assertEquals(
        one.world().getBodyList().getPosition(), other.world().getBodyList().getPosition());
  }

  private static void play(GlassGame game) {
    for (int frame = 0; frame < 300; frame++) {
      game.advance(1f / 60);
    }
  }
}
