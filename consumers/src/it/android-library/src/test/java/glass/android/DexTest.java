package glass.android;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.android.dex.ClassDef;
import com.android.dex.Dex;
import com.android.dx.command.dexer.DxContext;
import com.android.dx.command.dexer.Main;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Enumeration;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;
import org.jbox2d.dynamics.World;
import org.jbox2d.fracture.FractureSystem;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The library and all that it runs on become one file for Android's virtual machine. */
class DexTest {
  /** Version of the class files of Java 8. */
  private static final int JAVA_8 = 52;

  /** What lambda expressions refer to, which Android's own dexer turns into classes. */
  private static final Set<String> LAMBDAS =
      Set.of(
          "Ljava/lang/invoke/CallSite;",
          "Ljava/lang/invoke/LambdaMetafactory;",
          "Ljava/lang/invoke/MethodHandle;",
          "Ljava/lang/invoke/MethodHandles$Lookup;",
          "Ljava/lang/invoke/MethodHandles;",
          "Ljava/lang/invoke/MethodType;");

  @TempDir Path folder;

  @Test
  void everythingIsTranslated() throws Exception {
    Path file = folder.resolve("classes.dex");
    ByteArrayOutputStream complaints = new ByteArrayOutputStream();
    DxContext context = new DxContext(complaints, complaints);
    Main.Arguments arguments = new Main.Arguments(context);
    arguments.outName = file.toString();
    arguments.minSdkVersion = 26;
    arguments.fileNames =
        new String[] {
          placeOf(ShopTest.class).resolveSibling("classes").toString(),
          placeOf(World.class).toString(),
          placeOf(FractureSystem.class).toString(),
          placeOf(org.poly2tri.Poly2Tri.class).toString(),
          placeOf(org.slf4j.Logger.class).toString(),
        };
    arguments.makeOptionsObjects();
    assertEquals(0, new Main(context).runDx(arguments), complaints::toString);

    Dex dex = new Dex(file.toFile());
    Set<String> classes = new HashSet<>();
    for (ClassDef def : dex.classDefs()) {
      classes.add(dex.typeNames().get(def.getTypeIndex()));
    }
    for (String name :
        List.of(
            "Lglass/android/ShopView;",
            "Lorg/jbox2d/dynamics/World;",
            "Lorg/jbox2d/fracture/FractureSystem;",
            "Lorg/poly2tri/Poly2Tri;",
            "Lorg/slf4j/Logger;")) {
      assertTrue(classes.contains(name), name);
    }
    for (String name : classes) {
      assertTrue(!name.startsWith("Landroid/") && !name.startsWith("Ljava/"), name);
    }
    for (String name : dex.typeNames()) {
      boolean linkedAtRunTime =
          name.startsWith("Ljava/lang/invoke/") || name.startsWith("Ljava/lang/runtime/");
      assertTrue(!linkedAtRunTime || LAMBDAS.contains(name), name);
    }
  }

  /**
   * So that dexers of any age read them; only descriptors of modules, which they skip, are newer.
   */
  @Test
  void classFilesAreOfJava8() throws Exception {
    for (Class<?> type : List.of(World.class, FractureSystem.class)) {
      try (JarFile jar = new JarFile(placeOf(type).toFile())) {
        for (Enumeration<JarEntry> e = jar.entries(); e.hasMoreElements(); ) {
          JarEntry entry = e.nextElement();
          if (entry.getName().endsWith(".class") && !entry.getName().equals("module-info.class")) {
            assertEquals(JAVA_8, version(jar.getInputStream(entry)), entry.getName());
          }
        }
      }
    }
  }

  private static Path placeOf(Class<?> type) throws URISyntaxException {
    Path place = Path.of(type.getProtectionDomain().getCodeSource().getLocation().toURI());
    assertTrue(Files.exists(place), place.toString());
    return place;
  }

  /** A class file begins with a magic number, its minor and its major version. */
  private static int version(InputStream bytes) throws IOException {
    try (DataInputStream in = new DataInputStream(bytes)) {
      in.skipBytes(6);
      return in.readUnsignedShort();
    }
  }
}
