package org.jbox2d.documentation;

import java.io.ByteArrayOutputStream;
import java.io.OutputStream;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.net.URI;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import javax.tools.Diagnostic;
import javax.tools.DiagnosticCollector;
import javax.tools.FileObject;
import javax.tools.ForwardingJavaFileManager;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileManager;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.jbox2d.dynamics.World;

/**
 * A snippet of Java, compiled in memory as the body of a method or of a class, whichever it is.
 * What it takes for granted are the imports below and the fields of {@link Scenery}.
 */
final class Snippet {
  private static final String NAME = "SnippetOfADocument";
  private static final String IMPORTS =
      "import java.util.*; import org.jbox2d.callbacks.*; import org.jbox2d.collision.*;"
          + " import org.jbox2d.collision.shapes.*; import org.jbox2d.common.*;"
          + " import org.jbox2d.dynamics.*; import org.jbox2d.dynamics.contacts.*;"
          + " import org.jbox2d.dynamics.joints.*; import org.jbox2d.fracture.*;"
          + " import org.jbox2d.fracture.materials.*; ";
  private static final String HEAD =
      IMPORTS + "public class " + NAME + " extends org.jbox2d.documentation.Scenery { ";

  private final Scenery scenery;

  private Snippet(Scenery scenery) {
    this.scenery = scenery;
  }

  /**
   * Compiles a snippet.
   *
   * @throws AssertionError with what the compiler says
   */
  static Snippet compile(String code) throws ReflectiveOperationException {
    Compilation statements =
        new Compilation(HEAD + "@Override public void run() {\n" + code + "}}");
    if (statements.succeeded) {
      return new Snippet(statements.load());
    }
    Compilation members = new Compilation(HEAD + "\n" + code + "}");
    if (members.succeeded) {
      return new Snippet(members.load());
    }
    throw new AssertionError(
        "as statements:\n" + statements.messages() + "as members:\n" + members.messages());
  }

  /**
   * Runs it: statements in the scenery, whose world then goes on for two seconds, or a method that
   * makes a world, which does.
   *
   * @return the world
   */
  World run() throws ReflectiveOperationException {
    scenery.run();
    World world = scenery.world;
    for (Method method : scenery.getClass().getDeclaredMethods()) {
      if (method.getReturnType() == World.class
          && method.getParameterCount() == 0
          && Modifier.isStatic(method.getModifiers())) {
        method.setAccessible(true);
        world = (World) method.invoke(null);
      }
    }
    for (int i = 0; i < 120; i++) {
      world.step(1f / 60, 8, 3);
    }
    return world;
  }

  /** One run of the compiler. */
  private static final class Compilation {
    private final DiagnosticCollector<JavaFileObject> diagnostics = new DiagnosticCollector<>();
    private final Map<String, ByteArrayOutputStream> classes = new HashMap<>();
    final boolean succeeded;

    Compilation(String source) {
      JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
      StandardJavaFileManager files = compiler.getStandardFileManager(diagnostics, null, null);
      List<String> options = List.of("-cp", System.getProperty("java.class.path"), "-proc:none");
      succeeded =
          compiler
              .getTask(
                  null, new Output(files), diagnostics, options, null, List.of(new Source(source)))
              .call();
    }

    String messages() {
      StringBuilder all = new StringBuilder();
      for (Diagnostic<? extends JavaFileObject> d : diagnostics.getDiagnostics()) {
        all.append("  line ").append(d.getLineNumber() - 1).append(": ");
        all.append(d.getMessage(null)).append('\n');
      }
      return all.toString();
    }

    Scenery load() throws ReflectiveOperationException {
      ClassLoader loader =
          new ClassLoader(Snippet.class.getClassLoader()) {
            @Override
            protected Class<?> findClass(String name) throws ClassNotFoundException {
              ByteArrayOutputStream bytes = classes.get(name);
              if (bytes == null) {
                throw new ClassNotFoundException(name);
              }
              return defineClass(name, bytes.toByteArray(), 0, bytes.size());
            }
          };
      return (Scenery) loader.loadClass(NAME).getDeclaredConstructor().newInstance();
    }

    /** Keeps the class files in memory. */
    private final class Output extends ForwardingJavaFileManager<JavaFileManager> {
      Output(JavaFileManager files) {
        super(files);
      }

      @Override
      public JavaFileObject getJavaFileForOutput(
          Location location, String name, JavaFileObject.Kind kind, FileObject sibling) {
        return new SimpleJavaFileObject(URI.create("memory:///" + name + kind.extension), kind) {
          @Override
          public OutputStream openOutputStream() {
            return classes.computeIfAbsent(name, n -> new ByteArrayOutputStream());
          }
        };
      }
    }
  }

  /** The source of one class. */
  private static final class Source extends SimpleJavaFileObject {
    private final String text;

    Source(String text) {
      super(URI.create("memory:///" + NAME + Kind.SOURCE.extension), Kind.SOURCE);
      this.text = text;
    }

    @Override
    public CharSequence getCharContent(boolean ignoreEncodingErrors) {
      return text;
    }
  }
}
