package org.jbox2d.testbed.paint;

import org.jbox2d.testbed.scenes.Scene.Framing;

/**
 * How the world is mapped to a picture: the world point in the middle, and the scale. World y is
 * up, picture y is down. Immutable.
 *
 * @param centreX world coordinate in the middle of the picture, m
 * @param centreY see {@code centreX}
 * @param scale pixels per metre
 * @param width of the picture, pixels
 * @param height see {@code width}
 */
public record View(double centreX, double centreY, double scale, int width, int height) {
  /** Smallest and largest scale that the wheel reaches, pixels per metre. */
  private static final double MIN_SCALE = 0.5;

  private static final double MAX_SCALE = 2000;

  /** The view that shows all of a framing, in the middle of the picture. */
  public static View of(Framing framing, int width, int height) {
    double scale = Math.min(width / framing.width(), height / framing.height());
    return new View(framing.centreX(), framing.centreY(), scale, width, height);
  }

  /** Returns the picture's coordinate of a world coordinate. */
  public double toPictureX(double x) {
    return 0.5 * width + (x - centreX) * scale;
  }

  /** Returns the picture's coordinate of a world coordinate. */
  public double toPictureY(double y) {
    return 0.5 * height - (y - centreY) * scale;
  }

  /** Returns the world coordinate of a picture's coordinate. */
  public double toWorldX(double pictureX) {
    return centreX + (pictureX - 0.5 * width) / scale;
  }

  /** Returns the world coordinate of a picture's coordinate. */
  public double toWorldY(double pictureY) {
    return centreY - (pictureY - 0.5 * height) / scale;
  }

  /** Returns the view moved so that what was at a picture's point is the given vector from it. */
  public View dragged(double pixelsX, double pixelsY) {
    return new View(centreX - pixelsX / scale, centreY + pixelsY / scale, scale, width, height);
  }

  /** Returns the view enlarged by a factor; what is at the given point of the picture stays. */
  public View zoomed(double factor, double pictureX, double pictureY) {
    double next = Math.max(MIN_SCALE, Math.min(MAX_SCALE, scale * factor));
    double x = toWorldX(pictureX) - (pictureX - 0.5 * width) / next;
    double y = toWorldY(pictureY) + (pictureY - 0.5 * height) / next;
    return new View(x, y, next, width, height);
  }

  /** Returns the view for a picture of another size, with the same extent in height. */
  public View resized(int newWidth, int newHeight) {
    double factor = height > 0 ? (double) newHeight / height : 1;
    return new View(centreX, centreY, scale * factor, newWidth, newHeight);
  }

  /** Returns the view of the same part of the world in a picture of another width. */
  public View scaledTo(int newWidth) {
    double factor = (double) newWidth / width;
    int newHeight = (int) Math.round(height * factor);
    return new View(centreX, centreY, scale * factor, newWidth, newHeight);
  }
}
