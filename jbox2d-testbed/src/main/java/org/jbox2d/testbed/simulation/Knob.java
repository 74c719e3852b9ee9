package org.jbox2d.testbed.simulation;

import java.util.function.ObjDoubleConsumer;
import org.jbox2d.testbed.parameters.Parameter;

/** A parameter that acts on a run at once: what it is, and what setting it does. */
final class Knob {
  final Parameter parameter;
  private final ObjDoubleConsumer<Simulation> effect;

  Knob(Parameter parameter, ObjDoubleConsumer<Simulation> effect) {
    this.parameter = parameter;
    this.effect = effect;
  }

  void turn(Simulation run, double value) {
    effect.accept(run, value);
  }
}
