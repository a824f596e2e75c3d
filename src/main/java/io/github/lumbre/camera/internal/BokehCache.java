package io.github.lumbre.camera.internal;

import io.github.lumbre.camera.Aperture;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.sampling.Sampler;
import java.util.Arrays;

/**
 * A lens with the shape of a black and white mask, one unit wide, one unit high and centered. A
 * lens sample on a white texel is used directly. Any other is replaced by a random point of a
 * random white texel. The density over the white area is therefore exactly uniform.
 */
public final class BokehCache implements Aperture {
  private final int width;
  private final int height;
  private final boolean[] white;
  private final int[] whiteTexels;

  /** Creates a lens; see {@link Aperture#mask}. */
  public BokehCache(boolean[][] white) {
    height = white.length;
    width = height == 0 ? 0 : white[0].length;
    this.white = new boolean[Math.multiplyExact(width, height)];
    int[] found = new int[this.white.length];
    int count = 0;
    for (int y = 0; y < height; y++) {
      for (int x = 0; x < width; x++) {
        if (white[y][x]) {
          this.white[y * width + x] = true;
          found[count++] = y * width + x;
        }
      }
    }
    if (count == 0) {
      throw new IllegalArgumentException("white: expected at least one white texel, found none");
    }
    whiteTexels = Arrays.copyOf(found, count);
  }

  /** Returns the mask, {@code [row][column]}, with row 0 at the <b>bottom</b>. */
  public boolean[][] toMask() {
    boolean[][] mask = new boolean[height][];
    for (int y = 0; y < height; y++) {
      mask[y] = Arrays.copyOfRange(white, y * width, (y + 1) * width);
    }
    return mask;
  }

  @Override
  public Point2 sample(Sampler sampler) {
    Point2 u = sampler.get2d(Sampler.LENS);
    int x = (int) (u.x() * width);
    int y = (int) (u.y() * height);
    double fromLeft = u.x();
    double fromBottom = u.y();
    if (!white[y * width + x]) {
      int texel = whiteTexels[(int) (sampler.get1d(Sampler.MASK) * whiteTexels.length)];
      Point2 jitter = sampler.get2d(Sampler.MASK + 1);
      fromLeft = (texel % width + jitter.x()) / width;
      fromBottom = (texel / width + jitter.y()) / height;
    }
    // Single allocation site, so that escape analysis can remove it.
    return new Point2(fromLeft - .5, fromBottom - .5);
  }

  @Override
  public double area() {
    return (double) whiteTexels.length / white.length;
  }

  @Override
  public boolean contains(double x, double y) {
    int column = (int) Math.floor((x + .5) * width);
    int row = (int) Math.floor((y + .5) * height);
    return column >= 0 && column < width && row >= 0 && row < height && white[row * width + column];
  }
}
