package io.github.lumbre.lab.checks;

import io.github.lumbre.camera.Aperture;
import io.github.lumbre.camera.Camera;
import io.github.lumbre.camera.CylindricalCamera;
import io.github.lumbre.camera.FishEyeCamera;
import io.github.lumbre.camera.PinholeCamera;
import io.github.lumbre.camera.SphericalCamera;
import io.github.lumbre.camera.ThinLensCamera;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.sampling.Sampler;
import io.github.lumbre.sampling.SobolSampler;
import java.util.List;
import java.util.Optional;

/** Invariants of transforms and of the rays of cameras. */
final class TransformInvariants {
  private static final int TRIES = 100_000;
  private static final double BELOW_ONE = 0x1.fffffffffffffp-1;

  private TransformInvariants() {}

  static List<Invariant> all() {
    return List.of(
        new Invariant(
            "transform-inverse",
            "distance of M⁻¹ M p from p, in 2^-52 × the condition number × the length of p",
            "products of translations, rotations and scales from 1e-4 to 1e4",
            64,
            TransformInvariants::inverses),
        new Invariant(
            "camera-rays",
            "deviation of directions from unit length, in 2^-52; infinite if a direction is not"
                + " finite",
            "five cameras, fields of view 1e-12° to 179.999999°, heights to 1e9, corners and edges",
            4,
            TransformInvariants::cameraRays));
  }

  private static double inverses(Tries tries) {
    Draws draws = tries.draws(11);
    double worst = 0;
    for (int i = 0; i < tries.times() * TRIES; i++) {
      double[] factors = new double[3];
      double least = Double.POSITIVE_INFINITY;
      double most = 0;
      for (int axis = 0; axis < 3; axis++) {
        // Random powers of two suffice; powers of ten would need a logarithm.
        factors[axis] = Math.scalb(draws.between(1, 2), draws.below(27) - 13);
        least = Math.min(least, factors[axis]);
        most = Math.max(most, factors[axis]);
      }
      Vec3 offset = draws.direction().times(10 * draws.unit());
      Vec3 angles = new Vec3(draws.between(0, 360), draws.between(0, 360), draws.between(0, 360));
      Transform transform =
          Transform.translation(offset)
              .times(Transform.rotationDegrees(angles))
              .times(Transform.scale(new Vec3(factors[0], factors[1], factors[2])));
      Vec3 p = draws.direction();
      double condition = most / least * (1 + offset.length() / most);
      double error = transform.inversePoint(transform.point(p)).minus(p).length();
      worst = Math.max(worst, error / (Invariants.EPSILON * condition));
    }
    return worst;
  }

  private static List<Camera> cameras(double fov) {
    Frame axes = Frame.WORLD;
    double height = fov < 90 ? fov : 1e9 * (fov - 90) / 90;
    return List.of(
        new PinholeCamera(Vec3.ZERO, axes, 1.5, fov),
        new ThinLensCamera(Vec3.ZERO, axes, 1.5, fov, 5, .1, Aperture.DISK),
        new CylindricalCamera(Vec3.ZERO, axes, 1.5, height),
        new FishEyeCamera(Vec3.ZERO, axes, 1.5, fov),
        new SphericalCamera(Vec3.ZERO, axes, 1.5));
  }

  private static double cameraRays(Tries tries) {
    double worst = 0;
    Sampler sampler = new SobolSampler(12);
    Draws draws = tries.draws(12);
    double[] ends = {0, 0x1p-53, .5, BELOW_ONE};
    for (double fov : new double[] {1e-12, 1e-6, 1, 90, 179, 179.999999}) {
      for (Camera camera : cameras(fov)) {
        for (int i = 0; i < TRIES / 20; i++) {
          sampler.startSample(i, 0, i);
          Point2 film = i < 16 ? new Point2(ends[i % 4], ends[Math.floorDiv(i, 4)]) : draws.point();
          Optional<Ray> ray = camera.rayFor(film, sampler);
          if (ray.isPresent()) {
            worst = Math.max(worst, deviation(ray.get()));
          }
        }
      }
    }
    return worst;
  }

  private static double deviation(Ray ray) {
    if (!ray.direction().isFinite() || !ray.origin().isFinite()) {
      return Double.POSITIVE_INFINITY;
    }
    return Math.abs(ray.direction().length() - 1) / Invariants.EPSILON;
  }
}
