package org.jbox2d.fracture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.World;
import org.jbox2d.fracture.materials.Glass;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What breaks something goes on, and neither loses way nor passes through what holds. */
class ProjectileTest {
  private static final float GAP = 6f;

  /** Steps' way by which a projectile may be behind where its velocity has carried it. */
  private static final double BEHIND = 1.1;

  private static Material glass() {
    Glass glass = new Glass();
    glass.m_rigidity = 1f;
    glass.m_shattering = 0.5f;
    glass.m_radius = 1.5f;
    glass.m_fragments = null;
    return glass;
  }

  /** Panes one behind the other, and a wall that holds behind them all. */
  private static World panes(int count, BodyType type) {
    World world = new World(new Vec2());
    for (int i = 0; i < count; i++) {
      Body pane = Range.body(world, type, GAP * i, 0f);
      Range.fixture(pane, Range.box(0.1f, 4f), 0.1f, glass());
    }
    Body wall = Range.body(world, BodyType.STATIC, wallAt(count), 0f);
    Range.fixture(wall, Range.box(0.5f, 50f), 0f, null);
    return world;
  }

  private static float wallAt(int count) {
    return GAP * count + 15f;
  }

  private static Body shot(World world, float speed, boolean bullet) {
    Body disc = Range.disc(world, -5.13f, 0.1f, 0.4f, 20f, speed, 0f);
    disc.setBullet(bullet);
    return disc;
  }

  /**
   * Way lost adds up to no more than the last step's, through 1 pane as through 10. Splinters go at
   * the end of the step in which they are born, as they would slow the shot.
   */
  @ParameterizedTest
  @CsvSource({
    "25, 30, true",
    "25, 60, true",
    "50, 60, true",
    "50, 240, true",
    "100, 60, true",
    "25, 60, false",
    "50, 30, false",
    "100, 120, false"
  })
  void losesNoWay(float speed, float hz, boolean bullet) {
    for (int count : new int[] {1, 3, 10}) {
      World world = panes(count, BodyType.STATIC);
      FractureSystem.of(world).setDebrisBudget(0);
      Body disc = shot(world, speed, bullet);
      double x = disc.getWorldCenter().x;
      for (int i = 0; i < (GAP * count + 10f) / speed * hz; i++) {
        world.step(1f / hz, 8, 3);
        x += disc.getLinearVelocity().x / hz;
        double behind = (x - disc.getWorldCenter().x) * hz / speed;
        String where = count + " panes, step " + i;
        assertTrue(Math.abs(behind) < BEHIND, where + ": " + behind + " steps behind");
      }
      assertEquals(count, FractureSystem.of(world).getFractureCount());
      assertTrue(disc.getLinearVelocity().x > 0.9f * speed, "goes on");
    }
  }

  /**
   * The splinters stay, and are pushed: the shot gives them momentum rather than pass over them.
   */
  @ParameterizedTest
  @CsvSource({"25, 30, true", "50, 60, true", "100, 60, true", "50, 60, false", "100, 120, false"})
  void collidesWithThePieces(float speed, float hz, boolean bullet) {
    World world = panes(1, BodyType.STATIC);
    Body disc = shot(world, speed, bullet);
    double x = disc.getWorldCenter().x;
    while (disc.getWorldCenter().x < 6f) {
      world.step(1f / hz, 8, 3);
      x += disc.getLinearVelocity().x / hz;
      assertTrue((x - disc.getWorldCenter().x) * hz / speed < BEHIND, "x " + x);
    }
    Totals totals = Totals.of(world);
    double ofDisc = disc.getMass() * disc.getLinearVelocity().x;
    assertTrue(totals.px - ofDisc > 2e-4 * ofDisc, "splinters have " + (totals.px - ofDisc));
  }

  @ParameterizedTest
  @CsvSource({
    "STATIC, 100, 60",
    "STATIC, 50, 30",
    "DYNAMIC, 100, 60",
    "DYNAMIC, 110, 60",
    "STATIC, 400, 240"
  })
  void neverPassesWhatHolds(BodyType type, float speed, float hz) {
    for (float offset = 0f; offset < 2f; offset += 0.17f) {
      for (boolean bullet : new boolean[] {true, false}) {
        World world = panes(2, type);
        // One that stands so near behind the last pane that making up for lost way leads there.
        Body near = Range.body(world, BodyType.STATIC, GAP + 0.65f, 0f);
        Range.fixture(near, Range.box(0.1f, 50f), 0f, null);
        Body disc = shot(world, speed, bullet);
        disc.setTransform(new Vec2(-5f - offset, 0.1f), 0f);
        for (int i = 0; i < 0.5f * hz; i++) {
          world.step(1f / hz, 8, 3);
          float x = disc.getWorldCenter().x;
          assertTrue(x < GAP + 0.65f, "offset " + offset + ", step " + i + ": " + x);
        }
        // What is no bullet may pass through thin dynamic bodies, as anywhere in the engine.
        boolean hits = bullet || type == BodyType.STATIC;
        assertTrue(!hits || FractureSystem.of(world).getFractureCount() > 0, "nothing broke");
      }
    }
  }
}
