package io.github.lumbre.material;

import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.ColorChannel;
import io.github.lumbre.material.internal.Ggx;
import io.github.lumbre.material.internal.NormalChannel;
import io.github.lumbre.material.internal.ScalarChannel;
import io.github.lumbre.material.internal.Tilted;
import io.github.lumbre.texture.TexturePoint;
import java.util.Optional;

/** Sheen and, above it, the clear coat of a {@link MetallicRoughness} material. Immutable. */
final class Coverings {
  /** The reflectance of the clear coat at normal incidence, for an index of refraction of 1.5. */
  private static final double COAT_F0 = .04;

  private static final TexturePoint ORIGIN = new TexturePoint(0, 0);

  private final ScalarChannel clearcoat;
  private final ScalarChannel clearcoatRoughness;
  private final Optional<NormalChannel> coatNormals;
  private final ColorChannel sheenColor;
  private final ScalarChannel sheenRoughness;

  Coverings(MetallicRoughness.Builder values) {
    clearcoat = values.number(MaterialParameter.CLEARCOAT);
    clearcoatRoughness = values.number(MaterialParameter.CLEARCOAT_ROUGHNESS);
    coatNormals = values.normals(MaterialParameter.CLEARCOAT_NORMAL);
    sheenColor = values.color(MaterialParameter.SHEEN_COLOR);
    sheenRoughness = values.number(MaterialParameter.SHEEN_ROUGHNESS);
  }

  /** Returns whether a clear coat may cover the surface somewhere. */
  boolean mayBeCoated() {
    return !clearcoat.isConstant() || clearcoat.fractionAt(ORIGIN) > 0;
  }

  /** Returns whether a clear coat covers the surface at a hit. */
  boolean isCoated(SurfaceHit hit) {
    return clearcoat.fractionAt(hit) > 0;
  }

  /** Returns a base with the sheen above it. */
  Bsdf sheened(Bsdf base, SurfaceHit hit) {
    Rgb sheenColor = sheenColor(hit);
    if (sheenColor.isBlack()) {
      return base;
    }
    double roughness = sheenRoughness.fractionAt(hit);
    double most = sheenColor.max();
    return new Layered(
        new Sheen(sheenColor, roughness),
        base,
        (x, y, z) -> most * Sheen.albedo(Math.abs(z), roughness));
  }

  /** Returns a BSDF below the clear coat. */
  Bsdf coated(Bsdf base, SurfaceHit hit) {
    double coat = clearcoat.fractionAt(hit);
    return coat > 0 ? coated(base, coat, coatAlpha(hit), hit) : base;
  }

  private Bsdf coated(Bsdf base, double coat, double alpha, SurfaceHit hit) {
    Lobe smooth = new SchlickReflection(Rgb.gray(coat * COAT_F0), coat, new Ggx(alpha));
    if (coatNormals.isPresent() && coatNormals.get().tilted(smooth, hit) instanceof Tilted bumpy) {
      return new Layered(bumpy, base, (x, y, z) -> coatAlbedo(coat, bumpy.cosine(x, y, z), alpha));
    }
    return new Layered(smooth, base, (x, y, z) -> coatAlbedo(coat, Math.abs(z), alpha));
  }

  /** Returns the fraction of light that sheen and clear coat let pass straight. */
  double passed(SurfaceHit hit, double cosine) {
    double sheen = sheenColor(hit).max() * Sheen.albedo(cosine, sheenRoughness.fractionAt(hit));
    return (1 - sheen) * (1 - coatAlbedo(clearcoat.fractionAt(hit), cosine, coatAlpha(hit)));
  }

  private Rgb sheenColor(SurfaceHit hit) {
    return sheenColor.at(hit).clampedToOne();
  }

  private double coatAlpha(SurfaceHit hit) {
    return Math.max(MetallicBase.MIN_ALPHA, MetallicBase.alpha(clearcoatRoughness, hit));
  }

  private static double coatAlbedo(double coat, double cosine, double alpha) {
    return GgxAlbedo.of(coat * COAT_F0, coat, cosine, alpha);
  }
}
