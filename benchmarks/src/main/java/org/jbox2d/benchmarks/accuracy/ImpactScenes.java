package org.jbox2d.benchmarks.accuracy;

import java.util.ArrayList;
import java.util.List;
import org.jbox2d.benchmarks.engines.Kind;
import org.jbox2d.benchmarks.engines.Matter;
import org.jbox2d.benchmarks.engines.Sim;
import org.jbox2d.benchmarks.engines.SimBody;

/** Collisions: momentum, energy, and which way things go. */
final class ImpactScenes {
  private static final double G = 10;

  private ImpactScenes() {}

  static List<Scene> all() {
    return List.of(
        headOn("elastic_pair", 1, 1),
        headOn("elastic_unequal", 1, 3),
        headOn("restitution_half", 0.5, 1),
        headOn("inelastic_pair", 0, 2),
        oblique(),
        rodStruck(),
        bounce(),
        bounceOn(),
        cradle("cradle_apart", 0.05, 0.02, "one after the other"),
        cradle("cradle_touching", 0, 0.1, "all at once, as the toy does it"),
        cradleHung(),
        billiardBreak(),
        gas(),
        clump());
  }

  /** A disc hits another at rest: v1 = (m1 - e m2) v / M, v2 = (1 + e) m1 v / M. */
  private static Scene headOn(String name, double e, double mass) {
    double v = 5;
    double v1 = (1 - e * mass) * v / (1 + mass);
    double v2 = (1 + e) * v / (1 + mass);
    return new Scene(
        name,
        1,
        0.01,
        "momentum and restitution "
            + e
            + " at a mass of 1 to "
            + mass
            + " give both speeds exactly",
        sim -> {
          sim.gravity(0, 0);
          SimBody a = sim.dynamic(-2, 0).disc(0.5, Matter.bouncy(1, e)).move(v, 0, 0);
          SimBody b = sim.dynamic(0, 0).disc(0.5, Matter.bouncy(mass, e));
          return t -> Math.max(Math.abs(a.vx() - v1), Math.abs(b.vx() - v2)) / v;
        });
  }

  private static Scene oblique() {
    double v = 8;
    return new Scene(
        "oblique",
        1,
        0.05,
        "the struck ball leaves along the line of centres at first touch; 3 degrees miss a pocket",
        sim -> {
          sim.gravity(0, 0);
          Matter ivory = Matter.bouncy(1, 1);
          SimBody a = sim.dynamic(-3, 0.6).disc(0.5, ivory).move(v, 0, 0).bullet();
          SimBody b = sim.dynamic(0, 0).disc(0.5, ivory).bullet();
          double bx = v * 0.8 * 0.8;
          double by = -v * 0.8 * 0.6;
          return t ->
              Math.max(
                      Math.hypot(b.vx() - bx, b.vy() - by),
                      Math.hypot(a.vx() - (v - bx), a.vy() + by))
                  / v;
        });
  }

  /** A disc hits a free rod near its end: the impulse is (1 + e) v / (1/m + 1/M + d^2/I). */
  private static Scene rodStruck() {
    double v = 5;
    double arm = 0.9;
    double m = Math.PI * 0.01;
    double rod = 2 * 0.1;
    double inertia = rod * (4 + 0.01) / 12;
    double impulse = 2 * v / (1 / m + 1 / rod + arm * arm / inertia);
    return new Scene(
        "rod_struck",
        0.3,
        0.02,
        "an elastic blow near the end of a free rod: speed and spin by momentum and energy",
        sim -> {
          sim.gravity(0, 0);
          Matter steel = Matter.bouncy(1, 1);
          SimBody target = sim.dynamic(0, 0).box(1, 0.05, steel);
          SimBody ball = sim.dynamic(arm, -0.4).disc(0.1, steel).move(0, v, 0);
          return t ->
              Math.max(
                  Math.abs(ball.vy() - (v - impulse / m)) / v,
                  Math.max(
                      Math.abs(target.vy() * rod / impulse - 1),
                      Math.abs(target.w() * inertia / (impulse * arm) - 1)));
        });
  }

  /** Keeps the greatest height since the last time that the ball came up from a floor. */
  private abstract static class Peaks implements Run {
    final List<Double> heights = new ArrayList<>();
    private double highest = Double.NEGATIVE_INFINITY;
    private boolean falling = true;

