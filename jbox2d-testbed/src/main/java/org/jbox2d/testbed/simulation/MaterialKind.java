package org.jbox2d.testbed.simulation;

import java.util.List;
import org.jbox2d.fracture.Material;
import org.jbox2d.fracture.materials.Bricks;
import org.jbox2d.fracture.materials.Diffusion;
import org.jbox2d.fracture.materials.Glass;
import org.jbox2d.fracture.materials.Radial;
import org.jbox2d.fracture.materials.Splinters;
import org.jbox2d.fracture.materials.Uniform;
import org.jbox2d.testbed.parameters.Parameter;

/** The choice by what material things break, whatever the scene has made them of. */
final class MaterialKind {
  static final Parameter PARAMETER =
      Parameter.choice(
          Parameter.Group.MATERIAL,
          "material",
          List.of("as-built", "uniform", "diffusion", "glass", "radial", "splinters", "bricks"),
          0,
          "How things break, whatever the scene has made them of.");

  private MaterialKind() {}

  /**
   * Returns a material of a kind with the values of another.
   *
   * @param kind index of the choice; 0 gives the other itself
   */
  static Material of(int kind, Material like) {
    Material material = make(kind);
    if (material == null) {
      return like;
    }
    material.m_rigidity = like.m_rigidity;
    material.m_shattering = like.m_shattering;
    material.m_radius = like.m_radius;
    material.m_fragments = like.m_fragments == null ? null : material;
    return material;
  }

  private static Material make(int kind) {
    return switch (PARAMETER.choices().get(kind)) {
      case "uniform" -> new Uniform();
      case "diffusion" -> new Diffusion();
      case "glass" -> new Glass();
      case "radial" -> new Radial();
      case "splinters" -> new Splinters();
      case "bricks" -> new Bricks();
      default -> null;
    };
  }
}
