package org.jbox2d.fracture;

import org.jbox2d.fracture.materials.Diffusion;
import org.jbox2d.fracture.materials.Glass;
import org.jbox2d.fracture.materials.Uniform;

/**
 * The constants of {@link Material}. They are of its subclasses; were they static fields of the
 * class itself, two threads of which one first uses {@code Material} and the other {@code Glass}
 * could wait for each other's class initialisation for ever. An interface is initialised only when
 * a field of it is read.
 */
interface MaterialConstants {
  /** Sites spread evenly over a square around the contact. */
  Material UNIFORM = Material.constant("Material.UNIFORM", new Uniform());

  /** Sites that lie the denser the nearer the contact. */
  Material DIFFUSION = Material.constant("Material.DIFFUSION", new Diffusion());

  /** Sites on circles around the contact. */
  Material GLASS = Material.constant("Material.GLASS", new Glass());
}
