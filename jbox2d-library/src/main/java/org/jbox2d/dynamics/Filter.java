package org.jbox2d.dynamics;

/** Which fixtures collide with which: by category bits, and by groups that always or never do. */
public class Filter {
  /** What this fixture is; normally a single bit. */
  public int categoryBits;

  /** The categories this fixture accepts collisions with. */
  public int maskBits;

  /**
   * Fixtures of the same positive group always collide, of the same negative group never; 0, or
   * different groups: the bits decide.
   */
  public int groupIndex;

  /** Category 1, collides with every category of the lower 16 bits, no group. */
  public Filter() {
    categoryBits = 0x0001;
    maskBits = 0xFFFF;
    groupIndex = 0;
  }

  /** Copies {@code argOther} into this filter. */
  public void set(Filter argOther) {
    categoryBits = argOther.categoryBits;
    maskBits = argOther.maskBits;
    groupIndex = argOther.groupIndex;
  }
}
