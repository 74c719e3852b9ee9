package org.jbox2d.fracture;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.dynamics.FixtureMaterial;
import org.jbox2d.dynamics.SolvedContact;
import org.jbox2d.fracture.impact.RequestBook;

/**
 * What a breakable fixture is made of: how hard a blow it takes, and how it breaks. A fixture whose
 * material is {@code null} never breaks.
 *
 * <p>A kind of material is defined by its sites ({@link #focee}): the body breaks along the Voronoi
 * cells of the sites. A material may be shared by many fixtures and by worlds on different threads,
 * as long as nobody changes it meanwhile.
 *
 * <p>{@link #UNIFORM}, {@link #DIFFUSION} and {@link #GLASS} are constants: to change a value take
 * a copy, {@code Material.GLASS.copy()}, or make one, {@code new Glass()}. Changing a field of a
 * constant is reported by an IllegalStateException at the next blow on a fixture that has it.
 */
public abstract class Material implements FixtureMaterial, MaterialConstants, Cloneable {
  /** Default of {@link #m_rigidity}, N s. */
  public static final float DEFAULT_RIGIDITY = 64f;

  /** Default of {@link #m_shattering}, m. */
  public static final float DEFAULT_SHATTERING = 4f;

  /** Default of {@link #m_radius}, m. */
  public static final float DEFAULT_RADIUS = 2f;

  /** Impulse of a blow above which the fixture breaks, N s; not negative. */
  public float m_rigidity = DEFAULT_RIGIDITY;

  /**
   * Impulse up to which a blow leaves no damage, N s; not negative. A blow between this and the
   * rigidity takes what it has above this off the rigidity that is left, which does not fall below
   * this; so repeated blows break what each of them would not. Infinite by default: weak blows do
   * nothing.
   */
  public float m_toughness = Float.POSITIVE_INFINITY;

  /** Relative size of the fragments, m; positive. */
  public float m_shattering = DEFAULT_SHATTERING;

  /** Radius of the region that breaks away around the contact, m; positive. */
  public float m_radius = DEFAULT_RADIUS;

  /**
   * Material of the splinters; {@code this} by default; {@code null}: they never break. What stays
   * keeps this material.
   */
  public Material m_fragments = this;

  /** The values a constant must keep; {@code null} for any other material. */
  private Constant constant;

  /**
   * A material with the default values. The first material of a program breaks a small box in a
   * world of its own, so that the first fracture of a game does not have to load what fractures
   * need; see {@link FractureSystem#warmUp()}.
   */
  protected Material() {
    Rehearsal.first();
  }

  /**
   * Returns the sites of a fracture. The same arguments must always give the same sites.
   *
   * @param contactPoint where the blow struck, in the body's frame, m
   * @param contactVector velocity of the striking body relative to the struck one, in the body's
   *     frame, m/s; may be zero
   * @return at least one site, in the body's frame; sites may lie outside the body
   */
  public abstract Vec2[] focee(Vec2 contactPoint, Vec2 contactVector);

  /**
   * Returns the sites of a fracture, drawn from the given generator. A material that does not need
   * one leaves this as it is.
   *
   * @param random seeded by the world's seed and the number of the fracture
   */
  public Vec2[] focee(Vec2 contactPoint, Vec2 contactVector, SiteRandom random) {
    return focee(contactPoint, contactVector);
  }

  /**
   * Returns a generator whose seed is made of the arguments' bits, for materials that are random
   * and yet a function of their arguments.
   */
  protected static SiteRandom randomOf(Vec2 contactPoint, Vec2 contactVector) {
    long point = SiteRandom.mix(bits(contactPoint.x), bits(contactPoint.y));
    long vector = SiteRandom.mix(bits(contactVector.x), bits(contactVector.y));
    return new SiteRandom(SiteRandom.mix(point, vector));
  }

  private static long bits(float f) {
    return Float.floatToIntBits(f);
  }

  /**
   * Returns a copy whose fields may be changed. If this material's splinters are of itself, the
   * copy's are of the copy.
   */
  public Material copy() {
    Material copy;
    try {
      copy = (Material) clone();
    } catch (CloneNotSupportedException e) {
      throw new AssertionError("Material is Cloneable", e);
    }
    copy.constant = null;
    if (m_fragments == this) {
      copy.m_fragments = copy;
    }
    return copy;
  }

  /** Returns whether a blow may be hard enough. Called by the engine. */
  @Override
  public final boolean hears(Fixture fixture, float normalImpulse) {
    check();
    return !fixture.isSensor()
        && RequestBook.matters(normalImpulse, this, fixture.getCompound() != null);
  }

  /** Records the blow if it is hard enough. Called by the engine. */
  @Override
  public final void contactSolved(Fixture fixture, SolvedContact solved) {
    FractureSystem.of(fixture.getBody().getWorld()).record(fixture, this, solved);
  }

  /**
   * Checks that the fields make sense.
   *
   * @throws IllegalStateException if not, or if this is a constant that was changed; the message
   *     names the field
   */
  final void check() {
    if (constant != null) {
      constant.check(this);
    }
    if (!(m_rigidity >= 0f && m_toughness >= 0f && m_shattering > 0f && m_radius > 0f)
        || Float.isInfinite(m_shattering)
        || Float.isInfinite(m_radius)) {
      throw new IllegalStateException(
          "a material needs m_rigidity >= 0, m_toughness >= 0, m_shattering > 0 and m_radius > 0;"
              + " they are "
              + m_rigidity
              + ", "
              + m_toughness
              + ", "
              + m_shattering
              + ", "
              + m_radius);
    }
  }

  static Material constant(String name, Material material) {
    material.constant = new Constant(name, material);
    return material;
  }

  private static final class Constant {
    private final String name;
    private final float rigidity;
    private final float toughness;
    private final float shattering;
    private final float radius;
    private final Material fragments;

    Constant(String name, Material material) {
      this.name = name;
      rigidity = material.m_rigidity;
      toughness = material.m_toughness;
      shattering = material.m_shattering;
      radius = material.m_radius;
      fragments = material.m_fragments;
    }

    void check(Material m) {
      if (m.m_rigidity != rigidity
          || m.m_toughness != toughness
          || m.m_shattering != shattering
          || m.m_radius != radius
          || m.m_fragments != fragments) {
        throw new IllegalStateException(
            name + " is shared by all worlds and was changed; change a copy, " + name + ".copy()");
      }
    }
  }
}
