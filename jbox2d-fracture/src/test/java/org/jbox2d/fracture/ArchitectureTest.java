package org.jbox2d.fracture;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;

/** The directions of dependency between the packages of the fracture module. */
@AnalyzeClasses(
    packages = "org.jbox2d.fracture",
    importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
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
}
