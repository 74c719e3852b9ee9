package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import java.util.function.Consumer;
import org.jbox2d.collision.AABB;
import org.jbox2d.collision.shapes.ChainShape;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.EdgeShape;
import org.jbox2d.collision.shapes.MassData;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.contacts.Contact;
import org.jbox2d.dynamics.joints.Joint;
import org.jbox2d.dynamics.joints.JointDef;
import org.jbox2d.dynamics.joints.MouseJointDef;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Values that cannot be are refused by name, and nothing has changed then. */
class BadInputTest {
  private static final float[] NOT_FINITE = {
    Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY
  };
  private static final float[] NOT_FINITE_OR_NEGATIVE = {
    Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY, -1f, -Float.MIN_VALUE
  };

  private final World world = Make.world();
  private final Body ground = Make.ground(world);
  private final Body box = Make.box(world, BodyType.DYNAMIC, 0f, 0.5f, 0.5f, 0.5f);
  private final Fixture fixture = box.getFixtureList();

  @AfterEach
  void nothingHasChanged() {
    assertEquals(2, world.getBodyCount());
    assertEquals(0, world.getJointCount());
    assertEquals(2, world.getProxyCount());
    assertEquals(1f, box.getMass(), 1e-5f);
    WorldInvariants.check(world);
    Make.steps(world, 100);
    WorldInvariants.check(world);
    assertEquals(0.5f, box.getPosition().y, 0.03f);
  }

  private static void refuses(String name, Runnable call) {
    IllegalArgumentException e = assertThrows(IllegalArgumentException.class, call::run, name);
    assertTrue(e.getMessage().contains(name), () -> name + " is not in: " + e.getMessage());
  }

  private static void refusesNonFinite(String name, Consumer<Float> call) {
    for (float bad : NOT_FINITE) {
      refuses(name, () -> call.accept(bad));
    }
  }

  private static void refusesVectors(String name, Consumer<Vec2> call) {
    refuses(name, () -> call.accept(null));
    for (float bad : NOT_FINITE) {
      refuses(name, () -> call.accept(new Vec2(bad, 0f)));
      refuses(name, () -> call.accept(new Vec2(0f, bad)));
    }
  }

  private static void refusesNonFiniteAndNegative(String name, Consumer<Float> call) {
    for (float bad : NOT_FINITE_OR_NEGATIVE) {
      refuses(name, () -> call.accept(bad));
    }
  }

  private void body(Consumer<BodyDef> change) {
    BodyDef def = new BodyDef();
    change.accept(def);
    world.createBody(def);
  }

  private void fixture(Consumer<FixtureDef> change) {
    FixtureDef def = new FixtureDef();
    def.shape = Make.circle(1f);
    def.density = 1f;
    change.accept(def);
    box.createFixture(def);
  }

  @Test
  void bodyDefinitions() {
    refuses("def", () -> world.createBody(null));
    refuses("type", () -> body(def -> def.type = null));
    refusesVectors("position", v -> body(def -> def.position = v));
    refusesVectors("linearVelocity", v -> body(def -> def.linearVelocity = v));
    refusesNonFinite("angle", x -> body(def -> def.angle = x));
    refusesNonFinite("angularVelocity", x -> body(def -> def.angularVelocity = x));
    refusesNonFinite("gravityScale", x -> body(def -> def.gravityScale = x));
    refusesNonFiniteAndNegative("linearDamping", x -> body(def -> def.linearDamping = x));
    refusesNonFiniteAndNegative("angularDamping", x -> body(def -> def.angularDamping = x));
  }

  @Test
  void fixtureDefinitions() {
    refuses("def", () -> box.createFixture((FixtureDef) null));
    refuses("shape", () -> fixture(def -> def.shape = null));
    refuses("filter", () -> fixture(def -> def.filter = null));
    refusesNonFiniteAndNegative("density", x -> fixture(def -> def.density = x));
    refusesNonFiniteAndNegative("friction", x -> fixture(def -> def.friction = x));
    refusesNonFiniteAndNegative("restitution", x -> fixture(def -> def.restitution = x));
    refusesNonFiniteAndNegative("density", x -> box.createFixture(Make.circle(1f), x));
  }

