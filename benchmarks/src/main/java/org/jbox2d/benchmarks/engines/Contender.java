package org.jbox2d.benchmarks.engines;

import java.lang.reflect.Constructor;
import java.util.List;
import org.jbox2d.dynamics.Solver;

/** The solvers that are compared. */
public enum Contender {
  /** This project's sequential impulses. */
  SEQUENTIAL("sequential", true) {
    @Override
    public Sim open(Setting s) {
      return new OurSim(s.velocityIterations(), s.positionIterations());
    }
  },
  /** This project's soft step. */
  SOFT("soft", true) {
    @Override
    public Sim open(Setting s) {
      return new OurSim(Solver.softStep(s.substeps()));
    }

    @Override
    public String describe(Setting s) {
      return s.substeps() + " substeps";
    }
  },
  /** This project's adaptive solver. */
  ADAPTIVE("adaptive", true) {
    @Override
    public Sim open(Setting s) {
      return new OurSim(Solver.adaptive(s.leastSubsteps(), s.mostSubsteps()));
    }

    @Override
    public String describe(Setting s) {
      return s.leastSubsteps() + " to " + s.mostSubsteps();
    }
  },
  /** JBox2D 2.2.1.1 as released. */
  JBOX2D("jbox2d-2.2.1.1", false) {
    @Override
    public Sim open(Setting s) {
      try {
        return Original.MAKER.newInstance(s.velocityIterations(), s.positionIterations());
      } catch (ReflectiveOperationException e) {
        throw new IllegalStateException("the original engine does not start", e);
      }
    }
  },
  /** dyn4j 6. */
  DYN4J("dyn4j-6.0.0", false) {
    @Override
    public Sim open(Setting s) {
      return new Dyn4jSim(s.velocityIterations(), s.positionIterations());
    }
  },
  /** Box2D in C++ behind JNI. */
  GDX("gdx-box2d-1.14.2", false) {
    @Override
    public Sim open(Setting s) {
      return new GdxSim(s.velocityIterations(), s.positionIterations());
    }
  };

  /** Name, as in results. */
  public final String label;

  /** Whether it is of this project. */
  public final boolean ours;

  Contender(String label, boolean ours) {
    this.label = label;
    this.ours = ours;
  }

  /** Opens an empty world. */
  public abstract Sim open(Setting setting);

  /** What the setting is called with this solver. */
  public String describe(Setting s) {
    return s.velocityIterations() + "/" + s.positionIterations();
  }

  /** Whether a setting is one of this solver's. */
  public boolean has(Setting setting) {
    return true;
  }

  /** The contenders of some labels, or all if there are none. */
  public static List<Contender> chosen(List<String> labels) {
    return labels.isEmpty() ? List.of(values()) : labels.stream().map(Contender::of).toList();
  }

  /**
   * The contender of a label.
   *
   * @throws IllegalArgumentException if there is none
   */
  public static Contender of(String label) {
    for (Contender contender : values()) {
      if (contender.label.equals(label)) {
        return contender;
      }
    }
    throw new IllegalArgumentException("no solver is called " + label);
  }

  /** The original engine, loaded when it is first asked for. */
  private static final class Original {
    static final Constructor<? extends Sim> MAKER = maker();

    private static Constructor<? extends Sim> maker() {
      ClassLoader loader = new OriginalLoader(Contender.class.getClassLoader());
      String name = "org.jbox2d.benchmarks.engines.box2d.Box2dSim";
      try {
        return Class.forName(name, true, loader)
            .asSubclass(Sim.class)
            .getDeclaredConstructor(int.class, int.class);
      } catch (ReflectiveOperationException e) {
        throw new IllegalStateException("the original engine does not load", e);
      }
    }
  }
}
