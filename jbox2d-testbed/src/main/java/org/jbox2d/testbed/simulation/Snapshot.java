package org.jbox2d.testbed.simulation;

/**
 * The state of a run between two steps, as much of it as a picture shows. Immutable: it may be
 * painted on one thread while the run goes on in another.
 */
public final class Snapshot {
  /** Floats per body in {@link #transforms}: position, cosine and sine of the angle. */
  static final int STRIDE = 4;

  /** Floats per contact point in {@link #contacts}: position, normal times impulse. */
  static final int CONTACT = 4;

  /** Floats per body in {@link #centres}: position of the centre of mass. */
  static final int CENTRE = 2;

  /** Floats per box in {@link #boxes}: lower and upper bound. */
  static final int BOX = 4;

  /** Floats per joint in {@link #jointLines}: both anchors. */
  static final int LINE = 4;

  private final Counts counts;
  private final BodyOutline[] outlines;
  private final float[] transforms;
  private final boolean[] awake;
  private final float[] jointLines;
  private final float[] contacts;
  private final float[] centres;
  private final float[] boxes;
  private final FractureTrace lastFracture;
  private final long hash;

  /** Takes the arrays over; the caller must not keep them. */
  Snapshot(
      Counts counts,
      BodyOutline[] outlines,
      float[] transforms,
      boolean[] awake,
      float[] jointLines,
      float[] contacts,
      float[] centres,
      float[] boxes,
      FractureTrace lastFracture,
      long hash) {
    this.counts = counts;
    this.outlines = outlines;
    this.transforms = transforms;
    this.awake = awake;
    this.jointLines = jointLines;
    this.contacts = contacts;
    this.centres = centres;
    this.boxes = boxes;
    this.lastFracture = lastFracture;
    this.hash = hash;
  }

  /** Returns the numbers. */
  public Counts counts() {
    return counts;
  }

  /** Returns the number of bodies in the picture. */
  public int bodyCount() {
    return outlines.length;
  }

  /** Returns what a body looks like. */
  public BodyOutline outline(int body) {
    return outlines[body];
  }

  /** Returns whether a body is awake. */
  public boolean isAwake(int body) {
    return awake[body];
  }

  /** Returns the position of a body's origin, m. */
  public float x(int body) {
    return transforms[STRIDE * body];
  }

  /** Returns the position of a body's origin, m. */
  public float y(int body) {
    return transforms[STRIDE * body + 1];
  }

  /** Returns the cosine of a body's angle. */
  public float cos(int body) {
    return transforms[STRIDE * body + 2];
  }

  /** Returns the sine of a body's angle. */
  public float sin(int body) {
    return transforms[STRIDE * body + 3];
  }

  /** Returns the number of lines for joints. */
  public int lineCount() {
    return jointLines.length / LINE;
  }

  /** Returns a coordinate of a joint's line: x, y of one anchor, x, y of the other, m. */
  public float line(int joint, int coordinate) {
    return jointLines[LINE * joint + coordinate];
  }

  /** Returns the number of points of contact; 0 if they were not asked for. */
  public int contactCount() {
    return contacts.length / CONTACT;
  }

  /**
   * Returns a value of a point of contact: x and y of the point, m; x and y of the normal impulse
   * of the last step, N s.
   */
  public float contact(int point, int value) {
    return contacts[CONTACT * point + value];
  }

  /** Returns the position of a body's centre of mass, m. */
  public float centreX(int body) {
    return centres[CENTRE * body];
  }

  /** Returns the position of a body's centre of mass, m. */
  public float centreY(int body) {
    return centres[CENTRE * body + 1];
  }

  /** Returns the number of boxes of the broad phase; 0 if they were not asked for. */
  public int boxCount() {
    return boxes.length / BOX;
  }

  /** Returns a coordinate of a box: x, y of the lower bound, x, y of the upper, m. */
  public float box(int box, int coordinate) {
    return boxes[BOX * box + coordinate];
  }

  /** Returns what the last fracture was made by; {@code null} before there is one. */
  public FractureTrace lastFracture() {
    return lastFracture;
  }

  /** Returns the hash of the state; see {@link StateHash}. */
  public long hash() {
    return hash;
  }

  /**
   * Numbers of a run.
   *
   * @param scene name of the scene
   * @param steps steps done
   * @param time simulated time, s
   * @param bodies number of bodies
   * @param fixtures number of fixtures
   * @param contacts number of contacts, touching or not
   * @param particles number of particles
   * @param fractures number of fractures so far
   * @param totals sums over the bodies
   * @param phases how long the last step took
   */
  public record Counts(
      String scene,
      int steps,
      double time,
      int bodies,
      int fixtures,
      int contacts,
      int particles,
      int fractures,
      Totals totals,
      Phases phases) {}
}
