package org.jbox2d.testbed.ui;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.event.ActionEvent;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.DefaultListCellRenderer;
import javax.swing.DefaultListModel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import javax.swing.ScrollPaneConstants;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import org.jbox2d.testbed.scenes.Scene;
import org.jbox2d.testbed.scenes.Scenes;

/**
 * The scenes, each with a line on what it shows, and a field to search them. Up and down in the
 * field move the choice, enter takes it.
 */
final class SceneList extends JPanel {
  private static final long serialVersionUID = 1L;
  private static final int LIST_WIDTH = 230;
  private static final String QUIET = "<font color='#8b93a3'>";

  private final JTextField search = new JTextField();
  private final DefaultListModel<Scene> found = new DefaultListModel<>();
  private final JList<Scene> list = new JList<>(found);
  private final transient Consumer<Scene> choice;

  /** Whether the selection is being changed by the program. */
  private boolean quiet;

  /** A list that tells of what is chosen. */
  SceneList(Consumer<Scene> choice) {
    super(new BorderLayout(0, 4));
    this.choice = choice;
    search.setName("search");
    search.putClientProperty("JTextField.placeholderText", "Search scenes");
    search.getDocument().addDocumentListener(new Filter());
    bind("DOWN", () -> move(1));
    bind("UP", () -> move(-1));
    bind("ENTER", this::take);
    list.setName("scene list");
    list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    list.setCellRenderer(new Cell());
    // Keys are the canvas's; a list with the focus would take letters for itself.
    list.setFocusable(false);
    list.addListSelectionListener(
        e -> {
          if (!quiet && !e.getValueIsAdjusting() && list.getSelectedValue() != null) {
            choice.accept(list.getSelectedValue());
          }
        });
    filter();
    JScrollPane scroll =
        new JScrollPane(
            list,
            ScrollPaneConstants.VERTICAL_SCROLLBAR_AS_NEEDED,
            ScrollPaneConstants.HORIZONTAL_SCROLLBAR_NEVER);
    add(search, BorderLayout.NORTH);
    add(scroll, BorderLayout.CENTER);
    setPreferredSize(new Dimension(LIST_WIDTH, 400));
  }

  private void bind(String key, Runnable action) {
    search.getInputMap().put(KeyStroke.getKeyStroke(key), key);
    search
        .getActionMap()
        .put(
            key,
            new AbstractAction() {
              private static final long serialVersionUID = 1L;

              @Override
              public void actionPerformed(ActionEvent e) {
                action.run();
              }
            });
  }

  private void move(int by) {
    int to = Math.max(0, Math.min(found.size() - 1, list.getSelectedIndex() + by));
    quietly(
        () -> {
          list.setSelectedIndex(to);
          list.ensureIndexIsVisible(to);
        });
  }

  private void take() {
    if (list.getSelectedValue() == null && !found.isEmpty()) {
      move(1);
    }
    if (list.getSelectedValue() != null) {
      choice.accept(list.getSelectedValue());
    }
  }

  /** Shows which scene is on; it is not told of. */
  void show(Scene scene) {
    quietly(() -> list.setSelectedValue(scene, true));
  }

  /** Returns the scenes that the search has left, in order. */
  List<Scene> found() {
    return Collections.list(found.elements());
  }

  private void quietly(Runnable change) {
    quiet = true;
    change.run();
    quiet = false;
  }

  /** Keeps the scenes in whose name, title or line every word of the search occurs. */
  private void filter() {
    String[] words = search.getText().toLowerCase(Locale.ROOT).trim().split("\\s+");
    quietly(
        () -> {
          found.clear();
          for (Scene scene : Scenes.all()) {
            if (matches(scene, words)) {
              found.addElement(scene);
            }
          }
        });
  }

  private static boolean matches(Scene scene, String[] words) {
    String text = scene.name() + " " + scene.title() + " " + scene.shows();
    String lower = text.toLowerCase(Locale.ROOT);
    for (String word : words) {
      if (!lower.contains(word)) {
        return false;
      }
    }
    return true;
  }

  private final class Filter implements DocumentListener {
    @Override
    public void insertUpdate(DocumentEvent e) {
      filter();
    }

    @Override
    public void removeUpdate(DocumentEvent e) {
      filter();
    }

    @Override
    public void changedUpdate(DocumentEvent e) {
      filter();
    }
  }

  /** The title, and below it what the scene shows, in as many lines as that takes. */
  private static final class Cell extends DefaultListCellRenderer {
    private static final long serialVersionUID = 1L;
    private static final int TEXT_WIDTH = LIST_WIDTH - 36;

    @Override
    public Component getListCellRendererComponent(
        JList<?> list, Object value, int index, boolean selected, boolean focus) {
      super.getListCellRendererComponent(list, value, index, selected, focus);
      Scene scene = (Scene) value;
      FontMetrics metrics = getFontMetrics(getFont());
      StringBuilder text = new StringBuilder("<html><b>").append(scene.title()).append("</b>");
      text.append(selected ? "<font>" : QUIET);
      for (String line : wrapped(scene.shows(), metrics)) {
        text.append("<br>").append(line);
      }
      setText(text.append("</font></html>").toString());
      setBorder(BorderFactory.createEmptyBorder(4, 8, 5, 8));
      return this;
    }

    /** The width of a label of HTML is what its longest line takes, so lines are broken here. */
    private static List<String> wrapped(String text, FontMetrics metrics) {
      List<String> lines = new ArrayList<>();
      String line = "";
      for (String word : text.split(" ")) {
        String longer = line.isEmpty() ? word : line + " " + word;
        if (metrics.stringWidth(longer) > TEXT_WIDTH && !line.isEmpty()) {
          lines.add(line);
          line = word;
        } else {
          line = longer;
        }
      }
      lines.add(line);
      return lines;
    }
  }
}
