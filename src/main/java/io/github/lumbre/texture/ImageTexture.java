package io.github.lumbre.texture;

import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.Srgb;
import java.util.Objects;

/**
 * A picture as a texture, repeated in both directions without end.
 *
 * <p>u = 0 is the left edge of the left column and v = 0 the lower edge of the <b>bottom</b> row. A
 * coordinate that is not finite, as degenerate surfaces have, is read as (0, 0).
 */
public final class ImageTexture implements Texture<Rgb> {
  /** What the values of the file mean. */
  public enum Role {
    /** sRGB, decoded to linear light. */
    COLOUR {
      @Override
      double decode(int raw, int max) {
        return max == 255 ? Srgb.fromByte(raw) : Srgb.decode((double) raw / max);
      }
    },
    /** Numbers in [0,1], taken as they are. */
    DATA {
      @Override
      double decode(int raw, int max) {
        return (double) raw / max;
      }
    },
    /**
     * Components of a direction in [-1,1]: (byte - 128) / 127, or (value - 32768) / 32767 of 16
     * bits, so that the middle of the range is exactly 0.
     */
    NORMAL {
      @Override
      double decode(int raw, int max) {
        int middle = (max + 1) / 2;
        return Math.max(-1, (double) (raw - middle) / (middle - 1));
      }
    };

    abstract double decode(int raw, int max);
  }

  /** How values between the texels' centres are found. */
  public enum Filter {
    /** The value of the texel that the point lies in. */
    NEAREST,
    /** Interpolated between the four nearest centres, after decoding, across the borders too. */
    BILINEAR
  }

  private final Pixels pixels;
  private final double[] decoded;
  private final Filter filter;
  private final Rgb tint;

  public ImageTexture(Pixels pixels, Role role, Filter filter) {
    this(
        Objects.requireNonNull(pixels, "pixels"),
        table(Objects.requireNonNull(role, "role"), pixels.max()),
        Objects.requireNonNull(filter, "filter"),
        Rgb.WHITE);
  }

  private ImageTexture(Pixels pixels, double[] decoded, Filter filter, Rgb tint) {
    this.pixels = pixels;
    this.decoded = decoded;
    this.filter = filter;
    this.tint = tint;
  }

  private static double[] table(Role role, int max) {
    double[] table = new double[max + 1];
    for (int raw = 0; raw <= max; raw++) {
      table[raw] = role.decode(raw, max);
    }
    return table;
  }

  /** Returns this texture times a constant. */
  ImageTexture tinted(Rgb factor) {
    return new ImageTexture(pixels, decoded, filter, tint.times(factor));
  }

  public int width() {
    return pixels.width();
  }

  public int height() {
    return pixels.height();
  }

  @Override
  public Rgb at(TexturePoint p) {
    boolean finite = Double.isFinite(p.u()) && Double.isFinite(p.v());
    double column = pixels.width() * (finite ? fraction(p.u()) : 0);
    double row = pixels.height() * (finite ? fraction(p.v()) : 0);
    return filter == Filter.NEAREST ? nearest(column, row) : bilinear(column - .5, row - .5);
  }

  /** Returns u - floor(u), in [0,1]: of a tiny negative u it rounds to 1. */
  private static double fraction(double u) {
    return u - Math.floor(u);
  }

  private Rgb nearest(double column, double row) {
    int x = Math.min((int) column, pixels.width() - 1);
    int y = pixels.height() - 1 - Math.min((int) row, pixels.height() - 1);
    return new Rgb(tint.r() * texel(x, y, 0), tint.g() * texel(x, y, 1), tint.b() * texel(x, y, 2));
  }

  /**
   * Interpolates between four centres.
   *
   * @param column counted from the centre of the left column, in [-½, width - ½]
   * @param row counted from the centre of the bottom row, upwards
   */
  private Rgb bilinear(double column, double row) {
    int width = pixels.width();
    int height = pixels.height();
    double left = Math.floor(column);
    double bottom = Math.floor(row);
    int x0 = left < 0 ? width - 1 : (int) left;
    int x1 = x0 + 1 < width ? x0 + 1 : 0;
    int fromBottom = bottom < 0 ? height - 1 : (int) bottom;
    int y0 = height - 1 - fromBottom;
    int y1 = y0 > 0 ? y0 - 1 : height - 1;
    double s = column - left;
    double t = row - bottom;
    return new Rgb(
        tint.r() * blend(x0, x1, y0, y1, s, t, 0),
        tint.g() * blend(x0, x1, y0, y1, s, t, 1),
        tint.b() * blend(x0, x1, y0, y1, s, t, 2));
  }

  private double blend(int x0, int x1, int y0, int y1, double s, double t, int channel) {
    double lower = mix(texel(x0, y0, channel), texel(x1, y0, channel), s);
    double upper = mix(texel(x0, y1, channel), texel(x1, y1, channel), s);
    return mix(lower, upper, t);
  }

  private static double mix(double a, double b, double t) {
    return a + t * (b - a);
  }

  private double texel(int x, int y, int channel) {
    return decoded[pixels.raw(x, y, channel)];
  }
}
