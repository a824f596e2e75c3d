package io.github.lumbre.parser;

import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.texture.BilinearTexture;
import io.github.lumbre.texture.ImageTexture;
import io.github.lumbre.texture.ImageTexture.Filter;
import io.github.lumbre.texture.ImageTexture.Role;
import io.github.lumbre.texture.TexelTexture;
import io.github.lumbre.texture.Texture;

/** A texture whose use, and so the meaning of its values, is not yet known. */
interface Picture {
  int width();

  int height();

  /** Returns the texture as what a channel takes its values for. */
  Texture<Rgb> as(Role role);

  /** Returns the mean of a texel's components, taken as they are; row 0 is the top one. */
  double value(int column, int row);

  /** Returns the number of columns of the brightness table of an environment light. */
  default int domeColumns() {
    return width();
  }

  /** Returns the number of rows of the brightness table of an environment light. */
  default int domeRows() {
    return height();
  }

  /** A decoded picture file. */
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

  /**
   * A computed texture. Its values are linear light and numbers alike; as components of a direction
   * they stand for 2v - 1.
   */
  record Computed(TexelTexture texels, Filter filter) implements Picture {
    /** Computed textures have no small bright spots, but may have very many texels. */
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
