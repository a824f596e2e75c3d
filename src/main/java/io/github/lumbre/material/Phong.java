package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.texture.ScalarTexture;
import io.github.lumbre.texture.Texture;
import java.util.Objects;

/**
 * A diffuse surface with a Phong highlight: the format's Phong.
 *
 * @param diffuse colour, scaled down with the specular one where both together exceed 1
 * @param specular colour of the highlight
 * @param exponent of the highlight, at least 0: the larger, the smaller
 */
public record Phong(Texture<Rgb> diffuse, Texture<Rgb> specular, ScalarTexture exponent)
    implements Material {
  /**
   * Sharper highlights than this, of a millionth of a radian, are taken as this sharp: directions
   * have no digits left to distinguish their parts.
   */
  public static final double SHARPEST = 1e12;

  public Phong {
    Objects.requireNonNull(diffuse, "diffuse");
    Objects.requireNonNull(specular, "specular");
    Objects.requireNonNull(exponent, "exponent");
  }

  @Override
  public boolean isUniform() {
    return diffuse.isConstant() && specular.isConstant() && exponent.isConstant();
  }

  @Override
  public Bsdf at(double u, double v) {
    Reflectances colours = Reflectances.of(diffuse.at(u, v), specular.at(u, v));
    return colours.with(new PhongLobe(colours.specular(), Math.min(exponent.at(u, v), SHARPEST)));
  }
}
