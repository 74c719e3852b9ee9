package org.jbox2d.fracture.impact;

import org.jbox2d.dynamics.CompoundShape;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.fracture.Material;

/**
 * What blows that did not break a fixture have left in it, N s. Kept with the fixture; all parts of
 * a compound have the same.
 *
 * <p>With p the rigidity and t the toughness of a material, a blow of intensity i, {@code t < i <=
 * p - D}, adds {@code i - t} to the damage D; the fixture breaks by {@code i > max(t, p - D)}. As
 * intensities do not depend on the step or on resting loads, neither does damage.
 */
public final class Damage {
  private final float amount;

  private Damage(float amount) {
    this.amount = amount;
  }

  /** Returns the damage of a fixture, N s; 0 if it has none. */
  public static float of(Fixture fixture) {
    Object state = fixture.m_materialState;
    return state instanceof Damage ? ((Damage) state).amount : 0f;
  }

  /** Returns the impulse above which a fixture breaks, N s. */
  public static float rigidityLeft(Fixture fixture, Material material) {
    float damage = of(fixture);
    if (!(damage > 0f)) {
      return material.m_rigidity;
    }
    float least = Math.min(material.m_toughness, material.m_rigidity);
    return Math.max(least, material.m_rigidity - damage);
  }

  /** Returns the impulse above which a blow on a fixture matters at all, N s. */
  static float threshold(Material material) {
    return Math.min(material.m_toughness, material.m_rigidity);
  }

  /** Adds a blow that did not break; returns whether it did damage. */
  public static boolean add(Fixture fixture, Material material, float intensity) {
    float more = intensity - material.m_toughness;
    if (!(more > 0f)) {
      return false;
    }
    set(fixture, new Damage(of(fixture) + more));
    return true;
  }

  /** Mends a fixture and the others of its compound. */
  public static void clear(Fixture fixture) {
    set(fixture, null);
  }

  private static void set(Fixture fixture, Damage damage) {
    CompoundShape compound = fixture.getCompound();
    if (compound == null) {
      fixture.m_materialState = damage;
      return;
    }
    for (Fixture f = fixture.getBody().getFixtureList(); f != null; f = f.getNext()) {
      if (f.getCompound() == compound) {
        f.m_materialState = damage;
      }
    }
  }
}
