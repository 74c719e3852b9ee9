package org.jbox2d.benchmarks.accuracy;

import java.util.List;
import org.jbox2d.benchmarks.engines.Kind;
import org.jbox2d.benchmarks.engines.Matter;
import org.jbox2d.benchmarks.engines.Sim;
import org.jbox2d.benchmarks.engines.SimBody;

/** Friction, rolling, and floors with seams. */
final class SlidingScenes {
  private static final double G = 10;

  private SlidingScenes() {}

  static List<Scene> all() {
    return List.of(
        slideToRest(),
        slope("slope_stick", 0.99, 0.01, "does not slide; a hundredth of its side in 5 s"),
        slope("slope_slip", 1.01, 0.1, "slides off at g (sin - mu cos); a tenth of the way"),
        rollDown(),
        bowling(),
        carried(),
        rodFall(),
        seams("seams_box", false, false),
        seams("seams_disc", true, false),
        seams("seams_chain", false, true));
  }

  private static Scene slideToRest() {
    double v = 6;
    double mu = 0.4;
    return new Scene(
        "slide_to_rest",
        3,
        0.02,
        "stops after v^2 / (2 mu g) = 4.5 m; a fiftieth is half a hand",
        sim -> {
          sim.ground().box(20, 0.5, 0, -0.5, Matter.rough(0, mu));
          SimBody box = sim.dynamic(0, 0.5).box(0.5, 0.5, Matter.rough(1, mu)).move(v, 0, 0);
          return t -> Math.abs(box.x() / (v * v / (2 * mu * G)) - 1);
        });
  }

  /** A long ramp through the origin, and a body's origin at a height above its face. */
  private static SimBody onRamp(Sim sim, double angle, double height, Matter matter) {
    sim.body(Kind.STATIC, 0, 0, angle).box(30, 0.5, 0, -0.5, matter);
    return sim.body(
        Kind.DYNAMIC, -height * StrictMath.sin(angle), height * StrictMath.cos(angle), angle);
  }

  private static Scene slope(String name, double part, double limit, String truth) {
    double mu = 0.5;
    double angle = StrictMath.atan(part * mu);
    double a = Math.max(0, G * (StrictMath.sin(angle) - mu * StrictMath.cos(angle)));
    return new Scene(
        name,
        5,
        limit,
        "a slope of " + part + " of the friction angle: the box " + truth,
        sim -> {
          Matter wood = Matter.rough(1, mu);
          SimBody box = onRamp(sim, angle, 0.5, wood).box(0.5, 0.5, wood);
          double x0 = box.x();
          double y0 = box.y();
          return t -> {
            double way =
                (x0 - box.x()) * StrictMath.cos(angle) + (y0 - box.y()) * StrictMath.sin(angle);
            double truthful = 0.5 * a * t * t;
            return a == 0 ? Math.abs(way) : Math.abs(way / truthful - 1);
          };
        });
  }

  private static Scene rollDown() {
    double angle = Math.toRadians(20);
    double a = G * StrictMath.sin(angle) * 2 / 3;
    return new Scene(
        "roll_down",
        3,
        0.02,
        "a disc that rolls has 2/3 of the acceleration of one that slides",
        sim -> {
          Matter rubber = Matter.rough(1, 1);
          SimBody disc = onRamp(sim, angle, 0.5, rubber).disc(0.5, rubber);
          double x0 = disc.x();
          double y0 = disc.y();
          return t -> {
            double way =
                (x0 - disc.x()) * StrictMath.cos(angle) + (y0 - disc.y()) * StrictMath.sin(angle);
            return Math.abs(way / (0.5 * a * t * t) - 1);
          };
        });
  }

  private static Scene bowling() {
    double v = 6;
    double r = 0.5;
    return new Scene(
        "bowling",
        3,
        0.02,
        "a disc thrown without spin slides until it rolls at 2/3 of its speed",
        sim -> {
          Matter lane = Matter.rough(1, 0.2);
          sim.ground().box(30, 0.5, 0, -0.5, lane);
          SimBody disc = sim.dynamic(0, r).disc(r, lane).move(v, 0, 0);
          double end = v * 2 / 3;
          return t -> Math.max(Math.abs(disc.vx() / end - 1), Math.abs(disc.w() * r / end + 1));
        });
  }

  private static Scene carried() {
    double v = 2;
    double mu = 0.5;
    double lag = v * v / (2 * mu * G);
    return new Scene(
        "carried",
        2,
        0.05,
        "a box put on a moving platform lags v^2 / (2 mu g) behind, then goes with it",
        sim -> {
          Matter wood = Matter.rough(1, mu);
          SimBody platform = sim.body(Kind.KINEMATIC, 0, -0.5, 0).box(5, 0.5, wood).move(v, 0, 0);
          SimBody box = sim.dynamic(0, 0.5).box(0.5, 0.5, wood);
          return t ->
              Math.max(Math.abs((platform.x() - box.x()) / lag - 1), Math.abs(box.vx() / v - 1));
        });
  }

  /** A thin rod that stands on a corner and does not slip: a pendulum upside down. */
  private static Scene rodFall() {
    double a = 0.05;
    double tilt = Math.toRadians(8);
    double start = tilt - StrictMath.atan(a);
    double arm = Math.sqrt(1 + a * a);
    double k = G * arm / ((1 + a * a) / 3 + arm * arm);
    return new Scene(
        "rod_fall",
        1,
        0.05,
        "a rod let go at a tilt of 8 degrees falls about its foot to some 45; a twentieth of that",
        sim -> {
          Matter rubber = Matter.rough(1, 1);
          sim.ground().box(10, 0.5, 0, -0.5, rubber);
          SimBody rod =
              sim.body(
                      Kind.DYNAMIC, arm * StrictMath.sin(start), arm * StrictMath.cos(start), -tilt)
                  .box(a, 1, rubber);
          return t -> {
            double[] end =
                Truth.integrate(
                    new double[] {start, 0},
                    t,
                    (y, d) -> {
                      d[0] = y[1];
                      d[1] = k * StrictMath.sin(y[0]);
                    });
            double truth = end[0] - start;
            return Math.abs((-rod.angle() - tilt) / truth - 1);
          };
        });
  }

  /** The way is 20 m over 1 m tiles. What the body rests on at the start is its own height. */
  private static Scene seams(String name, boolean round, boolean chain) {
    double v = 5;
    double half = 0.25;
    return new Scene(
        name,
        4,
        0.01,
        "over a flat floor of " + (chain ? "edges" : "tiles") + " nothing stops or lifts a body",
        sim -> {
          Matter ice = Matter.smooth(1);
          if (chain) {
            double[] points = new double[2 * 27];
            for (int i = 0; i < 27; i++) {
              points[2 * i] = 24 - i;
            }
            sim.ground().chain(ice, points);
          } else {
            for (int i = -2; i < 25; i++) {
              sim.body(Kind.STATIC, i, -0.5, 0).box(0.5, 0.5, ice);
            }
          }
          SimBody body = sim.dynamic(0, half);
          if (round) {
            body.disc(half, ice).move(v, 0, -v / half);
          } else {
            body.box(half, half, ice).move(v, 0, 0);
          }
          return new Run() {
            private double lift;

            @Override
            public void after(double time, double dt) {
              lift = Math.max(lift, body.y() - half);
            }

            @Override
            public double error(double time) {
              // The skin of some engines' polygons is a third of that.
              double hop = Math.max(0, lift - 0.03) / half;
              return Math.max(hop, Math.abs(body.x() / (v * time) - 1));
            }
          };
        });
  }
}