  @Test
  void shapes() {
    refusesNonFiniteAndNegative("radius", x -> box.createFixture(Make.circle(x), 1f));
    refuses("radius", () -> box.createFixture(Make.circle(0f), 1f));
    refusesNonFinite("m_p", x -> box.createFixture(circleAt(x), 1f));
    refusesNonFinite("m_vertex1", x -> box.createFixture(edge(e -> e.m_vertex1.x = x), 1f));
    refusesNonFinite("m_vertex2", x -> box.createFixture(edge(e -> e.m_vertex2.y = x), 1f));
    refusesNonFinite("m_vertex0", x -> box.createFixture(edge(e -> ghosts(e, x, 0f)), 1f));
    refusesNonFinite("m_vertex3", x -> box.createFixture(edge(e -> ghosts(e, 0f, x)), 1f));
    refuses("vertices", () -> box.createFixture(new PolygonShape(), 1f));
    refuses("vertices", () -> box.createFixture(new ChainShape(), 1f));
    PolygonShape polygon = Make.boxShape(1f, 1f);
    polygon.m_vertices[2].y = Float.NaN;
    refuses("m_vertices[2]", () -> box.createFixture(polygon, 1f));
    refuses("m_radius", () -> box.createFixture(withRadius(Make.boxShape(1f, 1f), -1f), 1f));
  }

  private static Shape circleAt(float x) {
    CircleShape circle = Make.circle(1f);
    circle.m_p.x = x;
    return circle;
  }

  private static Shape edge(Consumer<EdgeShape> change) {
    EdgeShape edge = new EdgeShape();
    edge.set(new Vec2(), new Vec2(1f, 0f));
    change.accept(edge);
    return edge;
  }

  private static void ghosts(EdgeShape edge, float before, float after) {
    edge.m_hasVertex0 = true;
    edge.m_vertex0.x = before;
    edge.m_hasVertex3 = true;
    edge.m_vertex3.x = after;
  }

  private static Shape withRadius(Shape shape, float radius) {
    shape.m_radius = radius;
    return shape;
  }

  @Test
  void compounds() {
    FixtureDef def = new FixtureDef();
    refuses("compound", () -> box.createFixture(def, null));
    refuses("getParts", () -> box.createFixture(def, () -> null));
    refuses("getParts", () -> box.createFixture(def, () -> new Shape[0]));
    refuses(
        "getParts()[1]", () -> box.createFixture(def, () -> new Shape[] {Make.circle(1f), null}));
    refuses(
        "getParts()[1]",
        () -> box.createFixture(def, () -> new Shape[] {Make.circle(1f), Make.circle(-1f)}));
    assertEquals(1, box.m_fixtureCount);
  }

  @Test
  void fixtureSetters() {
    refusesNonFiniteAndNegative("density", fixture::setDensity);
    refusesNonFiniteAndNegative("friction", fixture::setFriction);
    refusesNonFiniteAndNegative("restitution", fixture::setRestitution);
    refuses("filter", () -> fixture.setFilterData(null));
    refuses("childIndex", () -> fixture.getAABB(1));
    refuses("childIndex", () -> fixture.getAABB(-1));
  }

  @Test
  void contactSetters() {
    Make.steps(world, 2);
    Contact contact = world.getContactList();
    refusesNonFiniteAndNegative("friction", contact::setFriction);
    refusesNonFiniteAndNegative("restitution", contact::setRestitution);
    refusesNonFinite("speed", contact::setTangentSpeed);
  }

  @Test
  void bodySetters() {
    Vec2 zero = new Vec2();
    refusesVectors("position", v -> box.setTransform(v, 0f));
    refusesNonFinite("angle", x -> box.setTransform(new Vec2(), x));
    refusesVectors("v", box::setLinearVelocity);
    refusesNonFinite("w", box::setAngularVelocity);
    refusesVectors("force", v -> box.applyForce(v, zero));
    refusesVectors("point", v -> box.applyForce(zero, v));
    refusesVectors("force", box::applyForceToCenter);
    refusesNonFinite("torque", box::applyTorque);
    refusesVectors("impulse", v -> box.applyLinearImpulse(v, zero));
    refusesVectors("point", v -> box.applyLinearImpulse(zero, v));
    refusesNonFinite("impulse", box::applyAngularImpulse);
    refusesNonFiniteAndNegative("linearDamping", box::setLinearDamping);
    refusesNonFiniteAndNegative("angularDamping", box::setAngularDamping);
    refusesNonFinite("gravityScale", box::setGravityScale);
    refuses("type", () -> box.setType(null));
    // what is refused is refused for static bodies too, though they would not move
    refusesVectors("v", ground::setLinearVelocity);
  }

  @Test
  void massData() {
    refuses("massData", () -> box.setMassData(null));
    refusesNonFinite("massData.mass", x -> mass(x, 1f, 0f));
    refusesNonFinite("massData.I", x -> mass(1f, x, 0f));
    refusesNonFinite("massData.center", x -> mass(1f, 1f, x));
    refuses("massData.I", () -> mass(2f, 1f, 1f));
  }

  private void mass(float mass, float inertia, float x) {
    MassData data = new MassData();
    data.mass = mass;
    data.I = inertia;
    data.center.x = x;
    box.setMassData(data);
  }

