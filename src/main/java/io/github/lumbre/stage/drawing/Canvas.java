package io.github.lumbre.stage.drawing;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** A picture to draw on. Mutable; for one thread. */
public final class Canvas implements Easel {
  /** Rows whose coverage is in memory at a time. */
  private static final int BAND = 64;

  private final int width;
  private final int height;
  private final float[] rgb;
  private final float[] alpha;

  /** Creates a canvas that shows a copy of a picture. */
  public Canvas(Image picture) {
    width = picture.width();
    height = picture.height();
    rgb = picture.rgb().clone();
    alpha = new float[picture.hasAlpha() ? width * height : 0];
    for (int i = 0; i < alpha.length; i++) {
      alpha[i] = picture.alpha(i % width, i / width);
    }
  }

  /** Returns the picture with what has been drawn; later drawing does not change it. */
  public Image image() {
    return new Image(width, height, rgb.clone(), alpha.clone());
  }

  @Override
  public void draw(Strokes strokes, Pen pen) {
    List<Segment> segments = new ArrayList<>();
    for (int i = 0; i < strokes.count(); i++) {
      Segment.of(strokes, i, .5 * pen.width(), width, height).ifPresent(segments::add);
    }
    if (segments.isEmpty()) {
      return;
    }
    long[] covered = new long[width * Math.min(BAND, height)];
    for (int top = 0; top < height; top += BAND) {
      int end = Math.min(top + BAND, height);
      Arrays.fill(covered, 0);
      for (Segment segment : segments) {
        cover(segment, top, end, covered);
      }
      blend(covered, top, end, pen);
    }
  }

  /** Fills what is inside an odd number of closed outlines. */
  void fill(List<double[]> outlines, Rgb color) {
    Areas areas = new Areas(outlines, width, height);
    for (int row = 0; row < height; row++) {
      double[] shares = areas.shares(row);
      for (int column = 0; column < width; column++) {
        if (shares[column] > 0) {
          blend(row * width + column, color, Math.min(1, shares[column]));
        }
      }
    }
  }

  /** Adds a segment's samples to those of the rows of a band. */
  private void cover(Segment segment, int top, int end, long[] covered) {
    int last = Math.min(segment.bottom(), end - 1);
    for (int row = Math.max(segment.top(), top); row <= last; row++) {
      int left = Math.max(0, (int) Math.floor(segment.edge(row, false)));
      int right = Math.min(width - 1, (int) Math.floor(segment.edge(row, true)));
      for (int column = left; column <= right; column++) {
        int at = (row - top) * width + column;
        if (covered[at] != -1L) {
          covered[at] |= segment.covered(column, row);
        }
      }
    }
  }

  private void blend(long[] covered, int top, int end, Pen pen) {
    for (int i = 0; i < (end - top) * width; i++) {
      if (covered[i] != 0) {
        double share = pen.opacity() * Long.bitCount(covered[i]) / PixelSamples.COUNT;
        blend(top * width + i, pen.color(), share);
      }
    }
  }

  /** Puts a color over a pixel: the "over" operator for straight alpha (Porter and Duff 1984). */
  private void blend(int pixel, Rgb color, double share) {
    double below = (alpha.length == 0 ? 1 : alpha[pixel]) * (1 - share);
    double total = share + below;
    if (total > 0) {
      int at = 3 * pixel;
      rgb[at] = mixed(color.r(), rgb[at], share / total);
      rgb[at + 1] = mixed(color.g(), rgb[at + 1], share / total);
      rgb[at + 2] = mixed(color.b(), rgb[at + 2], share / total);
      if (alpha.length > 0) {
        alpha[pixel] = (float) total;
      }
    }
  }

  private static float mixed(double above, float below, double share) {
    // What is covered completely may be infinite.
    return (float) (share == 1 ? above : share * above + (1 - share) * below);
  }
}
