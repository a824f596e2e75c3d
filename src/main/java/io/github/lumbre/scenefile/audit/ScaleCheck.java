package io.github.lumbre.scenefile.audit;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import io.github.lumbre.scenefile.internal.ParsedScene;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** Reports objects that are too small, relative to the largest coordinate, for double precision. */
final class ScaleCheck implements Check {
  /** Up to this ratio, rounding errors stay below the precision of an image. */
  private static final double ENVELOPE = 1e9;

  @Override
  public List<Finding> of(ParsedScene file, Pilot pilot) {
    double farthest = cameraDistance(file);
    double smallest = Double.POSITIVE_INFINITY;
    int far = -1;
    int small = -1;
    for (int i = 0; i < file.scene().primitives().size(); i++) {
      Bounds3 bounds = file.scene().primitives().get(i).shape().bounds();
      if (!bounds.isFinite() || bounds.isEmpty()) {
        continue;
      }
      double reach = Math.max(bounds.min().maxAbs(), bounds.max().maxAbs());
      double size = 2 * bounds.radius();
      if (reach > farthest) {
        farthest = reach;
        far = i;
      }
      if (size < smallest) {
        smallest = size;
        small = i;
      }
    }
    if (small < 0 || farthest / smallest <= ENVELOPE) {
      return List.of();
    }
    String whose = far < 0 ? "the camera" : file.origins().primitives().get(far).toString();
    return List.of(
        Finding.warning(
            "scale",
            file.origins().primitives().get(small),
            String.format(
                Locale.ROOT,
                "the object's size is %.3g, but coordinates reach %.3g (%s): a ratio of 1 to %.3g",
                smallest,
                farthest,
                whose,
                farthest / smallest),
            "beyond a ratio of 1 to 1e9, rounding may distort its shadows and outlines",
            "move the objects closer together, or the whole scene closer to the origin"));
  }

  private static double cameraDistance(ParsedScene file) {
    Sampler sampler = new SobolSampler(file.settings().seed());
    sampler.startSample(0, 0, 0);
    Optional<Ray> ray = file.scene().camera().rayFor(new Point2(.5, .5), sampler);
    return ray.map(r -> r.origin().maxAbs()).orElse(0.0);
  }
}
