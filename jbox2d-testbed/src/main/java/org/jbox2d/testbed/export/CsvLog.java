package org.jbox2d.testbed.export;

import java.io.BufferedWriter;
import java.io.Closeable;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jbox2d.testbed.simulation.Snapshot;
import org.jbox2d.testbed.simulation.Totals;

/**
 * Writes a line of figures for each step. Numbers are written as Java does, in full and the same in
 * every locale.
 */
public final class CsvLog implements Closeable {
  private static final String HEAD =
      "step,time,bodies,fixtures,contacts,fractures,mass,momentumX,momentumY,angularMomentum,"
          + "kineticEnergy,potentialEnergy,stepMillis";

  private final BufferedWriter out;

  /** Opens a file and writes the heading. */
  public CsvLog(Path file) throws IOException {
    out = Files.newBufferedWriter(file, StandardCharsets.UTF_8);
    out.write(HEAD);
    out.write('\n');
  }

  /** Writes a line. */
  public void write(Snapshot.Counts counts) throws IOException {
    Totals totals = counts.totals();
    StringBuilder line = new StringBuilder(160);
    line.append(counts.steps());
    line.append(',').append(counts.time());
    line.append(',').append(counts.bodies());
    line.append(',').append(counts.fixtures());
    line.append(',').append(counts.contacts());
    line.append(',').append(counts.fractures());
    line.append(',').append(totals.mass());
    line.append(',').append(totals.momentumX());
    line.append(',').append(totals.momentumY());
    line.append(',').append(totals.angularMomentum());
    line.append(',').append(totals.kineticEnergy());
    line.append(',').append(totals.potentialEnergy());
    line.append(',').append(counts.phases().step());
    out.append(line.append('\n'));
  }

  @Override
  public void close() throws IOException {
    out.close();
  }
}
