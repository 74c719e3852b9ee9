package org.jbox2d.fracture.fragmentation;

import java.util.Collections;
import java.util.List;
import org.jbox2d.fracture.geometry.Outline;

/**
 * What became of an outline.
 *
 * <p>Fragments and remainders tile the outline: neighbours have the same vertices along their
 * common edges, bit for bit. Vertices of the outline keep their coordinates.
 */
public final class Fragmentation {
  private final FragmentationStatus status;
  private final String reason;
  private final List<Fragment> fragments;
  private final List<Outline> remainders;

  Fragmentation(
      FragmentationStatus status,
      String reason,
      List<Fragment> fragments,
      List<Outline> remainders) {
    this.status = status;
    this.reason = reason;
    this.fragments = Collections.unmodifiableList(fragments);
    this.remainders = Collections.unmodifiableList(remainders);
  }

  static Fragmentation failure(FragmentationStatus status, String reason) {
    return new Fragmentation(
        status, reason, Collections.<Fragment>emptyList(), Collections.<Outline>emptyList());
  }

  static Fragmentation unbroken(Outline outline) {
    return new Fragmentation(
        FragmentationStatus.NOTHING_BREAKS,
        "",
        Collections.<Fragment>emptyList(),
        Collections.singletonList(outline));
  }

  /** How it ended. */
  public FragmentationStatus status() {
    return status;
  }

  /** What went wrong if it failed, else an empty text. */
  public String reason() {
    return reason;
  }

  /** What breaks away, in the order of the pieces; empty unless broken. */
  public List<Fragment> fragments() {
    return fragments;
  }

  /**
   * What stays, one outline for each connected part: the whole input if nothing breaks, empty on
   * failure.
   */
  public List<Outline> remainders() {
    return remainders;
  }
}
