package org.jbox2d.architecture;

import static com.tngtech.archunit.base.DescribedPredicate.describe;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.core.importer.Location;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import java.util.Random;
import java.util.Set;

/**
 * The directions of dependency between the packages of the library.
 *
 * <p>JBox2D's own signatures force these cycles, and no others are allowed: pooling, callbacks,
 * dynamics, contacts and joints name each other's types (a contact its fixtures, a body its joints,
 * a listener its contacts, a pool its contacts), and the box of collision takes a pool.
 */
@AnalyzeClasses(
    packages = "org.jbox2d",
    importOptions = {
      ImportOption.DoNotIncludeTests.class,
      ArchitectureTest.DoNotIncludeUpstream.class
    })
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

  private static final String RANDOM_FLOAT = "org.jbox2d.common.MathUtils.randomFloat";

  private static final String[] JDK = {"java.."};

  /** JBox2D's own testbed and serializer, on the class path of the tests, are not ours. */
  static final class DoNotIncludeUpstream implements ImportOption {
    @Override
    public boolean includes(Location location) {
      return !location.contains("/jbox2d-testbed-2.2.1.1.jar")
          && !location.contains("/jbox2d-serialization-1.1.0.jar");
    }
  }

  @ArchTest
  static final ArchRule commonUsesTheJdkAlone =
      classes()
          .that()
          .resideInAPackage("org.jbox2d.common..")
          .should()
          .onlyDependOnClassesThat()
          .resideInAnyPackage(with("org.jbox2d.common.."));

  @ArchTest
  static final ArchRule internalUsesCommon =
      classes()
          .that()
          .resideInAPackage("org.jbox2d.internal..")
          .should()
          .onlyDependOnClassesThat()
          .resideInAnyPackage(with("org.jbox2d.internal..", "org.jbox2d.common.."));

  @ArchTest
  static final ArchRule solverKnowsNoBodyContactOrJoint =
      classes()
          .that()
          .resideInAPackage("org.jbox2d.dynamics.solver..")
          .should()
          .onlyDependOnClassesThat()
          .resideInAnyPackage(
              with("org.jbox2d.dynamics.solver..", "org.jbox2d.common..", "org.jbox2d.internal.."));

  @ArchTest
  static final ArchRule collisionKnowsNoDynamics =
      noClasses()
          .that()
          .resideInAPackage("org.jbox2d.collision..")
          .should()
          .dependOnClassesThat()
          .resideInAPackage("org.jbox2d.dynamics..");

  @ArchTest
  static final ArchRule narrowPhaseKnowsNoBroadPhase =
      noClasses()
          .that()
          .resideInAPackage("org.jbox2d.collision.narrowphase..")
          .should()
          .dependOnClassesThat()
          .resideInAPackage("org.jbox2d.collision.broadphase..");

  @ArchTest
  static final ArchRule nothingUsesFractureAwtOrReflection =
      noClasses()
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage(
              "org.jbox2d.fracture..", "java.awt..", "javax.swing..", "java.lang.reflect..");

  /**
   * Two worlds share nothing but the tuning constants and the counters that JBox2D's API has (which
   * nothing counts in).
   */
  @ArchTest
  static final ArchRule noStaticState =
      fields()
          .that()
          .areStatic()
          .and()
          .areDeclaredInClassesThat()
          .doNotHaveFullyQualifiedName("org.jbox2d.common.Settings")
          .and()
          .areDeclaredInClassesThat()
          .doNotHaveFullyQualifiedName("org.jbox2d.collision.Distance")
          .and()
          .areDeclaredInClassesThat()
          .doNotHaveFullyQualifiedName("org.jbox2d.collision.TimeOfImpact")
          .should()
          .haveModifier(JavaModifier.FINAL);

  /**
   * Virtual machines may round these differently; {@code randomFloat} is JBox2D's, and the engine
   * has no use for it.
   */
  @ArchTest
  static final ArchRule nothingThatDiffersBetweenMachines =
      noClasses()
          .should()
          .callMethodWhere(
              describe(
                  "mathematics of the platform, randomness and identities",
                  call ->
                      !call.getOrigin().getFullName().startsWith(RANDOM_FLOAT)
                          && DIFFERING.contains(
                              call.getTargetOwner().getName() + "." + call.getName())))
          .orShould()
          .callConstructor(Random.class);

  private static String[] with(String... packages) {
    String[] all = new String[packages.length + JDK.length];
    System.arraycopy(packages, 0, all, 0, packages.length);
    System.arraycopy(JDK, 0, all, packages.length, JDK.length);
    return all;
  }
}
