package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.jbox2d.callbacks.DestructionListener;
import org.jbox2d.collision.AABB;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.MassData;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.contacts.Contact;
import org.jbox2d.dynamics.joints.Joint;
import org.jbox2d.dynamics.joints.MouseJointDef;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** What users change between steps, and the public state they read and write. */
class BodyChangesTest {
  private final World world = Make.world();

  @AfterEach
  void allAgrees() {
    WorldInvariants.check(world);
    Make.steps(world, 3);
    WorldInvariants.check(world);
  }

  @Test
  void listsAreNewestFirst() {
    Body a = Make.disc(world, 0f, 0f, 1f);
    Body b = Make.disc(world, 5f, 0f, 1f);
    Body c = Make.disc(world, 10f, 0f, 1f);
    assertSame(c, world.getBodyList());
    assertSame(b, c.getNext());
    assertSame(a, b.getNext());
    Fixture second = b.createFixture(Make.circle(0.1f), 1f);
    assertSame(second, b.getFixtureList());
    assertEquals(2, b.m_fixtureCount);
    world.destroyBody(b);
    assertSame(a, c.getNext());
  }

  @Test
  void gettersReturnTheLiveObjects() {
    Body body = Make.disc(world, 1f, 2f, 1f);
    assertSame(body.getPosition(), body.getPosition());
    assertSame(body.m_xf.p, body.getPosition());
    assertSame(body.m_xf, body.getTransform());
    assertSame(body.m_sweep.c, body.getWorldCenter());
    assertSame(body.m_linearVelocity, body.getLinearVelocity());
    assertNotSame(body.getWorldPoint(new Vec2()), body.getWorldPoint(new Vec2()));
    assertSame(world.getGravity(), world.getGravity());
  }

  @Test
  void whatIsWrittenIntoTheVelocityTakesEffect() {
    Body body = Make.disc(world, 0f, 0f, 1f);
    body.setGravityScale(0f);
    Make.steps(world, 1);
    body.getLinearVelocity().x = 6f;
    body.m_angularVelocity = 3f;
    Make.steps(world, 1);
    assertEquals(0.1f, body.getPosition().x, 1e-6f);
    assertEquals(0.05f, body.getAngle(), 1e-6f);
  }

  @Test
  void definitionsAreCopied() {
    BodyDef def = new BodyDef();
    def.type = BodyType.DYNAMIC;
    def.linearVelocity.set(1f, 0f);
    Body body = world.createBody(def);
    FixtureDef fixtureDef = new FixtureDef();
    CircleShape circle = Make.circle(1f);
    fixtureDef.shape = circle;
    fixtureDef.density = 1f;
    Fixture fixture = body.createFixture(fixtureDef);
    def.position.set(9f, 9f);
    def.linearVelocity.set(9f, 9f);
    fixtureDef.filter.groupIndex = 9;
    circle.m_radius = 9f;
    Vec2 gravity = new Vec2(0f, -1f);
    world.setGravity(gravity);
    gravity.set(9f, 9f);
    assertEquals(0f, body.getPosition().x);
    assertEquals(1f, body.getLinearVelocity().x);
    assertEquals(0, fixture.getFilterData().groupIndex);
    assertEquals(1f, fixture.getShape().m_radius);
    assertEquals(-1f, world.getGravity().y);
  }

  @Test
  void massFollowsTheShapeOnlyWhenAskedTo() {
    Body body = Make.disc(world, 0f, 0f, 1f);
    float pi = 3.1415927f;
    assertEquals(pi, body.getMass(), 1e-5f);
    body.getFixtureList().getShape().m_radius = 2f;
    body.getFixtureList().setDensity(3f);
    assertEquals(pi, body.getMass(), 1e-5f);
    body.resetMassData();
    assertEquals(12f * pi, body.getMass(), 1e-4f);
    assertEquals(24f * pi, body.getInertia(), 1e-3f);
  }

  @Test
  void massOfSeveralFixturesAddsUp() {
    Body body = Make.body(world, BodyType.DYNAMIC, 0f, 0f);
    PolygonShape left = new PolygonShape();
    left.setAsBox(0.5f, 0.5f, new Vec2(-1f, 0f), 0f);
    PolygonShape right = new PolygonShape();
    right.setAsBox(0.5f, 0.5f, new Vec2(1f, 0f), 0f);
    body.createFixture(left, 1f);
    body.createFixture(right, 3f);
    assertEquals(4f, body.getMass(), 1e-5f);
    assertEquals(0.5f, body.getLocalCenter().x, 1e-5f);
    // about the origin: sum of m (1/6 + 1)
    assertEquals(4f * 7f / 6f, body.getInertia(), 1e-3f);
    body.destroyFixture(body.getFixtureList());
    assertEquals(1f, body.getMass(), 1e-5f);
    assertEquals(-1f, body.getWorldCenter().x, 1e-5f);
  }

