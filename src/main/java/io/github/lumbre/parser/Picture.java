package io.github.lumbre.parser;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.texture.BilinearTexture;
import io.github.lumbre.texture.ImageTexture;
import io.github.lumbre.texture.ImageTexture.Filter;
import io.github.lumbre.texture.ImageTexture.Role;
import io.github.lumbre.texture.LinearTexture;
import io.github.lumbre.texture.TexelTexture;
import io.github.lumbre.texture.Texture;

/** A texture before it has a role: color, data or normals. */
interface Picture {
  int width();

  int height();

  /** Returns the texture, with its values interpreted for a role. */
  Texture<Rgb> as(Role role);

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
  record Linear(Image image) implements Picture {
    @Override
    public int width() {
      return image.width();
    }

    @Override
    public int height() {
      return image.height();
    }

    @Override
    public Texture<Rgb> as(Role role) {
      return new LinearTexture(image);
    }

    @Override
    public double value(int column, int row) {
      Rgb value = image.pixel(column, row);
      return (value.r() + value.g() + value.b()) / 3;
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
      return role == Role.NORMAL ? (u, v) -> values.at(u, v).times(2).plus(Rgb.grey(-1)) : values;
    }

    @Override
    public double value(int column, int row) {
      Rgb value = texels.texel(column, row);
      return (value.r() + value.g() + value.b()) / 3;
    }
  }
}
