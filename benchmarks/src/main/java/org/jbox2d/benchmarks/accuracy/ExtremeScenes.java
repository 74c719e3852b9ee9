package org.jbox2d.benchmarks.accuracy;

import java.util.ArrayList;
import java.util.List;
import org.jbox2d.benchmarks.engines.Kind;
import org.jbox2d.benchmarks.engines.Matter;
import org.jbox2d.benchmarks.engines.SimBody;

/** Where methods fail: speed, overlap, crowds, sleep. */
final class ExtremeScenes {
  private static final double G = 10;
  private static final Matter STONE = Matter.rough(1, 0.6);
  private static final Matter LEAD = Matter.smooth(10);

  private ExtremeScenes() {}

  static List<Scene> all() {
    return List.of(
        bulletStatic("bullet_static", 20, 200),
        bulletStatic("bullet_first_step", 1, 300),
        bulletDynamic(),
        thinFloor(),
        rodAtPost(),
        overlapStatic(),
        overlapPair(),
        crowdRush(),
        gravityOff(),
        inelasticGas(),
        sleepQuiet(),
        wakeByHit(),
        supportRemoved());
  }

  private static Scene bulletStatic(String name, double away, double speed) {
    double r = 0.05;
    double half = 0.05;
    return new Scene(
        name,
        0.5,
        0.5,
        speed + " m/s at a wall of 0.1 m from " + away + " m: it stops before it, to half its size",
        sim -> {
          sim.gravity(0, 0);
          sim.ground().box(half, 2, LEAD);
          SimBody shot = sim.dynamic(-away, 0).disc(r, LEAD).move(speed, 0, 0).bullet();
          return t -> Math.abs(shot.x() + half + r) / (2 * r);
        });
  }

  private static Scene bulletDynamic() {
    double v = 100;
    double m = 10 * Math.PI * 0.05 * 0.05;
    double plate = 0.1 * 2;
    double together = m * v / (m + plate);
    return new Scene(
        "bullet_dynamic",
        0.2,
        0.05,
        "a bullet of 100 m/s takes a free plate along: both have m v / (m + M)",
        sim -> {
          sim.gravity(0, 0);
          SimBody target = sim.dynamic(0, 0).box(0.05, 1, Matter.smooth(1));
          SimBody shot = sim.dynamic(-3.3, 0).disc(0.05, LEAD).move(v, 0, 0).bullet();
          return t ->
              Math.max(Math.abs(target.vx() / together - 1), Math.abs(shot.vx() / together - 1));
        });
  }

  private static Scene thinFloor() {
    return new Scene(
        "thin_floor",
        1,
        0.1,
        "a box that comes down at 100 m/s lies on an edge in the end, to a tenth of its size",
        sim -> {
          sim.ground().chain(STONE, 10, 0, -10, 0);
          SimBody box = sim.dynamic(0, 20.3).box(0.5, 0.5, STONE).move(0, -100, 0);
          return t -> Math.abs(box.y() - 0.5);
        });
  }

  /**
   * A propeller whose tip comes against a post. Contact is where the post is as far as both radii.
   */
  private static Scene rodAtPost() {
    double w = 40;
    double r = 0.1;
    double half = 0.05;
    double at = 1.8;
    double truth = Math.PI / 2 - StrictMath.asin((r + half) / at);
    return new Scene(
        "rod_at_post",
        0.5,
        0.05,
        "a rod that turns at 40 rad/s stops at a post; a twentieth of the quarter turn to it",
        sim -> {
          sim.gravity(0, 0);
          SimBody ground = sim.ground();
          sim.body(Kind.STATIC, 0, at, 0).disc(r, LEAD);
          SimBody rod = sim.dynamic(0, 0).box(2, half, LEAD).move(0, 0, w).bullet();
          sim.hinge(ground, rod, 0, 0);
          return t -> Math.abs(Truth.turn(rod.angle() - truth)) / truth;
        });
  }

