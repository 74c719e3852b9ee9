package org.jbox2d.benchmarks.accuracy;

import java.util.ArrayList;
import java.util.List;
import org.jbox2d.benchmarks.engines.Kind;
import org.jbox2d.benchmarks.engines.Matter;
import org.jbox2d.benchmarks.engines.Sim;
import org.jbox2d.benchmarks.engines.SimBody;

/** Bodies that lie on each other, and the forces between them. */
final class StackScenes {
  private static final double G = 10;
  private static final Matter STONE = Matter.rough(1, 0.6);

  private StackScenes() {}

  static List<Scene> all() {
    return List.of(
        tallStack(),
        footForce(),
        leverRule(),
        pyramid("pyramid", 10, 0),
        pyramid("far_from_origin", 3, 8000),
        massRatio("mass_ratio_10", 1, 10),
        massRatio("mass_ratio_100", 1, 100),
        massRatio("mass_ratio_1000", 1, 1000),
        massRatio("heavy_on_tower", 4, 100),
        bigOnSmall(),
        arch("arch_stands", 0.15),
        arch("arch_falls", 0.07),
        cardHouse());
  }

  /** Bodies with the places they should stay at. */
  private static final class Places {
    private final List<SimBody> bodies = new ArrayList<>();
    private final List<double[]> places = new ArrayList<>();

    void add(SimBody body) {
      bodies.add(body);
      places.add(new double[] {body.x(), body.y()});
    }

    double moved(int i) {
      double[] p = places.get(i);
      return Math.hypot(bodies.get(i).x() - p[0], bodies.get(i).y() - p[1]);
    }

    /** The greatest way. */
    double worst() {
      double worst = 0;
      for (int i = 0; i < bodies.size(); i++) {
        worst = Math.max(worst, moved(i));
      }
      return worst;
    }

    /** The greatest way over the height above a floor. */
    double worstOverHeight(double floor) {
      double worst = 0;
      for (int i = 0; i < bodies.size(); i++) {
        worst = Math.max(worst, moved(i) / (places.get(i)[1] - floor));
      }
      return worst;
    }
  }

  private static SimBody floor(Sim sim, double x, double y) {
    return sim.body(Kind.STATIC, x, y, 0).box(50, 0.5, 0, -0.5, STONE);
  }

  private static SimBody cube(Sim sim, double x, double y, double half, double density) {
    return sim.dynamic(x, y).box(half, half, Matter.rough(density, 0.6));
  }

  private static Scene tallStack() {
    return new Scene(
        "tall_stack",
        10,
        0.05,
        "20 boxes stay where they are: none goes further than a twentieth of its height",
        sim -> {
          floor(sim, 0, 0);
          Places places = new Places();
          for (int i = 0; i < 20; i++) {
            places.add(cube(sim, 0, i + 0.5, 0.5, 1));
          }
          return t -> places.worstOverHeight(0);
        });
  }

  /** Averages the force on a body over the last second. */
  private static final class Scales implements Run {
    private final SimBody[] plates;
    private final double[] truth;
    private final double[] impulse;
    private final double from;
    private double span;

    Scales(SimBody[] plates, double[] truth, double from) {
      this.plates = plates;
      this.truth = truth;
      this.from = from;
      impulse = new double[plates.length];
    }

    @Override
    public void after(double time, double dt) {
      if (time > from) {
        span += dt;
        for (int i = 0; i < plates.length; i++) {
          impulse[i] += plates[i].pressed();
        }
      }
    }

    @Override
    public double error(double time) {
      double worst = 0;
      for (int i = 0; i < plates.length; i++) {
        worst = Math.max(worst, Math.abs(impulse[i] / span / truth[i] - 1));
      }
      return worst;
    }
  }

  private static Scene footForce() {
    return new Scene(
        "foot_force",
        5,
        0.02,
        "the floor under 10 boxes bears their weight: listeners that break floors rely on it",
        sim -> {
          sim.listen();
          SimBody ground = floor(sim, 0, 0);
          for (int i = 0; i < 10; i++) {
            cube(sim, 0, i + 0.5, 0.5, 1);
          }
          return new Scales(new SimBody[] {ground}, new double[] {10 * G}, 4);
        });
  }

  /** A plank on two rollers, with a box at a third of the way from one. */
  private static Scene leverRule() {
    double plank = 4 * 0.2;
    double load = 0.36;
    double left = G * (plank / 2 + load / 6);
    double right = G * (plank / 2 + load * 5 / 6);
    return new Scene(
        "lever_rule",
        5,
        0.03,
        "two supports share a load by the lever rule, to 3 %",
        sim -> {
          sim.listen();
          SimBody a = sim.body(Kind.STATIC, -1.5, 0, 0).disc(0.1, STONE);
          SimBody b = sim.body(Kind.STATIC, 1.5, 0, 0).disc(0.1, STONE);
          sim.dynamic(0, 0.2).box(2, 0.1, STONE);
          cube(sim, 1, 0.6, 0.3, 1);
          return new Scales(new SimBody[] {a, b}, new double[] {left, right}, 4);
        });
  }

