package org.jbox2d.testbed.scenes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.MassData;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.dynamics.World;
import org.jbox2d.fracture.Material;
import org.junit.jupiter.api.Test;

class ScenesTest {
  private static final float ROUNDING = 1e-4f;

  @Test
  void namesAreUniqueAndWellFormed() {
    Set<String> names = new HashSet<>();
    for (Scene scene : Scenes.all()) {
      assertTrue(scene.name().matches("[a-z]+(-[a-z]+)*"), scene.name());
      assertTrue(names.add(scene.name()), scene.name());
      assertFalse(scene.title().isBlank());
      assertTrue(scene.shows().endsWith("."), scene.shows());
      assertSame(scene, Scenes.named(scene.name()));
    }
  }

  @Test
  void scenesOfTheThesisComeFirstInItsOrder() {
    List<String> expected =
        List.of(
            "main",
            "cube",
            "circle",
            "rotated-body",
            "static-body",
            "material-uniform",
            "material-diffusion",
            "material-glass");
    assertEquals(
        expected, Scenes.all().subList(0, expected.size()).stream().map(Scene::name).toList());
  }

  @Test
  void unknownSceneIsNamedWithThoseThereAre() {
    IllegalArgumentException e =
        assertThrows(IllegalArgumentException.class, () -> Scenes.named("Main"));
    assertTrue(e.getMessage().contains("'Main'"), e.getMessage());
    assertTrue(e.getMessage().contains("material-glass"), e.getMessage());
  }

  @Test
  void mainSceneHasTheNumbersOfTheThesis() {
    World world = Scenes.named("main").newWorld(1);
    assertEquals(-9.81f, world.getGravity().y);
    Body disc = world.getBodyList();
    Body box = disc.getNext();
    assertEquals(new Vec2(-30f, 5.3f), disc.getPosition());
    assertEquals(new Vec2(100f, 0f), disc.getLinearVelocity());
    CircleShape circle = (CircleShape) disc.getFixtureList().getShape();
    assertEquals(1f, circle.m_radius);
    assertEquals(5f, disc.getFixtureList().getDensity());
    assertEquals(0.4f, disc.getFixtureList().getFriction());
    assertEquals(0.1f, disc.getFixtureList().getRestitution());
    assertEquals(new Vec2(0f, 5f), box.getPosition());
    assertEquals(100f, box.getMass(), ROUNDING);
    Fixture fixture = box.getFixtureList();
    assertEquals(0.2f, fixture.getFriction());
    assertEquals(0f, fixture.getRestitution());
    Material material = (Material) fixture.getMaterial();
    assertEquals(40f, material.m_rigidity);
    assertEquals(3f, material.m_shattering);
  }

  @Test
  void staticBodyIsTheConcavePolygonOfTheThesis() {
    World world = Scenes.named("static-body").newWorld(1);
    Body pillar = world.getBodyList().getNext();
    assertEquals(BodyType.STATIC, pillar.getType());
    double area = 0;
    MassData data = new MassData();
    for (Fixture f = pillar.getFixtureList(); f != null; f = f.getNext()) {
      f.getMassData(data);
      area += data.mass;
    }
    // Shoelace formula over the digest's eight vertices.
    assertEquals(71.51, area, 0.01);
  }

  /** Each scene is built twice; materials and definitions must not be shared between builds. */
  @Test
  void buildingTwiceSharesNoMaterial() {
    for (Scene scene : Scenes.all()) {
      World first = scene.newWorld(1);
      World second = scene.newWorld(1);
      assertEquals(first.getBodyCount(), second.getBodyCount(), scene.name());
      Body b = second.getBodyList();
      for (Body a = first.getBodyList(); a != null; a = a.getNext(), b = b.getNext()) {
        assertNotNull(b);
        assertEquals(a.getPosition(), b.getPosition(), scene.name());
        Fixture fa = a.getFixtureList();
        if (fa.getMaterial() != null) {
          assertTrue(fa.getMaterial() != b.getFixtureList().getMaterial(), scene.name());
        }
      }
    }
  }
}