  private static Scene overlapStatic() {
    return new Scene(
        "overlap_floor",
        2,
        0.1,
        "a box put 0.4 m into the floor comes up and lies on it, without a hop of a tenth",
        sim -> {
          sim.ground().box(10, 2, 0, -2, STONE);
          SimBody box = sim.dynamic(0, 0.1).box(0.5, 0.5, STONE);
          return new Run() {
            private double top;

            @Override
            public void after(double time, double dt) {
              top = Math.max(top, box.y() - 0.5);
            }

            @Override
            public double error(double time) {
              return Math.max(top, Math.abs(box.y() - 0.5));
            }
          };
        });
  }

  private static Scene overlapPair() {
    return new Scene(
        "overlap_pair",
        2,
        0.1,
        "two boxes half in each other come apart and stay near: 0.1 m/s or 0.1 m is a burst",
        sim -> {
          sim.gravity(0, 0);
          SimBody a = sim.dynamic(0, 0).box(0.5, 0.5, STONE);
          SimBody b = sim.dynamic(0.5, 0).box(0.5, 0.5, STONE);
          return t ->
              Math.max(
                  Math.abs(Math.hypot(b.x() - a.x(), b.y() - a.y()) - 1),
                  Math.max(Math.hypot(a.vx(), a.vy()), Math.hypot(b.vx(), b.vy())));
        });
  }

  private static Scene crowdRush() {
    int n = 80;
    double r = 0.25;
    return new Scene(
        "crowd_rush",
        6,
        0.2,
        "80 discs pushed to one place, 5 m/s at most: none gets into another by a fifth of it",
        sim -> {
          sim.gravity(0, 0);
          List<SimBody> crowd = new ArrayList<>();
          double mass = Math.PI * r * r;
          for (int i = 0; i < n; i++) {
            double far = 2 + 0.075 * i;
            double a = 2.4 * i;
            crowd.add(
                sim.dynamic(far * StrictMath.cos(a), far * StrictMath.sin(a))
                    .disc(r, Matter.rough(1, 0.3))
                    .damp(2, 0));
          }
          return new Run() {
            private double worst;

            @Override
            public void before(double time) {
              for (SimBody b : crowd) {
                double d = Math.max(r, Math.hypot(b.x(), b.y()));
                b.push(-G * mass * b.x() / d, -G * mass * b.y() / d);
              }
            }

            @Override
            public void after(double time, double dt) {
              for (int i = 0; i < n; i++) {
                for (int k = 0; k < i; k++) {
                  SimBody a = crowd.get(i);
                  SimBody b = crowd.get(k);
                  double d = Math.hypot(a.x() - b.x(), a.y() - b.y());
                  worst = Math.max(worst, 1 - d / (2 * r));
                }
              }
            }

            @Override
            public double error(double time) {
              return worst;
            }
          };
        });
  }

  private static Scene gravityOff() {
    return new Scene(
        "gravity_off",
        4,
        0.02,
        "a stack at rest stays at rest when gravity ends: old impulses throw nothing up, 2 cm/s",
        sim -> {
          sim.ground().box(10, 0.5, 0, -0.5, STONE);
          List<SimBody> stack = new ArrayList<>();
          for (int i = 0; i < 10; i++) {
            stack.add(sim.dynamic(0, i + 0.5).box(0.5, 0.5, STONE));
          }
          return new Run() {
            private double worst;
            private boolean off;

            @Override
            public void before(double time) {
              if (!off && time > 2.5) {
                off = true;
                sim.gravity(0, 0);
              }
            }

            @Override
            public void after(double time, double dt) {
              if (off) {
                for (SimBody b : stack) {
                  worst = Math.max(worst, Math.hypot(b.vx(), b.vy()));
                }
              }
            }

            @Override
            public double error(double time) {
              return worst;
            }
          };
        });
  }

