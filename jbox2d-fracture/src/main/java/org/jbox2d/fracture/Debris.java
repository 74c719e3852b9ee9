package org.jbox2d.fracture;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.jbox2d.callbacks.StepListener;
import org.jbox2d.collision.shapes.MassData;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.dynamics.World;

/**
 * The pieces that have come off bodies of a world, while one of their two limits is set: how many
 * there may be, and how long they may sleep. What a limit takes goes at the end of the step.
 */
final class Debris implements StepListener {
  private final FractureSystem system;
  private final World world;

  /** In the order of their birth. */
  private final List<Item> items = new ArrayList<>();

  private int budget = Integer.MAX_VALUE;
  private float lifetime = Float.POSITIVE_INFINITY;
  private boolean listening;
  private int removed;

  Debris(FractureSystem system, World world) {
    this.system = system;
    this.world = world;
  }

  private static final class Item {
    private final Body body;
    private final double area;

    /** How long it has slept without a break, s. */
    private double asleep;

    private Item(Body body) {
      this.body = body;
      area = areaOf(body);
    }

    private static double areaOf(Body body) {
      MassData data = new MassData();
      double area = 0;
      for (Fixture f = body.getFixtureList(); f != null; f = f.getNext()) {
        f.getShape().computeMass(data, 1f);
        area += data.mass;
      }
      return area;
    }
  }

  // --- Limits ---

  void setBudget(int pieces) {
    budget = pieces;
    listen();
  }

  int budget() {
    return budget;
  }

  void setLifetime(float seconds) {
    lifetime = seconds;
    listen();
  }

  float lifetime() {
    return lifetime;
  }

  /** Number of pieces that were removed. */
  int removed() {
    return removed;
  }

  /** Hears of steps only while there is something to do. */
  private void listen() {
    boolean needed = budget < Integer.MAX_VALUE || lifetime < Float.POSITIVE_INFINITY;
    if (needed && !listening) {
      world.addStepListener(this);
    } else if (!needed && listening) {
      world.removeStepListener(this);
      items.clear();
    }
    listening = needed;
  }

  // --- Births and deaths ---

  /** Takes in what has come off a body: all that is loose, but for the body itself. */
  void add(Body broken, List<Body> pieces) {
    if (!listening) {
      return;
    }
    for (Body body : pieces) {
      if (body != broken && body.getType() == BodyType.DYNAMIC) {
        items.add(new Item(body));
      }
    }
  }

  @Override
  public void stepped(World stepped, float dt) {
    items.removeIf(item -> item.body.getWorld() != world);
    if (lifetime < Float.POSITIVE_INFINITY) {
      age(dt);
    }
    while (items.size() > budget) {
      removeOld(items.size() - budget);
    }
  }

  private void age(float dt) {
    List<Item> expired = new ArrayList<>();
    for (Item item : items) {
      item.asleep = item.body.isAwake() ? 0 : item.asleep + dt;
      if (item.asleep > lifetime) {
        expired.add(item);
      }
    }
    for (Item item : expired) {
      remove(item, FractureLimit.DEBRIS_LIFETIME);
    }
  }

  /**
   * Removes pieces of the older half, the smallest first and of equals the oldest: so large pieces
   * outlast many a generation of dust, but not all.
   */
  private void removeOld(int count) {
    List<Item> old = new ArrayList<>(items.subList(0, (items.size() + 1) / 2));
    old.sort(Comparator.comparingDouble(item -> item.area));
    for (Item item : old.subList(0, Math.min(count, old.size()))) {
      remove(item, FractureLimit.DEBRIS_BUDGET);
    }
  }

  /** What the listener wants to keep is no debris any more. */
  private void remove(Item item, FractureLimit limit) {
    items.remove(item);
    if (item.body.getWorld() != world) {
      return;
    }
    FractureListener listener = system.getListener();
    if (listener != null && !listener.discard(item.body, limit)) {
      return;
    }
    // The listener may have destroyed it itself.
    if (item.body.getWorld() == world) {
      world.destroyBody(item.body);
    }
    removed++;
  }
}