    abstract double height();

    abstract double speed();

    @Override
    public void after(double time, double dt) {
      if (falling && speed() > 0) {
        falling = false;
        highest = Double.NEGATIVE_INFINITY;
      }
      if (!falling) {
        if (height() < highest) {
          heights.add(highest);
          falling = true;
        }
        highest = Math.max(highest, height());
      }
    }
  }

  private static Peaks watch(SimBody ball, double rest) {
    return new Peaks() {
      @Override
      double height() {
        return ball.y() - rest;
      }

      @Override
      double speed() {
        return ball.vy();
      }

      @Override
      public double error(double time) {
        throw new UnsupportedOperationException();
      }
    };
  }

  private static SimBody dropped(Sim sim, double e, double height) {
    sim.ground().box(10, 0.5, 0, -0.5, Matter.bouncy(0, e));
    return sim.dynamic(0, 0.25 + height).disc(0.25, Matter.bouncy(1, e));
  }

  private static Scene bounce() {
    double e = 0.8;
    double h = 2;
    return new Scene(
        "bounce",
        3,
        0.1,
        "the n-th bounce reaches h e^(2n), n = 1 to 3; a tenth of a height is seen",
        sim -> {
          Peaks peaks = watch(dropped(sim, e, h), 0.25);
          return new Run() {
            @Override
            public void after(double time, double dt) {
              peaks.after(time, dt);
            }

            @Override
            public double error(double time) {
              double worst = peaks.heights.size() < 3 ? 1 : 0;
              double truth = h;
              for (int n = 0; n < Math.min(3, peaks.heights.size()); n++) {
                truth *= e * e;
                worst = Math.max(worst, Math.abs(peaks.heights.get(n) / truth - 1));
              }
              return worst;
            }
          };
        });
  }

  private static Scene bounceOn() {
    double h = 1;
    return new Scene(
        "bounce_on",
        10,
        0.1,
        "a perfectly elastic ball comes back to its height after ten bounces, to a tenth",
        sim -> {
          Peaks peaks = watch(dropped(sim, 1, h), 0.25);
          return new Run() {
            @Override
            public void after(double time, double dt) {
              peaks.after(time, dt);
            }

            @Override
            public double error(double time) {
              int n = peaks.heights.size();
              return n < 5 ? 1 : Math.abs(peaks.heights.get(n - 1) / h - 1);
            }
          };
        });
  }

  private static Scene cradle(String name, double gap, double limit, String how) {
    int n = 5;
    double v = 5;
    return new Scene(
        name,
        1.5,
        limit,
        "the last of five equal balls takes the speed of the first, " + how,
        sim -> {
          sim.gravity(0, 0);
          Matter steel = Matter.bouncy(1, 1);
          SimBody[] balls = new SimBody[n];
          for (int i = 0; i < n; i++) {
            double x = i == 0 ? -2 : (1 + gap) * (i - 1);
            balls[i] = sim.dynamic(x, 0).disc(0.5, steel);
          }
          balls[0].move(v, 0, 0);
          return t -> {
            double worst = 0;
            for (int i = 0; i < n; i++) {
              worst = Math.max(worst, Math.abs(balls[i].vx() - (i == n - 1 ? v : 0)) / v);
            }
            return worst;
          };
        });
  }

  private static Scene cradleHung() {
    int n = 5;
    double length = 3;
    double lift = Math.toRadians(30);
    double quarter = Truth.period(Math.sqrt(G / length), lift) / 4;
    return new Scene(
        "cradle_hung",
        Math.round(2 * quarter * 30) / 30.0,
        0.1,
        "on strings: when the first comes down, only the last goes up, as far as the first was",
        sim -> {
          Matter steel = Matter.bouncy(1, 1);
          SimBody[] balls = new SimBody[n];
          for (int i = 0; i < n; i++) {
            double a = i == 0 ? lift : 0;
            double x = i - length * StrictMath.sin(a);
            double y = -length * StrictMath.cos(a);
            balls[i] = sim.dynamic(x, y).disc(0.5, steel);
            sim.rod(sim.ground(), i, 0, balls[i], x, y);
          }
          return t -> {
            double worst = 0;
            for (int i = 0; i < n; i++) {
              double angle = StrictMath.atan2(balls[i].x() - i, -balls[i].y());
              worst = Math.max(worst, Math.abs(angle - (i == n - 1 ? lift : 0)) / lift);
            }
            return worst;
          };
        });
  }

