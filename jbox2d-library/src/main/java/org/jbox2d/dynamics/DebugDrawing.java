package org.jbox2d.dynamics;

import org.jbox2d.callbacks.DebugDraw;
import org.jbox2d.collision.AABB;
import org.jbox2d.collision.shapes.ChainShape;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.EdgeShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Color3f;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.contacts.Contact;
import org.jbox2d.dynamics.joints.Joint;

/** Draws a world by means of a {@link DebugDraw}, as its flags ask. */
final class DebugDrawing {
  private static final Color3f INACTIVE = new Color3f(0.5f, 0.5f, 0.3f);
  private static final Color3f STATIC = new Color3f(0.5f, 0.9f, 0.3f);
  private static final Color3f KINEMATIC = new Color3f(0.5f, 0.5f, 0.9f);
  private static final Color3f ASLEEP = new Color3f(0.5f, 0.5f, 0.5f);
  private static final Color3f AWAKE = new Color3f(0.9f, 0.7f, 0.7f);
  private static final Color3f JOINT = new Color3f(0.5f, 0.8f, 0.8f);
  private static final Color3f PAIR = new Color3f(0.3f, 0.9f, 0.9f);
  private static final Color3f BOUNDS = new Color3f(0.9f, 0.3f, 0.9f);

  private final World world;
  private final DebugDraw draw;

  DebugDrawing(World world, DebugDraw draw) {
    this.world = world;
    this.draw = draw;
  }

  void draw() {
    int flags = draw.getFlags();
    if ((flags & DebugDraw.e_shapeBit) != 0) {
      drawShapes((flags & DebugDraw.e_wireframeDrawingBit) != 0);
    }
    if ((flags & DebugDraw.e_jointBit) != 0) {
      for (Joint j = world.getJointList(); j != null; j = j.getNext()) {
        drawJoint(j);
      }
    }
    if ((flags & DebugDraw.e_pairBit) != 0) {
      drawPairs();
    }
    if ((flags & DebugDraw.e_aabbBit) != 0) {
      drawBounds();
    }
    if ((flags & DebugDraw.e_centerOfMassBit) != 0) {
      Transform xf = new Transform();
      for (Body b = world.getBodyList(); b != null; b = b.m_next) {
        xf.set(b.m_xf);
        xf.p.set(b.m_sweep.c);
        draw.drawTransform(xf);
      }
    }
    if ((flags & DebugDraw.e_dynamicTreeBit) != 0) {
      world.getContactManager().m_broadPhase.drawTree(draw);
    }
    draw.flush();
  }

  private void drawShapes(boolean wireframe) {
    for (Body b = world.getBodyList(); b != null; b = b.m_next) {
      Color3f color = colorOf(b);
      for (Fixture f = b.m_fixtureList; f != null; f = f.m_next) {
        drawShape(f, b.m_xf, color, wireframe);
      }
    }
  }

  private static Color3f colorOf(Body b) {
    if (!b.isActive()) {
      return INACTIVE;
    }
    switch (b.m_type) {
      case STATIC:
        return STATIC;
      case KINEMATIC:
        return KINEMATIC;
      default:
        return b.isAwake() ? AWAKE : ASLEEP;
    }
  }

  private void drawShape(Fixture fixture, Transform xf, Color3f color, boolean wireframe) {
    switch (fixture.getType()) {
      case CIRCLE:
        CircleShape circle = (CircleShape) fixture.m_shape;
        Vec2 axis = new Vec2(xf.q.c, xf.q.s);
        Vec2 centre = Transform.mul(xf, circle.m_p);
        if (wireframe) {
          draw.drawCircle(centre, circle.m_radius, axis, color);
        } else {
          draw.drawSolidCircle(centre, circle.m_radius, axis, color);
        }
        break;
      case POLYGON:
        PolygonShape polygon = (PolygonShape) fixture.m_shape;
        Vec2[] vertices = new Vec2[polygon.m_count];
        for (int i = 0; i < vertices.length; i++) {
          vertices[i] = Transform.mul(xf, polygon.m_vertices[i]);
        }
        if (wireframe) {
          draw.drawPolygon(vertices, vertices.length, color);
        } else {
          draw.drawSolidPolygon(vertices, vertices.length, color);
        }
        break;
      case EDGE:
        EdgeShape edge = (EdgeShape) fixture.m_shape;
        draw.drawSegment(
            Transform.mul(xf, edge.m_vertex1), Transform.mul(xf, edge.m_vertex2), color);
        break;
      default:
        ChainShape chain = (ChainShape) fixture.m_shape;
        for (int i = 0; i + 1 < chain.m_count; i++) {
          draw.drawSegment(
              Transform.mul(xf, chain.m_vertices[i]),
              Transform.mul(xf, chain.m_vertices[i + 1]),
              color);
        }
        break;
    }
  }

  private void drawJoint(Joint joint) {
    Vec2 a = new Vec2();
    Vec2 b = new Vec2();
    joint.getAnchorA(a);
    joint.getAnchorB(b);
    switch (joint.getType()) {
      case CONSTANT_VOLUME:
        for (int i = 0; i < joint.bodyCount(); i++) {
          draw.drawSegment(
              joint.body(i).getWorldCenter(),
              joint.body((i + 1) % joint.bodyCount()).getWorldCenter(),
              JOINT);
        }
        break;
      case DISTANCE:
      case MOUSE:
        draw.drawSegment(a, b, JOINT);
        break;
      default:
        draw.drawSegment(joint.getBodyA().m_xf.p, a, JOINT);
        draw.drawSegment(a, b, JOINT);
        draw.drawSegment(joint.getBodyB().m_xf.p, b, JOINT);
        break;
    }
  }

  private void drawPairs() {
    for (Contact c = world.getContactList(); c != null; c = c.getNext()) {
      draw.drawSegment(
          c.m_fixtureA.getAABB(c.m_indexA).getCenter(),
          c.m_fixtureB.getAABB(c.m_indexB).getCenter(),
          PAIR);
    }
  }

  private void drawBounds() {
    for (Body b = world.getBodyList(); b != null; b = b.m_next) {
      for (Fixture f = b.m_fixtureList; f != null; f = f.m_next) {
        for (int i = 0; i < f.m_proxyCount; i++) {
          AABB aabb = world.getContactManager().m_broadPhase.getFatAABB(f.m_proxies[i].proxyId);
          Vec2[] corners = new Vec2[] {new Vec2(), new Vec2(), new Vec2(), new Vec2()};
          aabb.getVertices(corners);
          draw.drawPolygon(corners, 4, BOUNDS);
        }
      }
    }
  }
}
