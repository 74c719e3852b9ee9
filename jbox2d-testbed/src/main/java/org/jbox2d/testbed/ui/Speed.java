package org.jbox2d.testbed.ui;

/** How much simulated time passes in a second. */
enum Speed {
  FULL("full speed", 1),
  HALF("1/2", 1 / 2.0),
  QUARTER("1/4", 1 / 4.0),
  EIGHTH("1/8", 1 / 8.0),
  SIXTEENTH("1/16", 1 / 16.0);

  private final String label;
  final double factor;

  Speed(String label, double factor) {
    this.label = label;
    this.factor = factor;
  }

  @Override
  public String toString() {
    return label;
  }
}
