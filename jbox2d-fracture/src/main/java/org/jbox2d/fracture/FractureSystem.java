package org.jbox2d.fracture;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.dynamics.SolvedContact;
import org.jbox2d.dynamics.World;
import org.jbox2d.fracture.assembly.Plan;
import org.jbox2d.fracture.impact.Blow;
import org.jbox2d.fracture.impact.Damage;
import org.jbox2d.fracture.impact.Request;
import org.jbox2d.fracture.impact.RequestBook;
import org.jbox2d.fracture.impact.Strike;
import org.jbox2d.fracture.impact.Wear;

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
  private final RequestBook book = new RequestBook();
  private final List<Wear> worn = new ArrayList<>();
  private final Debris debris;
  private final Breaking breaking;

  /** No lambda: making the first one of a program would take longer than the fracture. */
  private final Runnable task =
      new Runnable() {
        @Override
        public void run() {
          breakRecorded();
        }
      };

  private FractureSystem(World world) {
    this.world = world;
    debris = new Debris(this, world);
    breaking = new Breaking(world, debris);
  }

  /** Returns the fracture system of a world. */
  public static FractureSystem of(World world) {
    if (world == null) {
      throw new IllegalArgumentException("world is null");
    }
    return world.extension(FractureSystem.class, FractureSystem::new);
  }

  /**
   * Breaks many small bodies in worlds of its own, so that what a fracture needs is compiled before
   * a game needs it. Call it while a game is loading, once; it takes some tenths of a second.
   *
   * <p>Without it one body is broken so when the first {@link Material} of the program is made,
   * which takes some hundredths of a second: all classes are loaded then, and the first fracture of
   * the game takes some tens of times as long as one when all is compiled, but no longer. The
   * system property {@code org.jbox2d.fracture.rehearsal}, set to {@code false} before, forbids
   * that. No world ever notices either.
   */
  public static void warmUp() {
    new Rehearsal().run();
  }

  // --- Recording, while the world is locked ---

  /** Records a blow if it is hard enough to matter. */
  void record(Fixture fixture, Material material, SolvedContact solved) {
    Blow blow = new Blow(solved);
    if (!RequestBook.matters(blow.intensity, material, fixture.getCompound() != null)) {
      return;
    }
    if (book.isEmpty()) {
      world.defer(task);
    }
    book.add(new Strike(fixture, material, blow));
  }

  // --- Breaking, after the step ---

  /** Breaks and damages what the blows of the step call for. */
  private void breakRecorded() {
    List<Request> requests = book.take(worn);
    breaking.wear(worn);
    breaking.carryOut(FractureCause.COLLISION, requests);
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
      request = RequestBook.requestOf(new Strike(fixture, material, point, impulse), worn);
      breaking.wear(worn);
    }
    List<Plan> plans =
        request == null
            ? Collections.emptyList()
            : breaking.plan(cause, Collections.singletonList(request));
    boolean yields = !plans.isEmpty() && plans.get(0).yields();
    float share = yields ? request.hardest().share() : 1f;
    if (push) {
      body.applyLinearImpulse(impulse.mul(share), point);
    }
    if (plans.isEmpty()) {
      return Collections.emptyList();
    }
    List<Body> bodies = breaking.carryOut(plans.get(0));
    breaking.tell(cause, plans.get(0), bodies);
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
    return new Cutting(breaking, world, local).cut(body);
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
    breaking.listener = listener;
  }

  /** Returns who hears of fractures. */
  public FractureListener getListener() {
    return breaking.listener;
  }

  /**
   * Sets the seed of the materials' sites. The same seed and the same calls give the same pieces.
   */
  public void setSeed(long seed) {
    breaking.seed = seed;
  }

  /** Returns the seed. */
  public long getSeed() {
    return breaking.seed;
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
    breaking.minimumArea = area;
  }

  /** Returns the area below which a body does not break, m^2. */
  public float getMinimumArea() {
    return breaking.minimumArea;
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
    breaking.bodyLimit = bodies;
  }

  /** Returns how many bodies the world may have. */
  public int getBodyLimit() {
    return breaking.bodyLimit;
  }

  /**
   * Sets how many pieces a body may break into, what stays counted. Beyond it cells that lie side
   * by side break away as one, so that mass and the region that breaks are kept; {@link
   * FractureEvent#limit()} tells. No limit by default.
   *
   * @throws IllegalArgumentException if it is below 2
   */
  public void setPiecesPerFracture(int pieces) {
    if (pieces < 2) {
      throw new IllegalArgumentException(
          "a fracture has at least 2 pieces, the limit is " + pieces);
    }
    breaking.pieceLimit = pieces;
  }

  /** Returns how many pieces a body may break into. */
  public int getPiecesPerFracture() {
    return breaking.pieceLimit;
  }

  /**
   * Sets how many pieces there may be that have come off bodies: splinters, and what stayed but no
   * longer hangs together with the largest part, if it is dynamic. Pieces of a cut are not counted,
   * nor those made while neither this limit nor {@link #setDebrisLifetime} was set. Beyond it
   * pieces are destroyed at the end of the step: of the older half, the smallest first. {@link
   * FractureListener#discard} hears of each. No limit by default.
   *
   * @param pieces {@code Integer.MAX_VALUE} for no limit
   * @throws IllegalArgumentException if it is negative
   */
  public void setDebrisBudget(int pieces) {
    if (pieces < 0) {
      throw new IllegalArgumentException("budget must not be negative, is " + pieces);
    }
    debris.setBudget(pieces);
  }

  /** Returns how many pieces there may be that have come off bodies. */
  public int getDebrisBudget() {
    return debris.budget();
  }

  /**
   * Sets how long a piece may sleep without a break before it is destroyed, s; those that {@link
   * #setDebrisBudget} counts. {@link FractureListener#discard} hears of each. For ever by default.
   *
   * @param seconds infinite for no limit
   * @throws IllegalArgumentException if it is negative or NaN
   */
  public void setDebrisLifetime(float seconds) {
    if (!(seconds >= 0f)) {
      throw new IllegalArgumentException("lifetime must not be negative, is " + seconds);
    }
    debris.setLifetime(seconds);
  }

  /** Returns how long a piece may sleep before it is destroyed, s. */
  public float getDebrisLifetime() {
    return debris.lifetime();
  }

  /** Returns how many pieces were destroyed because of a limit. */
  public int getDiscardedCount() {
    return debris.removed();
  }

  /**
   * Returns what blows too weak to break a fixture have left in it, N s: by this the rigidity is
   * less; 0 unless its material has a {@link Material#m_toughness}.
   */
  public static float damageOf(Fixture fixture) {
    return Damage.of(fixture);
  }

  /** Mends a fixture, and the others of its compound. */
  public static void mend(Fixture fixture) {
    Damage.clear(fixture);
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
    breaking.stepLimit = fractures;
  }

  /** Returns how many bodies may break in a step. */
  public int getFracturesPerStep() {
    return breaking.stepLimit;
  }

  /** Returns how many bodies have broken. */
  public int getFractureCount() {
    return breaking.fractures;
  }

  /**
   * Returns how many fractures were called off because something went wrong; their bodies stayed
   * whole.
   */
  public int getFailureCount() {
    return breaking.failures;
  }

  /** Returns how many fractures did not happen because of a limit. */
  public int getLimitedCount() {
    return breaking.limited;
  }
}
