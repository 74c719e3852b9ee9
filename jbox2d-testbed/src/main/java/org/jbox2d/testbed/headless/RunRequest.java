package org.jbox2d.testbed.headless;

import java.nio.file.Path;
import org.jbox2d.testbed.simulation.Setup;

/**
 * What a headless run is to do.
 *
 * @param setup what to run; {@code null} if a recording tells
 * @param steps how many steps; of no meaning for a recording
 * @param replay a recording to repeat, or {@code null}
 * @param record where to record the run, or {@code null}
 * @param png where to write a picture of the end, or {@code null}
 * @param csv where to write figures of each step, or {@code null}
 * @param gif where to write an animation, or {@code null}
 * @param profile whether to print how long the phases of a step took
 * @param hashOnly whether to print the hash of the end and nothing else
 */
public record RunRequest(
    Setup setup,
    int steps,
    Path replay,
    Path record,
    Path png,
    Path csv,
    Path gif,
    boolean profile,
    boolean hashOnly) {}
