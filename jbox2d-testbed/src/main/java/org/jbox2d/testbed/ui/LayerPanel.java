package org.jbox2d.testbed.ui;

import java.awt.GridLayout;
import java.util.EnumMap;
import java.util.Map;
import java.util.function.Consumer;
import javax.swing.JCheckBox;
import javax.swing.JPanel;
import org.jbox2d.testbed.paint.Layer;
import org.jbox2d.testbed.paint.Layers;

/** A box for each layer; the keys 1 to 9 switch them too. */
final class LayerPanel extends JPanel {
  private static final long serialVersionUID = 1L;

  private final Map<Layer, JCheckBox> boxes = new EnumMap<>(Layer.class);

  /** Boxes that tell of the layer whose box is clicked. */
  LayerPanel(Consumer<Layer> toggled) {
    super(new GridLayout(0, 2));
    for (Layer layer : Layer.values()) {
      JCheckBox box = new JCheckBox(key(layer) + "  " + layer.title());
      box.setName(layer.name());
      box.setFocusable(false);
      box.addActionListener(e -> toggled.accept(layer));
      boxes.put(layer, box);
      add(box);
    }
  }

  /** Returns the key of a layer. */
  static String key(Layer layer) {
    return Integer.toString(layer.ordinal() + 1);
  }

  /** Shows which layers are on. */
  void show(Layers layers) {
    boxes.forEach((layer, box) -> box.setSelected(layers.has(layer)));
  }
}
