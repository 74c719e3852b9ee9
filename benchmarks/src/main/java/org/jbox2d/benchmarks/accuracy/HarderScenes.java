package org.jbox2d.benchmarks.accuracy;

import java.util.ArrayList;
import java.util.List;
import org.jbox2d.benchmarks.engines.Kind;
import org.jbox2d.benchmarks.engines.Matter;
import org.jbox2d.benchmarks.engines.SimBody;

/** Scenes in which several things have to be right at once. */
final class HarderScenes {
  private static final double G = 10;
  private static final Matter STONE = Matter.rough(1, 0.6);

  private HarderScenes() {}

  static List<Scene> all() {
    return List.of(
        bounceFlat(),
        flatLanding(),
        spinBounce(),
        rollOn(),
        loadedBridge(),
        bulletPair(),
        whirl(),
        overhang("overhang_stands", 0.9),
        overhang("overhang_falls", 1.1),
        tabletop(),
        smallWheel(),
        column(),
        overlapHeap());
  }

  private static Scene bounceFlat() {
    double h = 1;
    return new Scene(
        "bounce_flat",
        4,
        0.1,
        "an elastic box that falls flat comes back to its height without a turn, to a tenth",
        sim -> {
          Matter rubber = Matter.bouncy(1, 1);
          sim.ground().box(10, 0.5, 0, -0.5, rubber);
          SimBody box = sim.dynamic(0, 0.5 + h).box(1, 0.5, rubber);
          return new Run() {
            private double highest;
            private double turn;

            @Override
            public void after(double time, double dt) {
              turn = Math.max(turn, Math.abs(Truth.turn(box.angle())));
              if (time > 2.5) {
                highest = Math.max(highest, box.y() - 0.5);
              }
            }

            @Override
            public double error(double time) {
              return Math.max(turn, Math.abs(highest / h - 1));
            }
          };
        });
  }

  private static Scene flatLanding() {
    return new Scene(
        "flat_landing",
        2,
        0.05,
        "a slab without bounce that falls flat lies where it came down: 5 cm, or 3 degrees on the way",
        sim -> {
          sim.ground().box(10, 0.5, 0, -0.5, STONE);
          SimBody slab = sim.dynamic(0, 5).box(2, 0.1, STONE);
          return new Run() {
            private double turn;
            private double hop;

            @Override
            public void after(double time, double dt) {
              turn = Math.max(turn, Math.abs(Truth.turn(slab.angle())));
              hop = time > 1.2 ? Math.max(hop, Math.abs(slab.y() - 0.1)) : 0;
            }

            @Override
            public double error(double time) {
              return Math.max(Math.max(turn, hop), Math.abs(slab.x()));
            }
          };
        });
  }

  /** Friction at the bounce stops the foot of the disc: vx becomes 2/3 of it, the rest is spin. */
  private static Scene spinBounce() {
    double vx = 3;
    double r = 0.25;
    double e = 0.8;
    return new Scene(
        "spin_bounce",
        0.8,
        0.05,
        "a disc thrown at a rough floor leaves with 2/3 of its speed along it, and rolling",
        sim -> {
          Matter ball = new Matter(1, 1, e, false);
          sim.ground().box(20, 0.5, 0, -0.5, ball);
          SimBody disc = sim.dynamic(0, r + 1).disc(r, ball).move(vx, 0, 0);
          double end = vx * 2 / 3;
          return t -> Math.max(Math.abs(disc.vx() / end - 1), Math.abs(disc.w() * r / end + 1));
        });
  }

  private static Scene rollOn() {
    double v = 4;
    double r = 0.5;
    return new Scene(
        "roll_on",
        10,
        0.01,
        "a disc that rolls on a level floor goes on as fast as ever, to 1 %",
        sim -> {
          Matter rubber = Matter.rough(1, 0.8);
          sim.ground().box(100, 0.5, 0, -0.5, rubber);
          SimBody disc = sim.dynamic(-30, r).disc(r, rubber).move(v, 0, -v / r);
          return t ->
              Math.max(Math.abs(disc.vx() / v - 1), Math.abs((disc.x() + 30) / (v * t) - 1));
        });
  }

