package org.jbox2d.benchmarks.accuracy;

import java.util.List;
import org.jbox2d.benchmarks.engines.Kind;
import org.jbox2d.benchmarks.engines.Matter;
import org.jbox2d.benchmarks.engines.Sim;
import org.jbox2d.benchmarks.engines.SimBody;

/** One joint, or a few: pendulums, springs, motors, limits, rails. */
final class JointScenes {
  private static final double G = 10;
  private static final Matter IRON = Matter.smooth(1);

  private JointScenes() {}

  static List<Scene> all() {
    return List.of(
        pendulumPeriod(),
        pendulumEnergy(),
        physicalPendulum(),
        doublePendulum(),
        doublePendulumEnergy(),
        motor(),
        hingeLimit(),
        spring(),
        springSag(),
        rail(),
        rope(),
        pulley(),
        seesaw());
  }

  /** Times of upward zero crossings, by linear interpolation. */
  private abstract static class Crossings implements Run {
    private final double truth;
    private double last;
    private double first = Double.NaN;
    private double latest;
    private int count;

    Crossings(double truth, double start) {
      this.truth = truth;
      last = start;
    }

    abstract double value();

    @Override
    public void after(double time, double dt) {
      double now = value();
      if (last < 0 && now >= 0) {
        latest = time - dt * now / (now - last);
        if (Double.isNaN(first)) {
          first = latest;
        } else {
          count++;
        }
      }
      last = now;
    }

    @Override
    public double error(double time) {
      return count == 0 ? 1 : Math.abs((latest - first) / count / truth - 1);
    }
  }

  private static Scene pendulumPeriod() {
    double length = 1;
    double truth = Truth.period(Math.sqrt(G / length), Math.PI / 2);
    return new Scene(
        "pendulum_period",
        12,
        0.01,
        "a bob on a rod, let go level: the period by the elliptic integral; a clock off by 1 %",
        sim -> {
          SimBody bob = sim.dynamic(length, 0).disc(0.1, IRON);
          sim.rod(sim.ground(), 0, 0, bob, length, 0);
          return new Crossings(truth, length) {
            @Override
            double value() {
              return bob.x();
            }
          };
        });
  }

  private static Scene pendulumEnergy() {
    double length = 1;
    double period = Truth.period(Math.sqrt(G / length), Math.PI / 2);
    return new Scene(
        "pendulum_energy",
        20,
        0.1,
        "the same swings to its height again after 20 s, to a tenth",
        sim -> {
          SimBody bob = sim.dynamic(length, 0).disc(0.1, IRON);
          sim.rod(sim.ground(), 0, 0, bob, length, 0);
          return new Run() {
            private double highest = Double.NEGATIVE_INFINITY;

            @Override
            public void after(double time, double dt) {
              if (time > 20 - period) {
                highest = Math.max(highest, bob.y());
              }
            }

            @Override
            public double error(double time) {
              return Math.abs(highest) / length;
            }
          };
        });
  }

  private static Scene physicalPendulum() {
    double a = 0.05;
    double amplitude = Math.toRadians(60);
    double inertia = (1 + a * a) / 3 + 1;
    double truth = Truth.period(Math.sqrt(G / inertia), amplitude);
    return new Scene(
        "physical_pendulum",
        12,
        0.01,
        "a rod hinged at its end, let go at 60 degrees: the period by the elliptic integral",
        sim -> {
          double x = StrictMath.sin(amplitude);
          double y = -StrictMath.cos(amplitude);
          SimBody rod = sim.body(Kind.DYNAMIC, x, y, amplitude).box(a, 1, IRON);
          sim.hinge(sim.ground(), rod, 0, 0);
          return new Crossings(truth, x) {
            @Override
            double value() {
              return rod.x();
            }
          };
        });
  }

