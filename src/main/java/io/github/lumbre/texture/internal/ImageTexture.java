package io.github.lumbre.texture.internal;

import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.internal.Srgb;
import io.github.lumbre.texture.Texture;
import java.util.Objects;

/**
 * A picture as a texture that repeats infinitely in both directions.
 *
 * <p>u = 0 is the left edge of the left column, and v = 0 is the lower edge of the <b>bottom</b>
 * row. Points with a coordinate that is not finite, which degenerate surfaces have, are read as (0,
 * 0).
 */
public final class ImageTexture implements Texture<Rgb> {
  /** The meaning of the file's values. */
  public enum Role {
    /** Colors in sRGB, decoded to linear RGB. */
    COLOR {
      @Override
      double decode(int raw, int max) {
        return max == 255 ? Srgb.fromByte(raw) : Srgb.decode((double) raw / max);
      }
    },
    /** Numbers in [0,1], not decoded. */
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

  /** The interpolation between texels. */
  public enum Filter {
    /** The value of the texel that contains the point. */
    NEAREST,
    /**
     * Bilinear interpolation of decoded values between the four nearest centers, also across the
     * borders.
     */
    BILINEAR
  }

  private final Pixels pixels;
  private final Role role;
  private final double[] decoded;
  private final Filter filter;
  private final Rgb tint;

  public ImageTexture(Pixels pixels, Role role, Filter filter) {
    this(
        Objects.requireNonNull(pixels, "pixels"),
        role,
        table(Objects.requireNonNull(role, "role"), pixels.max()),
        Objects.requireNonNull(filter, "filter"),
        Rgb.WHITE);
  }

  private ImageTexture(Pixels pixels, Role role, double[] decoded, Filter filter, Rgb tint) {
    this.role = role;
    this.pixels = pixels;
    this.decoded = decoded;
    this.filter = filter;
    this.tint = tint;
  }

  static double[] table(Role role, int max) {
    double[] table = new double[max + 1];
    for (int raw = 0; raw <= max; raw++) {
      table[raw] = role.decode(raw, max);
    }
    return table;
  }

  /** Returns the product of this texture and a constant. */
  ImageTexture tinted(Rgb factor) {
    return new ImageTexture(pixels, role, decoded, filter, tint.times(factor));
  }

  /** Returns the encoded texels. */
  public Pixels pixels() {
    return pixels;
  }

  /** Returns the meaning of the file's values. */
  public Role role() {
    return role;
  }

  /** Returns the interpolation between texels. */
  public Filter filter() {
    return filter;
  }

  /** Returns the constant factor of the decoded values. */
  public Rgb tint() {
    return tint;
  }

  /** Returns the width in texels. */
  public int width() {
    return pixels.width();
  }

  /** Returns the height in texels. */
  public int height() {
    return pixels.height();
  }

  @Override
  public Rgb at(double u, double v) {
    return filter == Filter.NEAREST ? nearest(u, v) : bilinear(u, v);
  }

  private Rgb nearest(double u, double v) {
    int x = Texel.column(u, v, pixels.width());
    int y = Texel.row(u, v, pixels.height());
    return new Rgb(tint.r() * texel(x, y, 0), tint.g() * texel(x, y, 1), tint.b() * texel(x, y, 2));
  }

  private Rgb bilinear(double u, double v) {
    Bilinear around = Bilinear.around(u, v, pixels.width(), pixels.height());
    return new Rgb(
        tint.r() * blend(around, 0), tint.g() * blend(around, 1), tint.b() * blend(around, 2));
  }

  private double blend(Bilinear around, int channel) {
    return around.blend(
        texel(around.x0(), around.y0(), channel),
        texel(around.x1(), around.y0(), channel),
        texel(around.x0(), around.y1(), channel),
        texel(around.x1(), around.y1(), channel));
  }

  /** Returns the decoded texels without the constant factor. */
  GridMaxima.TexelRows texels() {
    return new GridMaxima.TexelRows() {
      @Override
      public int width() {
        return pixels.width();
      }

      @Override
      public int height() {
        return pixels.height();
      }

      @Override
      public void read(int y, int channel, double[] row) {
        pixels.lookUp(y, channel, decoded, row);
      }
    };
  }

  private double texel(int x, int y, int channel) {
    return decoded[pixels.raw(x, y, channel)];
  }
}
