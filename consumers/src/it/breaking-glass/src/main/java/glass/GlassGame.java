package glass;

import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;
import org.jbox2d.fracture.FractureSystem;
import org.jbox2d.fracture.Material;

/** Four panes of glass in a row, and balls to throw at them. */
public final class GlassGame {
  private static final float STEP = 1f / 60;

  private final World world = new World(new Vec2(0, -9.81f));
  private final Material glass = Material.GLASS.copy();
  private float due;
  private int score;

  public GlassGame() {
    PolygonShape floor = new PolygonShape();
    floor.setAsBox(40, 1, new Vec2(0, -1), 0);
    world.createBody(new BodyDef()).createFixture(floor, 0);

    glass.m_rigidity = 20;
    for (int i = 0; i < 4; i++) {
      addPane(5 * i, 3);
    }
    FractureSystem.of(world)
        .setListener((material, intensity, fragments) -> score += fragments.size());
  }

  private void addPane(float x, float y) {
    PolygonShape pane = new PolygonShape();
    pane.setAsBox(0.4f, 3);
    FixtureDef fixture = new FixtureDef();
    fixture.shape = pane;
    fixture.density = 1;
    fixture.friction = 0.6f;
    fixture.material = glass;
    body(x, y).createFixture(fixture);
  }

  /** Throws a ball of half a metre; all lengths are in metres. */
  public void throwBall(Vec2 from, Vec2 velocity) {
    CircleShape ball = new CircleShape();
    ball.setRadius(0.5f);
    Body body = body(from.x, from.y);
    body.createFixture(ball, 5);
    body.setLinearVelocity(velocity);
  }

  private Body body(float x, float y) {
    BodyDef def = new BodyDef();
    def.type = BodyType.DYNAMIC;
    def.position.set(x, y);
    return world.createBody(def);
  }

  /** Lets time pass, in steps of one length however long the frame was. */
  public void advance(float seconds) {
    due = Math.min(due + seconds, 0.25f);
    while (due >= STEP) {
      world.step(STEP, 8, 3);
      due -= STEP;
    }
  }

  public World world() {
    return world;
  }

  /** Pieces made so far. */
  public int score() {
    return score;
  }
}
