package org.jbox2d.benchmarks.engines;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.HashMap;
import java.util.Map;
import java.util.jar.JarEntry;
import java.util.jar.JarInputStream;

/**
 * Loads JBox2D 2.2.1.1, whose classes have the names of ours, from a jar packed as a resource, and
 * the adapter a second time, so that it links against it. Everything else comes from the parent.
 */
final class OriginalLoader extends ClassLoader {
  private static final String JAR = "jbox2d-2.2.1.1.jar";
  private static final String ENGINE = "org.jbox2d.";
  private static final String SHARED = "org.jbox2d.benchmarks.";
  private static final String ADAPTER = "org.jbox2d.benchmarks.engines.box2d.";

  private final Map<String, byte[]> engineClasses = new HashMap<>();

  OriginalLoader(ClassLoader parent) {
    super(parent);
    try (InputStream in = OriginalLoader.class.getResourceAsStream(JAR)) {
      if (in == null) {
        throw new IllegalStateException("resource " + JAR + " is missing: build with Maven");
      }
      JarInputStream jar = new JarInputStream(in);
      for (JarEntry e = jar.getNextJarEntry(); e != null; e = jar.getNextJarEntry()) {
        if (e.getName().endsWith(".class")) {
          engineClasses.put(e.getName(), jar.readAllBytes());
        }
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
    boolean own = name.startsWith(ADAPTER) || (name.startsWith(ENGINE) && !name.startsWith(SHARED));
    if (!own) {
      return super.loadClass(name, resolve);
    }
    synchronized (getClassLoadingLock(name)) {
      Class<?> loaded = findLoadedClass(name);
      return loaded != null ? loaded : findClass(name);
    }
  }

  @Override
  protected Class<?> findClass(String name) throws ClassNotFoundException {
    String path = name.replace('.', '/') + ".class";
    byte[] code = name.startsWith(ADAPTER) ? readFromParent(path) : engineClasses.get(path);
    if (code == null) {
      throw new ClassNotFoundException(name);
    }
    return defineClass(name, code, 0, code.length);
  }

  private byte[] readFromParent(String path) {
    try (InputStream in = getParent().getResourceAsStream(path)) {
      return in == null ? null : in.readAllBytes();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
