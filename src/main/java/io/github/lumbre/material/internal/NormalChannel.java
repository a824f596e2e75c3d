package io.github.lumbre.material.internal;

import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.material.Bsdf;
import io.github.lumbre.material.Channel;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.texture.NormalMap;
import java.util.Objects;

/**
 * The normals of a surface, perturbed by a map. Immutable.
 *
 * @param uvSet 0 or 1: the texture coordinates of the map
 */
public record NormalChannel(NormalMap map, int uvSet) implements Channel {
  public NormalChannel {
    Objects.requireNonNull(map, "map");
  }

  /** Perturbs a hit's shading frame. */
  public void perturb(SurfaceHit hit) {
    Vec3 local = local(hit);
    if (local.maxAbs() != 0) {
      hit.perturb(toWorld(local, hit));
    }
  }

  /**
   * Returns a BSDF around the perturbed normal; the BSDF itself where the surface keeps its normal,
   * or if the viewer is behind the perturbed one.
   */
  public Bsdf tilted(Bsdf bsdf, SurfaceHit hit) {
    Vec3 local = local(hit);
    return local.maxAbs() == 0
        ? bsdf
        : Tilted.of(bsdf, hit.toLocal(toWorld(local, hit)), hit.toLocal(hit.wo()));
  }

  private Vec3 local(SurfaceHit hit) {
    return map.normal(hit.u(uvSet), hit.v(uvSet));
  }

  private static Vec3 toWorld(Vec3 local, SurfaceHit hit) {
    // Normalize first, so that sums of huge components do not overflow.
    Vec3 normal = hit.toWorld(local.normalized()).normalized();
    return NormalMap.raised(normal, hit.geometricNormal());
  }
}
