package org.jbox2d.fracture;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.World;
import org.jbox2d.fracture.materials.Diffusion;
import org.jbox2d.fracture.materials.Glass;
import org.jbox2d.fracture.materials.Uniform;
import org.junit.jupiter.api.Test;

class MaterialTest {
  @Test
  void defaultsAreThoseOfTheThesis() {
    for (Material m : new Material[] {new Uniform(), new Diffusion()}) {
      assertEquals(64f, m.m_rigidity);
      assertEquals(4f, m.m_shattering);
      assertEquals(2f, m.m_radius);
      assertSame(m, m.m_fragments);
    }
    assertEquals(1f, new Glass().m_shattering);
    assertEquals(4f, new Glass().m_radius);
  }

  @Test
  void uniformFillsItsSquare() {
    Uniform m = new Uniform();
    Vec2 d = new Vec2(3, -2);
    Vec2[] sites = m.focee(d, new Vec2(1, 0), new SiteRandom(7));
    assertEquals(100, sites.length);
    float half = 2.5f * m.m_shattering / 2;
    double meanX = 0;
    double spread = 0;
    for (Vec2 v : sites) {
      assertTrue(Math.abs(v.x - d.x) <= half && Math.abs(v.y - d.y) <= half, "outside: " + v);
      meanX += (v.x - d.x) / sites.length;
      spread += (v.x - d.x) * (v.x - d.x) / sites.length;
    }
    // Variance of a uniform distribution of width 2h: h^2/3; standard error of 100 samples about 9
    // %.
    assertEquals(half * half / 3, spread, 0.3 * half * half / 3);
    assertEquals(0, meanX, half * 0.2);
  }

  @Test
  void diffusionStretchesAlongTheImpact() {
    Diffusion m = new Diffusion();
    Vec2 along = new Vec2(3, 4);
    double[] spread = new double[2];
    for (int seed = 0; seed < 40; seed++) {
      for (Vec2 v : m.focee(new Vec2(), along, new SiteRandom(seed))) {
        double a = (v.x * 3 + v.y * 4) / 5;
        double b = (v.x * 4 - v.y * 3) / 5;
        spread[0] += a * a;
        spread[1] += b * b;
      }
    }
    // c = 4: sixteen times the variance; 5,120 samples of a heavy tail.
    assertEquals(16, spread[0] / spread[1], 2.5);
  }

  @Test
  void glassLiesOnCircles() {
    Glass m = new Glass();
    m.m_shattering = 2f;
    Vec2 d = new Vec2(-1, 5);
    Vec2[] sites = m.focee(d, new Vec2(), new SiteRandom(3));
    assertEquals(120, sites.length);
    for (int i = 0; i < sites.length; i++) {
      double r = Math.hypot(sites[i].x - d.x, sites[i].y - d.y);
      assertEquals(2.0 * (1 + i / 30), r, 2.0 / 40 + 1e-5);
    }
  }

  @Test
  void sitesAreAFunctionOfTheArguments() {
    for (Material m : new Material[] {new Uniform(), new Diffusion(), new Glass()}) {
      Vec2[] once = m.focee(new Vec2(1, 2), new Vec2(3, 4));
      Vec2[] again = m.focee(new Vec2(1, 2), new Vec2(3, 4));
      assertArrayEquals(once, again);
      assertNotEquals(once[0], m.focee(new Vec2(1, 2), new Vec2(3, 5))[0]);
    }
  }

  @Test
  void zeroImpactVectorGivesFiniteSites() {
    for (Material m : new Material[] {new Uniform(), new Diffusion(), new Glass()}) {
      for (Vec2 v : m.focee(new Vec2(), new Vec2())) {
        assertTrue(Float.isFinite(v.x) && Float.isFinite(v.y));
      }
    }
  }

  @Test
  void copyOfAConstantIsItsOwnMaterial() {
    Material copy = Material.GLASS.copy();
    assertNotSame(Material.GLASS, copy);
    assertTrue(copy instanceof Glass);
    assertSame(copy, copy.m_fragments);
    copy.m_rigidity = 1f;
    assertEquals(64f, Material.GLASS.m_rigidity);
  }

  /** Defect 18 of the reference: scenes that set a value of a constant changed each other. */
  @Test
  void changedConstantIsReported() {
    World world = new World(new Vec2());
    Range.wall(world, BodyType.DYNAMIC, 1f, Material.UNIFORM);
    Range.disc(world, -4f, 0f, 0.5f, 1f, 50f, 0f);
    Material.UNIFORM.m_rigidity = 5f;
    try {
      IllegalStateException e =
          assertThrows(IllegalStateException.class, () -> Range.step(world, 60f, 1f));
      assertTrue(e.getMessage().contains("Material.UNIFORM"), e.getMessage());
    } finally {
      Material.UNIFORM.m_rigidity = Material.DEFAULT_RIGIDITY;
    }
    assertTrue(!world.isLocked());
  }

  @Test
  void nonsensicalValuesAreNamed() {
    World world = new World(new Vec2());
    Uniform m = Range.uniform(Float.NaN, 1f);
    Range.wall(world, BodyType.DYNAMIC, 1f, m);
    Range.disc(world, -4f, 0f, 0.5f, 1f, 50f, 0f);
    IllegalStateException e =
        assertThrows(IllegalStateException.class, () -> Range.step(world, 60f, 1f));
    assertTrue(e.getMessage().contains("NaN"), e.getMessage());
  }
}
