package io.github.lumbre.texture.internal;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.texture.Texture;
import java.util.Objects;

/**
 * Texels with bilinear interpolation between the four nearest centers, also across the borders.
 * Coordinates that are not finite are read as (0, 0).
 */
public record BilinearTexture(TexelTexture texels) implements Texture<Rgb> {
  public BilinearTexture {
    Objects.requireNonNull(texels, "texels");
  }

  @Override
  public Rgb at(double u, double v) {
    Bilinear around = Bilinear.around(u, v, texels.width(), texels.height());
    Rgb v00 = texels.texel(around.x0(), around.y0());
    Rgb v10 = texels.texel(around.x1(), around.y0());
    Rgb v01 = texels.texel(around.x0(), around.y1());
    Rgb v11 = texels.texel(around.x1(), around.y1());
    return new Rgb(
        around.blend(v00.r(), v10.r(), v01.r(), v11.r()),
        around.blend(v00.g(), v10.g(), v01.g(), v11.g()),
        around.blend(v00.b(), v10.b(), v01.b(), v11.b()));
  }
}