  private static Scene inelasticGas() {
    int n = 6;
    return new Scene(
        "energy_never_grows",
        8,
        0.01,
        "36 boxes without bounce in a box without gravity: energy never rises by 1 % of the first",
        sim -> {
          sim.gravity(0, 0);
          SimBody wall = sim.ground();
          wall.box(6, 0.5, 0, 5.5, STONE).box(6, 0.5, 0, -5.5, STONE);
          wall.box(0.5, 6, 5.5, 0, STONE).box(0.5, 6, -5.5, 0, STONE);
          List<SimBody> boxes = new ArrayList<>();
          for (int i = 0; i < n * n; i++) {
            double a = 2.4 * i;
            boxes.add(
                sim.dynamic(1.4 * (i % n) - 3.5, 1.4 * (i / n) - 3.5)
                    .box(0.4, 0.4, STONE)
                    .move(4 * StrictMath.cos(a), 4 * StrictMath.sin(a), 3 * StrictMath.sin(7 * a)));
          }
          double first = energy(boxes);
          return new Run() {
            private double least = first;
            private double worst;

            @Override
            public void after(double time, double dt) {
              double now = energy(boxes);
              worst = Math.max(worst, (now - least) / first);
              least = Math.min(least, now);
            }

            @Override
            public double error(double time) {
              return worst;
            }
          };
        });
  }

  /** Of boxes of 0.8 m, over their mass: I/m = 0.64 / 6. */
  private static double energy(List<SimBody> boxes) {
    double sum = 0;
    for (SimBody b : boxes) {
      sum += 0.5 * (b.vx() * b.vx() + b.vy() * b.vy() + b.w() * b.w() * 0.64 / 6);
    }
    return sum;
  }

  private static Scene sleepQuiet() {
    return new Scene(
        "sleep",
        4,
        0.05,
        "a pyramid of ten boxes at rest sleeps within 4 s, or it costs for ever: the part awake",
        sim -> {
          sim.allowSleep();
          sim.ground().box(10, 0.5, 0, -0.5, STONE);
          List<SimBody> boxes = new ArrayList<>();
          for (int row = 0; row < 4; row++) {
            for (int i = 0; i < 4 - row; i++) {
              boxes.add(sim.dynamic(i + 0.5 * row, row + 0.5).box(0.45, 0.5, STONE));
            }
          }
          return t -> {
            int awake = 0;
            for (SimBody b : boxes) {
              awake += b.awake() ? 1 : 0;
            }
            return (double) awake / boxes.size();
          };
        });
  }

  private static Scene wakeByHit() {
    double v = 3;
    return new Scene(
        "wake_by_hit",
        3,
        0.05,
        "an elastic ball that hits one asleep gives it all of its speed",
        sim -> {
          sim.allowSleep();
          Matter ivory = Matter.bouncy(1, 1);
          sim.ground().box(30, 0.5, 0, -0.5, Matter.smooth(0));
          SimBody a = sim.dynamic(-7, 0.5).disc(0.5, ivory).move(v, 0, 0);
          SimBody b = sim.dynamic(0, 0.5).disc(0.5, ivory);
          return t -> Math.max(Math.abs(a.vx()), Math.abs(b.vx() - v)) / v;
        });
  }

  private static Scene supportRemoved() {
    return new Scene(
        "support_removed",
        4,
        0.05,
        "a stack asleep falls freely when the shelf under it goes: 5 m in the next second",
        sim -> {
          sim.allowSleep();
          SimBody shelf = sim.ground().box(2, 0.1, 0, -0.1, STONE);
          SimBody[] stack = new SimBody[3];
          for (int i = 0; i < 3; i++) {
            stack[i] = sim.dynamic(0, i + 0.5).box(0.5, 0.5, STONE);
          }
          return new Run() {
            private boolean gone;
            private double from;

            @Override
            public void before(double time) {
              if (!gone && time > 2.999) {
                gone = true;
                from = stack[2].y();
                sim.remove(shelf);
              }
            }

            @Override
            public double error(double time) {
              return Math.abs((from - stack[2].y()) / (0.5 * G) - 1);
            }
          };
        });
  }
}
