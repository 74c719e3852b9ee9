package org.jbox2d.fracture.impact;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jbox2d.dynamics.Body;
import org.jbox2d.fracture.Material;

/**
 * The strikes of a step, and what they call for.
 *
 * <p>A blow on a polygon of several convex parts may touch more than one of them: strikes on what
 * breaks as one, by the same body, are one blow, and their intensities add up. What is hit hardest
 * on a body breaks, at most one thing a body a step, at all places where it was struck hard enough.
 */
public final class RequestBook {
  /**
   * Strikes weaker than this share of the rigidity, or of the toughness, are not kept: no sum of a
   * few of them would break or damage anything.
   */
  private static final float LEAST_SHARE = 0.05f;

  /**
   * In the order in which bodies were first struck; looked up by identity, walked in insertion
   * order.
   */
  private final Map<Body, List<Strike>> strikes = new LinkedHashMap<>();

  /** Whether a blow of this intensity is worth keeping: it may break something, or damage it. */
  public static boolean matters(float intensity, Material material, boolean partOfCompound) {
    float least = Damage.threshold(material);
    return intensity > (partOfCompound ? LEAST_SHARE * least : least);
  }

  /** Whether there is nothing in the book. */
  public boolean isEmpty() {
    return strikes.isEmpty();
  }

  /** Enters a strike. */
  public void add(Strike strike) {
    Body body = strike.fixture.getBody();
    List<Strike> onBody = strikes.get(body);
    if (onBody == null) {
      onBody = new ArrayList<>();
      strikes.put(body, onBody);
    }
    onBody.add(strike);
  }

  /**
   * Returns what the strikes call for, in the order in which the bodies were first struck, and
   * empties the book.
   *
   * @param worn receives the blows that only did damage
   */
  public List<Request> take(List<Wear> worn) {
    List<Request> requests = new ArrayList<>();
    for (Map.Entry<Body, List<Strike>> entry : strikes.entrySet()) {
      Request request = requestOf(entry.getKey(), entry.getValue(), worn);
      if (request != null) {
        requests.add(request);
      }
    }
    strikes.clear();
    return requests;
  }

  /**
   * Returns the request of a single strike, or {@code null} if it is too weak.
   *
   * @param worn receives the strike if it only did damage
   */
  public static Request requestOf(Strike strike, List<Wear> worn) {
    return requestOf(strike.fixture.getBody(), Collections.singletonList(strike), worn);
  }

  /** Returns the request of a single strike, however weak. */
  public static Request commanded(Strike strike) {
    return new Request(strike, strike.intensity, Collections.singletonList(strike));
  }

  private static Request requestOf(Body body, List<Strike> struck, List<Wear> worn) {
    if (body.m_world == null) {
      return null;
    }
    List<Blows> groups = group(body, struck);
    Blows hardest = null;
    for (Blows group : groups) {
      if (group.exceedsRigidity() && (hardest == null || group.intensity > hardest.intensity)) {
        hardest = group;
      }
    }
    for (Blows group : groups) {
      if (!group.exceedsRigidity() && (hardest == null || !group.hitSame(hardest))) {
        group.wear(worn);
      }
    }
    if (hardest == null) {
      return null;
    }
    List<Strike> all = new ArrayList<>();
    for (Blows group : groups) {
      if (group.exceedsRigidity() && group.hitSame(hardest)) {
        group.addTo(all);
      }
    }
    Strike first = hardest.strongest;
    all.remove(first);
    all.add(0, first);
    return new Request(first, hardest.intensity, all);
  }

  private static List<Blows> group(Body body, List<Strike> struck) {
    List<Blows> groups = new ArrayList<>();
    for (Strike strike : struck) {
      if (!strike.isLive(body)) {
        continue;
      }
      Blows home = null;
      for (Blows group : groups) {
        if (group.takes(strike)) {
          home = group;
        }
      }
      if (home == null) {
        groups.add(new Blows(strike));
      } else {
        home.add(strike);
      }
    }
    return groups;
  }

  /** The strikes of one body on what breaks as one. */
  private static final class Blows {
    private final List<Strike> members = new ArrayList<>();
    private Strike strongest;
    private float intensity;

    Blows(Strike first) {
      strongest = first;
      add(first);
    }

    boolean takes(Strike strike) {
      Strike first = members.get(0);
      return first.striker() == strike.striker() && first.breakable() == strike.breakable();
    }

    boolean hitSame(Blows other) {
      return members.get(0).breakable() == other.members.get(0).breakable();
    }

    void add(Strike strike) {
      members.add(strike);
      intensity += strike.intensity;
      if (strike.intensity > strongest.intensity) {
        strongest = strike;
      }
    }

    private float rigidity() {
      return Damage.rigidityLeft(strongest.fixture, strongest.material);
    }

    boolean exceedsRigidity() {
      return intensity > rigidity();
    }

    void addTo(List<Strike> out) {
      for (Strike strike : members) {
        strike.share = Math.min(1f, rigidity() / intensity);
        out.add(strike);
      }
    }

    void wear(List<Wear> worn) {
      if (intensity > strongest.material.m_toughness) {
        worn.add(new Wear(strongest, intensity));
      }
    }
  }
}