  /** Two like worlds, a comb on a row of discs: what is left goes on the same to the last bit. */
  @Test
  void fixturesDestroyedTogetherGoAsOneByOne() {
    for (boolean heard : new boolean[] {false, true}) {
      World[] worlds = {Make.world(), Make.world()};
      for (int k = 0; k < 2; k++) {
        Body comb = combOnDiscs(worlds[k]);
        if (heard) {
          worlds[k].setContactListener(new CollisionResponseTest.QuietListener());
        }
        Make.steps(worlds[k], 30);
        assertTrue(worlds[k].getContactCount() > 8);
        List<Fixture> leaving = new ArrayList<>();
        int i = 0;
        for (Fixture f = comb.getFixtureList(); f != null; f = f.getNext()) {
          if (i++ % 3 > 0) {
            leaving.add(f);
          }
        }
        if (k == 0) {
          comb.destroyFixtures(leaving);
        } else {
          leaving.forEach(comb::destroyFixture);
        }
        assertEquals(4, comb.m_fixtureCount);
        WorldInvariants.check(worlds[k]);
        Make.steps(worlds[k], 60);
      }
      assertEquals(StateHash.of(worlds[1]), StateHash.of(worlds[0]));
    }
  }

  private static Body combOnDiscs(World world) {
    Make.ground(world);
    Body comb = Make.body(world, BodyType.DYNAMIC, 0f, 1.6f);
    for (int i = 0; i < 12; i++) {
      PolygonShape tooth = new PolygonShape();
      tooth.setAsBox(0.3f, 0.3f, new Vec2(0.5f * (i * 5 % 12), 0f), 0f);
      comb.createFixture(tooth, 1f);
      Make.disc(world, 0.7f * i - 1f, 0.5f, 0.3f);
    }
    return comb;
  }

  @Test
  void noFixtureGoesIfOneIsNotOfTheBody() {
    Body a = Make.disc(world, 0f, 0f, 1f);
    Body b = Make.disc(world, 5f, 0f, 1f);
    List<Fixture> both = List.of(a.getFixtureList(), b.getFixtureList());
    assertThrows(IllegalArgumentException.class, () -> a.destroyFixtures(both));
    assertEquals(1, a.m_fixtureCount);
    a.destroyFixtures(List.of());
    assertEquals(1, a.m_fixtureCount);
  }

  @Test
  void aListenerMayDestroyTheBodyWhoseFixturesGo() {
    Body floor = Make.box(world, BodyType.STATIC, 0f, -1f, 5f, 1f);
    Body body = Make.box(world, BodyType.DYNAMIC, 0f, 0.5f, 0.5f, 0.5f);
    body.createFixture(Make.circle(0.2f), 1f);
    Make.steps(world, 5);
    world.setContactListener(
        new CollisionResponseTest.QuietListener() {
          @Override
          public void endContact(Contact contact) {
            if (body.getWorld() != null) {
              world.destroyBody(body);
            }
          }
        });
    List<Fixture> all = List.of(body.getFixtureList(), body.getFixtureList().getNext());
    body.destroyFixtures(all);
    assertNull(body.getWorld());
    assertEquals(1, world.getBodyCount());
    assertSame(floor, world.getBodyList());
    world.setContactListener(null);
  }

  @Test
  void aDynamicBodyWithoutDensityWeighsOne() {
    Body body = Make.body(world, BodyType.DYNAMIC, 0f, 0f);
    assertEquals(1f, body.getMass());
    body.createFixture(Make.circle(1f), 0f);
    assertEquals(1f, body.getMass());
    body.resetMassData();
    assertEquals(1f, body.getMass());
  }

