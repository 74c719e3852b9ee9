package org.jbox2d.fracture;

import java.util.LinkedHashMap;
import java.util.Map;
import org.jbox2d.callbacks.RayCastCallback;
import org.jbox2d.collision.AABB;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.dynamics.World;

/**
 * One explosion. It goes out as evenly spaced rays, each of which strikes the first fixture it
 * meets.
 *
 * <p>In the plane a blast spreads over a circle, so that its impulse on a surface of length l at
 * distance d, {@code I l / d}, is that on the angle the surface takes up as seen from the center:
 * each ray carries {@code I 2 pi / n}, less the share {@code d / radius} that is lost on the way.
 * All rays on a fixture together are one strike, at the mean of their points.
 */
final class Explosion {
  /** Rays; at the edge of an explosion of radius 10 m they are 0.17 m apart. */
  private static final int RAYS = 360;

  private final FractureSystem system;
  private final World world;
  private final Vec2 center;
  private final float radius;
  private final float impulse;

  /** In the order in which the rays meet them. */
  private final Map<Fixture, Push> pushes = new LinkedHashMap<>();

  Explosion(FractureSystem system, World world, Vec2 center, float radius, float impulse) {
    this.system = system;
    this.world = world;
    this.center = center.clone();
    this.radius = radius;
    this.impulse = impulse;
  }

  int setOff() {
    strikeAround();
    for (int i = 0; i < RAYS; i++) {
      double angle = 2 * Math.PI * i / RAYS;
      castRay((float) StrictMath.cos(angle), (float) StrictMath.sin(angle));
    }
    for (Map.Entry<Fixture, Push> entry : pushes.entrySet()) {
      entry.getValue().act(entry.getKey());
    }
    return pushes.size();
  }

  /**
   * A fixture that the center is in takes what goes out towards its walls; seen as a whole that is
   * no push, but it can break it.
   */
  private void strikeAround() {
    AABB at = new AABB();
    at.lowerBound.set(center);
    at.upperBound.set(center);
    world.queryAABB(
        fixture -> {
          if (!fixture.isSensor() && fixture.testPoint(center)) {
            pushOf(fixture).inside = true;
          }
          return true;
        },
        at);
  }

  private Push pushOf(Fixture fixture) {
    return pushes.computeIfAbsent(fixture, f -> new Push());
  }

  private void castRay(float x, float y) {
    Vec2 end = new Vec2(center.x + x * radius, center.y + y * radius);
    FirstHit hit = new FirstHit();
    world.raycast(hit, center, end);
    if (hit.fixture != null) {
      float strength = (float) (impulse * (2 * Math.PI / RAYS)) * (1f - hit.fraction);
      pushOf(hit.fixture).add(x * strength, y * strength, strength, hit.point);
    }
  }

  private final class Push {
    private double x;
    private double y;
    private double strength;
    private double atX;
    private double atY;
    private boolean inside;

    void add(double px, double py, double size, Vec2 point) {
      x += px;
      y += py;
      strength += size;
      atX += size * point.x;
      atY += size * point.y;
    }

    void act(Fixture fixture) {
      // What broke before may have taken this fixture's body with it.
      if (fixture.getBody() == null || fixture.getBody().getWorld() != world) {
        return;
      }
      Body body = fixture.getBody();
      if (inside) {
        Vec2 all = new Vec2((float) (2 * Math.PI) * impulse, 0f);
        system.strikeWithoutPush(fixture, center, all);
        return;
      }
      if (!(strength > 0)) {
        return;
      }
      Vec2 point = new Vec2((float) (atX / strength), (float) (atY / strength));
      Vec2 push = new Vec2((float) x, (float) y);
      if (body.getType() == BodyType.DYNAMIC || fixture.getMaterial() instanceof Material) {
        system.strike(FractureCause.EXPLOSION, fixture, point, push);
      }
    }
  }

  /** The nearest fixture that is not a sensor. */
  private static final class FirstHit implements RayCastCallback {
    private Fixture fixture;
    private float fraction;
    private final Vec2 point = new Vec2();

    @Override
    public float reportFixture(Fixture hit, Vec2 at, Vec2 normal, float f) {
      if (hit.isSensor()) {
        return -1f;
      }
      fixture = hit;
      fraction = f;
      point.set(at);
      return f;
    }
  }
}
