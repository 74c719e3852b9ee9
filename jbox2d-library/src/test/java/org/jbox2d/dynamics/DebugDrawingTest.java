package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.jbox2d.callbacks.DebugDraw;
import org.jbox2d.collision.AABB;
import org.jbox2d.collision.shapes.ChainShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Color3f;
import org.jbox2d.common.MathUtils;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.joints.ConstantVolumeJointDef;
import org.jbox2d.dynamics.joints.DistanceJointDef;
import org.jbox2d.dynamics.joints.RevoluteJointDef;
import org.junit.jupiter.api.Test;

/** What a world draws of itself, flag by flag. */
class DebugDrawingTest {
  private static final float ROUNDING = 1e-5f;

  private final World world = Make.world();
  private final Recorder drawn = new Recorder();

  @Test
  void drawsNothingWithoutFlagsButEndsTheFrame() {
    Make.box(world, BodyType.DYNAMIC, 0f, 0f, 1f, 1f);
    draw(0);
    assertEquals(List.of(), drawn.calls);
    assertEquals(1, drawn.frames);
  }

  @Test
  void solidShapesStandWhereTheirBodiesAre() {
    Body box = Make.box(world, BodyType.DYNAMIC, 3f, 1f, 2f, 1f);
    box.setTransform(new Vec2(3f, 1f), 0.5f * MathUtils.PI);
    Body disc = Make.disc(world, -4f, 2f, 0.5f);
    disc.setTransform(new Vec2(-4f, 2f), 0.5f * MathUtils.PI);
    draw(DebugDraw.e_shapeBit);

    assertEquals(List.of("solidCircle", "solidPolygon"), drawn.kinds());
    Call circle = drawn.only("solidCircle");
    near(-4f, 2f, circle.points[0]);
    near(0f, 1f, circle.points[1]);
    assertEquals(0.5f, circle.radius);
    AABB bounds = boundsOf(drawn.only("solidPolygon").points);
    near(2f, -1f, bounds.lowerBound);
    near(4f, 3f, bounds.upperBound);
  }

  @Test
  void wireframesAreOutlines() {
    Make.box(world, BodyType.DYNAMIC, 3f, 1f, 2f, 1f);
    Make.disc(world, -4f, 2f, 0.5f);
    draw(DebugDraw.e_shapeBit | DebugDraw.e_wireframeDrawingBit);
    assertEquals(List.of("circle", "polygon"), drawn.kinds());
    near(1f, 0f, drawn.only("circle").points[1]);
  }

  @Test
  void edgesAndChainsAreSegments() {
    Body ground = Make.ground(world);
    ChainShape chain = new ChainShape();
    chain.createChain(new Vec2[] {new Vec2(0f, 0f), new Vec2(1f, 2f), new Vec2(3f, 2f)}, 3);
    ground.createFixture(chain, 0f);
    ground.setTransform(new Vec2(0f, 5f), 0f);
    draw(DebugDraw.e_shapeBit);
    assertEquals(List.of("segment", "segment", "segment"), drawn.kinds());
    assertTrue(drawn.hasSegment(-200f, 5f, 200f, 5f));
    assertTrue(drawn.hasSegment(0f, 5f, 1f, 7f));
    assertTrue(drawn.hasSegment(1f, 7f, 3f, 7f));
  }

  @Test
  void coloursTellTheStateOfABody() {
    List<Color3f> colours = new ArrayList<>();
    Body body = Make.box(world, BodyType.STATIC, 0f, 0f, 1f, 1f);
    colours.add(colour());
    body.setType(BodyType.KINEMATIC);
    colours.add(colour());
    body.setType(BodyType.DYNAMIC);
    colours.add(colour());
    body.setAwake(false);
    colours.add(colour());
    body.setActive(false);
    colours.add(colour());
    assertEquals(5, colours.stream().map(c -> c.x + " " + c.y + " " + c.z).distinct().count());
  }

  @Test
  void jointsRunThroughTheirAnchors() {
    Body a = Make.box(world, BodyType.DYNAMIC, 0f, 0f, 1f, 1f);
    Body b = Make.box(world, BodyType.DYNAMIC, 6f, 0f, 1f, 1f);
    DistanceJointDef rod = new DistanceJointDef();
    rod.initialize(a, b, new Vec2(1f, 0.5f), new Vec2(5f, 0.5f));
    world.createJoint(rod);
    draw(DebugDraw.e_jointBit);
    assertEquals(List.of("segment"), drawn.kinds());
    assertTrue(drawn.hasSegment(1f, 0.5f, 5f, 0.5f));

    RevoluteJointDef hinge = new RevoluteJointDef();
    hinge.initialize(a, b, new Vec2(3f, 2f));
    world.createJoint(hinge);
    draw(DebugDraw.e_jointBit);
    assertEquals(4, drawn.calls.size());
    assertTrue(drawn.hasSegment(0f, 0f, 3f, 2f));
    assertTrue(drawn.hasSegment(6f, 0f, 3f, 2f));
  }

  @Test
  void ringOfConstantVolumeIsClosed() {
    ConstantVolumeJointDef def = new ConstantVolumeJointDef();
    Vec2[] corners = {new Vec2(0f, 0f), new Vec2(4f, 0f), new Vec2(4f, 4f), new Vec2(0f, 4f)};
    for (Vec2 corner : corners) {
      def.addBody(Make.disc(world, corner.x, corner.y, 0.2f));
    }
    world.createJoint(def);
    draw(DebugDraw.e_jointBit);
    for (int i = 0; i < corners.length; i++) {
      Vec2 next = corners[(i + 1) % corners.length];
      assertTrue(drawn.hasSegment(corners[i].x, corners[i].y, next.x, next.y), "side " + i);
    }
  }