  private static Scene pyramid(String name, int base, double away) {
    return new Scene(
        name,
        10,
        0.05,
        (away > 0 ? away + " m from the origin along both axes, " : "")
            + "a pyramid stays: no box goes further than a twentieth of its height",
        sim -> {
          floor(sim, away, away);
          Places places = new Places();
          for (int row = 0; row < base; row++) {
            for (int i = row; i < base; i++) {
              double x = away + (i - 0.5 * row) * 1.05 - 0.5 * base;
              places.add(cube(sim, x, away + row + 0.5, 0.5, 1));
            }
          }
          return t -> places.worstOverHeight(away);
        });
  }

  private static Scene massRatio(String name, int light, double ratio) {
    return new Scene(
        name,
        5,
        0.1,
        light
            + " light box(es) bear one of "
            + ratio
            + " times the mass, pressed by a tenth at most",
        sim -> {
          floor(sim, 0, 0);
          Places places = new Places();
          for (int i = 0; i < light; i++) {
            places.add(cube(sim, 0, i + 0.5, 0.5, 1));
          }
          places.add(cube(sim, 0, light + 0.5, 0.5, ratio));
          return t -> places.worst();
        });
  }

  private static Scene bigOnSmall() {
    return new Scene(
        "big_on_small",
        5,
        0.1,
        "a box of 8 m stands on two of 0.5 m, pressed by a tenth of them at most",
        sim -> {
          floor(sim, 0, 0);
          Places places = new Places();
          places.add(cube(sim, -3, 0.25, 0.25, 1));
          places.add(cube(sim, 3, 0.25, 0.25, 1));
          places.add(cube(sim, 0, 4.5, 4, 1));
          return t -> places.worst() / 0.5;
        });
  }

  /**
   * A half circle of wedges without mortar. By Heyman it stands if its thickness is more than some
   * 0.107 of its mean radius, if no stone slides.
   */
  private static Scene arch(String name, double thickness) {
    int n = 13;
    double r = 5;
    boolean stands = thickness > 0.107;
    double inner = r * (1 - thickness / 2);
    double outer = r * (1 + thickness / 2);
    return new Scene(
        name,
        stands ? 10 : 5,
        stands ? 0.05 : 0.5,
        "Heyman: an arch of a thickness of "
            + thickness
            + " of its radius "
            + (stands ? "stands, its stones within 5 % of it" : "falls to half its height or less"),
        sim -> {
          Matter granite = Matter.rough(1, 1);
          sim.ground().box(50, 0.5, 0, -0.5, granite);
          Places places = new Places();
          SimBody crown = null;
          for (int i = 0; i < n; i++) {
            SimBody stone =
                wedge(sim, Math.PI * i / n, Math.PI * (i + 1) / n, inner, outer, granite);
            places.add(stone);
            crown = i == n / 2 ? stone : crown;
          }
          SimBody key = crown;
          double top = key.y();
          return t -> stands ? places.worst() / r : Math.max(0, 2 * key.y() / top - 1);
        });
  }

  private static SimBody wedge(
      Sim sim, double from, double to, double inner, double outer, Matter matter) {
    double middle = 0.5 * (from + to);
    double r = 0.5 * (inner + outer);
    double x = r * StrictMath.cos(middle);
    double y = r * StrictMath.sin(middle);
    double[] corners = new double[8];
    double[] radii = {inner, outer, outer, inner};
    double[] angles = {from, from, to, to};
    for (int k = 0; k < 4; k++) {
      corners[2 * k] = radii[k] * StrictMath.cos(angles[k]) - x;
      corners[2 * k + 1] = radii[k] * StrictMath.sin(angles[k]) - y;
    }
    return sim.dynamic(x, y).polygon(matter, corners);
  }

  /** Two storeys of leaning cards with one lying between. */
  private static Scene cardHouse() {
    return new Scene(
        "card_house",
        10,
        0.1,
        "a house of eight cards stands: no card goes further than a tenth of its length",
        sim -> {
          floor(sim, 0, 0);
          Places places = new Places();
          double lean = Math.toRadians(20);
          double half = 0.03;
          double high = StrictMath.cos(lean) + 2 * half * StrictMath.sin(lean);
          double wide = 2 * (StrictMath.sin(lean) + 2 * half * StrictMath.cos(lean));
          for (int i = 0; i < 3; i++) {
            pair(sim, places, (i - 1) * wide, 0, lean, half);
          }
          for (int i = 0; i < 2; i++) {
            double x = (i - 0.5) * wide;
            places.add(sim.dynamic(x, high + half).box(0.5 * wide - 0.01, half, STONE));
          }
          return t -> places.worst();
        });
  }

  /** Two cards of 1 m that lean on each other over x, on a floor. */
  private static void pair(
      Sim sim, Places places, double x, double floor, double lean, double half) {
    double dx = 0.5 * StrictMath.sin(lean) + half * StrictMath.cos(lean);
    double y = floor + 0.5 * StrictMath.cos(lean) + half * StrictMath.sin(lean);
    for (int side = -1; side <= 1; side += 2) {
      places.add(sim.body(Kind.DYNAMIC, x + side * dx, y, side * lean).box(half, 0.5, STONE));
    }
  }
}
