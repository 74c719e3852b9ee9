package org.jbox2d.upstream;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.lang.reflect.Constructor;
import java.util.Map;
import java.util.TreeMap;
import org.jbox2d.callbacks.DebugDraw;
import org.jbox2d.common.Color3f;
import org.jbox2d.common.OBBViewportTransform;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.dynamics.World;
import org.jbox2d.serialization.SerializationResult;
import org.jbox2d.serialization.pb.PbDeserializer;
import org.jbox2d.serialization.pb.PbSerializer;
import org.jbox2d.testbed.framework.TestbedModel;
import org.jbox2d.testbed.framework.TestbedSetting;
import org.jbox2d.testbed.framework.TestbedTest;

/** Runs one test program of JBox2D without a display. Loaded once for each {@link Engine}. */
final class TestbedRun {
  private static final String KEYS = "asdwqebrncml,.0123456789 ";

  private TestbedRun() {}

  /**
   * Runs a test.
   *
   * @param input whether keys are pressed, the mouse is dragged, and everything is drawn
   * @return bodies, joints, fixtures, awake (bodies that are not static), and x, y (mean position);
   *     without input also the same after saving and loading, with the prefix "loaded "
   */
  static Map<String, Double> run(String testClass, int steps, boolean input)
      throws ReflectiveOperationException, IOException {
    TestbedModel model = new TestbedModel();
    CountingDraw draw = new CountingDraw();
    model.setDebugDraw(draw);
    TestbedTest test = make(testClass);
    if (input) {
      drawEverything(model);
    }
    model.setRunningTest(test);
    test.setDialogOnSaveLoadErrors(false);
    test.init(model);
    for (int i = 0; i < steps; i++) {
      if (input) {
        play(test, i);
      }
      test.update();
      checkFinite(test.getWorld(), i);
    }
    Map<String, Double> result = new TreeMap<>();
    count(test.getWorld(), result, "");
    result.put("drawn", (double) draw.calls);
    if (!input) {
      count(saveAndLoad(test.getWorld()), result, "loaded ");
    }
    return result;
  }

  /** Some tests have a switch. */
  private static TestbedTest make(String testClass) throws ReflectiveOperationException {
    Constructor<?> constructor = Class.forName(testClass).getConstructors()[0];
    boolean plain = constructor.getParameterCount() == 0;
    return (TestbedTest) (plain ? constructor.newInstance() : constructor.newInstance(true));
  }

  private static void drawEverything(TestbedModel model) {
    for (TestbedSetting setting : model.getSettings().getSettings()) {
      if (setting.name.startsWith("Draw")) {
        setting.enabled = true;
      }
    }
  }

  /** Presses each key of the tests in turn, drags what is in the middle, throws a bomb. */
  private static void play(TestbedTest test, int i) {
    char key = KEYS.charAt((i / 20) % KEYS.length());
    if (i % 20 == 10) {
      test.queueKeyPressed(key, Character.toUpperCase(key));
    } else if (i % 20 == 14) {
      test.queueKeyReleased(key, Character.toUpperCase(key));
    }
    int beat = i % 100;
    Vec2 point = new Vec2(0f, 1f + 0.05f * beat);
    if (beat == 20) {
      test.queueMouseDown(point);
    } else if (beat > 20 && beat < 60) {
      test.queueMouseMove(point);
    } else if (beat == 60) {
      test.queueMouseUp(point);
    }
    if (i == 400) {
      test.queueShiftMouseDown(new Vec2(-10f, 20f));
      test.queueMouseMove(new Vec2(-12f, 22f));
      test.queueMouseUp(new Vec2(-12f, 22f));
    }
  }

  private static void checkFinite(World world, int step) {
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      Vec2 p = b.getPosition();
      Vec2 v = b.getLinearVelocity();
      if (!Float.isFinite(p.x + p.y + b.getAngle() + v.x + v.y + b.getAngularVelocity())) {
        throw new AssertionError("not finite in step " + step + ": " + p + ", " + v);
      }
    }
  }

  private static World saveAndLoad(World world) throws IOException {
    SerializationResult saved = new PbSerializer().serialize(world);
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    saved.writeTo(out);
    World loaded =
        new PbDeserializer().deserializeWorld(new ByteArrayInputStream(out.toByteArray()));
    for (int i = 0; i < 10; i++) {
      loaded.step(1f / 60f, 8, 3);
      checkFinite(loaded, i);
    }
    return loaded;
  }

  private static void count(World world, Map<String, Double> result, String prefix) {
    int fixtures = 0;
    int awake = 0;
    double x = 0;
    double y = 0;
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      for (Fixture f = b.getFixtureList(); f != null; f = f.getNext()) {
        fixtures++;
      }
      awake += b.isAwake() && b.getType() != BodyType.STATIC ? 1 : 0;
      x += b.getPosition().x / world.getBodyCount();
      y += b.getPosition().y / world.getBodyCount();
    }
    result.put(prefix + "bodies", (double) world.getBodyCount());
    result.put(prefix + "joints", (double) world.getJointCount());
    result.put(prefix + "fixtures", (double) fixtures);
    result.put(prefix + "awake", (double) awake);
    result.put(prefix + "x", x);
    result.put(prefix + "y", y);
  }

  private static final class CountingDraw extends DebugDraw {
    int calls;

    CountingDraw() {
      super(new OBBViewportTransform());
      viewportTransform.setExtents(300, 300);
    }

    @Override
    public void drawPoint(Vec2 center, float radiusOnScreen, Color3f color) {
      calls++;
    }

    @Override
    public void drawSolidPolygon(Vec2[] vertices, int vertexCount, Color3f color) {
      calls++;
    }

    @Override
    public void drawCircle(Vec2 center, float radius, Color3f color) {
      calls++;
    }

    @Override
    public void drawSolidCircle(Vec2 center, float radius, Vec2 axis, Color3f color) {
      calls++;
    }

    @Override
    public void drawSegment(Vec2 p1, Vec2 p2, Color3f color) {
      calls++;
    }

    @Override
    public void drawTransform(Transform xf) {
      calls++;
    }

    @Override
    public void drawString(float x, float y, String text, Color3f color) {
      calls++;
    }
  }
}
