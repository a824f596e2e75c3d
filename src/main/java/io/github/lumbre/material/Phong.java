package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.internal.Range;
import io.github.lumbre.texture.ScalarTexture;
import io.github.lumbre.texture.Texture;
import java.util.Objects;

/**
 * The Phong material of the scene format: a diffuse lobe plus a Phong highlight.
 *
 * @param diffuse diffuse color; both colors are scaled down wherever their sum exceeds 1
 * @param specular color of the highlight
 * @param exponent exponent of the highlight, at least 0; larger exponents give smaller highlights
 */
public record Phong(Texture<Rgb> diffuse, Texture<Rgb> specular, ScalarTexture exponent)
    implements Material {
  /**
   * The largest exponent; larger ones are clamped to it. Its highlight is about 1e-6 radians wide,
   * and the rounding of directions cannot resolve smaller ones.
   */
  public static final double SHARPEST = 1e12;

  /**
   * Returns a material of two colors.
   *
   * @param diffuse each component in [0, 1]
   * @param specular each component in [0, 1]
   * @param exponent at least 0
   * @throws IllegalArgumentException if a number is out of range
   */
  public static Phong of(Rgb diffuse, Rgb specular, double exponent) {
    return new Phong(
        Values.reflectance("diffuse", diffuse),
        Values.reflectance("specular", specular),
        Values.number("exponent", exponent, Range.NOT_NEGATIVE));
  }

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
    Reflectances colors = Reflectances.of(diffuse.at(u, v), specular.at(u, v));
    return colors.with(new PhongLobe(colors.specular(), Math.min(exponent.at(u, v), SHARPEST)));
  }
}
