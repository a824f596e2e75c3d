package io.github.lumbre.material;

import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.texture.NormalMap;
import java.util.Objects;
import java.util.Optional;

/**
 * Any material on a surface whose normals a map perturbs.
 *
 * @param uvSet 0 or 1: the texture coordinates of the map
 */
public record NormalMapped(Material material, NormalMap map, int uvSet) implements Material {
  /** Creates a material whose map has the first texture coordinates. */
  public NormalMapped(Material material, NormalMap map) {
    this(material, map, 0);
  }

  public NormalMapped {
    Objects.requireNonNull(material, "material");
    Objects.requireNonNull(map, "map");
  }

  /** Returns nothing: perturbed normals reflect to other places than the surface's own. */
  @Override
  public Optional<Rgb> mirrorReflectance() {
    return Optional.empty();
  }

  /** Returns nothing, for the same reason. */
  @Override
  public Optional<Dielectric> clearGlass() {
    return Optional.empty();
  }

  @Override
  public boolean isUniform() {
    return material.isUniform();
  }

  @Override
  public Bsdf at(double u, double v) {
    return material.at(u, v);
  }

  @Override
  public Bsdf at(SurfaceHit hit) {
    return material.at(hit);
  }

  @Override
  public boolean isOpaque() {
    return material.isOpaque();
  }

  @Override
  public Rgb transmittance(SurfaceHit hit) {
    return material.transmittance(hit);
  }

  @Override
  public Rgb absorption() {
    return material.absorption();
  }

  @Override
  public void perturb(SurfaceHit hit) {
    material.perturb(hit);
    Vec3 local = map.normal(hit.u(uvSet), hit.v(uvSet));
    if (local.maxAbs() != 0) {
      // Normalize first, so that sums of huge components do not overflow.
      Vec3 normal = hit.toWorld(local.normalized()).normalized();
      hit.perturb(NormalMap.raised(normal, hit.geometricNormal()));
    }
  }

  @Override
  public Material simplified() {
    return new NormalMapped(material.simplified(), map, uvSet);
  }
}
