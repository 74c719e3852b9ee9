package org.jbox2d.dynamics;

import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.MassData;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;

/** Mass, centre of mass and inertia of a body. */
final class BodyMass {
  private BodyMass() {}

  /** Sums up the fixtures. */
  static void reset(Body body) {
    set(body, 0f, 0f);
    if (body.m_type != BodyType.DYNAMIC) {
      body.m_sweep.localCenter.setZero();
      body.m_sweep.c0.set(body.m_xf.p);
      body.m_sweep.c.set(body.m_xf.p);
      body.m_sweep.a0 = body.m_sweep.a;
      return;
    }
    MassData data = body.m_world.scratchMass;
    double mass = 0;
    double cx = 0;
    double cy = 0;
    for (Fixture f = body.m_fixtureList; f != null; f = f.m_next) {
      if (f.m_density > 0f) {
        f.getMassData(data);
        mass += data.mass;
        cx += (double) data.mass * data.center.x;
        cy += (double) data.mass * data.center.y;
      }
    }
    Vec2 centre = body.m_world.scratchCentre;
    if (mass > 0) {
      centre.set((float) (cx / mass), (float) (cy / mass));
    } else {
      // A dynamic body must have some mass: one without any counts as 1 kg.
      centre.setZero();
      mass = 1;
    }
    boolean turns = (body.m_flags & Body.e_fixedRotationFlag) == 0;
    set(body, (float) mass, turns ? (float) inertia(body, data, centre) : 0f);
    moveCentre(body, centre);
  }

  /**
   * Inertia about the body's centre: each fixture's about its own centroid, moved there. The
   * inertia about the origin, which {@link MassData} holds, would not do for a small shape far from
   * it: the difference of two large floats.
   */
  private static double inertia(Body body, MassData data, Vec2 centre) {
    double sum = 0;
    for (Fixture f = body.m_fixtureList; f != null; f = f.m_next) {
      if (f.m_density > 0f) {
        f.getMassData(data);
        double dx = (double) data.center.x - centre.x;
        double dy = (double) data.center.y - centre.y;
        sum += aboutCentroid(f, data) + data.mass * (dx * dx + dy * dy);
      }
    }
    return sum;
  }

  private static double aboutCentroid(Fixture f, MassData data) {
    if (f.m_shape instanceof CircleShape) {
      double r = f.m_shape.m_radius;
      return 0.5 * data.mass * r * r;
    }
    if (f.m_shape instanceof PolygonShape) {
      return f.m_density * secondMoment((PolygonShape) f.m_shape, data.center);
    }
    double x = data.center.x;
    double y = data.center.y;
    return data.I - data.mass * (x * x + y * y);
  }

  /**
   * Second moment of area about a point: with p, q the ends of an edge seen from there, {@code sum
   * (p x q) (p.p + p.q + q.q) / 12} (Green's theorem).
   */
  private static double secondMoment(PolygonShape polygon, Vec2 about) {
    double sum = 0;
    Vec2 last = polygon.m_vertices[polygon.m_count - 1];
    double px = (double) last.x - about.x;
    double py = (double) last.y - about.y;
    for (int i = 0; i < polygon.m_count; i++) {
      double qx = (double) polygon.m_vertices[i].x - about.x;
      double qy = (double) polygon.m_vertices[i].y - about.y;
      double squares = px * (px + qx) + qx * qx + py * (py + qy) + qy * qy;
      sum += (px * qy - py * qx) * squares;
      px = qx;
      py = qy;
    }
    return sum / 12;
  }

  /** Takes mass data given by hand. */
  static void override(Body body, MassData given) {
    Checks.notNull(given, "massData");
    Checks.finite(given.mass, "massData.mass");
    Checks.finite(given.I, "massData.I");
    Checks.finite(given.center, "massData.center");
    if (body.m_type != BodyType.DYNAMIC) {
      return;
    }
    float mass = given.mass > 0f ? given.mass : 1f;
    float aboutCentre = 0f;
    if (given.I > 0f && (body.m_flags & Body.e_fixedRotationFlag) == 0) {
      float least = mass * given.center.lengthSquared();
      aboutCentre = given.I - least;
      if (!(aboutCentre > 0f)) {
        throw new IllegalArgumentException(
            "massData.I must exceed mass * |center|^2 = " + least + ", is " + given.I);
      }
    }
    set(body, mass, aboutCentre);
    moveCentre(body, given.center);
  }

  private static void set(Body body, float mass, float inertia) {
    body.thickness = -1f;
    body.m_mass = mass;
    body.m_invMass = mass > 0f ? 1f / mass : 0f;
    body.m_I = inertia;
    body.m_invI = inertia > 0f ? 1f / inertia : 0f;
  }

  /**
   * Moves the centre of mass, and lets the velocity be that of the new centre on the same rigid
   * motion.
   */
  private static void moveCentre(Body body, Vec2 localCentre) {
    Vec2 c = body.m_sweep.c;
    float oldX = c.x;
    float oldY = c.y;
    body.m_sweep.localCenter.set(localCentre);
    Transform.mulToOutUnsafe(body.m_xf, body.m_sweep.localCenter, c);
    body.m_sweep.c0.set(c);
    body.m_sweep.a0 = body.m_sweep.a;
    body.m_linearVelocity.x -= body.m_angularVelocity * (c.y - oldY);
    body.m_linearVelocity.y += body.m_angularVelocity * (c.x - oldX);
  }
}
