package org.jbox2d.benchmarks.accuracy;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.jbox2d.benchmarks.engines.OurSim;
import org.jbox2d.benchmarks.engines.Sim;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;
import org.jbox2d.fracture.FractureSystem;
import org.jbox2d.fracture.Material;
import org.jbox2d.fracture.materials.Glass;
import org.jbox2d.fracture.materials.Uniform;
import org.jbox2d.testbed.simulation.Totals;

/** Bodies that break, in this project's solvers alone. */
final class FractureScenes {
  private static final long SEED = 7;
  private static final double SHOT_SPEED = 60;
  private static final float SHOT_DENSITY = 5f;

  private FractureScenes() {}

  static List<Scene> all() {
    return List.of(
        shot("fracture_mass", 0.001, "pieces have the mass of the whole", Shot::mass),
        shot("fracture_momentum", 0.001, "momentum is that of the shot", Shot::momentum),
        shot("fracture_spin", 0.01, "angular momentum is that of the shot", Shot::spin),
        shot("fracture_energy", 0.01, "breaking never adds energy", Shot::energy),
        threshold(),
        throughGlass(),
        pileAtRest(),
        restingLoad());
  }

  private static World worldOf(Sim sim) {
    World world = ((OurSim) sim).world();
    FractureSystem.of(world).setSeed(SEED);
    return world;
  }

  private static Body body(
      World world, BodyType type, double x, double y, Shape shape, float density, Material m) {
    BodyDef def = new BodyDef();
    def.type = type;
    def.position.set((float) x, (float) y);
    Body body = world.createBody(def);
    FixtureDef fixture = new FixtureDef();
    fixture.shape = shape;
    fixture.density = density;
    fixture.friction = 0.5f;
    fixture.material = m;
    body.createFixture(fixture);
    return body;
  }

  private static PolygonShape box(double halfWidth, double halfHeight) {
    PolygonShape shape = new PolygonShape();
    shape.setAsBox((float) halfWidth, (float) halfHeight);
    return shape;
  }

  private static CircleShape disc(double radius) {
    CircleShape shape = new CircleShape();
    shape.m_radius = (float) radius;
    return shape;
  }

  private static Body shoot(World world, double x, double y, double speed) {
    Body shot = body(world, BodyType.DYNAMIC, x, y, disc(0.5), SHOT_DENSITY, null);
    shot.m_linearVelocity.set((float) speed, 0f);
    shot.setBullet(true);
    return shot;
  }

  /** What a shot at a block of stone has changed. */
  private static final class Shot {
    final World world;
    final Totals before;
    Totals now;
    double gained;

    Shot(World world) {
      this.world = world;
      before = Totals.of(world);
      now = before;
    }

    void look() {
      Totals last = now;
      now = Totals.of(world);
      gained = Math.max(gained, now.kineticEnergy() - last.kineticEnergy());
    }

    double mass() {
      return Math.abs(now.mass() / before.mass() - 1);
    }

    double momentum() {
      return Math.hypot(now.momentumX() - before.momentumX(), now.momentumY() - before.momentumY())
          / before.momentumX();
    }

    double spin() {
      return Math.abs(now.angularMomentum() / before.angularMomentum() - 1);
    }

    double energy() {
      return gained / before.kineticEnergy();
    }
  }

  /** Reads one error off a shot. */
  @FunctionalInterface
  private interface Reading {
    double of(Shot shot);
  }

  private static Scene shot(String name, double limit, String truth, Reading reading) {
    return new Scene(
        name,
        2,
        limit,
        "a ball of 60 m/s breaks a free block, without gravity: " + truth + ", to " + limit,
        sim -> {
          sim.gravity(0, 0);
          World world = worldOf(sim);
          Material stone = new Uniform();
          stone.m_rigidity = 20f;
          body(world, BodyType.DYNAMIC, 0, 0, box(2, 3), 1f, stone);
          shoot(world, -6, 1, SHOT_SPEED);
          Shot shot = new Shot(world);
          return new Run() {
            @Override
            public void after(double time, double dt) {
              shot.look();
            }

            @Override
            public double error(double time) {
              boolean broke = FractureSystem.of(world).getFractureCount() > 0;
              return broke ? reading.of(shot) : 1;
            }
          };
        });
  }

