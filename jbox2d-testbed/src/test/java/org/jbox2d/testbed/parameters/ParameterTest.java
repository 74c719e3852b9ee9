package org.jbox2d.testbed.parameters;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.jbox2d.testbed.scenes.Scene;
import org.jbox2d.testbed.scenes.Scenes;
import org.jbox2d.testbed.simulation.Setup;
import org.jbox2d.testbed.simulation.Simulation;
import org.junit.jupiter.api.Test;

class ParameterTest {
  private static final Parameter SPEED =
      Parameter.real(Parameter.Group.SCENE, "speed", "m/s", -2.5, 10, 3, "How fast.");
  private static final Parameter COLOUR =
      Parameter.choice(Parameter.Group.SCENE, "colour", List.of("red", "green"), 1, "What.");

  @Test
  void textsAreReadAndWritten() {
    assertEquals(-2.5, SPEED.parse("-2.5"));
    assertEquals("3.0", SPEED.format(SPEED.initial()));
    assertEquals("-2.5 to 10 m/s", SPEED.range());
    assertEquals(0, COLOUR.parse("red"));
    assertEquals("green", COLOUR.format(1));
    assertEquals("red, green", COLOUR.range());
  }

  @Test
  void errorsSayWhatWouldBeRight() {
    for (String wrong : List.of("11", "-3", "NaN", "fast")) {
      IllegalArgumentException e =
          assertThrows(IllegalArgumentException.class, () -> SPEED.parse(wrong));
      assertTrue(e.getMessage().startsWith("speed must be -2.5 to 10 m/s, is "), e.getMessage());
    }
    assertThrows(IllegalArgumentException.class, () -> COLOUR.parse("blue"));
    assertThrows(IllegalArgumentException.class, () -> COLOUR.checked(0.5));
    assertThrows(IllegalArgumentException.class, () -> COLOUR.checked(2));
  }

  @Test
  void defaultOutsideTheRangeWidensIt() {
    Parameter wider = SPEED.startingAt(20.1f);
    assertEquals(20.1, wider.initial());
    assertEquals(20.1, wider.most());
    assertThrows(
        IllegalArgumentException.class,
        () -> Parameter.whole(Parameter.Group.SCENE, "n", 1, 5, 6, "Too many."));
  }

  @Test
  void parametersOfEverySceneHaveUniqueNamesUnitsAndDocs() {
    for (Scene scene : Scenes.all()) {
      Set<String> names = new HashSet<>();
      for (Parameter p : new Simulation(Setup.of(scene, 1)).parameters()) {
        assertTrue(p.name().matches("[a-z]+(-[a-z]+)*"), p.name());
        assertTrue(names.add(p.name()), scene.name() + " has two of " + p.name());
        assertTrue(p.doc().endsWith("."), p.doc());
        assertTrue(p.least() < p.most() || p.choices().size() == 1, p.name());
        assertEquals(p.initial(), p.parse(p.format(p.initial())));
      }
    }
  }

  /** The panel's initial values are those of the world: setting them all changes nothing. */
  @Test
  void settingEveryDefaultChangesNothing() {
    for (Scene scene : Scenes.all()) {
      Simulation plain = new Simulation(Setup.of(scene, 1));
      Setup setup = Setup.of(scene, 1);
      for (Parameter p : plain.parameters()) {
        setup = setup.with(p.name(), p.initial());
      }
      Simulation explicit = new Simulation(setup);
      for (int i = 0; i < 20; i++) {
        plain.step();
        explicit.step();
      }
      assertEquals(plain.hash(), explicit.hash(), scene.name());
    }
  }

  /** Whatever parameter a scene has of its own does something, soon. */
  @Test
  void everyParameterOfASceneMatters() {
    for (Scene scene : Scenes.all()) {
      for (Parameter p : scene.parameters()) {
        Setup plain = Setup.of(scene, 1);
        double other = p.initial() == p.most() ? p.least() : p.most();
        assertTrue(differSoon(plain, plain.with(p.name(), other)), scene.name() + ": " + p.name());
      }
    }
  }

  /** Within three seconds of the scene. */
  private static boolean differSoon(Setup a, Setup b) {
    Simulation runA = new Simulation(a);
    Simulation runB = new Simulation(b);
    for (int i = 0; i < 180 && runA.hash() == runB.hash(); i++) {
      runA.step();
      runB.step();
    }
    return runA.hash() != runB.hash();
  }

  @Test
  void valuesAreImmutable() {
    Values values = Values.NONE.with("speed", 4);
    assertEquals(4, values.get(SPEED));
    assertEquals(3, values.without("speed").get(SPEED));
    assertEquals(3, Values.NONE.get(SPEED));
    assertFalse(values.equals(Values.NONE));
    assertThrows(UnsupportedOperationException.class, () -> values.set().clear());
  }
}