  @Test
  void pairsJoinTheCentresOfBounds() {
    Make.disc(world, 0f, 0f, 1f);
    Make.disc(world, 1.5f, 0.5f, 1f);
    Make.disc(world, 20f, 0f, 1f);
    world.setGravity(new Vec2());
    world.step(0f, 8, 3);
    draw(DebugDraw.e_pairBit);
    assertEquals(List.of("segment"), drawn.kinds());
    assertTrue(drawn.hasSegment(0f, 0f, 1.5f, 0.5f));
  }

  @Test
  void boundsHoldTheirFixtures() {
    Body box = Make.box(world, BodyType.DYNAMIC, 3f, 1f, 2f, 1f);
    draw(DebugDraw.e_aabbBit);
    AABB bounds = boundsOf(drawn.only("polygon").points);
    assertTrue(bounds.contains(box.getFixtureList().getAABB(0)));
    assertTrue(bounds.getPerimeter() < 2f * (5f + 3f), bounds + " is wide");
  }

  @Test
  void centreOfMassIsWhereTheBodyTurns() {
    Body body = Make.body(world, BodyType.DYNAMIC, 5f, 5f);
    body.createFixture(Make.boxShape(1f, 1f), 1f);
    PolygonShape aside = Make.boxShape(1f, 1f);
    aside.setAsBox(1f, 1f, new Vec2(2f, 0f), 0f);
    body.createFixture(aside, 1f);
    draw(DebugDraw.e_centerOfMassBit);
    near(6f, 5f, drawn.only("transform").points[0]);
  }

  @Test
  void treeHasABoxForEachNode() {
    for (int i = 0; i < 4; i++) {
      Make.disc(world, 10f * i, 0f, 1f);
    }
    draw(DebugDraw.e_dynamicTreeBit);
    long boxes = drawn.calls.stream().filter(c -> c.kind.equals("polygon")).count();
    assertEquals(7, boxes);
  }

  /** A world without a drawer is asked to draw by programs that set one only for debugging. */
  @Test
  void worldWithoutADrawerDrawsNothing() {
    Make.disc(world, 0f, 0f, 1f);
    world.drawDebugData();
    assertEquals(0, drawn.frames);
  }

  private void draw(int flags) {
    drawn.calls.clear();
    drawn.setFlags(flags);
    world.setDebugDraw(drawn);
    world.drawDebugData();
  }

  private Color3f colour() {
    draw(DebugDraw.e_shapeBit);
    return drawn.only("solidPolygon").color;
  }

  private static AABB boundsOf(Vec2[] points) {
    AABB bounds = new AABB(points[0], points[0]);
    for (Vec2 point : points) {
      bounds.combine(new AABB(point, point));
    }
    return bounds;
  }

  private static void near(float x, float y, Vec2 point) {
    assertEquals(x, point.x, ROUNDING);
    assertEquals(y, point.y, ROUNDING);
  }

  private record Call(String kind, Vec2[] points, float radius, Color3f color) {}

  /** Keeps copies of what it is told to draw. */
  private static final class Recorder extends DebugDraw {
    final List<Call> calls = new ArrayList<>();
    int frames;

    List<String> kinds() {
      return calls.stream().map(Call::kind).sorted().collect(Collectors.toList());
    }

    Call only(String kind) {
      List<Call> found =
          calls.stream().filter(c -> c.kind.equals(kind)).collect(Collectors.toList());
      assertEquals(1, found.size(), kind);
      return found.get(0);
    }

    boolean hasSegment(float x1, float y1, float x2, float y2) {
      Vec2 p = new Vec2(x1, y1);
      Vec2 q = new Vec2(x2, y2);
      for (Call call : calls) {
        if (call.kind.equals("segment")
            && (close(p, call.points[0]) && close(q, call.points[1])
                || close(q, call.points[0]) && close(p, call.points[1]))) {
          return true;
        }
      }
      return false;
    }

    private static boolean close(Vec2 p, Vec2 q) {
      return MathUtils.distance(p, q) < ROUNDING;
    }

    private void add(String kind, float radius, Color3f color, Vec2... points) {
      Vec2[] copies = new Vec2[points.length];
      for (int i = 0; i < points.length; i++) {
        copies[i] = points[i].clone();
      }
      calls.add(new Call(kind, copies, radius, color));
    }

    @Override
    public void drawPolygon(Vec2[] vertices, int vertexCount, Color3f color) {
      add("polygon", 0f, color, Arrays.copyOf(vertices, vertexCount));
    }

    @Override
    public void drawPoint(Vec2 point, float radius, Color3f color) {
      add("point", radius, color, point);
    }

    @Override
    public void drawSolidPolygon(Vec2[] vertices, int vertexCount, Color3f color) {
      add("solidPolygon", 0f, color, Arrays.copyOf(vertices, vertexCount));
    }

    @Override
    public void drawCircle(Vec2 center, float radius, Color3f color) {
      add("circle", radius, color, center);
    }

    @Override
    public void drawCircle(Vec2 center, float radius, Vec2 axis, Color3f color) {
      add("circle", radius, color, center, axis);
    }

    @Override
    public void drawSolidCircle(Vec2 center, float radius, Vec2 axis, Color3f color) {
      add("solidCircle", radius, color, center, axis);
    }

    @Override
    public void drawSegment(Vec2 p1, Vec2 p2, Color3f color) {
      add("segment", 0f, color, p1, p2);
    }

    @Override
    public void drawTransform(Transform xf) {
      add("transform", 0f, null, xf.p);
    }

    @Override
    public void drawString(float x, float y, String s, Color3f color) {
      add("string", 0f, color, new Vec2(x, y));
    }

    @Override
    public void flush() {
      frames++;
    }
  }
}
