package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;

/**
 * A diffuse and a specular color whose sum is at most 1 in each component.
 *
 * @param diffuse each component in [0,1]
 * @param specular each component in [0,1]
 */
record Reflectances(Rgb diffuse, Rgb specular) {
  /**
   * Returns the two colors. If the largest component of their sum exceeds 1, both are divided by
   * it, which keeps their hue and ratio.
   */
  static Reflectances of(Rgb diffuse, Rgb specular) {
    double most = diffuse.plus(specular).max();
    return most > 1
        ? new Reflectances(diffuse.times(1 / most), specular.times(1 / most))
        : new Reflectances(diffuse, specular);
  }

  /**
   * Returns the BSDF that combines the diffuse color with a specular lobe. A black one of the two
   * is left out.
   */
  Bsdf with(Lobe lobe) {
    Lambertian lambertian = new Lambertian(diffuse);
    if (specular.isBlack()) {
      return lambertian;
    }
    return diffuse.isBlack() ? lobe : new Mixture(lambertian, lobe);
  }
}