  /** Two equal bobs on rods of 1 m; angles from straight down. */
  private static void slope(double[] s, double[] d) {
    double delta = s[0] - s[2];
    double cos = StrictMath.cos(delta);
    double sin = StrictMath.sin(delta);
    double g1 = -G * StrictMath.sin(s[0]);
    double g2 = -G * StrictMath.sin(s[2]);
    // 2 a1 + a2 cos = 2 g1 - w2^2 sin;  a1 cos + a2 = g2 + w1^2 sin
    double p = 2 * g1 - s[3] * s[3] * sin;
    double q = g2 + s[1] * s[1] * sin;
    double determinant = 2 - cos * cos;
    d[0] = s[1];
    d[1] = (p - q * cos) / determinant;
    d[2] = s[3];
    d[3] = (2 * q - p * cos) / determinant;
  }

  private static SimBody[] twoBobs(Sim sim) {
    SimBody first = sim.dynamic(1, 0).disc(0.1, IRON);
    SimBody second = sim.dynamic(2, 0).disc(0.1, IRON);
    sim.rod(sim.ground(), 0, 0, first, 1, 0);
    sim.rod(first, 1, 0, second, 2, 0);
    return new SimBody[] {first, second};
  }

  private static Scene doublePendulum() {
    return new Scene(
        "double_pendulum",
        1.5,
        0.05,
        "two bobs let go level, after 1.5 s as the equations of motion have them; 5 % of its length",
        sim -> {
          SimBody[] bobs = twoBobs(sim);
          return t -> {
            double[] start = {Math.PI / 2, 0, Math.PI / 2, 0};
            double[] s = Truth.integrate(start, t, JointScenes::slope);
            double x = StrictMath.sin(s[0]) + StrictMath.sin(s[2]);
            double y = -StrictMath.cos(s[0]) - StrictMath.cos(s[2]);
            return Math.hypot(bobs[1].x() - x, bobs[1].y() - y) / 2;
          };
        });
  }

  private static Scene doublePendulumEnergy() {
    return new Scene(
        "double_pend_energy",
        20,
        0.1,
        "the same keeps its energy for 20 s, to a tenth of what it has above its rest",
        sim -> {
          SimBody[] bobs = twoBobs(sim);
          return new Run() {
            private double sum;
            private double span;

            @Override
            public void after(double time, double dt) {
              if (time > 18) {
                for (SimBody b : bobs) {
                  sum += (0.5 * (b.vx() * b.vx() + b.vy() * b.vy()) + G * b.y()) * dt;
                }
                span += dt;
              }
            }

            @Override
            public double error(double time) {
              return Math.abs(sum / span) / (3 * G);
            }
          };
        });
  }

  private static Scene motor() {
    double torque = 2;
    double inertia = 0.5 * Math.PI;
    return new Scene(
        "motor",
        2,
        0.01,
        "a motor of limited torque speeds up a flywheel at torque over inertia",
        sim -> {
          SimBody wheel = sim.dynamic(0, 0).disc(1, IRON);
          sim.motor(sim.ground(), wheel, 0, 0, 100, torque);
          return t -> Math.abs(wheel.w() / (torque / inertia * t) - 1);
        });
  }

  private static Scene hingeLimit() {
    double limit = Math.PI / 4;
    return new Scene(
        "hinge_limit",
        4,
        0.02,
        "a trapdoor falls to its limit of 45 degrees and stays there, to a degree",
        sim -> {
          SimBody door = sim.dynamic(1, 0).box(1, 0.05, IRON);
          sim.limited(sim.ground(), door, 0, 0, -limit, limit);
          return new Run() {
            private double worst;

            @Override
            public void after(double time, double dt) {
              if (time > 2) {
                worst = Math.max(worst, Math.abs(door.angle() + limit) / limit);
              }
            }

            @Override
            public double error(double time) {
              return worst;
            }
          };
        });
  }

