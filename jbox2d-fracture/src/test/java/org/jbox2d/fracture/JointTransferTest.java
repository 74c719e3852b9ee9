package org.jbox2d.fracture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.jbox2d.callbacks.DestructionListener;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.dynamics.World;
import org.jbox2d.dynamics.joints.Joint;
import org.jbox2d.dynamics.joints.JointEdge;
import org.jbox2d.dynamics.joints.RevoluteJointDef;
import org.junit.jupiter.api.Test;

/**
 * Joints of a body that breaks: each goes to the piece that holds its anchor. Defect 16 of the
 * reference: they were lost.
 */
class JointTransferTest {
  private final World world = new World(new Vec2(0, -10));
  private final FractureSystem system = FractureSystem.of(world);
  private final Body ground = Range.body(world, BodyType.STATIC, 0, 30);
  private final Body box = Range.wall(world, BodyType.DYNAMIC, 5f, Range.uniform(50f, 3f));
  private final List<Joint> gone = new ArrayList<>();

  private Joint pinAt(float x, float y) {
    RevoluteJointDef def = new RevoluteJointDef();
    def.initialize(ground, box, new Vec2(x, y));
    return world.createJoint(def);
  }

  private List<Body> strike(float x, float y) {
    return system.strike(box.getFixtureList(), new Vec2(x, y), new Vec2(400, 0));
  }

  private static boolean holds(Body body, Vec2 p) {
    for (Fixture f = body.getFixtureList(); f != null; f = f.getNext()) {
      if (f.testPoint(p)) {
        return true;
      }
    }
    return false;
  }

  private static boolean lists(Body body, Joint joint) {
    for (JointEdge edge = body.getJointList(); edge != null; edge = edge.next) {
      if (edge.joint == joint) {
        return true;
      }
    }
    return false;
  }

  @Test
  void jointFarFromTheBlowStaysWithTheRemainder() {
    Joint pin = pinAt(4, 4);
    List<Body> pieces = strike(-5, -2);
    assertTrue(pieces.size() > 3);
    assertSame(box, pin.getBodyB());
    assertSame(box, pieces.get(0));
    assertTrue(lists(box, pin) && lists(ground, pin));
  }

  @Test
  void jointInASplinterGoesWithIt() {
    Vec2 anchor = new Vec2(-4.6f, 0.3f);
    Joint pin = pinAt(anchor.x, anchor.y);
    strike(-5, 0);
    Body holder = pin.getBodyB();
    assertNotSame(box, holder);
    assertTrue(holds(holder, anchor));
    assertTrue(lists(holder, pin) && lists(ground, pin));
    assertFalse(lists(box, pin));
    assertEquals(1, world.getJointCount());
    // It holds: the splinter swings about its pin, and the rest falls.
    Range.step(world, 60f, 1f);
    Vec2 now = new Vec2();
    pin.getAnchorB(now);
    assertEquals(0, now.sub(anchor).length(), 0.02);
    assertTrue(box.getWorldCenter().y < -3);
  }

  @Test
  void jointWithoutAPieceSaysGoodbye() {
    world.setDestructionListener(
        new DestructionListener() {
          @Override
          public void sayGoodbye(Joint joint) {
            gone.add(joint);
          }

          @Override
          public void sayGoodbye(Fixture fixture) {}
        });
    box.getFixtureList().m_material = everywhere();
    Joint pin = pinAt(20, 20);
    List<Body> pieces = strike(-5, 0);
    assertTrue(pieces.size() > 3 && !pieces.contains(box), "all of it broke away");
    assertEquals(List.of(pin), gone);
    assertEquals(0, world.getJointCount());
    assertEquals(null, ground.getJointList());
    Range.step(world, 60f, 0.5f);
  }

  @Test
  void jointOfTwoBodiesThatBothBreak() {
    Body other = Range.body(world, BodyType.DYNAMIC, 8f, 0f);
    Range.fixture(other, Range.box(3f, 3f), 1f, Range.uniform(50f, 3f));
    RevoluteJointDef def = new RevoluteJointDef();
    Vec2 anchor = new Vec2(4.9f, 0.2f);
    def.initialize(box, other, anchor);
    def.collideConnected = true;
    Joint hinge = world.createJoint(def);
    strike(5, 0);
    system.strike(other.getFixtureList(), new Vec2(5, 0), new Vec2(400, 0));
    assertTrue(holds(hinge.getBodyA(), anchor));
    assertTrue(lists(hinge.getBodyA(), hinge) && lists(hinge.getBodyB(), hinge));
    assertSame(hinge.getBodyB(), hinge.m_edgeA.other);
    assertSame(hinge.getBodyA(), hinge.m_edgeB.other);
    Range.step(world, 60f, 0.5f);
    assertEquals(1, world.getJointCount());
  }

  private static Material everywhere() {
    Material m = Range.uniform(50f, 8f);
    m.m_radius = 100f;
    return m;
  }
}
