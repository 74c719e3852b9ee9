package org.jbox2d.fracture;

import java.util.ArrayList;
import java.util.List;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.World;
import org.jbox2d.fracture.assembly.PartShapes;
import org.jbox2d.fracture.assembly.Plan;
import org.jbox2d.fracture.impact.Blow;
import org.jbox2d.fracture.impact.Strike;

/**
 * The bodies of the blows of a step that broke something. From the blow to the end of the step they
 * have moved as if nothing would break: the projectile was held up. What broke is known only then,
 * and what the projectile and the pieces do to each other only in the next step, in which they make
 * up for the way lost: {@link World#letCatchUp}. So a bullet goes on as fast as its velocity says
 * through however many panes, and yet collides with the pieces of each.
 */
final class HeldUp {
  private final World world;
  private final List<Member> members = new ArrayList<>();

  /** A body, and its motion since its last blow; made before anything is given back. */
  private static final class Member {
    private final Body body;
    private float time;

    /** One of those that have struck each other, the same for all of them. */
    private Member group = this;

    /** Whether one of those is not moved by it. */
    private boolean open;

    private final Vec2 center;
    private final Vec2 velocity;
    private final float angularVelocity;

    /** What has become of it if it broke; {@code null} if it did not. */
    private List<Body> pieces;

    Member(Body body) {
      this.body = body;
      open = body.getType() != BodyType.DYNAMIC;
      time = Float.POSITIVE_INFINITY;
      center = body.getWorldCenter().clone();
      velocity = body.getLinearVelocity().clone();
      angularVelocity = body.getAngularVelocity();
    }
  }

  HeldUp(World world, List<Plan> plans) {
    this.world = world;
    for (Plan plan : plans) {
      if (plan.yields()) {
        for (Strike strike : plan.request.strikes) {
          if (strike.blow != null) {
            add(strike.blow);
          }
        }
      }
    }
  }

  private void add(Blow blow) {
    Member a = memberOf(blow.bodyA);
    Member b = memberOf(blow.bodyB);
    // A projectile that is itself late has been at it for longer than the step; the pieces that it
    // pushes must come along.
    float time =
        Math.max(world.timeSince(blow.bodyA, blow.alpha), world.timeSince(blow.bodyB, blow.alpha));
    a.time = Math.min(a.time, time);
    b.time = Math.min(b.time, time);
    join(a, b);
  }

  /** Makes one group of those of two members. */
  private void join(Member a, Member b) {
    Member from = b.group;
    boolean open = a.open || b.open;
    for (Member member : members) {
      if (member.group == from) {
        member.group = a.group;
      }
      if (member.group == a.group) {
        member.open = open;
      }
    }
  }

  private Member memberOf(Body body) {
    for (Member member : members) {
      if (member.body == body) {
        return member;
      }
    }
    Member member = new Member(body);
    members.add(member);
    return member;
  }

  /** A body has broken, or come loose. */
  void hasBroken(Body body, List<Body> pieces) {
    for (Member member : members) {
      if (member.body == body && !pieces.isEmpty()) {
        member.pieces = pieces;
      }
    }
  }

  /** Tells the world who is late, and by how much: since the last of its blows. */
  void letCatchUp() {
    for (Member member : members) {
      if (member.pieces == null) {
        letCatchUp(member.body, member);
        continue;
      }
      for (Body piece : member.pieces) {
        letCatchUp(piece, member);
      }
    }
  }

  private void letCatchUp(Body body, Member member) {
    if (body.getType() != BodyType.DYNAMIC || body.getWorld() != world) {
      return;
    }
    float w = member.angularVelocity;
    float x = body.getWorldCenter().x - member.center.x;
    float y = body.getWorldCenter().y - member.center.y;
    Vec2 before = new Vec2(member.velocity.x - w * y, member.velocity.y + w * x);
    if (member.pieces == null) {
      close(body, before, member.time);
    }
    world.letCatchUp(body, member.open ? null : member.group, member.time, before, w);
  }

  /**
   * Moves a projectile, along its way, up to the pieces: their skins are thinner than that of what
   * broke, so that it no longer touches them, and would meet them one after the other in the next
   * step, or if it is no bullet pass over them, rather than push all at once. It is not taken off
   * what is to be made up for: by about as much has the engine pushed it out of the thicker skin.
   */
  private static void close(Body body, Vec2 before, float most) {
    Vec2 v = body.getLinearVelocity();
    if (!(Vec2.dot(v, v) > Vec2.dot(v, before))) {
      return;
    }
    float thinner = Settings.polygonRadius - PartShapes.PIECE_SKIN_IN_SLOPS * Settings.linearSlop;
    float time = Math.min(most, thinner / v.length());
    Vec2 p = body.getPosition();
    body.setTransform(new Vec2(p.x + time * v.x, p.y + time * v.y), body.getAngle());
  }
}
