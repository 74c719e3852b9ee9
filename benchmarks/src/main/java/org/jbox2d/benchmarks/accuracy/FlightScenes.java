package org.jbox2d.benchmarks.accuracy;

import java.util.List;
import org.jbox2d.benchmarks.engines.Matter;
import org.jbox2d.benchmarks.engines.SimBody;

/** Bodies that touch nothing: the integrator, rounding, and caps of speed. */
final class FlightScenes {
  private static final Matter STONE = Matter.smooth(1);
  private static final double G = 10;

  private FlightScenes() {}

  static List<Scene> all() {
    return List.of(
        freeFall(), projectile(), dampedFall(), spin(), thrownHammer(), fastFlight(), fastSpin());
  }

  private static Scene freeFall() {
    return new Scene(
        "free_fall",
        2,
        0.02,
        "falls g t^2 / 2 = 20 m; a fiftieth is a visible 0.4 m",
        sim -> {
          SimBody ball = sim.dynamic(0, 0).disc(0.5, STONE);
          return t -> Math.abs(ball.y() / (0.5 * G * t * t) + 1);
        });
  }

  private static Scene projectile() {
    double speed = 20;
    return new Scene(
        "projectile",
        2,
        0.02,
        "parabola; off by a fiftieth of the 28 m flown, it misses what it was aimed at",
        sim -> {
          SimBody ball = sim.dynamic(0, 0).disc(0.2, STONE).move(speed, speed, 0);
          return t -> {
            double dx = ball.x() - speed * t;
            double dy = ball.y() - (speed * t - 0.5 * G * t * t);
            return Math.hypot(dx, dy) / (speed * Math.sqrt(2));
          };
        });
  }

  private static Scene dampedFall() {
    double c = 0.5;
    return new Scene(
        "damped_fall",
        4,
        0.02,
        "drag in proportion to speed: y' = -(g/c) (1 - exp(-c t)); a fiftieth as for free fall",
        sim -> {
          SimBody ball = sim.dynamic(0, 0).disc(0.5, STONE).damp(c, 0);
          return t -> {
            double decay = 1 - StrictMath.exp(-c * t);
            double fallen = G / c * (t - decay / c);
            return Math.abs(ball.y() / fallen + 1);
          };
        });
  }

  private static Scene spin() {
    double w = 10;
    return new Scene(
        "spin",
        10,
        0.01,
        "a free body keeps its angular velocity; off by a hundredth of a turn after 16 turns",
        sim -> {
          SimBody wheel = sim.dynamic(0, 0).box(1, 0.1, STONE).move(0, 0, w);
          return t ->
              Math.max(
                  Math.abs(wheel.w() / w - 1),
                  Math.abs(Truth.turn(wheel.angle() - w * t)) / (2 * Math.PI));
        });
  }

  /** Head and shaft are a box each, so that the origin is not the centre of mass. */
  private static Scene thrownHammer() {
    double w = 8;
    double shaft = 2 * 0.1;
    double head = 0.4 * 0.6;
    double centre = (head * 1.2) / (shaft + head);
    return new Scene(
        "thrown_hammer",
        1,
        0.03,
        "the centre of mass flies a parabola while the rest turns about it; 3 % of the flight",
        sim -> {
          SimBody hammer =
              sim.dynamic(0, 0).box(1, 0.05, STONE).box(0.2, 0.3, 1.2, 0, STONE).move(5, 5, w);
          return t -> {
            double x = centre + 5 * t - centre * StrictMath.cos(w * t);
            double y = 5 * t - 0.5 * G * t * t - centre * StrictMath.sin(w * t);
            return Math.hypot(hammer.x() - x, hammer.y() - y) / (5 * Math.sqrt(2));
          };
        });
  }

  private static Scene fastFlight() {
    double speed = 800;
    return new Scene(
        "fast_flight",
        1,
        0.01,
        "800 m/s, a shell: without forces the speed stays; a hundredth, or the engine caps it",
        sim -> {
          sim.gravity(0, 0);
          SimBody shell = sim.dynamic(0, 0).disc(0.1, STONE).move(speed, 0, 0);
          return t -> Math.abs(shell.x() / (speed * t) - 1);
        });
  }

  private static Scene fastSpin() {
    double w = 300;
    return new Scene(
        "fast_spin",
        1,
        0.02,
        "300 rad/s, a drill: without torque it stays; a fiftieth, or the engine caps it",
        sim -> {
          sim.gravity(0, 0);
          SimBody drill = sim.dynamic(0, 0).disc(0.1, STONE).move(0, 0, w);
          return t ->
              Math.max(
                  Math.abs(drill.w() / w - 1),
                  Math.abs(Truth.turn(drill.angle() - w * t)) / Math.PI);
        });
  }
}
