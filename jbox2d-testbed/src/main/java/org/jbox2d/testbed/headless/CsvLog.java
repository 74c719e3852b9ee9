package org.jbox2d.testbed.headless;

import java.io.BufferedWriter;
import java.io.Closeable;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jbox2d.testbed.simulation.Simulation;
import org.jbox2d.testbed.simulation.Totals;

/**
 * Writes a line of figures for each step. Numbers are written as Java does, in full and the same in
 * every locale.
 */
final class CsvLog implements Closeable {
  private static final String HEAD =
      "step,time,bodies,fixtures,contacts,fractures,mass,momentumX,momentumY,angularMomentum,"
          + "kineticEnergy,potentialEnergy,stepMillis";

  private final BufferedWriter out;

  CsvLog(Path file) throws IOException {
    out = Files.newBufferedWriter(file, StandardCharsets.UTF_8);
    out.write(HEAD);
    out.write('\n');
  }

  /** Writes the state after the last step. */
  void write(Simulation run) throws IOException {
    Totals totals = Totals.of(run.world());
    StringBuilder line = new StringBuilder(160);
    line.append(run.steps());
    line.append(',').append(run.time());
    line.append(',').append(run.world().getBodyCount());
    line.append(',').append(run.fixtureCount());
    line.append(',').append(run.world().getContactCount());
    line.append(',').append(run.fractureCount());
    line.append(',').append(totals.mass());
    line.append(',').append(totals.momentumX());
    line.append(',').append(totals.momentumY());
    line.append(',').append(totals.angularMomentum());
    line.append(',').append(totals.kineticEnergy());
    line.append(',').append(totals.potentialEnergy());
    line.append(',').append(run.stepMillis());
    out.append(line.append('\n'));
  }

  @Override
  public void close() throws IOException {
    out.close();
  }
}
