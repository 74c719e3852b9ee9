package org.jbox2d.testbed.headless;

import java.nio.file.Path;
import org.jbox2d.testbed.scenes.Scene;

/**
 * What a headless run is to do.
 *
 * @param scene what to run
 * @param steps how many steps
 * @param hz steps per second
 * @param seed seed of the fractures
 * @param png where to write a picture of the end, or {@code null}
 * @param csv where to write figures of each step, or {@code null}
 * @param gif where to write an animation, or {@code null}
 * @param profile whether to print how long the phases of a step took
 * @param hashOnly whether to print the hash of the end and nothing else
 */
public record RunRequest(
    Scene scene,
    int steps,
    float hz,
    long seed,
    Path png,
    Path csv,
    Path gif,
    boolean profile,
    boolean hashOnly) {}
