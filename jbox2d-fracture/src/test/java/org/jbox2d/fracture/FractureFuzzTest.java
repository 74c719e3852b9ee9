package org.jbox2d.fracture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Collections;
import org.junit.jupiter.api.Test;

/**
 * A share of the random scenes of {@link FractureFuzz}. All of them: {@code mvn -pl jbox2d-fracture
 * -am test -Dtest=FractureFuzzTest -Dsurefire.failIfNoSpecifiedTests=false
 * -Dfracture.fuzz.cases=10000}.
 */
class FractureFuzzTest {
  private static final int CASES = 200;

  @Test
  void randomScenes() {
    int cases = Integer.getInteger("fracture.fuzz.cases", CASES);
    FractureFuzz fuzz = new FractureFuzz();
    fuzz.run(0, cases);
    assertEquals(Collections.emptyList(), fuzz.violations, fuzz.toString());
    assertEquals(Collections.emptyMap(), fuzz.failures, fuzz.toString());
    assertTrue(fuzz.fractures > cases, "few fractures: " + fuzz);
  }
}
