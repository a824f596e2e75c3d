package io.github.lumbre.material;

import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.SpecularReflection;
import io.github.lumbre.texture.TexturePoint;
import java.util.Optional;

/** A surface material: evaluates its textures at a hit and returns the BSDF there. Immutable. */
public interface Material {
  /**
   * Returns the BSDF at a point of the surface, in the hit's shading frame.
   *
   * @param u texture coordinate, any finite number
   * @param v texture coordinate, any finite number
   */
  Bsdf at(double u, double v);

  /** Returns the BSDF at a point of the surface, in the hit's shading frame. */
  default Bsdf at(TexturePoint point) {
    return at(point.u(), point.v());
  }

  /**
   * Returns how the surface scatters at a hit, in its shading frame. Materials that read only the
   * first texture coordinates implement {@link #at(double, double)} alone.
   */
  default Bsdf at(SurfaceHit hit) {
    return at(hit.u(), hit.v());
  }

  /** Returns whether no ray passes straight through the surface. */
  default boolean isOpaque() {
    return true;
  }

  /**
   * Returns the fraction of light, per color, that passes straight through the surface at a hit: in
   * [0,1]. {@link #at(SurfaceHit)} scatters the rest.
   */
  default Rgb transmittance(SurfaceHit hit) {
    return Rgb.BLACK;
  }

  /**
   * Returns whether some of the light that passes straight through the surface at a hit passes
   * through clear glass, not only where the surface is partly absent.
   */
  default boolean passesThroughGlass(SurfaceHit hit) {
    return false;
  }

  /**
   * Returns whether the surface may refract colors to different directions, so that samples of
   * {@link Bsdf#narrowed} should be used.
   */
  default boolean isDispersive() {
    return false;
  }

  /** Returns whether the camera sees only the surface's shadows; see {@link ShadowCatcher}. */
  default boolean catchesShadows() {
    return false;
  }

  /**
   * Returns the absorption coefficient of the medium behind the surface, per world unit; black if
   * it absorbs nothing.
   */
  default Rgb absorption() {
    return Rgb.BLACK;
  }

  /**
   * Returns the fraction of light, per color in [0,1], that the surface reflects if it is known to
   * be the same perfect mirror everywhere; empty otherwise.
   */
  default Optional<Rgb> mirrorReflectance() {
    return isUniform() && at(0, 0) instanceof SpecularReflection mirror
        ? Optional.of(mirror.reflectance())
        : Optional.empty();
  }

  /** Returns whether the surface is known to scatter everywhere alike, in its frame. */
  boolean isUniform();

  /** Returns an equivalent material that evaluates constant textures only once. */
  default Material simplified() {
    return isUniform() ? new UniformMaterial(at(0, 0)) : this;
  }

  /** Perturbs the hit's shading frame by a normal map, if there is one. */
  default void perturb(SurfaceHit hit) {}
}
