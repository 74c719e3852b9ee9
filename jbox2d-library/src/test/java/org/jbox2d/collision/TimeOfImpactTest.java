package org.jbox2d.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.jbox2d.collision.TimeOfImpact.TOIInput;
import org.jbox2d.collision.TimeOfImpact.TOIOutput;
import org.jbox2d.collision.TimeOfImpact.TOIOutputState;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Settings;
import org.junit.jupiter.api.Test;

/** Times of contact of moving shapes. */
class TimeOfImpactTest {

  private final TimeOfImpact toi = new TimeOfImpact();
  private final TOIInput input = new TOIInput();
  private final TOIOutput output = new TOIOutput();

  @Test
  void discsHitThinWallsAtAnySpeed() {
    float[] radii = {0.05f, 0.1f, 0.2f, 0.5f};
    float[] speeds = {10f, 30f, 100f, 300f, 1000f, 2000f};
    float[] walls = {0.01f, 0.02f, 0.05f, 0.1f, 0.2f};
    for (float radius : radii) {
      for (float speed : speeds) {
        for (float wall : walls) {
          CircleShape disc = new CircleShape();
          disc.m_radius = radius;
          PolygonShape box = new PolygonShape();
          box.setAsBox(0.5f * wall, 5f);
          float way = speed / 60f;
          input.proxyA.set(box, 0);
          input.proxyB.set(disc, 0);
          input.sweepA.a0 = 0f;
          input.sweepA.a = 0f;
          input.sweepB.c0.set(-radius - wall - 0.4f * way, 0.1f);
          input.sweepB.c.set(input.sweepB.c0.x + way, 0.1f);
          input.tMax = 1f;
          toi.timeOfImpact(output, input);
          String what = "radius " + radius + ", speed " + speed + ", wall " + wall;
          float reach = -0.5f * wall - radius - box.m_radius + 3f * Settings.linearSlop;
          if (input.sweepB.c.x < reach) {
            assertEquals(TOIOutputState.SEPARATED, output.state, what);
          } else {
            assertEquals(TOIOutputState.TOUCHING, output.state, what);
            float expected = (reach - input.sweepB.c0.x) / way;
            assertEquals(expected, output.t, 0.3f * Settings.linearSlop / way + 1e-6f, what);
          }
        }
      }
    }
  }
}