  /** A chain with a weight of 20 links at the hinge in its middle. */
  private static Scene loadedBridge() {
    int links = 20;
    double load = 20;
    double span = 19;
    double[] angles = Truth.loadedChain(links, span, load);
    return new Scene(
        "bridge_load",
        10,
        0.02,
        "a bridge of 20 planks with the weight of 20 more in its middle hangs as the balance has it",
        sim -> {
          SimBody ground = sim.ground();
          SimBody[] planks = new SimBody[links];
          double[][] places = new double[links][];
          double x = 0;
          double y = 0;
          SimBody last = ground;
          Matter wood = Matter.smooth(1).ghostly();
          for (int i = 0; i < links; i++) {
            double c = StrictMath.cos(angles[i]);
            double s = StrictMath.sin(angles[i]);
            places[i] = new double[] {x + 0.5 * c, y + 0.5 * s};
            planks[i] =
                sim.body(Kind.DYNAMIC, places[i][0], places[i][1], angles[i]).box(0.5, 0.1, wood);
            sim.hinge(last, planks[i], x, y);
            last = planks[i];
            x += c;
            y += s;
            if (i == links / 2 - 1) {
              double density = load * 0.2 / (Math.PI * 0.25);
              SimBody ball = sim.dynamic(x, y).disc(0.5, Matter.smooth(density).ghostly());
              sim.hinge(last, ball, x, y);
            }
          }
          sim.hinge(last, ground, x, y);
          return t -> {
            double worst = 0;
            for (int i = 0; i < links; i++) {
              double dx = planks[i].x() - places[i][0];
              double dy = planks[i].y() - places[i][1];
              worst = Math.max(worst, Math.hypot(dx, dy) / span);
            }
            return worst;
          };
        });
  }

  private static Scene bulletPair() {
    double v = 150;
    return new Scene(
        "bullet_pair",
        0.5,
        0.05,
        "two equal bullets without bounce that meet head-on at 300 m/s stop: 5 % of the speed of one",
        sim -> {
          sim.gravity(0, 0);
          Matter lead = Matter.smooth(10);
          SimBody a = sim.dynamic(-10.3, 0).disc(0.1, lead).move(v, 0, 0).bullet();
          SimBody b = sim.dynamic(10.3, 0).disc(0.1, lead).move(-v, 0, 0).bullet();
          return t -> Math.max(Math.abs(a.vx()), Math.abs(b.vx())) / v;
        });
  }

  /** Long thin rods that spin fast in a closed room with thin walls. */
  private static Scene whirl() {
    int n = 8;
    return new Scene(
        "whirl",
        6,
        0.1,
        "eight rods that spin at 50 rad/s in a room with thin walls stay in it: the part that is out",
        sim -> {
          Matter wall = Matter.bouncy(0, 0.5);
          sim.ground().chain(wall, 5, -5, 5, 5, -5, 5, -5, -5, 5, -5);
          List<SimBody> rods = new ArrayList<>();
          for (int i = 0; i < n; i++) {
            double x = 2.2 * (i % 4) - 3.3;
            double y = 2.2 * (i / 4) - 1;
            rods.add(
                sim.dynamic(x, y)
                    .box(1, 0.05, Matter.bouncy(1, 0.5))
                    .move(8 * StrictMath.cos(i), 8 * StrictMath.sin(i), i % 2 == 0 ? 50 : -50)
                    .bullet());
          }
          return t -> {
            int out = 0;
            for (SimBody rod : rods) {
              out += Math.abs(rod.x()) > 5 || Math.abs(rod.y()) > 5 ? 1 : 0;
            }
            return (double) out / n;
          };
        });
  }

  /**
   * Bricks that stick out over the edge of a table: the top one by half its half length, the next
   * by a quarter... is as far as they can. A part of that stands, more falls.
   */
  private static Scene overhang(String name, double part) {
    int n = 4;
    boolean stands = part < 1;
    return new Scene(
        name,
        stands ? 8 : 4,
        stands ? 0.05 : 0.5,
        n
            + " bricks stick out over an edge by "
            + part
            + " of the harmonic bound: they "
            + (stands ? "stay, to 5 % of a brick" : "fall, and are not held by what is too stiff"),
        sim -> {
          sim.ground().box(5, 0.5, -5, -0.5, STONE);
          List<SimBody> bricks = new ArrayList<>();
          double[] x0 = new double[n];
          double[] y0 = new double[n];
          double x = -1;
          for (int i = 0; i < n; i++) {
            // The brick at height i carries n - 1 - i others; it sticks out by 1 / (n - i).
            x += part / (n - i);
            x0[i] = x;
            y0[i] = 0.2 + 0.4 * i;
            bricks.add(sim.dynamic(x, y0[i]).box(1, 0.2, STONE));
          }
          return t -> {
            double worst = 0;
            for (int i = 0; i < n; i++) {
              SimBody b = bricks.get(i);
              worst = Math.max(worst, Math.hypot(b.x() - x0[i], b.y() - y0[i]));
            }
            return stands ? worst / 2 : Math.max(0, 1 - worst);
          };
        });
  }

