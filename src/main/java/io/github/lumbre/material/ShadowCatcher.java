package io.github.lumbre.material;

import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.texture.Texture;

/**
 * A floor that shows only its shadows: the camera sees black where other surfaces block the direct
 * light, in proportion to the light that they block, and otherwise shows the background. All other
 * rays meet a diffuse surface.
 *
 * @param surface the material that other rays hit
 */
public record ShadowCatcher(Matte surface) implements Material {
  /**
   * @param albedo fraction of the light that is reflected to other surfaces; components above 1 are
   *     clamped to 1
   */
  public ShadowCatcher(Texture<Rgb> albedo) {
    this(new Matte(albedo));
  }

  /**
   * Returns a shadow catcher of one color.
   *
   * @param albedo its reflectance toward other surfaces, each component in [0, 1]
   * @throws IllegalArgumentException if a component is out of range
   */
  public static ShadowCatcher of(Rgb albedo) {
    return new ShadowCatcher(Matte.of(albedo));
  }

  @Override
  public boolean isUniform() {
    return surface.isUniform();
  }

  @Override
  public Bsdf at(double u, double v) {
    return surface.at(u, v);
  }

  @Override
  public boolean catchesShadows() {
    return true;
  }

  /** {@inheritDoc} The camera may see through this one. Its transmittance is black. */
  @Override
  public boolean isOpaque() {
    return false;
  }

  @Override
  public Rgb transmittance(SurfaceHit hit) {
    return Rgb.BLACK;
  }

  /** Returns this material, which must be known to catch shadows. */
  @Override
  public Material simplified() {
    return this;
  }
}
