package org.jbox2d.testbed.simulation;

/**
 * An input and when it came.
 *
 * @param step number of steps done before it
 * @param input what is done
 */
public record TimedInput(int step, Input input) {}
