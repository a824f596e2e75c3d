package io.github.lumbre.material;

import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.NormalChannel;
import io.github.lumbre.texture.NormalMap;
import java.util.Objects;
import java.util.Optional;

/**
 * Any material on a surface whose normals a map perturbs. A clear coat keeps the surface's normals:
 * the map perturbs the normals of the lobes below it.
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
    return material instanceof MetallicRoughness layered && layered.isCoated(hit)
        ? layered.at(hit, new NormalChannel(map, uvSet))
        : material.at(hit);
  }

  @Override
  public boolean isOpaque() {
    return material.isOpaque();
  }

  @Override
  public boolean passesThroughGlass(SurfaceHit hit) {
    return material.passesThroughGlass(hit);
  }

  @Override
  public Rgb transmittance(SurfaceHit hit) {
    return material.transmittance(hit);
  }

  @Override
  public boolean isDispersive() {
    return material.isDispersive();
  }

  @Override
  public Rgb absorption() {
    return material.absorption();
  }

  @Override
  public void perturb(SurfaceHit hit) {
    material.perturb(hit);
    if (!(material instanceof MetallicRoughness layered && layered.isCoated(hit))) {
      new NormalChannel(map, uvSet).perturb(hit);
    }
  }

  @Override
  public Material simplified() {
    boolean isCoated = material instanceof MetallicRoughness layered && layered.mayBeCoated();
    return new NormalMapped(isCoated ? material : material.simplified(), map, uvSet);
  }
}
