package org.jbox2d.fracture.materials;

import org.jbox2d.common.Vec2;
import org.jbox2d.fracture.Material;
import org.jbox2d.fracture.SiteRandom;

/**
 * A material made from any function of the impact:
 *
 * <pre>
 *   Material cross = new FunctionMaterial((d, v, random) -&gt; fourSitesAround(d));
 * </pre>
 *
 * The material may be used by several worlds on different threads if the function may.
 */
public class FunctionMaterial extends Material {
  /** Where the sites of a fracture are. */
  @FunctionalInterface
  public interface Function {
    /**
     * Returns the sites of a fracture, as {@link Material#focee(Vec2, Vec2, SiteRandom)}. The
     * result must depend on nothing but the arguments, or the same scene breaks otherwise the next
     * time. Without a site, or with one that is not finite, the fracture is called off.
     *
     * @param contactPoint where the blow struck, in the body's frame, m; the function's to keep
     * @param contactVector velocity of the striking body relative to the struck one, in the body's
     *     frame, m/s; may be zero; the function's to keep
     * @param random the only source of chance
     */
    Vec2[] sites(Vec2 contactPoint, Vec2 contactVector, SiteRandom random);
  }

  private final Function function;

  /**
   * The default values of {@link Material}; the function decides whether {@link #m_shattering}
   * means anything.
   *
   * @throws IllegalArgumentException if the function is {@code null}
   */
  public FunctionMaterial(Function function) {
    if (function == null) {
      throw new IllegalArgumentException("function is null");
    }
    this.function = function;
  }

  @Override
  public Vec2[] focee(Vec2 contactPoint, Vec2 contactVector) {
    return focee(contactPoint, contactVector, randomOf(contactPoint, contactVector));
  }

  @Override
  public Vec2[] focee(Vec2 contactPoint, Vec2 contactVector, SiteRandom random) {
    return function.sites(contactPoint.clone(), contactVector.clone(), random);
  }
}