  @Test
  void massDataMayBeOverridden() {
    Body body = Make.disc(world, 0f, 0f, 1f);
    MassData data = new MassData();
    data.mass = 5f;
    data.I = 30f;
    data.center.set(1f, 0f);
    body.setAngularVelocity(2f);
    body.setMassData(data);
    assertEquals(5f, body.getMass());
    assertEquals(30f, body.getInertia(), 1e-4f);
    assertEquals(25f, body.m_I, 1e-4f);
    assertEquals(1f, body.getWorldCenter().x, 1e-6f);
    assertEquals(2f, body.getLinearVelocity().y, 1e-6f, "the same motion, at the new centre");
    MassData out = new MassData();
    body.getMassData(out);
    assertEquals(30f, out.I, 1e-4f);
    assertEquals(1f, out.center.x);
  }

  @Test
  void kinematicBodiesPushAndAreNotPushed() {
    Make.ground(world);
    Body ram = Make.box(world, BodyType.KINEMATIC, -3f, 0.6f, 0.5f, 0.5f);
    Body box = Make.box(world, BodyType.DYNAMIC, 0f, 0.51f, 0.5f, 0.5f);
    ram.setLinearVelocity(new Vec2(2f, 0f));
    Make.steps(world, 180);
    assertEquals(3f, ram.getPosition().x, 1e-3f);
    assertEquals(4f, box.getPosition().x, 0.1f);
    assertEquals(0.6f, ram.getPosition().y, 0f);
  }

  @Test
  void inactiveBodiesAreOutOfEverything() {
    Body body = Make.disc(world, 0f, 5f, 1f);
    body.setActive(false);
    Make.steps(world, 10);
    assertEquals(5f, body.getPosition().y);
    assertEquals(0, found(body.getPosition()));
    body.applyForceToCenter(new Vec2(1000f, 0f));
    Make.steps(world, 2);
    body.setActive(true);
    assertEquals(1, found(body.getPosition()));
    Make.steps(world, 10);
    assertEquals(0f, body.getPosition().x, 0f);
    assertTrue(body.getPosition().y < 5f);
  }

  private int found(Vec2 point) {
    int[] count = new int[1];
    world.queryAABB(
        fixture -> {
          count[0]++;
          return true;
        },
        new AABB(point, point));
    return count[0];
  }

  @Test
  void teleportingMovesTheBounds() {
    Body body = Make.disc(world, 0f, 0f, 1f);
    body.setTransform(new Vec2(100f, 50f), 1f);
    assertEquals(1, found(new Vec2(100f, 50f)));
    assertEquals(0, found(new Vec2(0f, 0f)));
    assertEquals(100f, body.m_sweep.c0.x);
    assertEquals(1f, body.getAngle());
  }

  /** A disc that moves freely, and one that is put somewhere: bounds are one radius about it. */
  @Test
  void boundsAreWhereTheBodyIs() {
    Body body = Make.disc(world, 0f, 0f, 1f);
    body.setLinearVelocity(new Vec2(30f, 0f));
    for (int i = 0; i < 5; i++) {
      Make.steps(world, 1);
      checkBounds(body);
    }
    body.setTransform(new Vec2(7f, -3f), 0f);
    checkBounds(body);
    body.setType(BodyType.STATIC);
    checkBounds(body);
  }

  private static void checkBounds(Body body) {
    AABB bounds = body.getFixtureList().getAABB(0);
    assertEquals(body.getPosition().x - 1f, bounds.lowerBound.x, 1e-5f);
    assertEquals(body.getPosition().y - 1f, bounds.lowerBound.y, 1e-5f);
    assertEquals(body.getPosition().x + 1f, bounds.upperBound.x, 1e-5f);
    assertEquals(body.getPosition().y + 1f, bounds.upperBound.y, 1e-5f);
    int proxy = body.getFixtureList().m_proxies[0].proxyId;
    assertTrue(body.m_world.m_contactManager.m_broadPhase.covers(proxy, bounds));
  }

  @Test
  void destructionTellsJointsAndFixtures() {
    Body ground = Make.ground(world);
    Body body = Make.disc(world, 0f, 2f, 1f);
    body.createFixture(Make.circle(0.5f), 1f);
    MouseJointDef def = new MouseJointDef();
    def.bodyA = ground;
    def.bodyB = body;
    world.createJoint(def);
    List<String> heard = new ArrayList<>();
    world.setDestructionListener(
        new DestructionListener() {
          @Override
          public void sayGoodbye(Joint joint) {
            heard.add("joint");
          }

          @Override
          public void sayGoodbye(Fixture fixture) {
            heard.add("fixture");
          }
        });
    world.destroyBody(body);
    assertEquals(List.of("joint", "fixture", "fixture"), heard);
    assertEquals(0, world.getJointCount());
    assertNull(ground.getJointList());
  }

