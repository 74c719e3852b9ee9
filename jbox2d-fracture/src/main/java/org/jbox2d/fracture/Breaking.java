package org.jbox2d.fracture;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.World;
import org.jbox2d.fracture.assembly.Assembler;
import org.jbox2d.fracture.assembly.Plan;
import org.jbox2d.fracture.assembly.Planner;
import org.jbox2d.fracture.impact.Blow;
import org.jbox2d.fracture.impact.Damage;
import org.jbox2d.fracture.impact.GiveBack;
import org.jbox2d.fracture.impact.Request;
import org.jbox2d.fracture.impact.Strike;
import org.jbox2d.fracture.impact.Wear;

/** Breaks what is called for, while the world is not locked; counts and tells. */
final class Breaking {
  /** What a game may set. */
  float minimumArea = FractureSystem.DEFAULT_MINIMUM_AREA;

  int bodyLimit = Integer.MAX_VALUE;
  int stepLimit = Integer.MAX_VALUE;
  int pieceLimit = Integer.MAX_VALUE;
  long seed;
  FractureListener listener;

  /** What has become of it. */
  int fractures;

  int failures;
  int limited;

  final Debris debris;
  private final World world;
  private final Planner planner = new Planner();
  private final GiveBack giveBack = new GiveBack();
  private long attempts;

  Breaking(World world, Debris debris) {
    this.world = world;
    this.debris = debris;
  }

  Planner planner() {
    return planner;
  }

  /**
   * Breaks what the blows of a step call for. Plans all fractures first, which changes nothing;
   * gives back what the broken bodies did not take of the blows; then replaces each body by its
   * pieces; then tells the listener.
   */
  void carryOut(FractureCause cause, List<Request> requests) {
    List<Plan> plans = plan(cause, requests);
    HeldUp heldUp = new HeldUp(world, plans);
    giveBack(plans);
    List<List<Body>> pieces = new ArrayList<>(plans.size());
    for (Plan plan : plans) {
      pieces.add(carryOut(plan));
      heldUp.hasBroken(plan.request.body, pieces.get(pieces.size() - 1));
    }
    heldUp.letCatchUp();
    for (int i = 0; i < plans.size(); i++) {
      tell(cause, plans.get(i), pieces.get(i));
    }
  }

  // --- Plans ---

  List<Plan> plan(FractureCause cause, List<Request> requests) {
    List<Plan> plans = new ArrayList<>(requests.size());
    int bodies = world.getBodyCount();
    int breaking = 0;
    for (Request called : requests) {
      FractureProposal proposal = new FractureProposal(cause, called);
      if (listener != null && !listener.allow(proposal)) {
        continue;
      }
      if (breaking >= stepLimit || bodies >= bodyLimit) {
        limit(
            proposal,
            breaking >= stepLimit ? FractureLimit.FRACTURES_PER_STEP : FractureLimit.BODIES);
        continue;
      }
      Request request = proposal.request();
      Plan plan = planner.plan(request, SiteRandom.mix(seed, attempts++), minimumArea, pieceLimit);
      if (plan.outcome == Plan.Outcome.BREAKS && bodies + plan.splinterCount() > bodyLimit) {
        limit(proposal, FractureLimit.BODIES);
        continue;
      }
      if (plan.outcome == Plan.Outcome.HOLDS && plan.limit != null) {
        limit(proposal, plan.limit);
        continue;
      }
      bodies += plan.splinterCount();
      breaking += plan.yields() ? 1 : 0;
      plans.add(plan);
    }
    return plans;
  }

  private void limit(FractureProposal proposal, FractureLimit limit) {
    limited++;
    if (listener != null) {
      listener.limited(proposal, limit);
    }
  }

  // --- What the blows have too much ---

  /**
   * One contact, one z: if it broke both of its bodies, the larger share acts. A blow that broke
   * nothing is left alone.
   */
  private void giveBack(List<Plan> plans) {
    List<Blow> done = new ArrayList<>();
    for (Plan plan : plans) {
      for (Strike strike : plan.request.strikes) {
        if (plan.yields() && strike.blow != null && !contains(done, strike.blow)) {
          done.add(strike.blow);
          giveBack.add(strike.blow, shareThatActs(plans, strike));
        }
      }
    }
    giveBack.apply();
  }

  private static float shareThatActs(List<Plan> plans, Strike strike) {
    float share = strike.share();
    for (Plan other : plans) {
      if (other.yields()) {
        for (Strike s : other.request.strikes) {
          if (s != strike && s.blow != null && s.blow.isSameAs(strike.blow)) {
            share = Math.max(share, s.share());
          }
        }
      }
    }
    return share;
  }

  private static boolean contains(List<Blow> blows, Blow blow) {
    for (Blow b : blows) {
      if (b.isSameAs(blow)) {
        return true;
      }
    }
    return false;
  }

  // --- Pieces ---

  List<Body> carryOut(Plan plan) {
    switch (plan.outcome) {
      case BREAKS:
        fractures++;
        List<Body> bodies = Assembler.carryOut(world, plan, plan.request.material.m_fragments);
        debris.add(plan.request.body, bodies);
        return bodies;
      case COMES_LOOSE:
        fractures++;
        plan.request.body.setType(BodyType.DYNAMIC);
        return Collections.singletonList(plan.request.body);
      case FAILS:
        failures++;
        return Collections.emptyList();
      default:
        return Collections.emptyList();
    }
  }

  void tell(FractureCause cause, Plan plan, List<Body> bodies) {
    if (listener == null) {
      return;
    }
    Request r = plan.request;
    if (plan.outcome == Plan.Outcome.FAILS) {
      Strike s = r.hardest();
      listener.failed(
          new FractureFailure(plan.reason, r.body, r.material, s.point, s.vector, seed));
    } else if (plan.yields()) {
      listener.action(r.material, r.intensity, bodies);
      listener.fractured(new FractureEvent(cause, plan, bodies));
    }
  }

  /** Tells of a cut. */
  void tellCut(Plan plan, List<Body> bodies) {
    if (plan.outcome == Plan.Outcome.FAILS) {
      failures++;
    } else if (plan.outcome == Plan.Outcome.BREAKS) {
      fractures++;
    }
    tell(FractureCause.CUT, plan, bodies);
  }

  // --- Damage ---

  /** Damages what blows were too weak to break. */
  void wear(List<Wear> worn) {
    for (Wear wear : worn) {
      boolean done = Damage.add(wear.fixture, wear.material, wear.intensity);
      if (done && listener != null) {
        listener.damaged(wear.fixture, wear.intensity, Damage.of(wear.fixture));
      }
    }
    worn.clear();
  }
}
