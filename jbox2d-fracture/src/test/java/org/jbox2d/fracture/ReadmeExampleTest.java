package org.jbox2d.fracture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.EdgeShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.dynamics.World;
import org.junit.jupiter.api.Test;

/**
 * The example of the README compiles and runs, and is the one in the README; the thesis'
 * introductory listing (2.2) runs as it is.
 */
class ReadmeExampleTest {
  // README example begins
  static World breakingGlass() {
    World world = new World(new Vec2(0, -9.81f));

    Body ground = world.createBody(new BodyDef());
    PolygonShape floor = new PolygonShape();
    floor.setAsBox(40, 1, new Vec2(0, -1), 0);
    ground.createFixture(floor, 0);

    BodyDef def = new BodyDef();
    def.type = BodyType.DYNAMIC;
    def.position.set(0, 5);
    PolygonShape pane = new PolygonShape();
    pane.setAsBox(1, 5);
    Fixture glass = world.createBody(def).createFixture(pane, 1);
    glass.m_material = Material.GLASS;

    def.position.set(-20, 6);
    def.linearVelocity.set(60, 0);
    CircleShape ball = new CircleShape();
    ball.setRadius(0.5f);
    world.createBody(def).createFixture(ball, 5);
    return world;
  }

  // README example ends

  @Test
  void exampleBreaks() {
    World world = breakingGlass();
    Range.step(world, 60f, 2f);
    assertTrue(world.getBodyCount() > 10, world.getBodyCount() + " bodies");
  }

  @Test
  void exampleIsTheOneOfTheReadme() throws Exception {
    String readme = read(Paths.get("..", "README.md"));
    Path self =
        Paths.get("src", "test", "java", "org", "jbox2d", "fracture", "ReadmeExampleTest.java");
    String source = read(self);
    int begin = source.indexOf("begins\n") + "begins\n".length();
    int end = source.indexOf("  // README example ends");
    String example = source.substring(begin, end).trim();
    assertTrue(
        withoutIndent(readme).contains(withoutIndent(example)), "the README's example differs");
  }

  private static String withoutIndent(String text) {
    return text.replaceAll("(?m)^ +", "").replaceAll("\\n+", "\n");
  }

  private static String read(Path path) throws Exception {
    return new String(Files.readAllBytes(path), StandardCharsets.UTF_8);
  }

  /** Thesis, section 2.2 and 8.2: the words of the listing, with its slips of the pen corrected. */
  @Test
  void introductorySceneOfTheThesis() {
    World w = new World(new Vec2(0, -9.81f));
    BodyDef bd = new BodyDef();
    bd.setType(BodyType.STATIC);
    Body ground = w.createBody(bd);
    EdgeShape edge = new EdgeShape();
    edge.set(new Vec2(-10, 0), new Vec2(10, 0));
    Fixture f1 = ground.createFixture(edge, 0.0f);
    bd.type = BodyType.DYNAMIC;
    bd.position = new Vec2(0.0f, 5.0f);
    Body target = w.createBody(bd);
    PolygonShape cube = new PolygonShape();
    cube.setAsBox(5.0f, 5.0f);
    Fixture f2 = target.createFixture(cube, 1.0f);
    f2.m_friction = 0.2f;
    f2.m_restitution = 0.0f;
    f2.m_material = Material.UNIFORM;
    bd.type = BodyType.DYNAMIC;
    bd.position = new Vec2(-30.0f, 5.3f);
    bd.linearVelocity = new Vec2(100.0f, 0.0f);
    Body bullet = w.createBody(bd);
    CircleShape circle = new CircleShape();
    circle.m_radius = 1.0f;
    Fixture f3 = bullet.createFixture(circle, 2.0f);
    f3.m_friction = 0.4f;
    f3.m_restitution = 0.1f;
    for (int i = 0; i < 60; i++) {
      w.step(1f / 60, 8, 8);
    }
    assertTrue(w.getBodyCount() > 10, w.getBodyCount() + " bodies");
    int fixtures = 0;
    for (Body b = w.getBodyList(); b != null; b = b.getNext()) {
      for (Fixture f = b.m_fixtureList; f != null; f = f.m_next) {
        fixtures++;
      }
    }
    assertTrue(fixtures >= w.getBodyCount());
    assertEquals(ground, f1.getBody());
  }
}
