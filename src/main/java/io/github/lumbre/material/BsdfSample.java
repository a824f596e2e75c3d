package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Vec3;

/**
 * A direction drawn from a Bsdf.
 *
 * @param wi local, of unit length
 * @param weight f·|cos θi| / pdf, over all the lobes that could have drawn wi
 * @param pdf per solid angle; of a delta lobe, infinite
 */
public record BsdfSample(Vec3 wi, Rgb weight, double pdf) {
  /** The light ends here. */
  public static final BsdfSample ABSORBED = new BsdfSample(Vec3.Z, Rgb.BLACK, 0);

  /** Returns a sample of a delta lobe. */
  public static BsdfSample specular(Vec3 wi, Rgb weight) {
    return new BsdfSample(wi, weight, Double.POSITIVE_INFINITY);
  }

  public boolean isSpecular() {
    return pdf == Double.POSITIVE_INFINITY;
  }
}
