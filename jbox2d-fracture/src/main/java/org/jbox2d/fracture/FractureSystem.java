package org.jbox2d.fracture;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.jbox2d.common.Vec2;
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
import org.jbox2d.fracture.impact.RequestBook;
import org.jbox2d.fracture.impact.Strike;

/**
 * What a world has of fracture: listener, seed, limits and workspaces. It is there as soon as it is
 * asked for, or as a fixture with a {@link Material} is struck; nothing is shared between worlds.
 *
 * <p>During a step it records the blows that exceed the rigidity of the struck fixture. At the end
 * of the step, when the world is no longer locked, it breaks these bodies in the order in which
 * they were first struck, each at most once ({@link #breakRecorded}). Besides collisions a game can
 * {@link #strike}, {@link #cut} and {@link #explode}.
 */
public final class FractureSystem {
  /** Default of {@link #setMinimumArea}, m^2. */
  public static final float DEFAULT_MINIMUM_AREA = 0.5f;

  private final World world;
  private final Planner planner = new Planner();
  private final GiveBack giveBack = new GiveBack();
  private final RequestBook book = new RequestBook();

  private FractureListener listener;
  private long seed;
  private float minimumArea = DEFAULT_MINIMUM_AREA;
  private int bodyLimit = Integer.MAX_VALUE;
  private int stepLimit = Integer.MAX_VALUE;
  private int fractures;
  private int failures;
  private int limited;
  private long attempts;

  private FractureSystem(World world) {
    this.world = world;
  }

  /** Returns the fracture system of a world. */
  public static FractureSystem of(World world) {
    if (world == null) {
      throw new IllegalArgumentException("world is null");
    }
    return world.extension(FractureSystem.class, FractureSystem::new);
  }

  // --- Recording, while the world is locked ---

  /** Records a blow if it is hard enough to matter. */
  void record(Fixture fixture, Material material, SolvedContact solved) {
    boolean part = fixture.getCompound() != null;
    if (fixture.isSensor()
        || !RequestBook.matters(solved.normalImpulse(), material.m_rigidity, part)) {
      return;
    }
    Blow blow = new Blow(solved);
    if (!RequestBook.matters(blow.intensity, material.m_rigidity, part)) {
      return;
    }
    if (book.isEmpty()) {
      world.defer(this::breakRecorded);
    }
    book.add(new Strike(fixture, material, blow));
  }

  // --- Breaking, after the step ---

  /** Breaks what the blows of the step call for. */
  private void breakRecorded() {
    carryOut(FractureCause.COLLISION, book.take());
  }

  /**
   * Plans all fractures first, which changes nothing; gives back what the broken bodies did not
   * take of the blows; then replaces each body by its pieces; then tells the listener.
   */
  private List<Body> carryOut(FractureCause cause, List<Request> requests) {
    List<Plan> plans = plan(cause, requests);
    giveBack(plans);
    List<List<Body>> pieces = new ArrayList<>(plans.size());
    List<Body> all = new ArrayList<>();
    for (Plan plan : plans) {
      List<Body> made = carryOut(plan);
      pieces.add(made);
      all.addAll(made);
    }
    for (int i = 0; i < plans.size(); i++) {
      tell(cause, plans.get(i), pieces.get(i));
    }
    return all;
  }

  private List<Plan> plan(FractureCause cause, List<Request> requests) {
    List<Plan> plans = new ArrayList<>(requests.size());
    int bodies = world.getBodyCount();
    int breaking = 0;
    for (Request called : requests) {
      FractureProposal proposal = new FractureProposal(cause, called);
      if (listener != null && !listener.allow(proposal)) {
        continue;
      }
      Request request = proposal.request();
      if (breaking >= stepLimit || bodies >= bodyLimit) {
        limited++;
        continue;
      }
      Plan plan = planner.plan(request, SiteRandom.mix(seed, attempts++), minimumArea);
      if (plan.outcome == Plan.Outcome.BREAKS && bodies + plan.splinterCount() > bodyLimit) {
        limited++;
        continue;
      }
      bodies += plan.splinterCount();
      breaking += plan.yields() ? 1 : 0;
      plans.add(plan);
    }
    return plans;
  }

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

