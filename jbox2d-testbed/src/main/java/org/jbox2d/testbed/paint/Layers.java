package org.jbox2d.testbed.paint;

import java.util.EnumSet;
import java.util.Set;

/** The layers that a picture shows. Immutable. */
public final class Layers {
  /** Bodies and joints, sleeping bodies dimmed. */
  public static final Layers USUAL =
      new Layers(EnumSet.of(Layer.SHAPES, Layer.JOINTS, Layer.SLEEPING));

  private final Set<Layer> shown;

  private Layers(Set<Layer> shown) {
    this.shown = shown;
  }

  /** Returns whether a layer is shown. */
  public boolean has(Layer layer) {
    return shown.contains(layer);
  }

  /** Returns these layers with one shown or not. */
  public Layers with(Layer layer, boolean show) {
    EnumSet<Layer> copy = EnumSet.noneOf(Layer.class);
    copy.addAll(shown);
    if (show) {
      copy.add(layer);
    } else {
      copy.remove(layer);
    }
    return new Layers(copy);
  }

  /** Returns these layers with one switched over. */
  public Layers toggled(Layer layer) {
    return with(layer, !has(layer));
  }

  /** Returns the layers as bits, for {@link #ofBits}. */
  public int bits() {
    int bits = 0;
    for (Layer layer : shown) {
      bits |= 1 << layer.ordinal();
    }
    return bits;
  }

  /** Returns the layers of bits; bits of no layer are of no effect. */
  public static Layers ofBits(int bits) {
    EnumSet<Layer> shown = EnumSet.noneOf(Layer.class);
    for (Layer layer : Layer.values()) {
      if ((bits & 1 << layer.ordinal()) != 0) {
        shown.add(layer);
      }
    }
    return new Layers(shown);
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Layers && ((Layers) other).shown.equals(shown);
  }

  @Override
  public int hashCode() {
    return shown.hashCode();
  }

  @Override
  public String toString() {
    return shown.toString();
  }
}
