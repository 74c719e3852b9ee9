package glass.android;

import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.World;
import org.jbox2d.fracture.FractureListener;
import org.jbox2d.fracture.FractureSystem;
import org.jbox2d.fracture.Material;

/** A shop window and balls for it; knows nothing of Android. */
final class Shop {
  private static final float STEP = 1f / 60;

  final World world = new World(new Vec2(0, -9.81f));
  private float due;

  Shop(FractureListener listener) {
    PolygonShape box = new PolygonShape();
    box.setAsBox(20, 1, new Vec2(0, -1), 0);
    world.createBody(new BodyDef()).createFixture(box, 0);
    box.setAsBox(0.3f, 3);
    Material glass = Material.GLASS.copy();
    glass.m_rigidity = 20;
    body(4, 3).createFixture(box, 1).m_material = glass;
    FractureSystem.of(world).setListener(listener);
  }

  void throwBall(float x, float y) {
    CircleShape ball = new CircleShape();
    ball.setRadius(0.4f);
    Body body = body(x, y);
    body.createFixture(ball, 5);
    body.setLinearVelocity(new Vec2(40, 0));
  }

  /** Lets time pass, in steps of one length however long the frame was. */
  void advance(float seconds) {
    due = Math.min(due + seconds, 0.25f);
    while (due >= STEP) {
      world.step(STEP, 8, 3);
      due -= STEP;
    }
  }

  private Body body(float x, float y) {
    BodyDef def = new BodyDef();
    def.type = BodyType.DYNAMIC;
    def.position.set(x, y);
    return world.createBody(def);
  }
}