  @Test
  void aDestructionListenerMayDestroyTheFixtureAndTheJointItself() {
    Body ground = Make.ground(world);
    Body body = Make.disc(world, 0f, 2f, 1f);
    body.createFixture(Make.circle(0.5f), 1f);
    MouseJointDef def = new MouseJointDef();
    def.bodyA = ground;
    def.bodyB = body;
    world.createJoint(def);
    world.setDestructionListener(
        new DestructionListener() {
          @Override
          public void sayGoodbye(Joint joint) {
            world.destroyJoint(joint);
          }

          @Override
          public void sayGoodbye(Fixture fixture) {
            fixture.getBody().destroyFixture(fixture);
          }
        });
    world.destroyBody(body);
    assertEquals(1, world.getBodyCount());
    assertEquals(0, world.getJointCount());
  }

  @Test
  void callsOnADestroyedBodyDoNotDisturbTheWorld() {
    Body body = Make.disc(world, 0f, 2f, 1f);
    Fixture fixture = body.getFixtureList();
    world.destroyBody(body);
    body.setAwake(false);
    body.setAwake(true);
    body.setLinearVelocity(new Vec2(1f, 1f));
    body.applyForceToCenter(new Vec2(1f, 1f));
    fixture.refilter();
    fixture.setSensor(true);
    assertEquals(0, world.awake.count);
  }

  @Test
  void bodiesWhoseJointIsDestroyedCollideAgain() {
    Body a = Make.box(world, BodyType.STATIC, 0f, 0f, 0.5f, 0.5f);
    Body b = Make.box(world, BodyType.DYNAMIC, 0.6f, 0f, 0.5f, 0.5f);
    b.setGravityScale(0f);
    MouseJointDef def = new MouseJointDef();
    def.bodyA = a;
    def.bodyB = b;
    def.target.set(b.getPosition());
    Joint joint = world.createJoint(def);
    Make.steps(world, 10);
    assertEquals(0.6f, b.getPosition().x, 1e-3f);
    assertEquals(0, world.getContactCount());
    world.destroyJoint(joint);
    Make.steps(world, 60);
    assertEquals(1f, b.getPosition().x, 0.02f);
  }

  @Test
  void aJointEndsTheCollisionOfItsBodies() {
    Body a = Make.box(world, BodyType.STATIC, 0f, 0f, 0.5f, 0.5f);
    Body b = Make.box(world, BodyType.DYNAMIC, 0f, 1.01f, 0.5f, 0.5f);
    Make.steps(world, 60);
    assertFalse(b.isAwake());
    MouseJointDef def = new MouseJointDef();
    def.bodyA = a;
    def.bodyB = b;
    def.target.set(b.getPosition());
    world.createJoint(def);
    Make.steps(world, 60);
    assertTrue(b.getPosition().y < 0.5f, "falls into the other");
  }

  @Test
  void fixturesOfACompoundShareIt() {
    Shape[] parts = {Make.circle(0.5f), Make.boxShape(1f, 0.1f)};
    CompoundShape compound = () -> parts;
    Body body = Make.body(world, BodyType.DYNAMIC, 0f, 0f);
    FixtureDef def = new FixtureDef();
    def.density = 2f;
    def.friction = 0.7f;
    List<Fixture> fixtures = body.createFixture(def, compound);
    assertEquals(2, fixtures.size());
    assertNull(def.shape);
    for (int i = 0; i < 2; i++) {
      assertSame(compound, fixtures.get(i).getCompound());
      assertEquals(parts[i].getType(), fixtures.get(i).getType());
      assertEquals(0.7f, fixtures.get(i).getFriction());
    }
    assertEquals(2f * (0.25f * 3.1415927f + 0.4f), body.getMass(), 1e-4f);
    assertNull(body.createFixture(Make.circle(1f), 0f).getCompound());
  }

  @Test
  void extensionsAreMadeOncePerWorld() {
    StringBuilder first = world.extension(StringBuilder.class, w -> new StringBuilder("a"));
    assertSame(first, world.extension(StringBuilder.class, w -> new StringBuilder("b")));
    assertNotSame(
        first, new World(new Vec2()).extension(StringBuilder.class, w -> new StringBuilder("a")));
    assertEquals(7, world.extension(Integer.class, w -> 7));
  }
}
