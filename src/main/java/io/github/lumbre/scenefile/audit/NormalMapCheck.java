package io.github.lumbre.scenefile.audit;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.NormalMapped;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scenefile.internal.ParsedScene;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Reports normal maps that look like color images or height maps. */
final class NormalMapCheck implements Check {
  /** The smallest mean z: normals in tangent space mostly point outward, so the map is blue. */
  private static final double LEAST_OUTWARD = .3;

  /** The largest deviation of a normal's length from 1. */
  private static final double LENGTH_TOLERANCE = .25;

  private static final double MOST_ODD = .5;

  @Override
  public List<Finding> of(ParsedScene file, Pilot pilot) {
    List<Finding> findings = new ArrayList<>();
    for (Surfaces.Used used : Surfaces.materials(file)) {
      if (used.material() instanceof NormalMapped mapped) {
        look(used, mapped, findings);
      }
    }
    return findings;
  }

  private static void look(Surfaces.Used used, NormalMapped mapped, List<Finding> findings) {
    double[] outward = new double[1];
    int[] odd = new int[1];
    Surfaces.forTexturePoints(
        point -> {
          Rgb value = mapped.map().value(point);
          double length = new Vec3(value.r(), value.g(), value.b()).length();
          outward[0] += value.b() / Surfaces.texturePoints();
          odd[0] += Math.abs(length - 1) > LENGTH_TOLERANCE ? 1 : 0;
        });
    double oddShare = (double) odd[0] / Surfaces.texturePoints();
    if (outward[0] < LEAST_OUTWARD || oddShare > MOST_ODD) {
      findings.add(
          Finding.warning(
              "normal-map",
              used.origin(),
              String.format(
                  Locale.ROOT,
                  "the mean z of the normal map is %.2f, and %.0f %% of its vectors are not of"
                      + " unit length",
                  outward[0],
                  100 * oddShare),
              "the texture looks like a color image or a height map, and perturbs normals"
                  + " arbitrarily",
              "set normalTextureId to a normal map in tangent space"));
    }
  }
}
