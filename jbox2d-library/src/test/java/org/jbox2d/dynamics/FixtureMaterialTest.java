package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.jbox2d.callbacks.ContactImpulse;
import org.jbox2d.callbacks.ContactListener;
import org.jbox2d.collision.Manifold;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.contacts.Contact;
import org.junit.jupiter.api.Test;

/** What a material hears is what became of the body. */
class FixtureMaterialTest {

  /** In free space, the impulses that a body's material hears are its change of momentum. */
  @Test
  void impulsesAreTheChangeOfMomentum() {
    World world = Make.weightless();
    Body a = Make.dynamic(world, Make.boxShape(0.5f, 0.5f), -1.5f, 0.2f, 0.3f);
    Body b = Make.dynamic(world, Make.boxShape(0.6f, 0.4f), 0f, 0f, 0f);
    a.setLinearVelocity(new Vec2(6f, 1f));
    a.setAngularVelocity(1f);
    b.setLinearVelocity(new Vec2(-2f, 0f));
    int[] heard = new int[1];
    // momentum and angular momentum about the centre that b gains by contact in a step
    double[] gain = new double[3];
    double[] before = new double[6];
    b.getFixtureList()
        .setMaterial(
            (fixture, solved) -> {
              assertTrue(world.isLocked());
              assertSame(b.getFixtureList(), fixture);
              heard[0]++;
              boolean isB = solved.contact.m_fixtureB == fixture;
              float sign = isB ? 1f : -1f;
              before[0] = isB ? solved.velocityB.x : solved.velocityA.x;
              before[1] = isB ? solved.velocityB.y : solved.velocityA.y;
              before[2] = isB ? solved.angularVelocityB : solved.angularVelocityA;
              for (int i = 0; i < solved.pointCount; i++) {
                float px =
                    solved.normal.x * solved.normalImpulses[i]
                        + solved.normal.y * solved.tangentImpulses[i];
                float py =
                    solved.normal.y * solved.normalImpulses[i]
                        - solved.normal.x * solved.tangentImpulses[i];
                Vec2 arm = solved.points[i].sub(b.m_sweep.c0);
                gain[0] += sign * px;
                gain[1] += sign * py;
                gain[2] += sign * (arm.x * py - arm.y * px);
              }
            });
    for (int i = 0; i < 60; i++) {
      double vx = b.m_linearVelocity.x;
      double vy = b.m_linearVelocity.y;
      double w = b.m_angularVelocity;
      int heardBefore = heard[0];
      gain[0] = gain[1] = gain[2] = 0;
      Make.steps(world, 1);
      if (heard[0] > heardBefore) {
        assertEquals(vx, before[0], 1e-6);
        assertEquals(vy, before[1], 1e-6);
        assertEquals(w, before[2], 1e-6);
      }
      assertEquals(b.getMass() * (b.m_linearVelocity.x - vx), gain[0], 2e-4);
      assertEquals(b.getMass() * (b.m_linearVelocity.y - vy), gain[1], 2e-4);
      assertEquals(b.m_I * (b.m_angularVelocity - w), gain[2], 2e-4);
    }
    assertTrue(heard[0] > 0);
  }

  /** What it does not want to hear is not lost: the impulse of the step before is known anyway. */
  @Test
  void aMaterialHearsOnlyWhatItWants() {
    World world = Make.world();
    Make.ground(world);
    Body box = Make.box(world, BodyType.DYNAMIC, 0f, 0.51f, 0.5f, 0.5f);
    box.setSleepingAllowed(false);
    float weight = box.getMass() * Make.G * Make.STEP;
    List<Float> offered = new ArrayList<>();
    List<SolvedContact> heard = new ArrayList<>();
    float[] previous = new float[1];
    box.getFixtureList()
        .setMaterial(
            new FixtureMaterial() {
              @Override
              public boolean hears(Fixture fixture, float normalImpulse) {
                assertSame(box.getFixtureList(), fixture);
                offered.add(normalImpulse);
                return normalImpulse > 2f * weight;
              }

              @Override
              public void contactSolved(Fixture fixture, SolvedContact solved) {
                heard.add(solved);
                previous[0] = solved.previousNormalImpulse;
                assertEquals(offered.get(offered.size() - 1), solved.normalImpulse());
              }
            });
    Make.steps(world, 60);
    assertEquals(weight, offered.get(offered.size() - 1), 1e-3f);
    assertTrue(offered.size() >= 50);
    assertTrue(heard.isEmpty());
    box.setLinearVelocity(new Vec2(0f, -5f));
    Make.steps(world, 1);
    assertEquals(1, heard.size());
    assertEquals(weight, previous[0], 1e-3f);
  }

