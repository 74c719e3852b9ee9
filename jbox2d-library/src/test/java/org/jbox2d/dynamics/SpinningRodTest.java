package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.common.MathUtils;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.joints.RevoluteJoint;
import org.jbox2d.dynamics.joints.RevoluteJointDef;
import org.junit.jupiter.api.Test;

/** Thin rods that spin fast do not pass through posts, pinned or free. */
class SpinningRodTest {
  private final World world = Make.weightless();

  private Body post(float x, float y, float radius) {
    Body post = Make.body(world, BodyType.STATIC, x, y);
    post.createFixture(Make.circle(radius), 0f);
    return post;
  }

  private RevoluteJoint pin(Body rod, Vec2 anchor) {
    RevoluteJointDef def = new RevoluteJointDef();
    def.initialize(Make.body(world, BodyType.STATIC, 0f, 0f), rod, anchor);
    return (RevoluteJoint) world.createJoint(def);
  }

  private static float gap(RevoluteJoint joint) {
    Vec2 a = new Vec2();
    Vec2 b = new Vec2();
    joint.getAnchorA(a);
    joint.getAnchorB(b);
    return a.sub(b).length();
  }

  /**
   * Pinned at its end in the origin, it starts along the x axis; the post stands on the y axis. The
   * farthest post lies within the chord of the tip in a step, along which bodies are followed.
   */
  @Test
  void pinnedRodStopsAtAPost() {
    for (float radius : new float[] {0.02f, 0.05f, 0.2f}) {
      for (float distance : new float[] {0.3f, 0.9f, 1.6f}) {
        for (float spin = 5f; spin < 94f; spin += 8.3f) {
          stopsAtPost(radius, distance, spin);
        }
      }
    }
  }

  private void stopsAtPost(float radius, float distance, float spin) {
    Body post = post(0f, distance, radius);
    Body rod = Make.box(world, BodyType.DYNAMIC, 1f, 0f, 1f, 0.02f);
    rod.createFixture(Make.boxShape(0.05f, 0.02f), 1f);
    RevoluteJoint joint = pin(rod, new Vec2());
    rod.setAngularVelocity(spin);
    rod.setLinearVelocity(new Vec2(0f, spin));
    String what = "post " + radius + " at " + distance + ", spin " + spin;
    for (int i = 0; i < 60; i++) {
      world.step(Make.STEP, 8, 3);
      // A quarter turn less the angle that rod and post take up.
      assertTrue(rod.getAngle() < 0.5f * MathUtils.PI, what + ", step " + i);
      assertEquals(0f, gap(joint), 0.3f, what + ", step " + i);
    }
    assertEquals(0f, gap(joint), 0.01f, what);
    world.destroyBody(rod);
    world.destroyBody(post);
  }

  /** Pinned in the middle, between two posts, it bounces to and fro. */
  @Test
  void pinnedRodBouncesBetweenPosts() {
    post(0f, 0.8f, 0.03f);
    post(0.8f, 0f, 0.03f);
    Body rod = Make.body(world, BodyType.DYNAMIC, 0f, 0f);
    rod.createFixture(Make.boxShape(1f, 0.02f), 1f);
    rod.setTransform(new Vec2(), 0.25f * MathUtils.PI);
    Make.surface(rod, 0f, 1f);
    RevoluteJoint joint = pin(rod, new Vec2());
    rod.setAngularVelocity(70f);
    for (int i = 0; i < 300; i++) {
      world.step(Make.STEP, 8, 3);
      assertTrue(rod.getAngle() > 0f && rod.getAngle() < 0.5f * MathUtils.PI, "step " + i);
      assertEquals(0f, gap(joint), 0.05f, "step " + i);
    }
    assertTrue(Math.abs(rod.getAngularVelocity()) > 60f);
  }

  /** A free rod that spins past a post hits it with what it turns into its way. */
  @Test
  void freeRodDoesNotPassAPost() {
    post(0f, 0.6f, 0.03f);
    for (float spin = 10f; spin < 94f; spin += 6.7f) {
      Body rod = Make.box(world, BodyType.DYNAMIC, 0f, 0f, 1f, 0.02f);
      rod.setAngularVelocity(spin);
      float before = 0f;
      int hits = 0;
      for (int i = 0; i < 20 && hits == 0; i++) {
        world.step(Make.STEP, 8, 3);
        hits += world.getProfile().impacts;
        before = rod.getAngularVelocity();
      }
      assertTrue(hits > 0, "spin " + spin);
      assertTrue(before < 0.8f * spin, "spin " + spin + " became " + before);
      world.destroyBody(rod);
    }
  }

  /** What joints tie together is stopped as a whole: a chain of rods stays a chain. */
  @Test
  void jointedRodsStayTogether() {
    Make.box(world, BodyType.STATIC, 8f, 0f, 0.05f, 20f);
    Body last = null;
    for (int i = 0; i < 6; i++) {
      Body rod = Make.box(world, BodyType.DYNAMIC, 0f, 1f * i, 0.05f, 0.5f);
      rod.setLinearVelocity(new Vec2(100f, 0f));
      if (last != null) {
        RevoluteJointDef def = new RevoluteJointDef();
        def.initialize(last, rod, new Vec2(0f, i - 0.5f));
        world.createJoint(def);
      }
      last = rod;
    }
    for (int i = 0; i < 60; i++) {
      world.step(Make.STEP, 8, 3);
      for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
        assertTrue(b.getType() == BodyType.STATIC || b.getPosition().x < 8f, "step " + i);
      }
      for (RevoluteJoint j = (RevoluteJoint) world.getJointList();
          j != null;
          j = (RevoluteJoint) j.getNext()) {
        assertEquals(0f, gap(j), 0.05f, "step " + i);
      }
    }
  }
}
