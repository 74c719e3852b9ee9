/**
 * Runs written to files and repeated: what a run began with, what was done to it, and hashes of the
 * state after each step, so that a run that goes another way is found out at once.
 */
package org.jbox2d.testbed.recording;
