package org.jbox2d.fracture.fragmentation;

import org.jbox2d.fracture.geometry.Outline;

/** A piece that breaks away. */
public final class Fragment {
  private final Outline outline;
  private final int site;

  Fragment(Outline outline, int site) {
    this.outline = outline;
    this.site = site;
  }

  /** Its outline, normal, with holes if a hole of the body lies inside it. */
  public Outline outline() {
    return outline;
  }

  /**
   * Index of the site in whose cell it lies, of one of them if small pieces were merged into it; -1
   * if there was no cut by cells.
   */
  public int site() {
    return site;
  }
}