  @Test
  void restingHearsTheWeightEachStepAndTheStepBefore() {
    World world = Make.world();
    Make.ground(world);
    Body box = Make.box(world, BodyType.DYNAMIC, 0f, 0.51f, 0.5f, 0.5f);
    box.setSleepingAllowed(false);
    List<float[]> heard = new ArrayList<>();
    box.getFixtureList()
        .setMaterial(
            (fixture, solved) ->
                heard.add(
                    new float[] {
                      solved.normalImpulse(),
                      solved.previousNormalImpulse,
                      solved.gainA.y + solved.gainB.y,
                      solved.dt
                    }));
    Make.steps(world, 60);
    float weight = Make.G * Make.STEP;
    float[] last = heard.get(heard.size() - 1);
    assertEquals(weight, last[0], 1e-3f);
    assertEquals(heard.get(heard.size() - 2)[0], last[1], 1e-6f);
    assertEquals(-weight, last[2], 1e-5f);
    assertEquals(Make.STEP, last[3]);
    assertEquals(0f, heard.get(0)[1], "a new contact has no step before");
    world.step(0.5f * Make.STEP, 8, 3);
    last = heard.get(heard.size() - 1);
    assertEquals(0.5f * weight, last[1], 1e-3f, "scaled to the length of the step");
    assertEquals(0.5f * weight, last[0], 1e-3f);
  }

  @Test
  void bothMaterialsHearFixtureAFirst() {
    World world = Make.weightless();
    Body a = Make.disc(world, -0.6f, 0f, 0.5f);
    Body b = Make.disc(world, 0.6f, 0f, 0.5f);
    a.setLinearVelocity(new Vec2(3f, 0f));
    List<Fixture> order = new ArrayList<>();
    List<Fixture> expected = new ArrayList<>();
    FixtureMaterial material =
        (fixture, solved) -> {
          order.add(fixture);
          if (order.size() % 2 == 1) {
            expected.add(solved.contact.m_fixtureA);
            expected.add(solved.contact.m_fixtureB);
          }
        };
    a.getFixtureList().setMaterial(material);
    b.getFixtureList().setMaterial(material);
    Make.steps(world, 20);
    assertTrue(order.size() >= 2);
    assertEquals(expected, order);
  }

  @Test
  void aMaterialMayHaveItsBodyDestroyedAtTheEndOfTheStep() {
    World world = Make.world();
    Make.ground(world);
    FixtureDef def = new FixtureDef();
    def.shape = Make.circle(0.5f);
    def.density = 1f;
    def.material =
        (fixture, solved) -> {
          Body body = fixture.getBody();
          world.defer(
              () -> {
                if (body.getWorld() == world) {
                  world.destroyBody(body);
                }
              });
        };
    Make.body(world, BodyType.DYNAMIC, 0f, 2f).createFixture(def);
    Make.steps(world, 60);
    assertEquals(1, world.getBodyCount());
    WorldInvariants.check(world);
  }

  /**
   * A listener may give a material to what has just been solved. Where no fixture had one when the
   * step began, velocities had not been kept, and the report read beyond their array.
   */
  @Test
  void aMaterialSetWhileContactsAreReportedHearsFromTheNextStepOn() {
    World world = Make.world();
    Make.ground(world);
    Body box = Make.box(world, BodyType.DYNAMIC, 0f, 0.51f, 0.5f, 0.5f);
    box.setSleepingAllowed(false);
    int[] step = new int[1];
    List<Integer> heard = new ArrayList<>();
    world.setContactListener(
        new ContactListener() {
          @Override
          public void beginContact(Contact contact) {}

          @Override
          public void endContact(Contact contact) {}

          @Override
          public void preSolve(Contact contact, Manifold oldManifold) {}

          @Override
          public void postSolve(Contact contact, ContactImpulse impulse) {
            if (box.getFixtureList().getMaterial() == null) {
              box.getFixtureList().setMaterial((fixture, solved) -> heard.add(step[0]));
              heard.add(-step[0]);
            }
          }
        });
    for (step[0] = 1; step[0] <= 10; step[0]++) {
      Make.steps(world, 1);
    }
    assertTrue(heard.size() > 2);
    assertEquals(1 - heard.get(0), heard.get(1));
  }
}
