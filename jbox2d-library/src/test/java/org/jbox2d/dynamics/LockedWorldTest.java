package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.jbox2d.callbacks.ContactImpulse;
import org.jbox2d.collision.Manifold;
import org.jbox2d.collision.shapes.MassData;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.contacts.Contact;
import org.jbox2d.dynamics.joints.Joint;
import org.jbox2d.dynamics.joints.MouseJointDef;
import org.junit.jupiter.api.Test;

/** Changes in a step are refused and change nothing, or wait until its end. */
class LockedWorldTest {
  private final World world = Make.world();
  private final Body ground = Make.ground(world);
  private final Body box = Make.box(world, BodyType.DYNAMIC, 0f, 0.5f, 0.5f, 0.5f);

  /** Runs in a step, once. */
  private void inStep(Runnable task) {
    int[] runs = new int[1];
    world.setContactListener(
        new CollisionResponseTest.QuietListener() {
          @Override
          public void preSolve(Contact contact, Manifold oldManifold) {
            if (runs[0]++ == 0) {
              task.run();
            }
          }
        });
    world.step(Make.STEP, 8, 3);
    world.setContactListener(null);
    assertTrue(runs[0] > 0);
  }

  @Test
  void changesAreRefusedAndChangeNothing() {
    MouseJointDef jointDef = new MouseJointDef();
    jointDef.bodyA = ground;
    jointDef.bodyB = box;
    Joint joint = world.createJoint(jointDef);
    Body plain = Make.box(world, BodyType.DYNAMIC, 0f, 1.5f, 0.5f, 0.5f);
    Runnable[] changes = {
      () -> world.step(Make.STEP, 8, 3),
      () -> world.createBody(new BodyDef()),
      () -> world.destroyBody(box),
      () -> world.createJoint(jointDef),
      () -> world.destroyJoint(joint),
      () -> box.createFixture(Make.circle(1f), 1f),
      () -> box.createFixture(new FixtureDef(), () -> null),
      () -> box.destroyFixture(box.getFixtureList()),
      () -> box.setTransform(new Vec2(1f, 1f), 1f),
      () -> box.setType(BodyType.STATIC),
      () -> box.setActive(false),
      () -> box.setMassData(new MassData()),
    };
    Make.steps(world, 1);
    int[] refused = new int[1];
    plain.setLinearVelocity(new Vec2(0f, -1f));
    inStep(
        () -> {
          assertTrue(world.isLocked());
          Vec2 before = box.getPosition().clone();
          for (Runnable change : changes) {
            IllegalStateException e = assertThrows(IllegalStateException.class, change::run);
            assertTrue(e.getMessage().contains("locked"), e.getMessage());
            refused[0]++;
          }
          assertEquals(3, world.getBodyCount());
          assertEquals(1, world.getJointCount());
          assertEquals(1, box.m_fixtureCount);
          assertEquals(BodyType.DYNAMIC, box.getType());
          assertTrue(box.isActive());
          assertEquals(1f, box.getMass(), 1e-5f);
          assertEquals(before, box.getPosition());
        });
    assertEquals(changes.length, refused[0]);
    WorldInvariants.check(world);
  }

  @Test
  void aThrowingListenerLeavesTheWorldUsable() {
    for (String when : List.of("begin", "pre", "post", "end")) {
      World other = Make.debris(40, 3);
      int[] countdown = {30};
      other.setContactListener(
          new CollisionResponseTest.QuietListener() {
            private void hear(String what) {
              if (what.equals(when) && --countdown[0] == 0) {
                throw new UnsupportedOperationException(what);
              }
            }

            @Override
            public void beginContact(Contact contact) {
              hear("begin");
            }

            @Override
            public void endContact(Contact contact) {
              hear("end");
            }

            @Override
            public void preSolve(Contact contact, Manifold oldManifold) {
              hear("pre");
            }

            @Override
            public void postSolve(Contact contact, ContactImpulse impulse) {
              hear("post");
            }
          });
      UnsupportedOperationException e =
          assertThrows(UnsupportedOperationException.class, () -> Make.steps(other, 300));
      assertEquals(when, e.getMessage());
      assertFalse(other.isLocked());
      for (int i = 0; i < 200; i++) {
        other.step(Make.STEP, 8, 3);
        WorldInvariants.check(other);
      }
      while (other.getBodyList() != null) {
        other.destroyBody(other.getBodyList());
      }
      WorldInvariants.check(other);
      assertEquals(0, other.getContactCount());
      assertEquals(0, other.getProxyCount());
    }
  }

  @Test
  void deferredTasksRunInOrderAfterTheStep() {
    List<String> log = new ArrayList<>();
    inStep(
        () -> {
          world.defer(
              () -> {
                assertFalse(world.isLocked());
                log.add("first");
                world.defer(() -> log.add("nested"));
              });
          world.defer(() -> log.add("second"));
          assertTrue(log.isEmpty());
        });
    assertEquals(List.of("first", "nested", "second"), log);
    world.defer(() -> log.add("at once"));
    assertEquals(4, log.size());
  }

  @Test
  void tasksBehindOneThatThrowsRunAfterTheNextStep() {
    List<String> log = new ArrayList<>();
    assertThrows(
        UnsupportedOperationException.class,
        () ->
            inStep(
                () -> {
                  world.defer(() -> log.add("first"));
                  world.defer(
                      () -> {
                        throw new UnsupportedOperationException();
                      });
                  world.defer(() -> log.add("third"));
                }));
    assertEquals(List.of("first"), log);
    assertFalse(world.isLocked());
    Make.steps(world, 1);
    assertEquals(List.of("first", "third"), log);
  }

  @Test
  void aBodyMayBeDestroyedByADeferredTask() {
    inStep(() -> world.defer(() -> world.destroyBody(box)));
    assertEquals(1, world.getBodyCount());
    assertEquals(0, world.getContactCount());
    WorldInvariants.check(world);
  }

  @Test
  void aDeferredTaskMayStepTheWorld() {
    float y = box.getPosition().y;
    inStep(() -> world.defer(() -> Make.steps(world, 1)));
    assertEquals(y, box.getPosition().y, 0.05f);
    WorldInvariants.check(world);
  }
}