  private static Scene spring() {
    double v = 2;
    double w = 2 * Math.PI;
    double amplitude = v / w;
    return new Scene(
        "spring",
        2,
        0.1,
        "an undamped spring of 1 Hz: v/w sin(w t) for two swings, to a tenth of the amplitude",
        sim -> {
          sim.gravity(0, 0);
          SimBody ball = sim.dynamic(2, 0).disc(0.25, IRON).move(v, 0, 0);
          sim.spring(sim.ground(), 0, 0, ball, 2, 0, 1, 0);
          return new Run() {
            private double worst;

            @Override
            public void after(double time, double dt) {
              double truth = 2 + amplitude * StrictMath.sin(w * time);
              worst = Math.max(worst, Math.abs(ball.x() - truth) / amplitude);
            }

            @Override
            public double error(double time) {
              return worst;
            }
          };
        });
  }

  private static Scene springSag() {
    double w = 2 * Math.PI * 2;
    double sag = G / (w * w);
    return new Scene(
        "spring_sag",
        5,
        0.02,
        "a load on a damped spring of 2 Hz hangs g/w^2 lower; scales are read to 2 %",
        sim -> {
          SimBody load = sim.dynamic(0, -2).disc(0.25, IRON);
          sim.spring(sim.ground(), 0, 0, load, 0, -2, 2, 0.5);
          return t -> Math.abs((-2 - load.y()) / sag - 1);
        });
  }

  private static Scene rail() {
    double angle = Math.toRadians(-30);
    double ux = StrictMath.cos(angle);
    double uy = StrictMath.sin(angle);
    return new Scene(
        "rail",
        2,
        0.02,
        "a slider on a rail of 30 degrees has half of g along it and never leaves it or turns",
        sim -> {
          SimBody slider = sim.dynamic(0, 0).box(0.5, 0.2, IRON);
          sim.rail(sim.ground(), slider, 0, 0, ux, uy);
          return t -> {
            double way = 0.25 * G * t * t;
            double off = Math.hypot(slider.x() - way * ux, slider.y() - way * uy) / way;
            return Math.max(off, Math.abs(slider.angle()));
          };
        });
  }

  private static Scene rope() {
    double length = 2;
    return new Scene(
        "rope",
        5,
        0.01,
        "a ball falls into a rope: its distance never exceeds the length by more than 2 cm",
        sim -> {
          SimBody hook = sim.ground().disc(0.01, IRON);
          SimBody ball = sim.dynamic(1, 0).disc(0.2, IRON);
          sim.rope(hook, ball, length);
          return new Run() {
            private double worst;

            @Override
            public void after(double time, double dt) {
              worst = Math.max(worst, Math.hypot(ball.x(), ball.y()) / length - 1);
            }

            @Override
            public double error(double time) {
              return worst;
            }
          };
        });
  }

  private static Scene pulley() {
    return new Scene(
        "pulley",
        1.5,
        0.03,
        "Atwood's machine, 1 against 2: g/3, to 3 % of the way",
        sim -> {
          SimBody light = sim.dynamic(-1, -4).disc(0.25, IRON);
          SimBody heavy = sim.dynamic(1, -4).disc(0.25, Matter.smooth(2));
          sim.pulley(light, -1, 2, heavy, 1, 2);
          return t -> {
            double way = 0.5 * G / 3 * t * t;
            return Math.max(
                Math.abs((light.y() + 4) / way - 1), Math.abs((heavy.y() + 4) / way + 1));
          };
        });
  }

  private static Scene seesaw() {
    double torqueArm = 2;
    return new Scene(
        "seesaw",
        5,
        0.02,
        "loads in the ratio of their arms, fixed to a beam on a hinge, balance; a degree of tilt",
        sim -> {
          SimBody beam =
              sim.dynamic(0, 0)
                  .box(2.5, 0.05, IRON)
                  .box(0.1, 0.1, -torqueArm, 0.15, IRON)
                  .box(0.2, 0.1, torqueArm / 2, 0.15, IRON);
          sim.hinge(sim.ground(), beam, 0, 0);
          return t -> Math.abs(Truth.turn(beam.angle()));
        });
  }
}