  @Test
  void worldCalls() {
    refusesVectors("gravity", World::new);
    refusesVectors("gravity", world::setGravity);
    refusesNonFiniteAndNegative("dt", x -> world.step(x, 8, 3));
    refuses("iterations", () -> world.step(0.1f, -1, 3));
    refuses("iterations", () -> world.step(0.1f, 8, -3));
    refuses("task", () -> world.defer(null));
    refuses("callback", () -> world.queryAABB(null, new AABB()));
    refuses("aabb", () -> world.queryAABB(f -> true, null));
    refuses("callback", () -> world.raycast(null, new Vec2(), new Vec2(1f, 0f)));
    refusesVectors("point1", v -> world.raycast((f, p, n, x) -> 1f, v, new Vec2(1f, 0f)));
    refusesVectors("point2", v -> world.raycast((f, p, n, x) -> 1f, new Vec2(), v));
    AABB bounds = new AABB(new Vec2(Float.NaN, 0f), new Vec2(1f, 1f));
    refuses("aabb", () -> world.queryAABB(f -> true, bounds));
    assertThrows(IllegalArgumentException.class, () -> world.extension(String.class, w -> null));
  }

  @Test
  void bodiesOfOtherWorldsAndDestroyedOnes() {
    World other = Make.world();
    Body foreign = Make.disc(other, 0f, 0f, 1f);
    refuses("null", () -> world.destroyBody(null));
    refuses("not of this world", () -> world.destroyBody(foreign));
    other.destroyBody(foreign);
    refuses("destroyed before", () -> other.destroyBody(foreign));
    String destroyed = "destroyed";
    assertRefusedState(destroyed, () -> foreign.createFixture(Make.circle(1f), 1f));
    assertRefusedState(destroyed, () -> foreign.setTransform(new Vec2(), 0f));
    assertRefusedState(destroyed, () -> foreign.setType(BodyType.STATIC));
    assertRefusedState(destroyed, () -> foreign.setActive(false));
    assertEquals(0, other.getBodyCount());
    assertEquals(0, other.getProxyCount());
  }

  private static void assertRefusedState(String text, Runnable call) {
    IllegalStateException e = assertThrows(IllegalStateException.class, call::run);
    assertTrue(e.getMessage().contains(text), e.getMessage());
  }

  @Test
  void fixturesOfOtherBodiesAndDestroyedOnes() {
    refuses("null", () -> box.destroyFixture(null));
    refuses("not of this body", () -> ground.destroyFixture(fixture));
    Fixture second = box.createFixture(Make.circle(0.2f), 0f);
    box.destroyFixture(second);
    refuses("destroyed before", () -> box.destroyFixture(second));
  }

  @Test
  void joints() {
    World other = Make.world();
    Body foreign = Make.disc(other, 0f, 0f, 1f);
    refuses("def", () -> world.createJoint(null));
    refuses("bodyA", () -> world.createJoint(mouse(null, box)));
    refuses("bodyB", () -> world.createJoint(mouse(ground, null)));
    refuses("bodyA", () -> world.createJoint(mouse(foreign, box)));
    refuses("bodyB", () -> world.createJoint(mouse(ground, foreign)));
    JointDef unknown = new JointDef();
    unknown.bodyA = ground;
    unknown.bodyB = box;
    assertThrows(IllegalArgumentException.class, () -> world.createJoint(unknown));
    refuses("null", () -> world.destroyJoint(null));
    Joint joint = world.createJoint(mouse(ground, box));
    refuses("not of this world", () -> other.destroyJoint(joint));
    world.destroyJoint(joint);
    refuses("destroyed before", () -> world.destroyJoint(joint));
  }

  private static MouseJointDef mouse(Body a, Body b) {
    MouseJointDef def = new MouseJointDef();
    def.bodyA = a;
    def.bodyB = b;
    def.collideConnected = true;
    if (b != null) {
      def.target.set(b.getPosition());
    }
    return def;
  }

  /** Degenerate but finite: points that coincide, thin and tiny shapes, all in one place. */
  @Test
  void degenerateSceneStaysFinite() {
    World pile = Make.world();
    Make.ground(pile);
    Random random = new Random(11);
    EdgeShape point = new EdgeShape();
    point.set(new Vec2(0f, 0.1f), new Vec2(0f, 0.1f));
    Make.body(pile, BodyType.STATIC, 0f, 0f).createFixture(point, 0f);
    for (int i = 0; i < 12; i++) {
      Make.disc(pile, 0f, 1f, 0.3f);
      Make.box(pile, BodyType.DYNAMIC, 0f, 1f, 0.3f, 0.3f);
      Make.box(pile, BodyType.DYNAMIC, 0f, 1f, 0.5f, 0.006f);
      Make.disc(pile, random.nextFloat(), 2f, 0.001f);
    }
    for (int i = 0; i < 200; i++) {
      pile.step(Make.STEP, 8, 3);
      WorldInvariants.check(pile);
    }
  }
}
