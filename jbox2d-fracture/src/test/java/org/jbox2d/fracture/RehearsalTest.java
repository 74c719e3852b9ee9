package org.jbox2d.fracture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.io.File;
import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLClassLoader;
import java.util.Arrays;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.jbox2d.common.Settings;
import org.jbox2d.fracture.materials.Glass;
import org.junit.jupiter.api.Test;

/** The fracture that the first material of a program brings about. */
class RehearsalTest {
  private static final String[] FIRST_USES = {
    "org.jbox2d.fracture.MaterialConstants",
    "org.jbox2d.fracture.materials.Diffusion",
    "org.jbox2d.fracture.materials.Uniform",
    "org.jbox2d.fracture.materials.Glass"
  };

  @Test
  void breaksOneBox() {
    assertEquals(1, new Rehearsal().play(new Glass(), 0, 1));
  }

  /** It must break whatever a program has set before, lest its first material can't be made. */
  @Test
  void isPossibleInAnyScale() {
    float slop = Settings.linearSlop;
    int vertices = Settings.maxPolygonVertices;
    try {
      for (float scale : new float[] {0.01f, 1f, 100f}) {
        for (int most = 3; most <= 12; most += 3) {
          Settings.linearSlop = scale * slop;
          Settings.maxPolygonVertices = most;
          assertEquals(1, new Rehearsal().play(new Glass(), 0, 1), scale + ", " + most);
        }
      }
    } finally {
      Settings.linearSlop = slop;
      Settings.maxPolygonVertices = vertices;
    }
  }

  /** Classes that are initialized on two threads at once must not wait for each other. */
  @Test
  void firstMaterialsOnSeveralThreads() throws Exception {
    for (int round = 0; round < 4; round++) {
      try (URLClassLoader loader = freshLoader()) {
        FutureTask<?>[] tasks = new FutureTask<?>[FIRST_USES.length];
        for (int i = 0; i < tasks.length; i++) {
          String name = FIRST_USES[(i + round) % FIRST_USES.length];
          tasks[i] = new FutureTask<>(() -> firstUse(loader, name), null);
        }
        for (FutureTask<?> task : tasks) {
          Thread thread = new Thread(task);
          thread.setDaemon(true);
          thread.start();
        }
        for (FutureTask<?> task : tasks) {
          assertNull(resultOf(task));
        }
      }
    }
  }

  private static Object resultOf(FutureTask<?> task) throws InterruptedException {
    try {
      return task.get(60, TimeUnit.SECONDS);
    } catch (ExecutionException | TimeoutException e) {
      return e;
    }
  }

  private static void firstUse(ClassLoader loader, String name) {
    try {
      Class<?> type = Class.forName(name, true, loader);
      if (type.isInterface()) {
        type.getDeclaredFields()[0].getName();
      } else {
        type.getDeclaredConstructor().newInstance();
      }
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(name, e);
    }
  }

  private static URLClassLoader freshLoader() {
    URL[] urls =
        Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator))
            .map(RehearsalTest::urlOf)
            .toArray(URL[]::new);
    return new URLClassLoader(urls, ClassLoader.getPlatformClassLoader());
  }

  private static URL urlOf(String path) {
    try {
      return new File(path).toURI().toURL();
    } catch (MalformedURLException e) {
      throw new IllegalArgumentException(path, e);
    }
  }

  @Test
  void canBeForbidden() throws Exception {
    String before = System.getProperty(Rehearsal.PROPERTY);
    try (URLClassLoader loader = freshLoader()) {
      System.setProperty(Rehearsal.PROPERTY, "false");
      Class<?> rehearsal = Class.forName(Rehearsal.class.getName(), true, loader);
      java.lang.reflect.Method first = rehearsal.getDeclaredMethod("first");
      first.setAccessible(true);
      assertEquals(false, first.invoke(null));
    } finally {
      if (before == null) {
        System.clearProperty(Rehearsal.PROPERTY);
      } else {
        System.setProperty(Rehearsal.PROPERTY, before);
      }
    }
  }
}
