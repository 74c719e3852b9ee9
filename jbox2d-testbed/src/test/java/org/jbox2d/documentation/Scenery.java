package org.jbox2d.documentation;

import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.World;

/**
 * What the snippets of the documents take for granted: a world, a body without fixtures, a shape.
 */
public class Scenery implements Runnable {
  protected final World world = new World(new Vec2(0, -9.81f));
  protected final Body ground = world.createBody(new BodyDef());
  protected final Body body;
  protected final PolygonShape box = new PolygonShape();
  protected int score;

  protected Scenery() {
    box.setAsBox(40, 1, new Vec2(0, -1), 0);
    ground.createFixture(box, 0);
    BodyDef def = new BodyDef();
    def.type = BodyType.DYNAMIC;
    def.position.set(0, 3);
    body = world.createBody(def);
    box.setAsBox(1, 1);
  }

  /** A snippet of statements is the body of this. */
  @Override
  public void run() {}
}
