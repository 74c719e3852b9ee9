package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.jbox2d.collision.AABB;
import org.jbox2d.collision.broadphase.BroadPhase;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.contacts.ContactEdge;
import org.junit.jupiter.api.Test;

/** What a body counts as obstacles is what its list of contacts shows, whatever happens to them. */
class ObstaclesTest {
  @Test
  void theCountFollowsTypesBulletsAndContacts() {
    Random random = new Random(7);
    World world = new World(new Vec2(0, -10));
    List<Body> bodies = new ArrayList<>();
    int most = 0;
    for (int n = 0; n < 600; n++) {
      int what = random.nextInt(6);
      if (bodies.size() < 20 || what < 2) {
        bodies.add(disc(world, random));
      } else {
        Body body = bodies.get(random.nextInt(bodies.size()));
        if (what == 2) {
          body.setType(BodyType.values()[random.nextInt(3)]);
        } else if (what == 3) {
          body.setBullet(!body.isBullet());
        } else if (what == 4 && bodies.size() > 30) {
          bodies.remove(body);
          world.destroyBody(body);
        } else {
          body.setActive(!body.isActive());
        }
      }
      world.step(1 / 60f, 2, 2);
      int inWorld = 0;
      for (Body body : bodies) {
        inWorld += body.getType() != BodyType.DYNAMIC || body.isBullet() ? 1 : 0;
        int obstacles = 0;
        for (ContactEdge e = body.getContactList(); e != null; e = e.next) {
          obstacles += e.other.getType() != BodyType.DYNAMIC || e.other.isBullet() ? 1 : 0;
        }
        assertEquals(obstacles, body.obstacles);
        most = Math.max(most, obstacles);
      }
      assertEquals(inWorld, world.bodies.obstacles);
      assertEquals(obstaclesOf(bodies), obstaclesFoundIn(world));
    }
    assertTrue(most > 1);
  }

  private static Set<Fixture> obstaclesOf(List<Body> bodies) {
    Set<Fixture> fixtures = new HashSet<>();
    for (Body body : bodies) {
      if (body.isActive() && (body.getType() != BodyType.DYNAMIC || body.isBullet())) {
        fixtures.add(body.getFixtureList());
      }
    }
    return fixtures;
  }

  /** What a body that is followed along its way may find. */
  private static Set<Fixture> obstaclesFoundIn(World world) {
    Set<Fixture> fixtures = new HashSet<>();
    BroadPhase broadPhase = world.m_contactManager.m_broadPhase;
    broadPhase.queryObstacles(
        id -> fixtures.add(((FixtureProxy) broadPhase.getUserData(id)).fixture),
        new AABB(new Vec2(-1e9f, -1e9f), new Vec2(1e9f, 1e9f)));
    return fixtures;
  }

  private static Body disc(World world, Random random) {
    BodyDef def = new BodyDef();
    def.type = BodyType.values()[random.nextInt(3)];
    def.bullet = random.nextInt(4) == 0;
    def.position.set(3 * random.nextFloat(), 3 * random.nextFloat());
    def.gravityScale = 0;
    Body body = world.createBody(def);
    CircleShape shape = new CircleShape();
    shape.m_radius = 0.3f;
    body.createFixture(shape, 1);
    return body;
  }
}
