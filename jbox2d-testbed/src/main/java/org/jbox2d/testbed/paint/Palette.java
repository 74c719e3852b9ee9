package org.jbox2d.testbed.paint;

import java.awt.Color;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.testbed.simulation.BodyOutline;

/** Colours of a picture. */
public enum Palette {
  /** On a dark ground. */
  DARK(0x171a21, 0x222733, 0x343b4a, 0x566073, 0xd7dce5, -0.45f),
  /** On a light ground. */
  LIGHT(0xf7f8fa, 0xe9ecf1, 0xc9d0da, 0x8a94a6, 0x2b3240, -0.45f);

  private static final int PLAIN = 0x8fa3bf;
  private static final int KINEMATIC = 0x9a86c9;
  private static final int UNIFORM = 0xe0a458;
  private static final int DIFFUSION = 0xd9765f;
  private static final int GLASS = 0x6fc3cf;
  private static final int RADIAL = 0x8f9fe0;
  private static final int SPLINTERS = 0xb98a5a;
  private static final int BRICKS = 0xc4574d;
  private static final int OTHER_MATERIAL = 0xa3be6c;

  /** How much the brightness of bodies of one kind differs, so that neighbours can be told. */
  private static final float SPREAD = 0.3f;

  /** How much of a sleeping body's colour gives way to the ground. */
  private static final float ASLEEP = 0.35f;

  private final Color ground;
  private final Color grid;
  private final Color scenery;
  private final Color sceneryEdge;
  private final Color text;
  private final float edgeShift;

  Palette(int ground, int grid, int scenery, int sceneryEdge, int text, float edgeShift) {
    this.ground = new Color(ground);
    this.grid = new Color(grid);
    this.scenery = new Color(scenery);
    this.sceneryEdge = new Color(sceneryEdge);
    this.text = new Color(text);
    this.edgeShift = edgeShift;
  }

  /** Returns the colour of empty space. */
  public Color ground() {
    return ground;
  }

  /** Returns the colour of the lines every ten metres. */
  public Color grid() {
    return grid;
  }

  /** Returns the colour of text. */
  public Color text() {
    return text;
  }

  /** Returns the colour of joints. */
  public Color joint() {
    return new Color(0x4fb477);
  }

  /** Returns the colour of points of contact. */
  public Color contact() {
    return new Color(0xe5484d);
  }

  /** Returns the colour of the broad phase's boxes. */
  public Color box() {
    return new Color(0x9a86c9);
  }

  /** Returns the colour of Voronoi cells. */
  public Color cell() {
    return new Color(0x4fb4d8);
  }

  /** Returns the colour of where cells break away. */
  public Color region() {
    return new Color(0xe5b84d);
  }

  /** Returns the colour that fills a body. */
  Color fill(BodyOutline outline, boolean awake) {
    if (outline.type == BodyType.STATIC && outline.material.isEmpty()) {
      return scenery;
    }
    // The golden ratio spreads consecutive numbers evenly.
    float shade = (outline.id * 0.618034f % 1f - 0.5f) * SPREAD;
    Color colour = shifted(new Color(base(outline)), shade);
    boolean dimmed = !awake && outline.type == BodyType.DYNAMIC;
    return dimmed ? mixed(colour, ground, ASLEEP) : colour;
  }

  /** Returns the colour of a body's outline. */
  Color edge(BodyOutline outline, Color fill) {
    if (outline.type == BodyType.STATIC && outline.material.isEmpty()) {
      return sceneryEdge;
    }
    return shifted(fill, edgeShift);
  }

  private static int base(BodyOutline outline) {
    return switch (outline.material) {
      case "" -> outline.type == BodyType.KINEMATIC ? KINEMATIC : PLAIN;
      case "Uniform" -> UNIFORM;
      case "Diffusion" -> DIFFUSION;
      case "Glass" -> GLASS;
      case "Radial" -> RADIAL;
      case "Splinters" -> SPLINTERS;
      case "Bricks" -> BRICKS;
      default -> OTHER_MATERIAL;
    };
  }

  /** Towards white by a positive amount, towards black by a negative one. */
  private static Color shifted(Color c, float amount) {
    return mixed(c, amount > 0f ? Color.WHITE : Color.BLACK, Math.abs(amount));
  }

  private static Color mixed(Color a, Color b, float share) {
    return new Color(
        mixed(a.getRed(), b.getRed(), share),
        mixed(a.getGreen(), b.getGreen(), share),
        mixed(a.getBlue(), b.getBlue(), share));
  }

  private static int mixed(int a, int b, float share) {
    return Math.round(a + (b - a) * share);
  }
}
