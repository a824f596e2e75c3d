package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;

/**
 * A diffuse and a specular colour that together reflect at most 1.
 *
 * @param diffuse each component in [0,1]
 * @param specular each component in [0,1]
 */
record Reflectances(Rgb diffuse, Rgb specular) {
  /**
   * Returns the two colours, both divided by the largest component of their sum if that exceeds 1,
   * so that hue and proportion stay.
   */
  static Reflectances of(Rgb diffuse, Rgb specular) {
    double most = diffuse.plus(specular).max();
    return most > 1
        ? new Reflectances(diffuse.times(1 / most), specular.times(1 / most))
        : new Reflectances(diffuse, specular);
  }

  /** Returns the Bsdf of the diffuse part and a specular lobe, either left out if it is black. */
  Bsdf with(Lobe lobe) {
    Lambertian lambertian = new Lambertian(diffuse);
    if (specular.isBlack()) {
      return lambertian;
    }
    return diffuse.isBlack() ? lobe : new Mixture(lambertian, lobe);
  }
}