  private static double energy(List<SimBody> balls) {
    double sum = 0;
    for (SimBody b : balls) {
      sum += 0.5 * (b.vx() * b.vx() + b.vy() * b.vy());
    }
    return sum;
  }

  private static Scene billiardBreak() {
    double v = 10;
    return new Scene(
        "billiard_break",
        1,
        0.05,
        "15 touching elastic balls share the energy of the one that hits them, and no more",
        sim -> {
          sim.gravity(0, 0);
          Matter ivory = Matter.bouncy(1, 1);
          List<SimBody> balls = new ArrayList<>();
          for (int row = 0; row < 5; row++) {
            for (int i = 0; i <= row; i++) {
              double x = row * 0.5 * Math.sqrt(3);
              balls.add(sim.dynamic(x, i - 0.5 * row).disc(0.5, ivory));
            }
          }
          balls.add(sim.dynamic(-2, 0.1).disc(0.5, ivory).move(v, 0, 0));
          return t -> Math.abs(energy(balls) / (0.5 * v * v) - 1);
        });
  }

  private static Scene gas() {
    int n = 5;
    double speed = 4;
    return new Scene(
        "gas",
        10,
        0.1,
        "25 elastic balls in a box keep their energy over some 500 collisions, to a tenth",
        sim -> {
          sim.gravity(0, 0);
          Matter ideal = Matter.bouncy(1, 1);
          SimBody wall = sim.body(Kind.STATIC, 0, 0, 0);
          wall.box(6, 0.5, 0, 5.5, ideal).box(6, 0.5, 0, -5.5, ideal);
          wall.box(0.5, 6, 5.5, 0, ideal).box(0.5, 6, -5.5, 0, ideal);
          List<SimBody> balls = new ArrayList<>();
          for (int i = 0; i < n * n; i++) {
            double direction = 2.4 * i;
            balls.add(
                sim.dynamic(1.5 * (i % n) - 3, 1.5 * (i / n) - 3)
                    .disc(0.4, ideal)
                    .move(speed * StrictMath.cos(direction), speed * StrictMath.sin(direction), 0));
          }
          return t -> Math.abs(energy(balls) / (0.5 * n * n * speed * speed) - 1);
        });
  }

  /** Six boxes fly into each other, off their centres, and stay together more or less. */
  private static Scene clump() {
    int n = 6;
    double half = 0.5;
    double reach = 2.5;
    return new Scene(
        "clump",
        2,
        0.01,
        "boxes that strike each other in free space keep their angular momentum, to a hundredth: by"
            + " that a clump is 7 degrees ahead after two turns",
        sim -> {
          sim.gravity(0, 0);
          List<SimBody> boxes = new ArrayList<>();
          for (int i = 0; i < n; i++) {
            double a = (2 * Math.PI * i + 0.7 * StrictMath.sin(i)) / n;
            double aim = a + Math.PI + 0.25;
            double speed = 8 + 2 * StrictMath.cos(3 * i);
            boxes.add(
                sim.dynamic(reach * StrictMath.cos(a), reach * StrictMath.sin(a))
                    .box(half, 0.6 * half, Matter.rough(1, 0.5))
                    .move(speed * StrictMath.cos(aim), speed * StrictMath.sin(aim), 0.5 * i));
          }
          double before = spin(boxes, half, 0.6 * half);
          return t -> Math.abs(spin(boxes, half, 0.6 * half) / before - 1);
        });
  }

  /** Angular momentum of boxes of one size and density 1 about the origin. */
  private static double spin(List<SimBody> boxes, double halfWidth, double halfHeight) {
    double mass = 4 * halfWidth * halfHeight;
    double inertia = mass * (halfWidth * halfWidth + halfHeight * halfHeight) / 3;
    double spin = 0;
    for (SimBody b : boxes) {
      spin += mass * (b.x() * b.vy() - b.y() * b.vx()) + inertia * b.w();
    }
    return spin;
  }
}
