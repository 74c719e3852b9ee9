package org.jbox2d.fracture;

import java.util.ArrayList;
import java.util.List;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.CompoundShape;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.dynamics.World;
import org.jbox2d.fracture.assembly.Assembler;
import org.jbox2d.fracture.assembly.Plan;
import org.jbox2d.fracture.impact.Request;
import org.jbox2d.fracture.impact.RequestBook;
import org.jbox2d.fracture.impact.Strike;

/**
 * One cut through a body: its breakables one after the other. All pieces share the body's frame, so
 * the polyline serves for all.
 */
final class Cutting {
  private final Breaking breaking;
  private final World world;
  private final double[] polyline;

  Cutting(Breaking breaking, World world, double[] polyline) {
    this.breaking = breaking;
    this.world = world;
    this.polyline = polyline;
  }

  List<Body> cut(Body body) {
    List<Body> bodies = new ArrayList<>();
    bodies.add(body);
    boolean cut = false;
    // What has been cut is behind i; a cut may add bodies, and a body may have several fixtures to
    // cut.
    for (int i = 0; i < bodies.size(); i++) {
      List<Object> done = new ArrayList<>();
      for (Fixture f = next(bodies.get(i), done); f != null; f = next(bodies.get(i), done)) {
        cut |= cutOne(f, bodies, done);
      }
    }
    return cut ? bodies : new ArrayList<>();
  }

  private static Fixture next(Body body, List<Object> done) {
    for (Fixture f = body.getFixtureList(); f != null; f = f.getNext()) {
      if (!done.contains(unitOf(f))) {
        done.add(unitOf(f));
        return f;
      }
    }
    return null;
  }

  private static Object unitOf(Fixture f) {
    CompoundShape compound = f.getCompound();
    return compound == null ? f : compound;
  }

  private boolean cutOne(Fixture fixture, List<Body> bodies, List<Object> done) {
    Body body = fixture.getBody();
    Material material =
        fixture.getMaterial() instanceof Material ? (Material) fixture.getMaterial() : null;
    Vec2 start = body.getWorldPoint(new Vec2((float) polyline[0], (float) polyline[1]));
    Request request = RequestBook.commanded(new Strike(fixture, material, start, new Vec2()));
    if (!isAllowed(request)) {
      return false;
    }
    Plan plan = breaking.planner().cut(request, polyline);
    List<Body> made = new ArrayList<>();
    if (plan.outcome == Plan.Outcome.BREAKS) {
      made = Assembler.carryOut(world, plan, material);
      for (Body b : made) {
        if (!bodies.contains(b)) {
          bodies.add(b);
        }
        // The pieces of this fixture lie on one side of the cut each.
        for (Fixture f = b.getFixtureList(); f != null; f = f.getNext()) {
          if (plan.made(f.getCompound())) {
            done.add(unitOf(f));
          }
        }
      }
    }
    breaking.tellCut(plan, made);
    return plan.outcome == Plan.Outcome.BREAKS;
  }

  private boolean isAllowed(Request request) {
    FractureListener listener = breaking.listener;
    return listener == null || listener.allow(new FractureProposal(FractureCause.CUT, request));
  }
}
