package io.github.lumbre.lab.checks;

import io.github.lumbre.camera.Aperture;
import io.github.lumbre.camera.Camera;
import io.github.lumbre.camera.Lens;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import io.github.lumbre.texture.TexturePoint;
import io.github.lumbre.texture.internal.ImageTexture;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** Invariants of transforms, cameras, random numbers and texture coordinates. */
final class NumberInvariants {
  private static final int TRIES = 100_000;
  private static final double BELOW_ONE = 0x1.fffffffffffffp-1;

  private NumberInvariants() {}

  static List<Invariant> all() {
    return List.of(
        new Invariant(
            "transform-inverse",
            "distance of M⁻¹ M p from p, in 2^-52 × the condition number × the length of p",
            "products of translations, rotations and scales from 1e-4 to 1e4",
            64,
            NumberInvariants::inverses),
        new Invariant(
            "camera-rays",
            "deviation of directions from unit length, in 2^-52; infinite if a direction is not"
                + " finite",
            "five cameras, fields of view 1e-12° to 179.999999°, heights to 1e9, corners and edges",
            4,
            NumberInvariants::cameraRays),
        new Invariant(
            "fisheye-rim",
            "deviation of the share of samples with a ray from π/4, in standard errors",
            "100,000 points of the film",
            4.8916,
            NumberInvariants::fishEyeRim),
        new Invariant(
            "sampler-uniform",
            "χ² of binned first samples, as a normal deviate",
            "255 and 1023 degrees of freedom; pixels, dimensions and seeds",
            4.7534,
            tries -> uniformity()),
        new Invariant(
            "texture-wrap",
            "lookups more than one texel away from the correct one",
            "1000 x 999 texels, coordinates to ±1e9",
            0,
            NumberInvariants::wraps));
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
    return Stream.of(
            new Lens.Pinhole(fov),
            new Lens.ThinLens(fov, 5, .1, Aperture.DISK),
            new Lens.Cylindrical(height),
            new Lens.FishEye(fov),
            new Lens.Spherical())
        .map(lens -> lens.camera(Vec3.ZERO, axes, 1.5))
        .toList();
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

  private static double fishEyeRim(Tries tries) {
    Camera camera = new Lens.FishEye(180).camera(Vec3.ZERO, Frame.WORLD, 1);
    Sampler sampler = new SobolSampler(13);
    Draws draws = tries.draws(13);
    int imaged = 0;
    for (int i = 0; i < TRIES; i++) {
      imaged += camera.rayFor(draws.point(), sampler).isPresent() ? 1 : 0;
    }
    double share = Math.PI / 4;
    double error = Math.sqrt(share * (1 - share) / TRIES);
    return Math.abs((double) imaged / TRIES - share) / error;
  }

  private static double uniformity() {
    double worst = 0;
    for (int dimension = 0; dimension < 24; dimension += 6) {
      for (long seed = 0; seed < 3; seed++) {
        worst = Math.max(worst, uniformity(dimension, seed));
      }
    }
    return worst;
  }

  private static double uniformity(int dimension, long seed) {
    long[] line = new long[256];
    long[] square = new long[1024];
    Sampler sampler = new SobolSampler(seed);
    for (int i = 0; i < TRIES; i++) {
      // One sample per pixel, because samples of the same pixel are stratified, not independent.
      sampler.startSample(i % 400, Math.floorDiv(i, 400), 3);
      line[(int) (256 * sampler.get1d(dimension))]++;
      Point2 p = sampler.get2d(dimension + 1);
      square[(int) (32 * p.y()) * 32 + (int) (32 * p.x())]++;
    }
    return Math.max(deviate(line), deviate(square));
  }

  /** Returns the number of standard deviations of χ² above its mean (Fisher's approximation). */
  private static double deviate(long[] counts) {
    double expected = (double) TRIES / counts.length;
    double statistic = 0;
    for (long count : counts) {
      statistic += (count - expected) * (count - expected) / expected;
    }
    return Math.sqrt(2 * statistic) - Math.sqrt(2.0 * (counts.length - 1) - 1);
  }

  private static double wraps(Tries tries) {
    int width = 1000;
    int height = 999;
    short[] values = new short[3 * width * height];
    for (int i = 0; i < width * height; i++) {
      values[3 * i] = (short) (i % width);
      values[3 * i + 1] = (short) Math.floorDiv(i, width);
    }
    ImageTexture texture =
        new ImageTexture(
            Pixels.of(width, height, 3, values),
            ImageTexture.Role.DATA,
            ImageTexture.Filter.NEAREST);
    Draws draws = tries.draws(14);
    long wrong = 0;
    for (int i = 0; i < TRIES; i++) {
      double u = draws.unit();
      double v = draws.unit();
      double whole = Math.rint(draws.between(-1e9, 1e9));
      Rgb read = texture.at(new TexturePoint(u + whole, v - whole));
      int column = (int) Math.rint(read.r() * 65535);
      int row = height - 1 - (int) Math.rint(read.g() * 65535);
      wrong += isNear(column, u, width) && isNear(row, v, height) ? 0 : 1;
    }
    return wrong;
  }

  private static boolean isNear(int texel, double coordinate, int size) {
    int distance = Math.floorMod(texel - (int) (coordinate * size), size);
    return Math.min(distance, size - distance) <= 1;
  }
}