  /** Boxes hit walls with impulses of 0.8 to 1.2 of what they bear. */
  private static Scene threshold() {
    int n = 81;
    double mass = 4;
    double rigidity = 40;
    return new Scene(
        "fracture_threshold",
        1,
        0.03,
        "a box breaks at a wall if its momentum exceeds its rigidity, whatever the frame rate; 3 %",
        sim -> {
          sim.gravity(0, 0);
          World world = worldOf(sim);
          Set<Material> broken = new HashSet<>();
          FractureSystem.of(world)
              .setListener((material, intensity, fragments) -> broken.add(material));
          for (int i = 0; i < n; i++) {
            Material m = new Uniform();
            m.m_rigidity = (float) rigidity;
            m.m_fragments = null;
            body(world, BodyType.STATIC, 3, 8 * i, box(0.5, 3), 0f, null);
            Body b = body(world, BodyType.DYNAMIC, 0, 8 * i, box(1, 1), 1f, m);
            double part = 0.8 + 0.4 * i / (n - 1);
            b.m_linearVelocity.set((float) (part * rigidity / mass), 0f);
          }
          return t -> {
            double found = 1.2 - 0.4 * (broken.size() - 0.5) / (n - 1);
            return Math.abs(found - 1);
          };
        });
  }

  private static Scene throughGlass() {
    double wall = 8;
    return new Scene(
        "fracture_bullet",
        2,
        0.2,
        "a bullet breaks a pane and goes on to a wall: neither it nor a piece gets through that",
        sim -> {
          World world = worldOf(sim);
          Material glass = new Glass();
          glass.m_rigidity = 5f;
          body(world, BodyType.STATIC, wall + 0.25, 0, box(0.25, 400), 0f, null);
          body(world, BodyType.STATIC, 0, -4, box(40, 0.5), 0f, null);
          Body pane = body(world, BodyType.DYNAMIC, 0, 0, box(0.2, 3.4), 1f, glass);
          shoot(world, -4, 0, 150);
          return new Run() {
            private double beyond;

            @Override
            public void after(double time, double dt) {
              for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
                if (b.getType() == BodyType.DYNAMIC && b != pane) {
                  beyond = Math.max(beyond, b.getWorldCenter().x - wall);
                }
              }
            }

            @Override
            public double error(double time) {
              return FractureSystem.of(world).getFractureCount() > 0 ? beyond : 1;
            }
          };
        });
  }

  private static Scene pileAtRest() {
    return new Scene(
        "fracture_pile",
        8,
        0.1,
        "a block that broke on the floor lies still after 8 s: its fastest piece is below 0.1 m/s",
        sim -> {
          World world = worldOf(sim);
          Material stone = new Uniform();
          stone.m_rigidity = 30f;
          stone.m_fragments = null;
          body(world, BodyType.STATIC, 0, -1, box(40, 1), 0f, null);
          body(world, BodyType.STATIC, -6, 2, box(1, 4), 0f, null);
          body(world, BodyType.STATIC, 6, 2, box(1, 4), 0f, null);
          body(world, BodyType.DYNAMIC, 0, 8, box(2, 2), 1f, stone);
          return t -> {
            double fastest = 0;
            for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
              fastest = Math.max(fastest, b.getLinearVelocity().length());
            }
            return FractureSystem.of(world).getFractureCount() > 0 ? fastest : 1;
          };
        });
  }

  private static Scene restingLoad() {
    int n = 10;
    return new Scene(
        "fracture_resting",
        4,
        0.05,
        "a stack of breakable blocks does not break under its own weight: the part that does",
        sim -> {
          World world = worldOf(sim);
          Set<Material> broken = new HashSet<>();
          FractureSystem.of(world)
              .setListener((material, intensity, fragments) -> broken.add(material));
          body(world, BodyType.STATIC, 0, -1, box(40, 1), 0f, null);
          for (int i = 0; i < n; i++) {
            Material stone = new Uniform();
            // A block presses with 0.67 Ns in a step of 1/60 s; the lowest bears ten times that.
            stone.m_rigidity = 5f;
            body(world, BodyType.DYNAMIC, 0, 2 * i + 1, box(1, 1), 1f, stone);
          }
          return t -> (double) broken.size() / n;
        });
  }
}
