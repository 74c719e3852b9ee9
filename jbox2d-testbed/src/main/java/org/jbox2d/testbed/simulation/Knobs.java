package org.jbox2d.testbed.simulation;

import static org.jbox2d.testbed.parameters.Parameter.Group.MATERIAL;
import static org.jbox2d.testbed.parameters.Parameter.Group.SOLVER;

import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import java.util.function.ObjDoubleConsumer;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.dynamics.World;
import org.jbox2d.fracture.FractureSystem;
import org.jbox2d.fracture.Material;
import org.jbox2d.testbed.parameters.Parameter;
import org.jbox2d.testbed.scenes.Scene;

/** The parameters of every run; their defaults are what the scene has been built with. */
final class Knobs {
  /** Limit of bodies that counts as none. */
  private static final int MANY_BODIES = 20_000;

  private static final int MANY_FRACTURES = 1000;

  private Knobs() {}

  /** Returns the knobs of a run whose world has just been built. */
  static List<Knob> of(Simulation run) {
    List<Knob> knobs = new ArrayList<>();
    addMaterial(knobs, run.world());
    knobs.addAll(SolverChoice.knobs());
    addStep(knobs, run);
    addGravity(knobs, run.world().getGravity());
    for (Parameter tool : Tools.ALL) {
      knobs.add(new Knob(tool, (r, value) -> {}));
    }
    return knobs;
  }

  // --- What breaks

  private static void addMaterial(List<Knob> knobs, World world) {
    List<Material> materials = materialsOf(world);
    if (materials.isEmpty()) {
      return;
    }
    Material first = materials.get(0);
    knobs.add(new Knob(MaterialKind.PARAMETER, Simulation::setMaterialKind));
    knobs.add(
        ofMaterials(
            Parameter.real(
                    MATERIAL,
                    "rigidity",
                    "N s",
                    0,
                    500,
                    0,
                    "Impulse of a blow above which a body breaks.")
                .startingAt(first.m_rigidity),
            (m, value) -> m.m_rigidity = (float) value));
    knobs.add(
        ofMaterials(
            Parameter.real(
                    MATERIAL, "shattering", "m", 0.1, 20, 1, "Relative size of the fragments.")
                .startingAt(first.m_shattering),
            (m, value) -> m.m_shattering = (float) value));
    knobs.add(
        ofMaterials(
            Parameter.real(
                    MATERIAL,
                    "radius",
                    "m",
                    0.1,
                    20,
                    1,
                    "Radius of the region that breaks away about an impact.")
                .startingAt(first.m_radius),
            (m, value) -> m.m_radius = (float) value));
    addLimits(knobs, FractureSystem.of(world).getMinimumArea());
  }

  private static void addLimits(List<Knob> knobs, float minimumArea) {
    knobs.add(
        new Knob(
            Parameter.real(
                    MATERIAL,
                    "minimum-area",
                    "m^2",
                    0.001,
                    20,
                    1,
                    "Area below which a body does not break any more.")
                .startingAt(minimumArea),
            (run, value) -> FractureSystem.of(run.world()).setMinimumArea((float) value)));
    knobs.add(
        new Knob(
            Parameter.whole(
                MATERIAL,
                "body-limit",
                0,
                MANY_BODIES,
                MANY_BODIES,
                "Number of bodies beyond which nothing breaks."),
            (run, value) -> FractureSystem.of(run.world()).setBodyLimit((int) value)));
    knobs.add(
        new Knob(
            Parameter.whole(
                MATERIAL,
                "fractures-per-step",
                0,
                MANY_FRACTURES,
                MANY_FRACTURES,
                "How many bodies may break in a step."),
            (run, value) -> FractureSystem.of(run.world()).setFracturesPerStep((int) value)));
  }

  private static Knob ofMaterials(Parameter parameter, ObjDoubleConsumer<Material> effect) {
    return new Knob(
        parameter,
        (run, value) -> {
          for (Material material : materialsOf(run.world())) {
            effect.accept(material, value);
          }
        });
  }

  /** The materials of all fixtures, and of what their splinters will be of, each once. */
  private static List<Material> materialsOf(World world) {
    Set<Material> seen = Collections.newSetFromMap(new IdentityHashMap<>());
    List<Material> materials = new ArrayList<>();
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      for (Fixture f = b.getFixtureList(); f != null; f = f.getNext()) {
        Material material = f.getMaterial() instanceof Material m ? m : null;
        while (material != null && seen.add(material)) {
          materials.add(material);
          material = material.m_fragments;
        }
      }
    }
    return materials;
  }

  // --- How it is solved

  private static void addStep(List<Knob> knobs, Simulation run) {
    knobs.add(
        new Knob(
            Parameter.real(SOLVER, "hz", "1/s", 5, 1000, Scene.DEFAULT_HZ, "Steps per second.")
                .startingAt(run.hz()),
            (r, value) -> r.setHz((float) value)));
    knobs.add(
        new Knob(
            Parameter.whole(
                SOLVER,
                "velocity-iterations",
                1,
                100,
                Scene.VELOCITY_ITERATIONS,
                "Iterations of sequential impulses over the velocities."),
            (r, value) -> r.setVelocityIterations((int) value)));
    knobs.add(
        new Knob(
            Parameter.whole(
                SOLVER,
                "position-iterations",
                1,
                100,
                Scene.POSITION_ITERATIONS,
                "Iterations of sequential impulses over the positions."),
            (r, value) -> r.setPositionIterations((int) value)));
    knobs.add(
        ofWorld(
            Parameter.toggle(
                SOLVER, "warm-starting", true, "Begin with the impulses of the last step."),
            (w, value) -> w.setWarmStarting(value != 0)));
    knobs.add(
        ofWorld(
            Parameter.toggle(SOLVER, "continuous", true, "Stop fast bodies at what they meet."),
            (w, value) -> w.setContinuousPhysics(value != 0)));
    knobs.add(
        ofWorld(
            Parameter.toggle(SOLVER, "sleeping", true, "Leave bodies at rest out."),
            (w, value) -> w.setSleepingAllowed(value != 0)));
  }

  private static void addGravity(List<Knob> knobs, Vec2 gravity) {
    knobs.add(
        ofWorld(
            Parameter.real(SOLVER, "gravity-x", "m/s^2", -50, 50, 0, "Gravity to the right.")
                .startingAt(gravity.x),
            (w, value) -> {
              w.setGravity(new Vec2((float) value, w.getGravity().y));
              wakeAll(w);
            }));
    knobs.add(
        ofWorld(
            Parameter.real(SOLVER, "gravity-y", "m/s^2", -50, 50, 0, "Gravity upwards.")
                .startingAt(gravity.y),
            (w, value) -> {
              w.setGravity(new Vec2(w.getGravity().x, (float) value));
              wakeAll(w);
            }));
  }

  private static void wakeAll(World world) {
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      b.setAwake(true);
    }
  }

  private static Knob ofWorld(Parameter parameter, ObjDoubleConsumer<World> effect) {
    return new Knob(parameter, (run, value) -> effect.accept(run.world(), value));
  }
}
