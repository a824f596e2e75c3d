package io.github.lumbre.scenefile;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.internal.LinearPicture;
import io.github.lumbre.texture.Texture;
import io.github.lumbre.texture.internal.BilinearTexture;
import io.github.lumbre.texture.internal.ImageTexture;
import io.github.lumbre.texture.internal.ImageTexture.Filter;
import io.github.lumbre.texture.internal.ImageTexture.Role;
import io.github.lumbre.texture.internal.LinearTexture;
import io.github.lumbre.texture.internal.TexelTexture;
import java.util.Optional;
import java.util.function.Consumer;

/** A texture before it has a role: color, data or normals. */
interface Picture {
  int width();

  int height();

  /** Returns the texture, with its values interpreted for a role. */
  Texture<Rgb> as(Role role);

  /** Returns the texture as radiance, for example of a sky. */
  default Texture<Rgb> asLight() {
    return as(Role.COLOR);
  }

  /** Returns the mean of a texel's stored components, without conversion; row 0 is the top row. */
  double value(int column, int row);

  /** Returns the number of columns of the brightness table of an environment light. */
  default int domeColumns() {
    return width();
  }

  /** Returns the number of rows of the brightness table of an environment light. */
  default int domeRows() {
    return height();
  }

  /** A decoded image file. */
  record Decoded(Pixels pixels, Filter filter) implements Picture {
    @Override
    public int width() {
      return pixels.width();
    }

    @Override
    public int height() {
      return pixels.height();
    }

    @Override
    public Texture<Rgb> as(Role role) {
      return new ImageTexture(pixels, role, filter);
    }

    @Override
    public double value(int column, int row) {
      double r = pixels.value(column, row, 0);
      double g = pixels.value(column, row, 1);
      double b = pixels.value(column, row, 2);
      return (r + g + b) / 3;
    }
  }

  /** A picture of linear light, such as a sky. As data, its values are unchanged. */
  final class Linear implements Picture {
    private final LinearPicture picture;
    private final Image light;
    private final Consumer<String> warnings;
    private Optional<Image> straight = Optional.empty();

    /**
     * @param warnings receives a warning if alpha has to be clamped, at the first use as a surface
     */
    Linear(LinearPicture picture, Consumer<String> warnings) {
      this.picture = picture;
      this.warnings = warnings;
      light = picture.light();
    }

    @Override
    public int width() {
      return light.width();
    }

    @Override
    public int height() {
      return light.height();
    }

    @Override
    public Texture<Rgb> as(Role role) {
      return new LinearTexture(straight());
    }

    @Override
    public Texture<Rgb> asLight() {
      return new LinearTexture(light);
    }

    @Override
    public double value(int column, int row) {
      Rgb value = straight().pixel(column, row);
      return (value.r() + value.g() + value.b()) / 3;
    }

    private Image straight() {
      if (straight.isEmpty()) {
        straight = Optional.of(picture.straight());
        int clamped = picture.clampedAlphas();
        if (clamped > 0) {
          String pixels = clamped == 1 ? "1 pixel" : clamped + " pixels";
          warnings.accept("has alpha outside 0 to 1 in " + pixels + ", which is clamped");
        }
      }
      return straight.get();
    }
  }

  /**
   * A procedural texture. Its values serve unchanged as linear colors and as data. As a component
   * of a normal, a value v represents 2v - 1.
   */
  record Computed(TexelTexture texels, Filter filter) implements Picture {
    /** Limits the table: procedural textures may be huge, but have no small bright spots. */
    private static final int MAX_DOME_SIDE = 1024;

    @Override
    public int width() {
      return texels.width();
    }

    @Override
    public int height() {
      return texels.height();
    }

    @Override
    public int domeColumns() {
      return Math.min(width(), MAX_DOME_SIDE);
    }

    @Override
    public int domeRows() {
      return Math.min(height(), MAX_DOME_SIDE);
    }

    @Override
    public Texture<Rgb> as(Role role) {
      Texture<Rgb> values = filter == Filter.NEAREST ? texels : new BilinearTexture(texels);
      return role == Role.NORMAL ? (u, v) -> values.at(u, v).times(2).plus(Rgb.gray(-1)) : values;
    }

    @Override
    public double value(int column, int row) {
      Rgb value = texels.texel(column, row);
      return (value.r() + value.g() + value.b()) / 3;
    }
  }
}
