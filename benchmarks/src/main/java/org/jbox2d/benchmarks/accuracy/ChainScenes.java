package org.jbox2d.benchmarks.accuracy;

import java.util.List;
import org.jbox2d.benchmarks.engines.Kind;
import org.jbox2d.benchmarks.engines.Matter;
import org.jbox2d.benchmarks.engines.SimBody;

/** Many joints: bridges, chains, nets, beams. */
final class ChainScenes {
  private static final int LINKS = 10;

  private ChainScenes() {}

  static List<Scene> all() {
    return List.of(
        hangingChain("bridge", 20, 19, 0.1, "a bridge"),
        hangingChain("chain", 20, 12, 0.05, "a slack chain"),
        load("chain_load_100", 100),
        load("chain_load_1000", 1000),
        wreckingBall(),
        jointGrid(),
        cantilever());
  }

  /** Links of 1 m start where they hang in truth, and are to stay there. */
  private static Scene hangingChain(String name, int links, double span, double half, String what) {
    double[] angles = Truth.hangingChain(links, span);
    return new Scene(
        name,
        10,
        0.01,
        what + " of 20 links hangs as the balance of each link has it; 1 % of the span is a kink",
        sim -> {
          SimBody ground = sim.ground();
          SimBody[] body = new SimBody[links];
          double[] px = new double[links];
          double[] py = new double[links];
          double x = 0;
          double y = 0;
          SimBody last = ground;
          for (int i = 0; i < links; i++) {
            double c = StrictMath.cos(angles[i]);
            double s = StrictMath.sin(angles[i]);
            px[i] = x + 0.5 * c;
            py[i] = y + 0.5 * s;
            body[i] =
                sim.body(Kind.DYNAMIC, px[i], py[i], angles[i])
                    .box(0.5, half, Matter.smooth(1).ghostly());
            sim.hinge(last, body[i], x, y);
            last = body[i];
            x += c;
            y += s;
          }
          sim.hinge(last, ground, x, y);
          return t -> {
            double worst = 0;
            for (int i = 0; i < links; i++) {
              double off = Math.hypot(body[i].x() - px[i], body[i].y() - py[i]);
              worst = Math.max(worst, off / span);
            }
            return worst;
          };
        });
  }

  /** A ball at the lower end, of so many times the mass of a link. */
  private static Scene load(String name, double ratio) {
    return new Scene(
        name,
        5,
        0.01,
        "a chain of 10 links with " + ratio + " times a link's mass at its end does not stretch",
        sim -> {
          SimBody last = sim.ground();
          for (int i = 0; i < LINKS; i++) {
            SimBody link = sim.dynamic(0, -i - 0.5).box(0.1, 0.5, Matter.smooth(1).ghostly());
            sim.hinge(last, link, 0, -i);
            last = link;
          }
          double r = 0.5;
          double density = ratio * 0.2 / (Math.PI * r * r);
          SimBody ball = sim.dynamic(0, -LINKS).disc(r, Matter.smooth(density).ghostly());
          sim.hinge(last, ball, 0, -LINKS);
          return new Run() {
            private double worst;

            @Override
            public void after(double time, double dt) {
              worst = Math.max(worst, Math.hypot(ball.x(), ball.y() + LINKS) / LINKS);
            }

            @Override
            public double error(double time) {
              return worst;
            }
          };
        });
  }

  private static Scene wreckingBall() {
    return new Scene(
        "wrecking_ball",
        5,
        0.03,
        "a ball of 50 links' mass swings on a chain let go level, which stretches by 3 % at most",
        sim -> {
          SimBody last = sim.ground();
          for (int i = 0; i < LINKS; i++) {
            SimBody link = sim.dynamic(i + 0.5, 0).box(0.5, 0.1, Matter.smooth(1).ghostly());
            sim.hinge(last, link, i, 0);
            last = link;
          }
          double r = 0.5;
          double density = 50 * 0.2 / (Math.PI * r * r);
          SimBody ball = sim.dynamic(LINKS, 0).disc(r, Matter.smooth(density).ghostly());
          sim.hinge(last, ball, LINKS, 0);
          return new Run() {
            private double worst;

            @Override
            public void after(double time, double dt) {
              worst = Math.max(worst, Math.hypot(ball.x(), ball.y()) / LINKS - 1);
            }

            @Override
            public double error(double time) {
              return worst;
            }
          };
        });
  }

  /** Distance of two points that a hinge should hold together. */
  private static double gap(SimBody a, double ax, double ay, SimBody b, double bx, double by) {
    double ca = StrictMath.cos(a.angle());
    double sa = StrictMath.sin(a.angle());
    double cb = StrictMath.cos(b.angle());
    double sb = StrictMath.sin(b.angle());
    double x = a.x() + ca * ax - sa * ay - b.x() - cb * bx + sb * by;
    double y = a.y() + sa * ax + ca * ay - b.y() - sb * bx - cb * by;
    return Math.hypot(x, y);
  }

  private static Scene jointGrid() {
    int n = 12;
    return new Scene(
        "joint_grid",
        5,
        0.05,
        "a net of 12 x 12 discs hung up in the middle: no hinge opens by more than 5 % of a mesh",
        sim -> {
          SimBody[] net = new SimBody[n * n];
          for (int k = 0; k < n; k++) {
            for (int i = 0; i < n; i++) {
              boolean hook = i == 0 && (k == n / 2 || k == n / 2 - 1);
              SimBody disc = sim.body(hook ? Kind.STATIC : Kind.DYNAMIC, k, -i, 0);
              net[k * n + i] = disc.disc(0.4, Matter.smooth(1).ghostly());
              if (i > 0) {
                sim.hinge(net[k * n + i - 1], disc, k, 0.5 - i);
              }
              if (k > 0) {
                sim.hinge(net[(k - 1) * n + i], disc, k - 0.5, -i);
              }
            }
          }
          return new Run() {
            private double worst;

            @Override
            public void after(double time, double dt) {
              if (time < 4) {
                return;
              }
              for (int k = 0; k < n; k++) {
                for (int i = 0; i < n; i++) {
                  SimBody here = net[k * n + i];
                  if (i > 0) {
                    worst = Math.max(worst, gap(net[k * n + i - 1], 0, -0.5, here, 0, 0.5));
                  }
                  if (k > 0) {
                    worst = Math.max(worst, gap(net[(k - 1) * n + i], 0.5, 0, here, -0.5, 0));
                  }
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

  private static Scene cantilever() {
    int n = 6;
    return new Scene(
        "cantilever",
        5,
        0.05,
        "a beam of 6 boxes welded to a wall stays level: its tip sags by 5 % of its length at most",
        sim -> {
          SimBody last = sim.ground();
          for (int i = 0; i < n; i++) {
            SimBody part = sim.dynamic(i + 0.5, 0).box(0.5, 0.25, Matter.smooth(1).ghostly());
            sim.weld(last, part, i, 0);
            last = part;
          }
          SimBody tip = last;
          return t -> Math.hypot(tip.x() - (n - 0.5), tip.y()) / n;
        });
  }
}
