package org.jbox2d.testbed.recording;

/**
 * Where a repetition goes another way than the recording.
 *
 * @param step the first step after which the states differ
 * @param body the first body that differs, in order of creation, the oldest of those there are
 *     first and counted from 0; -1 if none does, but contacts do
 * @param what a sentence on both
 */
public record Divergence(int step, int body, String what) {
  @Override
  public String toString() {
    return "diverges after step " + step + ": " + what;
  }
}
