package io.github.lumbre.texture.internal;

import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.texture.ScalarTexture;
import io.github.lumbre.texture.Texture;
import java.util.Objects;

/**
 * A picture as a texture, with a wrap mode for each direction and access to single channels and
 * alpha. It has the coordinates of {@link ImageTexture}. It takes at most 4 bytes per texel for 8
 * bits per channel, and 8 for 16. Immutable.
 */
public final class SampledTexture implements Texture<Rgb> {
  /** The continuation of a texture outside [0,1). */
  public enum Wrap {
    /** It repeats. */
    REPEAT {
      @Override
      int index(long i, int size) {
        return (int) Math.floorMod(i, (long) size);
      }
    },
    /** It repeats, and every second copy is mirrored. */
    MIRROR {
      @Override
      int index(long i, int size) {
        int j = (int) Math.floorMod(i, 2L * size);
        return j < size ? j : 2 * size - 1 - j;
      }
    },
    /** Its border texels continue. */
    CLAMP {
      @Override
      int index(long i, int size) {
        return (int) Math.max(0, Math.min(size - 1, i));
      }
    };

    abstract int index(long i, int size);
  }

  private static final int ALPHA = 3;

  /** Larger coordinates have no fraction left. */
  private static final double MAX_COORDINATE = 0x1p40;

  private final Pixels pixels;
  private final ImageTexture.Role role;
  private final ImageTexture.Filter filter;
  private final Wrap wrapU;
  private final Wrap wrapV;
  private final double[] decoded;

  public SampledTexture(
      Pixels pixels, ImageTexture.Role role, ImageTexture.Filter filter, Wrap wrapU, Wrap wrapV) {
    this.pixels = Objects.requireNonNull(pixels, "pixels");
    this.role = Objects.requireNonNull(role, "role");
    this.filter = Objects.requireNonNull(filter, "filter");
    this.wrapU = Objects.requireNonNull(wrapU, "wrapU");
    this.wrapV = Objects.requireNonNull(wrapV, "wrapV");
    decoded = ImageTexture.table(role, pixels.max());
  }

  @Override
  public Rgb at(double u, double v) {
    Bilinear around = around(u, v);
    return new Rgb(blend(around, 0), blend(around, 1), blend(around, 2));
  }

  /**
   * Returns the decoded value of one channel.
   *
   * @param channel 0 to 3: red, green, blue, alpha; alpha is never decoded as a color, and 1 if the
   *     picture has none
   */
  public double channel(double u, double v, int channel) {
    return blend(around(u, v), channel);
  }

  /** Returns the texels around a point, or four times the one that contains it. */
  private Bilinear around(double u, double v) {
    if (!Texel.isFinite(u, v)) {
      InvalidCoordinates.count();
      return around(0, 0);
    }
    double x = clamped(u) * pixels.width();
    // Row 0 is at the top.
    double y = (1 - clamped(v)) * pixels.height();
    if (filter == ImageTexture.Filter.NEAREST) {
      int column = index(wrapU, floor(x), pixels.width());
      int row = index(wrapV, -floor(-y) - 1, pixels.height());
      return new Bilinear(column, column, row, row, 0, 0);
    }
    long left = floor(x - .5);
    long top = floor(y - .5);
    return new Bilinear(
        index(wrapU, left, pixels.width()),
        index(wrapU, left + 1, pixels.width()),
        index(wrapV, top, pixels.height()),
        index(wrapV, top + 1, pixels.height()),
        x - .5 - left,
        y - .5 - top);
  }

  private static double clamped(double coordinate) {
    return Math.abs(coordinate) < MAX_COORDINATE
        ? coordinate
        : Math.copySign(MAX_COORDINATE, coordinate);
  }

  /** Returns the largest integer that is not larger; {@link Math#floor} is slow at the start. */
  private static long floor(double x) {
    long cut = (long) x;
    return x < cut ? cut - 1 : cut;
  }

  /** Returns the column or row that continues the picture; inside of it without a division. */
  private static int index(Wrap wrap, long i, int size) {
    return 0 <= i && i < size ? (int) i : wrap.index(i, size);
  }

  private double blend(Bilinear around, int channel) {
    return around.blend(
        texel(around.x0(), around.y0(), channel),
        texel(around.x1(), around.y0(), channel),
        texel(around.x0(), around.y1(), channel),
        texel(around.x1(), around.y1(), channel));
  }

  private double texel(int x, int y, int channel) {
    return channel == ALPHA
        ? (double) pixels.alpha(x, y) / pixels.max()
        : decoded[pixels.raw(x, y, channel)];
  }

  /** Returns a scalar texture: one channel of this texture. */
  public ScalarTexture channel(int channel) {
    return (u, v) -> channel(u, v, channel);
  }

  @Override
  public String toString() {
    return "SampledTexture[" + pixels.width() + "x" + pixels.height() + " " + role + "]";
  }
}
