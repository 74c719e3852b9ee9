package glass;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.GraphicsEnvironment;
import java.awt.RenderingHints;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.Fixture;

/** Shows the game; a click throws a ball from the left to where the mouse is. */
public final class GlassWindow extends JPanel {
  private static final double PIXELS_A_METRE = 25;

  private final transient GlassGame game = new GlassGame();
  private long lastFrame = System.nanoTime();

  private GlassWindow() {
    setPreferredSize(new Dimension(1000, 500));
    addMouseListener(
        new MouseAdapter() {
          @Override
          public void mousePressed(MouseEvent e) {
            Vec2 from = new Vec2(-15, 4);
            Vec2 at = new Vec2((float) worldX(e.getX()), (float) worldY(e.getY()));
            Vec2 velocity = at.sub(from);
            velocity.normalize();
            game.throwBall(from, velocity.mul(50));
          }
        });
    new Timer(16, e -> frame()).start();
  }

  private void frame() {
    long now = System.nanoTime();
    game.advance((now - lastFrame) * 1e-9f);
    lastFrame = now;
    repaint();
  }

  private double worldX(double pixel) {
    return (pixel - 400) / PIXELS_A_METRE;
  }

  private double worldY(double pixel) {
    return (450 - pixel) / PIXELS_A_METRE;
  }

  @Override
  protected void paintComponent(Graphics graphics) {
    super.paintComponent(graphics);
    Graphics2D g = (Graphics2D) graphics;
    g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    g.setColor(Color.BLACK);
    g.drawString(game.score() + " pieces; click to throw", 10, 20);
    g.translate(400, 450);
    g.scale(PIXELS_A_METRE, -PIXELS_A_METRE);
    for (Body body = game.world().getBodyList(); body != null; body = body.getNext()) {
      for (Fixture f = body.getFixtureList(); f != null; f = f.getNext()) {
        g.setColor(f.getMaterial() == null ? Color.GRAY : new Color(70, 150, 200));
        paint(g, body, f);
      }
    }
  }

  private static void paint(Graphics2D g, Body body, Fixture fixture) {
    if (fixture.getShape() instanceof CircleShape circle) {
      Vec2 c = body.getWorldPoint(circle.m_p);
      double r = circle.getRadius();
      g.fill(new Ellipse2D.Double(c.x - r, c.y - r, 2 * r, 2 * r));
    } else if (fixture.getShape() instanceof PolygonShape polygon) {
      Path2D path = new Path2D.Double();
      for (int i = 0; i < polygon.getVertexCount(); i++) {
        Vec2 p = body.getWorldPoint(polygon.getVertex(i));
        if (i == 0) {
          path.moveTo(p.x, p.y);
        } else {
          path.lineTo(p.x, p.y);
        }
      }
      g.fill(path);
    }
  }

  public static void main(String[] args) {
    if (GraphicsEnvironment.isHeadless()) {
      GlassGame game = new GlassGame();
      game.throwBall(new Vec2(-15, 4), new Vec2(50, 0));
      for (int frame = 0; frame < 300; frame++) {
        game.advance(1f / 60);
      }
      System.out.println("No display. Five seconds on: " + game.score() + " pieces.");
      return;
    }
    SwingUtilities.invokeLater(
        () -> {
          JFrame window = new JFrame("Breaking glass");
          window.setDefaultCloseOperation(JFrame.EXIT_ON_CLOSE);
          window.add(new GlassWindow());
          window.pack();
          window.setVisible(true);
        });
  }
}
