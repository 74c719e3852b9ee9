package org.jbox2d.testbed.ui;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.GridBagConstraints;
import java.awt.GridBagLayout;
import java.awt.Insets;
import java.awt.Rectangle;
import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.List;
import java.util.function.ToDoubleFunction;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;
import javax.swing.JSpinner;
import javax.swing.Scrollable;
import javax.swing.SpinnerNumberModel;
import org.jbox2d.testbed.parameters.Parameter;

/**
 * The parameters of the run under headings: a slider and a number for each, a box for a switch, a
 * list for a choice. What is changed is told at once.
 */
final class ParameterPanel extends JPanel implements Scrollable {
  private static final long serialVersionUID = 1L;

  /** Steps of a slider over the range of a real number. */
  private static final int SLIDER_STEPS = 200;

  private static final int SLIDER_WIDTH = 80;
  private static final int NUMBER_WIDTH = 88;

  private final transient Listener listener;
  private final transient Runnable done;

  /** Hears of a change. */
  interface Listener {
    /** A parameter has a new value. */
    void changed(Parameter parameter, double value);
  }

  /**
   * An empty panel.
   *
   * @param done called when a value has been typed in
   */
  ParameterPanel(Listener listener, Runnable done) {
    super(new GridBagLayout());
    this.listener = listener;
    this.done = done;
  }

  /** Shows parameters with their values. */
  void show(List<Parameter> parameters, ToDoubleFunction<Parameter> value) {
    removeAll();
    Parameter.Group group = null;
    int row = 0;
    for (Parameter parameter : parameters) {
      if (parameter.group() != group) {
        group = parameter.group();
        JLabel heading = new JLabel("<html><b>" + group.title() + "</b></html>");
        add(heading, at(row++, 0, 3, 0, new Insets(10, 6, 2, 6)));
      }
      addRow(row++, parameter, value.applyAsDouble(parameter));
    }
    GridBagConstraints rest = at(row, 0, 3, 0, new Insets(0, 0, 0, 0));
    rest.weighty = 1;
    add(new JLabel(), rest);
    revalidate();
    repaint();
  }

  private void addRow(int row, Parameter parameter, double value) {
    JLabel name = new JLabel(parameter.name());
    name.putClientProperty("FlatLaf.styleClass", "small");
    String unit = parameter.unit().isEmpty() ? "" : " [" + parameter.unit() + "]";
    String tip = parameter.doc() + " " + parameter.range();
    name.setToolTipText(tip);
    Insets insets = new Insets(1, 6, 1, 2);
    add(name, at(row, 0, 1, 0, insets));
    if (parameter.isSwitch()) {
      add(toggle(parameter, value, tip), at(row, 1, 2, 1, insets));
    } else if (parameter.kind() == Parameter.Kind.CHOICE) {
      add(choice(parameter, value, tip), at(row, 1, 2, 1, insets));
    } else {
      name.setText(parameter.name() + unit);
      addNumber(row, parameter, value, tip);
    }
  }

  private static GridBagConstraints at(
      int row, int column, int columns, double weight, Insets insets) {
    return new GridBagConstraints(
        column,
        row,
        columns,
        1,
        weight,
        0,
        GridBagConstraints.WEST,
        GridBagConstraints.HORIZONTAL,
        insets,
        0,
        0);
  }

  private JComponent toggle(Parameter parameter, double value, String tip) {
    JCheckBox box = new JCheckBox();
    box.setName(parameter.name());
    box.setToolTipText(tip);
    box.setSelected(value != 0);
    box.setFocusable(false);
    box.addActionListener(e -> listener.changed(parameter, box.isSelected() ? 1 : 0));
    return box;
  }

  private JComponent choice(Parameter parameter, double value, String tip) {
    JComboBox<String> box = new JComboBox<>(parameter.choices().toArray(new String[0]));
    box.setName(parameter.name());
    box.setToolTipText(tip);
    box.setSelectedIndex((int) value);
    box.setFocusable(false);
    box.addActionListener(e -> listener.changed(parameter, box.getSelectedIndex()));
    return box;
  }

  /** A slider and a spinner that follow each other; the spinner has the exact value. */
  private void addNumber(int row, Parameter parameter, double value, String tip) {
    boolean whole = parameter.kind() == Parameter.Kind.WHOLE;
    double span = parameter.most() - parameter.least();
    double step = whole ? 1 : rounded(span / 100);
    JSpinner number =
        new JSpinner(new SpinnerNumberModel(value, parameter.least(), parameter.most(), step));
    number.setEditor(new JSpinner.NumberEditor(number, whole ? "0" : "0.###"));
    number.setName(parameter.name());
    number.setToolTipText(tip);
    Dimension size = new Dimension(NUMBER_WIDTH, number.getPreferredSize().height);
    number.setPreferredSize(size);
    number.setMinimumSize(size);
    int positions = whole ? (int) Math.min(span, SLIDER_STEPS) : SLIDER_STEPS;
    JSlider slider = new JSlider(0, positions, position(parameter, value, positions));
    slider.setName(parameter.name() + " slider");
    slider.setFocusable(false);
    Dimension length = new Dimension(SLIDER_WIDTH, slider.getPreferredSize().height);
    slider.setPreferredSize(length);
    slider.setMinimumSize(length);
    boolean[] following = new boolean[1];
    number.addChangeListener(
        e -> {
          double v = ((Number) number.getValue()).doubleValue();
          following[0] = true;
          slider.setValue(position(parameter, v, positions));
          following[0] = false;
          listener.changed(parameter, v);
        });
    slider.addChangeListener(
        e -> {
          // Building a scene anew for each pixel would be too much.
          boolean wait = slider.getValueIsAdjusting() && parameter.group() == Parameter.Group.SCENE;
          if (!following[0] && !wait) {
            double v = parameter.least() + span * slider.getValue() / positions;
            number.setValue(limited(parameter, whole ? Math.rint(v) : rounded(v)));
          }
        });
    enterLeaves(number);
    add(slider, at(row, 1, 1, 1, new Insets(1, 2, 1, 2)));
    add(number, at(row, 2, 1, 0, new Insets(1, 2, 1, 6)));
  }

  private void enterLeaves(JSpinner number) {
    Component editor = ((JSpinner.DefaultEditor) number.getEditor()).getTextField();
    editor.addKeyListener(
        new KeyAdapter() {
          @Override
          public void keyReleased(KeyEvent e) {
            if (e.getKeyCode() == KeyEvent.VK_ENTER) {
              done.run();
            }
          }
        });
  }

  private static int position(Parameter parameter, double value, int positions) {
    double span = parameter.most() - parameter.least();
    return (int) Math.rint((value - parameter.least()) / span * positions);
  }

  private static double limited(Parameter parameter, double value) {
    return Math.max(parameter.least(), Math.min(parameter.most(), value));
  }

  /** To three digits. */
  static double rounded(double value) {
    return value == 0 ? 0 : new BigDecimal(value).round(new MathContext(3)).doubleValue();
  }

  // --- As wide as what it scrolls in

  @Override
  public Dimension getPreferredScrollableViewportSize() {
    return getPreferredSize();
  }

  @Override
  public int getScrollableUnitIncrement(Rectangle visible, int orientation, int way) {
    return 16;
  }

  @Override
  public int getScrollableBlockIncrement(Rectangle visible, int orientation, int way) {
    return visible.height;
  }

  @Override
  public boolean getScrollableTracksViewportWidth() {
    return true;
  }

  @Override
  public boolean getScrollableTracksViewportHeight() {
    return false;
  }
}
