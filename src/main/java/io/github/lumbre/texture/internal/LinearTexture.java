package io.github.lumbre.texture.internal;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.texture.Texture;
import java.util.Objects;

/**
 * A picture of linear light, such as a sky, as a texture that repeats infinitely in both
 * directions, with bilinear interpolation. It has the coordinates of {@link ImageTexture}. It takes
 * 12 bytes per texel.
 */
public final class LinearTexture implements Texture<Rgb> {
  private final Image image;

  public LinearTexture(Image image) {
    this.image = Objects.requireNonNull(image, "image");
  }

  public Image image() {
    return image;
  }

  GridMaxima.TexelRows texels() {
    return new GridMaxima.TexelRows() {
      @Override
      public int width() {
        return image.width();
      }

      @Override
      public int height() {
        return image.height();
      }

      @Override
      public void read(int y, int channel, double[] row) {
        int start = 3 * y * row.length + channel;
        for (int x = 0; x < row.length; x++) {
          row[x] = image.rgb()[start + 3 * x];
        }
      }
    };
  }

  @Override
  public Rgb at(double u, double v) {
    Bilinear around = Bilinear.around(u, v, image.width(), image.height());
    Rgb v00 = image.pixel(around.x0(), around.y0());
    Rgb v10 = image.pixel(around.x1(), around.y0());
    Rgb v01 = image.pixel(around.x0(), around.y1());
    Rgb v11 = image.pixel(around.x1(), around.y1());
    return new Rgb(
        around.blend(v00.r(), v10.r(), v01.r(), v11.r()),
        around.blend(v00.g(), v10.g(), v01.g(), v11.g()),
        around.blend(v00.b(), v10.b(), v01.b(), v11.b()));
  }
}