  /** Friction speeds the box up while the cloth is under it, and stops it afterwards. */
  private static Scene tabletop() {
    double v = 10;
    double mu = 0.2;
    double pull = 0.4;
    double gained = mu * G * pull;
    double way = 0.5 * gained * pull + gained * gained / (2 * mu * G);
    return new Scene(
        "tablecloth",
        2,
        0.1,
        "a cloth pulled away under a box moves it by mu g t^2, to a tenth",
        sim -> {
          Matter cloth = Matter.rough(1, mu);
          sim.ground().box(20, 0.5, 0, -0.5, cloth);
          double half = 0.25;
          // The cloth is as thin as nothing: a belt whose end passes the box at the right time.
          SimBody belt =
              sim.body(Kind.KINEMATIC, 0, 0.01, 0)
                  .box(20, 0.01, 20 - half - v * pull, 0, cloth)
                  .move(v, 0, 0);
          SimBody box = sim.dynamic(0, 0.02 + half).box(half, half, cloth);
          return new Run() {
            private boolean gone;

            @Override
            public void before(double time) {
              if (!gone && time > pull - 1e-6) {
                gone = true;
                sim.remove(belt);
              }
            }

            @Override
            public double error(double time) {
              return Math.abs(box.x() / way - 1);
            }
          };
        });
  }

  /** At the end it turns at 75 rad/s, by more than a radian in a step. */
  private static Scene smallWheel() {
    double r = 0.1;
    double slope = Math.toRadians(35);
    double a = G * StrictMath.sin(slope) * 2 / 3;
    return new Scene(
        "small_wheel",
        2,
        0.02,
        "a disc of 10 cm that rolls down 35 degrees has 2/3 of the acceleration of what slides",
        sim -> {
          Matter rubber = Matter.rough(1, 0.5);
          sim.body(Kind.STATIC, 0, 0, slope).box(60, 1, 0, -1, rubber);
          double x0 = -r * StrictMath.sin(slope);
          double y0 = r * StrictMath.cos(slope);
          SimBody disc = sim.dynamic(x0, y0).disc(r, rubber);
          return t -> {
            double dx = x0 - disc.x();
            double dy = y0 - disc.y();
            double way = dx * StrictMath.cos(slope) + dy * StrictMath.sin(slope);
            return Math.abs(way / (0.5 * a * t * t) - 1);
          };
        });
  }

  private static Scene column() {
    int n = 16;
    return new Scene(
        "column",
        10,
        0.1,
        "16 bricks on each other, a little out of line, stay to a tenth of their height",
        sim -> {
          sim.ground().box(10, 0.5, 0, -0.5, STONE);
          List<SimBody> bricks = new ArrayList<>();
          for (int i = 0; i < n; i++) {
            bricks.add(sim.dynamic(0.02 * (i % 3 - 1), 0.2 * i + 0.1).box(0.2, 0.1, STONE));
          }
          return t -> {
            double worst = 0;
            for (int i = 0; i < n; i++) {
              SimBody b = bricks.get(i);
              double y0 = 0.2 * i + 0.1;
              worst = Math.max(worst, Math.hypot(b.x() - 0.02 * (i % 3 - 1), b.y() - y0) / y0);
            }
            return worst;
          };
        });
  }

  private static Scene overlapHeap() {
    return new Scene(
        "overlap_heap",
        3,
        0.3,
        "nine boxes, each in its neighbours by 0.3 m, come apart without a burst of 0.3 m/s",
        sim -> {
          sim.gravity(0, 0);
          List<SimBody> boxes = new ArrayList<>();
          for (int i = 0; i < 9; i++) {
            boxes.add(sim.dynamic(0.7 * (i % 3), 0.7 * (i / 3)).box(0.5, 0.5, STONE));
          }
          return t -> {
            double fastest = 0;
            for (SimBody b : boxes) {
              fastest = Math.max(fastest, Math.hypot(b.vx(), b.vy()));
            }
            return fastest;
          };
        });
  }
}
