package io.github.lumbre.material;

import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.math.Frame;
import io.github.lumbre.texture.NormalMap;
import java.util.Objects;

/** Any material on a surface whose normals a map bends. */
public record NormalMapped(Material material, NormalMap map) implements Material {
  public NormalMapped {
    Objects.requireNonNull(material, "material");
    Objects.requireNonNull(map, "map");
  }

  @Override
  public Bsdf at(SurfaceHit hit) {
    return material.at(hit);
  }

  @Override
  public Frame frame(SurfaceHit hit) {
    return map.perturb(material.frame(hit), hit.geometricNormal(), hit.texture());
  }
}