  private List<Body> carryOut(Plan plan) {
    switch (plan.outcome) {
      case BREAKS:
        fractures++;
        return Assembler.carryOut(world, plan, plan.request.material.m_fragments);
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

  private void tell(FractureCause cause, Plan plan, List<Body> bodies) {
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

  // --- Commands ---

  /**
   * Strikes a fixture. If the impulse exceeds the rigidity of its material, the fixture breaks as
   * by a collision: the impulse p that breaking costs moves the body, the rest goes through it.
   * Otherwise the whole impulse moves the body.
   *
   * @param point world point, m
   * @param impulse world impulse, N s; its direction is that of the impact
   * @return the bodies the fixture's body broke into, remainders first; empty if it held
   * @throws IllegalStateException if the world is locked
   * @throws IllegalArgumentException if the fixture is of no body of this world, or a value is not
   *     finite
   */
  public List<Body> strike(Fixture fixture, Vec2 point, Vec2 impulse) {
    return strike(FractureCause.STRIKE, fixture, point, impulse);
  }

  List<Body> strike(FractureCause cause, Fixture fixture, Vec2 point, Vec2 impulse) {
    return strike(cause, fixture, point, impulse, true);
  }

  /** A strike from within, which moves nothing as a whole. */
  List<Body> strikeWithoutPush(Fixture fixture, Vec2 point, Vec2 impulse) {
    return strike(FractureCause.EXPLOSION, fixture, point, impulse, false);
  }

  private List<Body> strike(
      FractureCause cause, Fixture fixture, Vec2 point, Vec2 impulse, boolean push) {
    checkCommand(fixture);
    checkFinite(point, "point");
    checkFinite(impulse, "impulse");
    Body body = fixture.getBody();
    Request request = null;
    if (fixture.getMaterial() instanceof Material) {
      Material material = (Material) fixture.getMaterial();
      material.check();
      request = RequestBook.requestOf(new Strike(fixture, material, point, impulse));
    }
    List<Plan> plans =
        request == null ? Collections.emptyList() : plan(cause, Collections.singletonList(request));
    boolean yields = !plans.isEmpty() && plans.get(0).yields();
    float share = yields ? request.hardest().share() : 1f;
    if (push) {
      body.applyLinearImpulse(impulse.mul(share), point);
    }
    if (plans.isEmpty()) {
      return Collections.emptyList();
    }
    List<Body> bodies = carryOut(plans.get(0));
    tell(cause, plans.get(0), bodies);
    return bodies;
  }

  /**
   * Cuts a body along a polyline. Where a cut does not go through, nothing comes off. The largest
   * piece of each fixture stays the body; the others become bodies of their own, dynamic, of the
   * same material.
   *
   * @param polyline world points, at least two
   * @return the bodies, the old one first; empty if nothing was cut
   * @throws IllegalStateException if the world is locked
   * @throws IllegalArgumentException if the body is not of this world, or a point is not finite
   */
  public List<Body> cut(Body body, Vec2... polyline) {
    if (body == null || body.getWorld() != world) {
      throw new IllegalArgumentException("body is not of this world");
    }
    if (polyline.length < 2) {
      throw new IllegalArgumentException("a cut needs 2 points, has " + polyline.length);
    }
    checkUnlocked();
    double[] local = new double[2 * polyline.length];
    for (int i = 0; i < polyline.length; i++) {
      checkFinite(polyline[i], "polyline[" + i + "]");
      Vec2 p = body.getLocalPoint(polyline[i]);
      local[2 * i] = p.x;
      local[2 * i + 1] = p.y;
    }
    return new Cutting(this, world, planner, local).cut(body);
  }

  /**
   * Sets off an explosion: pushes bodies away from a point and breaks what it exceeds. It goes out
   * in straight rays; what stands behind something is in its shadow.
   *
   * @param center world point, m
   * @param radius how far it reaches, m; positive
   * @param impulse impulse on each metre of a surface that faces the center at a distance of 1 m, N
   *     s/m; not negative. It falls off with the distance d as {@code (1 - d / radius) / d}
   * @return how many fixtures it has struck
   * @throws IllegalStateException if the world is locked
   * @throws IllegalArgumentException if a value is not allowed
   */
  public int explode(Vec2 center, float radius, float impulse) {
    checkUnlocked();
    checkFinite(center, "center");
    if (!(radius > 0f) || Float.isInfinite(radius)) {
      throw new IllegalArgumentException("radius must be finite and positive, is " + radius);
    }
    if (!(impulse >= 0f) || Float.isInfinite(impulse)) {
      throw new IllegalArgumentException("impulse must be finite and not negative, is " + impulse);
    }
    return new Explosion(this, world, center, radius, impulse).setOff();
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

  /** Whether the listener allows a cut. */
  boolean allowsCut(Request request) {
    return listener == null || listener.allow(new FractureProposal(FractureCause.CUT, request));
  }

  private void checkCommand(Fixture fixture) {
    if (fixture == null || fixture.getBody() == null || fixture.getBody().getWorld() != world) {
      throw new IllegalArgumentException("fixture is of no body of this world");
    }
    checkUnlocked();
  }

  private void checkUnlocked() {
    if (world.isLocked()) {
      throw new IllegalStateException("the world is locked; queue the command by World.defer");
    }
  }

  private static void checkFinite(Vec2 v, String name) {
    if (v == null || !Float.isFinite(v.x) || !Float.isFinite(v.y)) {
      throw new IllegalArgumentException(name + " must be finite, is " + v);
    }
  }

  // --- Properties ---

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

  /**
   * Sets how many bodies the world may have; a fracture that would make more does not happen, and
   * its blow stays an ordinary blow. No limit by default.
   *
   * @throws IllegalArgumentException if it is negative
   */
  public void setBodyLimit(int bodies) {
    if (bodies < 0) {
      throw new IllegalArgumentException("limit must not be negative, is " + bodies);
    }
    bodyLimit = bodies;
  }

  /** Returns how many bodies the world may have. */
  public int getBodyLimit() {
    return bodyLimit;
  }

  /**
   * Sets how many bodies may break in a step; further blows of the step stay ordinary blows. No
   * limit by default.
   *
   * @throws IllegalArgumentException if it is negative
   */
  public void setFracturesPerStep(int fractures) {
    if (fractures < 0) {
      throw new IllegalArgumentException("limit must not be negative, is " + fractures);
    }
    stepLimit = fractures;
  }

  /** Returns how many bodies may break in a step. */
  public int getFracturesPerStep() {
    return stepLimit;
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

  /** Returns how many fractures did not happen because of a limit. */
  public int getLimitedCount() {
    return limited;
  }
}
