package org.jbox2d.testbed.ui;

import java.awt.Rectangle;
import java.util.prefs.Preferences;
import org.jbox2d.testbed.paint.Layers;
import org.jbox2d.testbed.scenes.Scene;
import org.jbox2d.testbed.scenes.Scenes;

/** What the window remembers from one time to the next. */
public final class WindowSettings {
  private static final String SCENE = "scene";
  private static final String LAYERS = "layers";

  private final Preferences store;

  /** Settings in the given store. */
  WindowSettings(Preferences store) {
    this.store = store;
  }

  /** Returns the settings of this user. */
  public static WindowSettings ofUser() {
    return new WindowSettings(Preferences.userRoot().node("org/jbox2d/testbed"));
  }

  /** Returns settings that nobody has made and that are not kept. */
  static WindowSettings forgotten() {
    return new WindowSettings(new MemoryPreferences());
  }

  /** Returns the last scene; the first of all if there is none. */
  public Scene scene() {
    String name = store.get(SCENE, "");
    for (Scene scene : Scenes.all()) {
      if (scene.name().equals(name)) {
        return scene;
      }
    }
    return Scenes.first();
  }

  void remember(Scene scene) {
    store.put(SCENE, scene.name());
  }

  Layers layers() {
    return Layers.ofBits(store.getInt(LAYERS, Layers.USUAL.bits()));
  }

  void remember(Layers layers) {
    store.putInt(LAYERS, layers.bits());
  }

  /** Returns where the window was; {@code null} if that is not known. */
  Rectangle bounds() {
    int width = store.getInt("width", 0);
    int height = store.getInt("height", 0);
    return width <= 0 || height <= 0
        ? null
        : new Rectangle(store.getInt("x", 0), store.getInt("y", 0), width, height);
  }

  void remember(Rectangle bounds) {
    store.putInt("x", bounds.x);
    store.putInt("y", bounds.y);
    store.putInt("width", bounds.width);
    store.putInt("height", bounds.height);
  }
}
