package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.jbox2d.callbacks.ContactImpulse;
import org.jbox2d.collision.Manifold;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.contacts.Contact;
import org.junit.jupiter.api.Test;

/** Stacks and piles come to rest, carry their weight, and sleep. */
class RestingTest {

  @Test
  void aStackOfTenCalmsDownAndSleeps() {
    World world = Make.world();
    Make.ground(world);
    Body[] boxes = stack(world, 10);
    Make.steps(world, 600);
    for (int i = 0; i < boxes.length; i++) {
      assertFalse(boxes[i].isAwake(), "box " + i + " is awake");
      assertEquals(0f, boxes[i].getPosition().x, 0.01f);
      assertEquals(0.5f + i, boxes[i].getPosition().y, 0.02f * (i + 1));
      assertEquals(0f, boxes[i].getAngle(), 0.01f);
    }
    assertEquals(0, world.awake.count);
    assertEquals(0, world.getContactManager().activeCount);
    WorldInvariants.check(world);
  }

  @Test
  void theFootOfAStackCarriesItsWeight() {
    World world = Make.world();
    world.setAllowSleep(false);
    Body ground = Make.ground(world);
    Body[] boxes = stack(world, 6);
    Make.steps(world, 300);
    float[] impulse = new float[1];
    world.setContactListener(
        new CollisionResponseTest.QuietListener() {
          @Override
          public void postSolve(Contact contact, ContactImpulse solved) {
            if (contact.m_fixtureA.m_body == ground || contact.m_fixtureB.m_body == ground) {
              impulse[0] += solved.normalImpulses[0] + solved.normalImpulses[1];
            }
          }
        });
    Make.steps(world, 60);
    float weight = boxes.length * boxes[0].getMass() * Make.G;
    assertEquals(weight, impulse[0], 0.01f * weight);
  }

  /**
   * Fifteen boxes that drop onto each other used to topple: where a contact point's id changed
   * between vertex and cut, by a rounding, its impulse was lost.
   */
  @Test
  void pointsOfAStackKeepTheirImpulses() {
    World world = Make.world();
    Make.ground(world);
    Body[] boxes = new Body[15];
    for (int i = 0; i < boxes.length; i++) {
      boxes[i] = Make.box(world, BodyType.DYNAMIC, 0f, 0.752f + 1.54f * i, 0.5f, 0.5f);
    }
    int[] lost = new int[1];
    world.setContactListener(
        new CollisionResponseTest.QuietListener() {
          @Override
          public void preSolve(Contact contact, Manifold old) {
            if (sum(contact.getManifold()) < 0.999f * sum(old)) {
              lost[0]++;
            }
          }

          private float sum(Manifold m) {
            float impulse = 0f;
            for (int i = 0; i < m.pointCount; i++) {
              impulse += m.points[i].normalImpulse;
            }
            return impulse;
          }
        });
    Make.steps(world, 600);
    assertEquals(0, lost[0]);
    assertEquals(14.5f, boxes[14].getPosition().y, 15 * 0.015f);
    assertEquals(0f, boxes[14].getPosition().x, 0.05f);
    assertFalse(boxes[14].isAwake());
  }

  private static Body[] stack(World world, int count) {
    Body[] boxes = new Body[count];
    for (int i = 0; i < count; i++) {
      boxes[i] = Make.box(world, BodyType.DYNAMIC, 0f, 0.52f + 1.02f * i, 0.5f, 0.5f);
    }
    return boxes;
  }

  @Test
  void aPyramidKeepsItsShapeAndSleeps() {
    World world = Make.pyramid(12);
    Make.steps(world, 600);
    float top = 0f;
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      assertTrue(b.getType() == BodyType.STATIC || !b.isAwake());
      top = Math.max(top, b.getPosition().y);
    }
    // Skins keep each row up to two polygon radii less a slop above the one below.
    assertEquals(11.5f, top, 12 * 0.02f);
    WorldInvariants.check(world);
  }

  @Test
  void aPileOfDebrisStaysInItsBoxAndSleeps() {
    World world = Make.debris(120, 7);
    int awakeSteps = 0;
    while (world.awake.count > 0 && awakeSteps < 3000) {
      world.step(Make.STEP, 8, 3);
      awakeSteps++;
      if (awakeSteps % 20 == 0) {
        WorldInvariants.check(world);
      }
    }
    int steps = awakeSteps;
    assertTrue(steps < 3000, "the pile never sleeps");
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      Vec2 c = b.getWorldCenter();
      assertTrue(Math.abs(c.x) < 6f && c.y >= 0f && c.y < 40f, () -> "outside: " + c);
    }
  }

  /** A box laid on its edge or corner falls on a side, whatever its first angle. */
  @Test
  void aBoxEndsOnOneOfItsSides() {
    Random random = new Random(5);
    for (int run = 0; run < 10; run++) {
      World world = Make.world();
      Make.ground(world);
      Body box = Make.dynamic(world, Make.boxShape(0.5f, 0.5f), 0f, 1.5f, 6f * random.nextFloat());
      Make.steps(world, 400);
      double quarter = Math.PI / 2;
      double turns = box.getAngle() / quarter;
      assertEquals(Math.rint(turns), turns, 0.01, "angle in quarter turns");
      assertEquals(0.5f, box.getPosition().y, 0.02f);
      assertFalse(box.isAwake());
    }
  }
}
