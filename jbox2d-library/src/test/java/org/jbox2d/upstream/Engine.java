package org.jbox2d.upstream;

import java.io.File;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.jbox2d.dynamics.World;

/**
 * One of two engines with the same class names: ours, and JBox2D 2.2.1.1 in a class loader of its
 * own, which also loads the callers a second time so that they link against it. What they return
 * are types of the JDK.
 */
final class Engine {
  /** Copied there by the build. */
  private static final Path ORIGINAL_JAR = Path.of("target", "original", "jbox2d-2.2.1.1.jar");

  static final Engine OURS = new Engine(Engine.class.getClassLoader());
  static final Engine ORIGINAL = new Engine(originalLoader());

  private final ClassLoader loader;

  private Engine(ClassLoader loader) {
    this.loader = loader;
  }

  private static ClassLoader originalLoader() {
    if (!Files.exists(ORIGINAL_JAR)) {
      throw new IllegalStateException(ORIGINAL_JAR + " is missing: build with Maven");
    }
    URL ours = World.class.getProtectionDomain().getCodeSource().getLocation();
    List<URL> urls = new ArrayList<>();
    try {
      urls.add(ORIGINAL_JAR.toUri().toURL());
      for (String entry : System.getProperty("java.class.path").split(File.pathSeparator)) {
        URL url = Path.of(entry).toUri().toURL();
        if (!url.equals(ours)) {
          urls.add(url);
        }
      }
    } catch (MalformedURLException e) {
      throw new IllegalStateException(e);
    }
    return new URLClassLoader(urls.toArray(new URL[0]), ClassLoader.getPlatformClassLoader());
  }

  /** Calls a static method of a class as linked against this engine. */
  Object call(Class<?> type, String method, Object... arguments) {
    try {
      Class<?> linked = Class.forName(type.getName(), true, loader);
      for (Method m : linked.getDeclaredMethods()) {
        if (m.getName().equals(method)) {
          m.setAccessible(true);
          return m.invoke(null, arguments);
        }
      }
      throw new IllegalArgumentException("no method " + method);
    } catch (InvocationTargetException e) {
      throw new AssertionError(type.getSimpleName() + "." + method + " failed", e.getCause());
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(e);
    }
  }
}
