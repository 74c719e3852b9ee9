package org.jbox2d.fracture.assembly;

import java.util.Collections;
import java.util.List;
import org.jbox2d.dynamics.CompoundShape;
import org.jbox2d.fracture.FractureLimit;
import org.jbox2d.fracture.fragmentation.ImpactRegion;
import org.jbox2d.fracture.impact.Request;

/** What a fracture will do, worked out before anything is changed. */
public final class Plan {
  /** What becomes of the request. */
  public enum Outcome {
    /** There are splinters. */
    BREAKS,
    /** A static body too small to break comes loose instead. */
    COMES_LOOSE,
    /** Nothing breaks away, or the body is too small or has no area: the blow was a blow. */
    HOLDS,
    /** Something went wrong; the body stays whole. */
    FAILS
  }

  public final Request request;
  public final Outcome outcome;

  /** Why it failed; empty otherwise. */
  public final String reason;

  /** Sites of the cells it breaks along, interleaved, in the body's frame; none for a cut. */
  public final double[] sites;

  /** Where it breaks, one region for each blow; none for a cut. */
  public final List<ImpactRegion> regions;

  /** What kept it from breaking, or made its pieces fewer; {@code null} for nothing. */
  public final FractureLimit limit;

  final Breakable breakable;
  final List<Piece> remainders;
  final List<Piece> splinters;

  private Plan(
      Request request,
      Outcome outcome,
      String reason,
      Breakable breakable,
      List<Piece> remainders,
      List<Piece> splinters,
      double[] sites,
      List<ImpactRegion> regions,
      FractureLimit limit) {
    this.request = request;
    this.outcome = outcome;
    this.reason = reason;
    this.breakable = breakable;
    this.remainders = remainders;
    this.splinters = splinters;
    this.sites = sites;
    this.regions = regions;
    this.limit = limit;
  }

  static Plan without(Request request, Outcome outcome) {
    return empty(request, outcome, "", null);
  }

  static Plan limited(Request request, FractureLimit limit) {
    return empty(request, Outcome.HOLDS, "", limit);
  }

  static Plan failed(Request request, String reason) {
    return empty(request, Outcome.FAILS, reason, null);
  }

  private static Plan empty(Request request, Outcome outcome, String reason, FractureLimit limit) {
    List<Piece> none = Collections.emptyList();
    return new Plan(
        request, outcome, reason, null, none, none, new double[0], Collections.emptyList(), limit);
  }

  static Plan breaks(
      Request request, Breakable breakable, List<Piece> remainders, List<Piece> splinters) {
    return new Plan(
        request,
        Outcome.BREAKS,
        "",
        breakable,
        remainders,
        splinters,
        new double[0],
        Collections.emptyList(),
        null);
  }

  /** This plan with what its pieces were made by, and what made them fewer. */
  Plan madeBy(double[] usedSites, List<ImpactRegion> usedRegions, FractureLimit usedLimit) {
    return new Plan(
        request,
        outcome,
        reason,
        breakable,
        remainders,
        splinters,
        usedSites,
        usedRegions,
        usedLimit);
  }

  /** Returns how many splinters there are; their bodies come last in the list of bodies made. */
  public int splinterCount() {
    return splinters.size();
  }

  /** Whether a compound is one of the pieces of this plan. */
  public boolean made(CompoundShape compound) {
    for (Piece piece : remainders) {
      if (piece == compound) {
        return true;
      }
    }
    for (Piece piece : splinters) {
      if (piece == compound) {
        return true;
      }
    }
    return false;
  }

  /** Whether the blow's rest is given back: it broke something, or tore it loose. */
  public boolean yields() {
    return outcome == Outcome.BREAKS || outcome == Outcome.COMES_LOOSE;
  }
}
