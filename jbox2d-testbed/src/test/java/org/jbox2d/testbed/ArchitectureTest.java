package org.jbox2d.testbed;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;

/** Directions between the testbed's packages, and who may use AWT. */
@AnalyzeClasses(
    packages = "org.jbox2d.testbed",
    importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
  @ArchTest
  static final ArchRule scenesAndSimulationUseNoAwt =
      noClasses()
          .that()
          .resideInAnyPackage("..testbed.scenes..", "..testbed.simulation..")
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage(
              "java.awt..", "javax.swing..", "javax.imageio..", "..testbed.paint..");

  /** What is painted are snapshots; a world that is being stepped is not within reach. */
  @ArchTest
  static final ArchRule windowAndPaintersKnowNoWorld =
      noClasses()
          .that()
          .resideInAnyPackage("..testbed.ui..", "..testbed.paint..")
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage(
              "org.jbox2d.fracture..",
              "org.jbox2d.dynamics.contacts..",
              "org.jbox2d.dynamics.joints..",
              "org.jbox2d.collision..")
          .orShould()
          .dependOnClassesThat()
          .haveNameMatching("org\\.jbox2d\\.dynamics\\.(World|Body|Fixture)");

  @ArchTest
  static final ArchRule swingIsOfTheWindowAlone =
      noClasses()
          .that()
          .resideOutsideOfPackage("..testbed.ui..")
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage("javax.swing..", "com.formdev..");

  @ArchTest
  static final ArchRule scenesKnowNothingOfTheRest =
      noClasses()
          .that()
          .resideInAPackage("..testbed.scenes..")
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage("..testbed.simulation..", "..testbed.headless..", "..testbed.ui..");

  @ArchTest
  static final ArchRule theRunnerKnowsNothingOfTheWindow =
      noClasses()
          .that()
          .resideInAnyPackage("..testbed.headless..", "..testbed.paint..")
          .should()
          .dependOnClassesThat()
          .resideInAPackage("..testbed.ui..");

  @ArchTest
  static final ArchRule onlyPublicPackagesOfTheEngineAreUsed =
      noClasses()
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage(
              "org.jbox2d.internal..",
              "org.jbox2d.collision.narrowphase..",
              "org.jbox2d.dynamics.solver..",
              "org.jbox2d.fracture.impact..",
              "org.jbox2d.fracture.assembly..",
              "org.jbox2d.fracture.fragmentation..",
              "org.jbox2d.fracture.geometry..",
              "org.jbox2d.fracture.hertelmehlhorn..",
              "org.jbox2d.fracture.triangulation..",
              "org.jbox2d.fracture.voronoi..");
}
