package org.jbox2d.testbed;

import java.io.PrintWriter;
import org.jbox2d.testbed.parameters.Parameter;
import org.jbox2d.testbed.simulation.Setup;
import org.jbox2d.testbed.simulation.Simulation;

/** Prints the parameters of a scene. */
final class ParameterTable {
  private ParameterTable() {}

  /** Prints a line for each: name, value, range, meaning. */
  static void print(Setup setup, PrintWriter out) {
    Simulation run = new Simulation(setup);
    int nameWidth = 0;
    int rangeWidth = 0;
    for (Parameter p : run.parameters()) {
      nameWidth = Math.max(nameWidth, setting(run, p).length());
      rangeWidth = Math.max(rangeWidth, p.range().length());
    }
    Parameter.Group group = null;
    for (Parameter p : run.parameters()) {
      if (p.group() != group) {
        group = p.group();
        out.println(group.title() + ":");
      }
      String row = "  %-" + nameWidth + "s  %-" + rangeWidth + "s  %s%n";
      out.printf(row, setting(run, p), p.range(), p.doc());
    }
    out.flush();
  }

  private static String setting(Simulation run, Parameter p) {
    return p.name() + "=" + p.format(run.value(p));
  }
}
