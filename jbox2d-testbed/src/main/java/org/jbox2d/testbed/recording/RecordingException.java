package org.jbox2d.testbed.recording;

import java.io.IOException;

/** A file is not a recording, or one that this program can't repeat. */
public final class RecordingException extends IOException {
  private static final long serialVersionUID = 1L;

  RecordingException(String message) {
    super(message);
  }
}
