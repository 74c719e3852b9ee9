package org.jbox2d.testbed.export;

import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.FileImageOutputStream;

/**
 * Writes pictures of one size as an endless GIF animation. Each frame holds only the rectangle that
 * differs from the frame before.
 */
public final class GifAnimation implements Closeable {
  /** Name of the standard metadata of a GIF frame in ImageIO. */
  private static final String FRAME_FORMAT = "javax_imageio_gif_image_1.0";

  /** How long each frame is shown, 1/100 s; 25 frames per second. */
  private static final int CENTISECONDS = 4;

  /** How long each frame is shown, s. */
  public static final double FRAME_SECONDS = CENTISECONDS / 100.0;

  private final ImageWriter writer;
  private final FileImageOutputStream out;
  private BufferedImage last;

  /** Opens a file. */
  public GifAnimation(Path file) throws IOException {
    // A file that was there keeps its tail otherwise.
    Files.deleteIfExists(file);
    out = new FileImageOutputStream(file.toFile());
    writer = ImageIO.getImageWritersByFormatName("gif").next();
    writer.setOutput(out);
    writer.prepareWriteSequence(null);
  }

  /** Appends a frame. */
  public void add(BufferedImage frame) throws IOException {
    Rectangle part = last == null ? whole(frame) : difference(last, frame);
    BufferedImage cut = frame.getSubimage(part.x, part.y, part.width, part.height);
    IIOMetadata metadata =
        writer.getDefaultImageMetadata(
            ImageTypeSpecifier.createFromRenderedImage(cut), writer.getDefaultWriteParam());
    IIOMetadataNode root = (IIOMetadataNode) metadata.getAsTree(FRAME_FORMAT);
    IIOMetadataNode descriptor = child(root, "ImageDescriptor");
    descriptor.setAttribute("imageLeftPosition", Integer.toString(part.x));
    descriptor.setAttribute("imageTopPosition", Integer.toString(part.y));
    IIOMetadataNode control = child(root, "GraphicControlExtension");
    control.setAttribute("disposalMethod", "doNotDispose");
    control.setAttribute("delayTime", Integer.toString(CENTISECONDS));
    if (last == null) {
      addLoop(root);
    }
    metadata.setFromTree(FRAME_FORMAT, root);
    writer.writeToSequence(new IIOImage(cut, null, metadata), null);
    last = frame;
  }

  private static Rectangle whole(BufferedImage image) {
    return new Rectangle(image.getWidth(), image.getHeight());
  }

  /** The smallest rectangle with all pixels that differ; one pixel if none does. */
  private static Rectangle difference(BufferedImage a, BufferedImage b) {
    int w = b.getWidth();
    int h = b.getHeight();
    int[] rowA = new int[w];
    int[] rowB = new int[w];
    int left = w;
    int right = -1;
    int top = h;
    int bottom = -1;
    for (int y = 0; y < h; y++) {
      a.getRGB(0, y, w, 1, rowA, 0, w);
      b.getRGB(0, y, w, 1, rowB, 0, w);
      int first = Arrays.mismatch(rowA, rowB);
      if (first < 0) {
        continue;
      }
      int end = w - 1;
      while (rowA[end] == rowB[end]) {
        end--;
      }
      left = Math.min(left, first);
      right = Math.max(right, end);
      top = Math.min(top, y);
      bottom = y;
    }
    return bottom < 0
        ? new Rectangle(1, 1)
        : new Rectangle(left, top, right - left + 1, bottom - top + 1);
  }

  /** The application extension by which browsers repeat an animation; 0 times means for ever. */
  private static void addLoop(IIOMetadataNode root) {
    IIOMetadataNode extension = new IIOMetadataNode("ApplicationExtension");
    extension.setAttribute("applicationID", "NETSCAPE");
    extension.setAttribute("authenticationCode", "2.0");
    extension.setUserObject(new byte[] {1, 0, 0});
    child(root, "ApplicationExtensions").appendChild(extension);
  }

  private static IIOMetadataNode child(IIOMetadataNode root, String name) {
    for (int i = 0; i < root.getLength(); i++) {
      if (root.item(i).getNodeName().equals(name)) {
        return (IIOMetadataNode) root.item(i);
      }
    }
    IIOMetadataNode made = new IIOMetadataNode(name);
    root.appendChild(made);
    return made;
  }

  @Override
  public void close() throws IOException {
    writer.endWriteSequence();
    writer.dispose();
    out.close();
  }
}
