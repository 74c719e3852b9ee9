package org.jbox2d.fracture;

import static com.tngtech.archunit.base.DescribedPredicate.describe;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import java.util.Random;
import java.util.Set;

/** The directions of dependency between the packages of the fracture module. */
@AnalyzeClasses(
    packages = "org.jbox2d.fracture",
    importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
  private static final Set<String> DIFFERING =
      Set.of(
          "java.lang.Math.acos",
          "java.lang.Math.asin",
          "java.lang.Math.atan",
          "java.lang.Math.atan2",
          "java.lang.Math.cbrt",
          "java.lang.Math.cos",
          "java.lang.Math.cosh",
          "java.lang.Math.exp",
          "java.lang.Math.expm1",
          "java.lang.Math.hypot",
          "java.lang.Math.log",
          "java.lang.Math.log10",
          "java.lang.Math.log1p",
          "java.lang.Math.pow",
          "java.lang.Math.random",
          "java.lang.Math.sin",
          "java.lang.Math.sinh",
          "java.lang.Math.tan",
          "java.lang.Math.tanh",
          "java.lang.System.identityHashCode",
          "java.util.UUID.randomUUID",
          "java.util.concurrent.ThreadLocalRandom.current");

  @ArchTest
  static final ArchRule geometrySeesNoWorld =
      noClasses()
          .that()
          .resideInAnyPackage(
              "org.jbox2d.fracture.geometry..",
              "org.jbox2d.fracture.voronoi..",
              "org.jbox2d.fracture.fragmentation..",
              "org.jbox2d.fracture.triangulation..",
              "org.jbox2d.fracture.hertelmehlhorn..")
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage("org.jbox2d.dynamics..", "org.jbox2d.collision..");

  @ArchTest
  static final ArchRule onlyTheTriangulatorKnowsPoly2tri =
      noClasses()
          .that()
          .resideOutsideOfPackage("org.jbox2d.fracture.triangulation..")
          .should()
          .dependOnClassesThat()
          .resideInAPackage("org.poly2tri..");

  @ArchTest
  static final ArchRule onlyExportedPackagesOfTheLibrary =
      noClasses()
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage(
              "org.jbox2d.internal..",
              "org.jbox2d.dynamics.solver..",
              "org.jbox2d.collision.narrowphase..");

  @ArchTest
  static final ArchRule noStaticState =
      fields().that().areStatic().should().haveModifier(JavaModifier.FINAL);

  @ArchTest
  static final ArchRule noAwtNoReflection =
      noClasses()
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage("java.awt..", "javax.swing..", "java.lang.reflect..");

  /** Virtual machines may round these differently; nor is anything drawn without a seed. */
  @ArchTest
  static final ArchRule nothingThatDiffersBetweenMachines =
      noClasses()
          .should()
          .callMethodWhere(
              describe(
                  "mathematics of the platform, randomness and identities",
                  call ->
                      DIFFERING.contains(call.getTargetOwner().getName() + "." + call.getName())))
          .orShould()
          .callConstructor(Random.class);
}
