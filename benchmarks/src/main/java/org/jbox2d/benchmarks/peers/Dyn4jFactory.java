package org.jbox2d.benchmarks.peers;

import org.dyn4j.dynamics.Body;
import org.dyn4j.dynamics.BodyFixture;
import org.dyn4j.geometry.Geometry;
import org.dyn4j.geometry.MassType;
import org.dyn4j.geometry.Vector2;
import org.dyn4j.world.World;
import org.jbox2d.benchmarks.SceneFactory;
import org.jbox2d.benchmarks.SteppedScene;
import org.jbox2d.benchmarks.scenes.Catalogue;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.Fixture;

/**
 * Builds a scene in our engine and copies its bodies into a dyn4j world. What a scene does each
 * frame besides the step is not copied, nor are joints: it serves scenes of polygons alone.
 */
final class Dyn4jFactory implements SceneFactory {
  private static final double DT = 1.0 / 60.0;

  @Override
  public SteppedScene build(String name) {
    org.jbox2d.dynamics.World source = new Catalogue().buildWorld(name);
    World<Body> world = new World<>();
    Vec2 g = source.getGravity();
    world.setGravity(new Vector2(g.x, g.y));
    world.getSettings().setAtRestDetectionEnabled(source.isSleepingAllowed());
    world.getSettings().setVelocityConstraintSolverIterations(8);
    world.getSettings().setPositionConstraintSolverIterations(3);
    for (org.jbox2d.dynamics.Body b = source.getBodyList(); b != null; b = b.getNext()) {
      world.addBody(copy(b));
    }
    return new SteppedScene() {
      @Override
      public void step() {
        world.step(1, DT);
      }

      @Override
      public int bodyCount() {
        return world.getBodyCount();
      }
    };
  }

  private static Body copy(org.jbox2d.dynamics.Body b) {
    Body copy = new Body();
    for (Fixture f = b.getFixtureList(); f != null; f = f.getNext()) {
      PolygonShape shape = (PolygonShape) f.getShape();
      Vector2[] vertices = new Vector2[shape.getVertexCount()];
      for (int i = 0; i < vertices.length; i++) {
        Vec2 v = shape.getVertex(i);
        vertices[i] = new Vector2(v.x, v.y);
      }
      BodyFixture fixture = copy.addFixture(Geometry.createPolygon(vertices));
      fixture.setDensity(f.getDensity() > 0f ? f.getDensity() : 1.0);
      fixture.setFriction(f.getFriction());
      fixture.setRestitution(f.getRestitution());
    }
    copy.setMass(b.getType() == BodyType.DYNAMIC ? MassType.NORMAL : MassType.INFINITE);
    copy.translate(b.getPosition().x, b.getPosition().y);
    copy.setLinearVelocity(b.getLinearVelocity().x, b.getLinearVelocity().y);
    copy.setAngularVelocity(b.getAngularVelocity());
    return copy;
  }
}
