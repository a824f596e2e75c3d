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
    return new Rgb(channel(u, v, 0), channel(u, v, 1), channel(u, v, 2));
  }

  /**
   * Returns the decoded value of one channel.
   *
   * @param channel 0 to 3: red, green, blue, alpha; alpha is never decoded as a color, and 1 if the
   *     picture has none
   */
  public double channel(double u, double v, int channel) {
    if (!Texel.isFinite(u, v)) {
      InvalidCoordinates.count();
      return channel(0, 0, channel);
    }
    double x = clamped(u) * pixels.width();
    // Row 0 is at the top.
    double y = (1 - clamped(v)) * pixels.height();
    if (filter == ImageTexture.Filter.NEAREST) {
      return texel((long) Math.floor(x), (long) Math.ceil(y) - 1, channel);
    }
    double left = Math.floor(x - .5);
    double top = Math.floor(y - .5);
    double s = x - .5 - left;
    double t = y - .5 - top;
    long column = (long) left;
    long row = (long) top;
    return Bilinear.mix(
        Bilinear.mix(texel(column, row, channel), texel(column + 1, row, channel), s),
        Bilinear.mix(texel(column, row + 1, channel), texel(column + 1, row + 1, channel), s),
        t);
  }

  private static double clamped(double coordinate) {
    return Math.max(-MAX_COORDINATE, Math.min(MAX_COORDINATE, coordinate));
  }

  private double texel(long column, long row, int channel) {
    int x = wrapU.index(column, pixels.width());
    int y = wrapV.index(row, pixels.height());
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
