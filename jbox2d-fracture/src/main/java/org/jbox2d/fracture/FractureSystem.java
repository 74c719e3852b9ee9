package org.jbox2d.fracture;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.dynamics.SolvedContact;
import org.jbox2d.dynamics.World;
import org.jbox2d.fracture.assembly.Assembler;
import org.jbox2d.fracture.assembly.Plan;
import org.jbox2d.fracture.assembly.Planner;
import org.jbox2d.fracture.impact.Blow;
import org.jbox2d.fracture.impact.GiveBack;
import org.jbox2d.fracture.impact.Request;

/**
 * What a world has of fracture: listener, seed, limits and workspaces. It is there as soon as it is
 * asked for, or as a fixture with a {@link Material} is struck; nothing is shared between worlds.
 *
 * <p>During a step it records, for each body, the strongest blow that exceeds the rigidity of the
 * struck fixture. At the end of the step, when the world is no longer locked, it breaks these
 * bodies in the order in which they were first struck ({@link #breakRequested}).
 */
public final class FractureSystem {
  /** Default of {@link #setMinimumArea}, m^2. */
  public static final float DEFAULT_MINIMUM_AREA = 0.5f;

  private final World world;
  private final Planner planner = new Planner();
  private final GiveBack giveBack = new GiveBack();

  /**
   * The strongest request of each body, in the order of first striking; looked up by identity,
   * walked in insertion order.
   */
  private final Map<Body, Request> requests = new LinkedHashMap<>();

  private FractureListener listener;
  private long seed;
  private float minimumArea = DEFAULT_MINIMUM_AREA;
  private int fractures;
  private int failures;
  private long attempts;

  private FractureSystem(World world) {
    this.world = world;
  }

  /** Returns the fracture system of a world. */
  public static FractureSystem of(World world) {
    return world.extension(FractureSystem.class, FractureSystem::new);
  }

  // --- Recording, while the world is locked
  // ---------------------------------------------------------------------------------

  /** Records a blow, if it exceeds the rigidity and is the strongest on its body in this step. */
  void record(Fixture fixture, Material material, SolvedContact solved) {
    if (!(solved.normalImpulse() > material.m_rigidity) || fixture.isSensor()) {
      return;
    }
    Blow blow = new Blow(solved);
    if (!(blow.intensity > material.m_rigidity)) {
      return;
    }
    if (requests.isEmpty()) {
      world.defer(this::breakRequested);
    }
    Body body = fixture.getBody();
    Request strongest = requests.get(body);
    if (strongest == null || blow.intensity > strongest.blow.intensity) {
      requests.put(body, new Request(fixture, material, blow));
    }
  }

  // --- Breaking, after the step
  // ---------------------------------------------------------------------------------------------

  /**
   * Breaks what was recorded: plans all fractures first, which changes nothing; gives back what the
   * broken bodies did not take of the blows; then replaces each body by its pieces, and tells the
   * listener.
   */
  private void breakRequested() {
    List<Plan> plans = plan();
    giveBack(plans);
    List<List<Body>> pieces = new ArrayList<>();
    for (Plan plan : plans) {
      pieces.add(carryOut(plan));
    }
    for (int i = 0; i < plans.size(); i++) {
      tell(plans.get(i), pieces.get(i));
    }
  }

  private List<Plan> plan() {
    List<Plan> plans = new ArrayList<>(requests.size());
    List<Request> recorded = new ArrayList<>(requests.values());
    requests.clear();
    for (Request request : recorded) {
      if (request.isLive()) {
        plans.add(planner.plan(request, SiteRandom.mix(seed, attempts++), minimumArea));
      }
    }
    return plans;
  }

  /**
   * One blow, one z: if it broke both of its bodies, breaking has cost it the larger rigidity. A
   * blow that broke nothing is left alone.
   */
  private void giveBack(List<Plan> plans) {
    List<Blow> done = new ArrayList<>();
    for (Plan plan : plans) {
      Blow blow = plan.request.blow;
      if (!plan.yields() || contains(done, blow)) {
        continue;
      }
      float rigidity = 0f;
      for (Plan other : plans) {
        if (other.yields() && other.request.blow.isSameAs(blow)) {
          rigidity = Math.max(rigidity, other.request.material.m_rigidity);
        }
      }
      done.add(blow);
      giveBack.add(blow, Math.min(1f, rigidity / blow.intensity));
    }
    giveBack.apply();
  }

  private static boolean contains(List<Blow> blows, Blow blow) {
    for (Blow b : blows) {
      if (b.isSameAs(blow)) {
        return true;
      }
    }
    return false;
  }

  private List<Body> carryOut(Plan plan) {
    switch (plan.outcome) {
      case BREAKS:
        fractures++;
        return Assembler.carryOut(world, plan);
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

  private void tell(Plan plan, List<Body> pieces) {
    if (listener == null) {
      return;
    }
    Request r = plan.request;
    if (plan.outcome == Plan.Outcome.FAILS) {
      listener.failed(
          new FractureFailure(plan.reason, r.body, r.material, r.point, r.vector, seed));
    } else if (plan.yields()) {
      listener.action(r.material, r.blow.intensity, pieces);
    }
  }

  // --- Properties
  // -----------------------------------------------------------------------------------------------------------

  /** Sets who hears of fractures; may be {@code null}. */
  public void setListener(FractureListener listener) {
    this.listener = listener;
  }

  /** Returns who hears of fractures. */
  public FractureListener getListener() {
    return listener;
  }

  /**
   * Sets the seed of the materials' sites. The same seed and the same calls give the same pieces.
   */
  public void setSeed(long seed) {
    this.seed = seed;
  }

  /** Returns the seed. */
  public long getSeed() {
    return seed;
  }

  /**
   * Sets the area below which a body does not break, m^2. For pieces of bodies smaller than ten
   * times that, a tenth of the area of the body that first broke takes its place, so that small
   * bodies break too. A static body below it comes loose instead.
   *
   * @throws IllegalArgumentException if it is negative or not finite
   */
  public void setMinimumArea(float area) {
    if (!(area >= 0f) || Float.isInfinite(area)) {
      throw new IllegalArgumentException("area must be finite and not negative, is " + area);
    }
    minimumArea = area;
  }

  /** Returns the area below which a body does not break, m^2. */
  public float getMinimumArea() {
    return minimumArea;
  }

  /** Returns how many bodies have broken. */
  public int getFractureCount() {
    return fractures;
  }

  /**
   * Returns how many fractures were called off because something went wrong; their bodies stayed
   * whole.
   */
  public int getFailureCount() {
    return failures;
  }
}
