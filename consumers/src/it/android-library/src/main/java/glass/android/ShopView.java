package glass.android;

import android.content.Context;
import android.graphics.Canvas;
import android.graphics.Color;
import android.graphics.Paint;
import android.graphics.Path;
import android.os.VibrationEffect;
import android.os.Vibrator;
import android.view.MotionEvent;
import android.view.View;
import java.util.List;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.collision.shapes.ShapeType;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.fracture.FractureListener;
import org.jbox2d.fracture.Material;

/** Shows the shop; a touch throws a ball at that height, and the phone shakes when glass breaks. */
public final class ShopView extends View implements FractureListener {
  private static final float PIXELS_A_METRE = 60;

  private final Shop shop = new Shop(this);
  private final Vibrator vibrator;
  private final Paint paint = new Paint();
  private final Path path = new Path();
  private final Vec2 point = new Vec2();
  private long lastFrame;

  public ShopView(Context context) {
    super(context);
    vibrator = context.getSystemService(Vibrator.class);
  }

  @Override
  public void action(Material material, float intensity, List<Body> fragments) {
    vibrator.vibrate(VibrationEffect.createOneShot(30, VibrationEffect.DEFAULT_AMPLITUDE));
  }

  @Override
  public boolean onTouchEvent(MotionEvent event) {
    if (event.getAction() == MotionEvent.ACTION_DOWN) {
      shop.throwBall(-8, (getHeight() - event.getY()) / PIXELS_A_METRE);
    }
    return true;
  }

  @Override
  protected void onDraw(Canvas canvas) {
    long now = System.nanoTime();
    shop.advance(lastFrame == 0 ? 0 : (now - lastFrame) * 1e-9f);
    lastFrame = now;
    canvas.drawColor(Color.WHITE);
    canvas.translate(0.5f * getWidth(), getHeight());
    canvas.scale(PIXELS_A_METRE, -PIXELS_A_METRE);
    for (Body body = shop.world.getBodyList(); body != null; body = body.getNext()) {
      for (Fixture f = body.getFixtureList(); f != null; f = f.getNext()) {
        paint.setColor(f.getMaterial() == null ? Color.GRAY : Color.BLUE);
        draw(canvas, body, f);
      }
    }
    postInvalidateOnAnimation();
  }

  private void draw(Canvas canvas, Body body, Fixture fixture) {
    if (fixture.getType() == ShapeType.CIRCLE) {
      CircleShape circle = (CircleShape) fixture.getShape();
      body.getWorldPointToOut(circle.m_p, point);
      canvas.drawCircle(point.x, point.y, circle.getRadius(), paint);
    } else if (fixture.getType() == ShapeType.POLYGON) {
      PolygonShape polygon = (PolygonShape) fixture.getShape();
      path.rewind();
      for (int i = 0; i < polygon.getVertexCount(); i++) {
        body.getWorldPointToOut(polygon.getVertex(i), point);
        if (i == 0) {
          path.moveTo(point.x, point.y);
        } else {
          path.lineTo(point.x, point.y);
        }
      }
      path.close();
      canvas.drawPath(path, paint);
    }
  }
}
