package io.github.lumbre.material;

import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.texture.NormalMap;
import java.util.Objects;

/** A material whose shading normals are perturbed by a normal map. */
public record NormalMapped(Material material, NormalMap map) implements Material {
  public NormalMapped {
    Objects.requireNonNull(material, "material");
    Objects.requireNonNull(map, "map");
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
  public void bend(SurfaceHit hit) {
    material.bend(hit);
    Vec3 local = map.normal(hit.u(), hit.v());
    if (local.maxAbs() != 0) {
      // Normalize first, so that sums of huge components do not overflow.
      Vec3 normal = hit.toWorld(local.normalized()).normalized();
      hit.bendTo(NormalMap.raised(normal, hit.geometricNormal()));
    }
  }

  @Override
  public Material simplified() {
    return new NormalMapped(material.simplified(), map);
  }
}
