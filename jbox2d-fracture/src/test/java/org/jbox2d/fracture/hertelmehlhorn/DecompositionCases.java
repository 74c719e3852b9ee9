package org.jbox2d.fracture.hertelmehlhorn;

import java.util.Random;
import org.jbox2d.fracture.fragmentation.OutlineKind;
import org.jbox2d.fracture.geometry.Outline;
import org.jbox2d.fracture.geometry.OutlineCheck;
import org.jbox2d.fracture.geometry.OutlineDefect;

/** Random decompositions by number. */
final class DecompositionCases {
  private DecompositionCases() {}

  static Outline make(OutlineKind kind, long seed) {
    Random random = new Random(seed * 31 + kind.ordinal());
    int n = random.nextInt(10) == 0 ? 3 + random.nextInt(510) : 3 + random.nextInt(30);
    int holes = random.nextInt(2) == 0 ? 1 + random.nextInt(4) : 0;
    Outline unit = kind.make(random, n, holes);
    double scale = Math.pow(10, random.nextInt(7) - 3);
    double offset = random.nextInt(3) == 0 ? Math.pow(10, random.nextInt(7)) * scale : 0;
    double[] xy = unit.coordinates().clone();
    for (int i = 0; i < xy.length; i++) {
      xy[i] = xy[i] * scale + offset;
    }
    Outline outline = new Outline(xy, unit.ringStarts());
    return OutlineCheck.of(outline).defect() == OutlineDefect.NONE ? outline : unit;
  }
}
