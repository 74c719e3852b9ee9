package org.jbox2d.fracture.assembly;

import java.util.ArrayList;
import java.util.List;
import org.jbox2d.dynamics.Fixture;

/** Remainders and unbroken fixtures that hang together: one body. */
final class Cluster {
  final List<Piece> remainders = new ArrayList<>();

  /** Fixtures that did not break, those of a compound in one group. */
  final List<List<Fixture>> others = new ArrayList<>();

  boolean holds(Fixture f) {
    for (List<Fixture> group : others) {
      if (group.contains(f)) {
        return true;
      }
    }
    return false;
  }

  /** Mass by density and area, by which the part that keeps the body's identity is chosen. */
  double mass(float density) {
    double mass = 0;
    for (Piece piece : remainders) {
      mass += density * piece.outline.area();
    }
    for (List<Fixture> group : others) {
      for (Fixture f : group) {
        mass += f.getDensity() * PartShapes.area(f.getShape());
      }
    }
    return mass;
  }
}
