package io.github.lumbre.integrator;

import io.github.lumbre.camera.ThinLensCamera;
import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.path.PathVertex.Source;
import io.github.lumbre.light.AreaLight;
import io.github.lumbre.light.Light;
import io.github.lumbre.light.LightBounds;
import io.github.lumbre.light.LightSample;
import io.github.lumbre.material.BsdfValue;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.scene.Scene;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * The lights behind the plane of focus whose blurred images are larger than themselves. Few rays
 * from random lens points meet such a light. It is therefore also sampled by itself: all rays of a
 * film point cross at one point of the plane of focus, and the line from a point of the light
 * through that crossing meets the lens in one point. Multiple importance sampling weights both
 * ways, with densities per solid angle at the crossing (Veach 1997, ch. 9). Immutable.
 *
 * <p>A grid over the plane of focus lists the lights whose blurred image covers each cell, so that
 * other lights are not selected. What the grid leaves out is left to random lens points.
 */
final class LensLights implements LightTechnique {
  /** Cells along each side of the grid. */
  private static final int SIDE = 64;

  /** The largest number of lights in all cells; beyond it, lights are left out. */
  private static final int MOST_ENTRIES = 1 << 20;

  /** Squares of extreme ratios of focus and aperture would overflow. */
  private static final double MOST_DENSITY = 1e100;

  private final Scene scene;
  private final ThinLensCamera camera;
  private final Light[] emitters;
  private final MisHeuristic heuristic;
  private final double halfWidth;
  private final double halfHeight;

  /** The area of the aperture, in world units squared. */
  private final double area;

  /** The emitters of each cell, in ascending order. */
  private final int[][] listed;

  /** The probabilities of {@link #listed}, summed up to each one and including it. */
  private final double[][] cumulative;

  private LensLights(LightSampling shared, ThinLensCamera camera, List<Image> images) {
    scene = shared.scene;
    this.camera = camera;
    emitters = shared.emitters;
    heuristic = shared.heuristic;
    Point2 half = camera.focusedHalfSize();
    halfWidth = half.x();
    halfHeight = half.y();
    area = area(camera);
    listed = new int[SIDE * SIDE][];
    cumulative = new double[SIDE * SIDE][];
    fill(images);
  }

  /**
   * Returns the lights of a scene that are worth sampling through the lens; empty if there are
   * none, or no lens, or rays pass through surfaces, or the background is transparent.
   */
  static Optional<LensLights> of(LightSampling shared) {
    if (shared.options.transparent()
        || !(shared.scene.camera() instanceof ThinLensCamera camera)
        || !camera.isBlurring()
        || !isUsable(camera.focusDistance() * camera.focusDistance() / area(camera))
        || Passing.isNeeded(shared.scene)) {
      return Optional.empty();
    }
    List<Image> images = new ArrayList<>();
    for (int i = 0; i < shared.emitters.length; i++) {
      if (shared.emitters[i] instanceof AreaLight light) {
        Image.of(i, light.bounds().orElseThrow(), camera).ifPresent(images::add);
      }
    }
    return images.isEmpty()
        ? Optional.empty()
        : Optional.of(new LensLights(shared, camera, images));
  }

  private static double area(ThinLensCamera camera) {
    return camera.aperture().area() * camera.apertureSize() * camera.apertureSize();
  }

  private static boolean isUsable(double density) {
    return density > 1 / MOST_DENSITY && density < MOST_DENSITY;
  }

  /**
   * The blurred image of a light on the plane of focus, a disk in camera space.
   *
   * @param weight estimate of the irradiance that the light gives at the center
   */
  private record Image(int emitter, double x, double y, double radius, double weight) {
    static Optional<Image> of(int emitter, LightBounds bounds, ThinLensCamera camera) {
      Vec3 center = bounds.box().center();
      Vec3 local = camera.axes().toLocal(center.minus(camera.position()));
      double radius = bounds.box().radius();
      double focus = camera.focusDistance();
      if (!(local.z() - radius > focus)) {
        return Optional.empty();
      }
      double scale = focus / local.z();
      double blur = camera.apertureSize() * (1 - scale);
      Vec3 crossing = local.times(scale);
      Vec3 way = local.minus(crossing);
      double weight = bounds.intensity() / way.dot(way);
      if (bounds.spread() < .5 * Math.PI) {
        Vec3 axis = camera.axes().toLocal(bounds.axis());
        weight *= Math.max(0, -axis.dot(way) / way.length());
      }
      boolean isWorthIt = blur > radius * scale && weight > 0 && Double.isFinite(weight);
      return isWorthIt
          ? Optional.of(
              new Image(emitter, crossing.x(), crossing.y(), blur + radius * scale, weight))
          : Optional.empty();
    }
  }

  private void fill(List<Image> images) {
    List<List<Image>> cells = new ArrayList<>();
    for (int cell = 0; cell < SIDE * SIDE; cell++) {
      cells.add(new ArrayList<>());
    }
    int entries = 0;
    for (Image image : images) {
      for (int row = cell(image.y - image.radius, halfHeight);
          row <= cell(image.y + image.radius, halfHeight);
          row++) {
        for (int column = cell(image.x - image.radius, halfWidth);
            column <= cell(image.x + image.radius, halfWidth);
            column++) {
          if (entries < MOST_ENTRIES && covers(image, column, row)) {
            cells.get(row * SIDE + column).add(image);
            entries++;
          }
        }
      }
    }
    for (int cell = 0; cell < cells.size(); cell++) {
      List<Image> here = cells.get(cell);
      listed[cell] = here.stream().mapToInt(Image::emitter).toArray();
      double[] weights = here.stream().mapToDouble(Image::weight).toArray();
      Arrays.parallelPrefix(weights, Double::sum);
      cumulative[cell] = weights;
      for (int i = 0; i < weights.length; i++) {
        weights[i] = i == weights.length - 1 ? 1 : weights[i] / weights[weights.length - 1];
      }
    }
  }

  private boolean covers(Image image, int column, int row) {
    double x = outside(image.x, column, halfWidth);
    double y = outside(image.y, row, halfHeight);
    return x * x + y * y <= image.radius * image.radius;
  }

  /** Returns how far a coordinate lies outside a column or row. */
  private static double outside(double value, int cell, double half) {
    double low = half * (2.0 * cell / SIDE - 1);
    double high = half * (2.0 * (cell + 1) / SIDE - 1);
    return Math.max(0, Math.max(low - value, value - high));
  }

  private static int cell(double value, double half) {
    double position = (value / half + 1) / 2 * SIDE;
    return (int) Math.max(0, Math.min(position, SIDE - 1));
  }

  /**
   * The point where the rays of a film point cross, and what is sampled there. Mutable; each thread
   * reuses one instance.
   */
  static final class Crossing {
    /** Whether the path's first ray is one of the camera. */
    boolean isUsed;

    /** The point in world space. */
    private double x, y, z;

    private int cell;
    private double rayPdf;

    /** The selected light, and the probability of selecting it. */
    private int emitter;

    private double probability;

    /** The lens point from which a light is seen, in world space. */
    private Vec3 lens = Vec3.ZERO;
  }

  /**
   * Moves to the crossing of a camera ray.
   *
   * @param ray origin on the lens and unit direction, in world space
   */
  private void cross(NearestHit ray, Crossing crossing) {
    Frame axes = camera.axes();
    Vec3 direction = ray.direction();
    double cosine = direction.dot(axes.normal());
    Vec3 point = ray.origin().plus(camera.focusDistance() / cosine, direction);
    Vec3 local = axes.toLocal(point.minus(camera.position()));
    crossing.x = point.x();
    crossing.y = point.y();
    crossing.z = point.z();
    crossing.cell = cell(local.y(), halfHeight) * SIDE + cell(local.x(), halfWidth);
    crossing.rayPdf = pdf(cosine);
  }

  /**
   * Samples one light through the lens of a camera ray, and adds its light that the film receives.
   */
  @Override
  public void add(int depth, Sampler sampler, RenderContext context) {
    Crossing crossing = context.crossing;
    if (!crossing.isUsed) {
      return;
    }
    LightSample light = context.scratch.light;
    cross(context.hit, crossing);
    double u = sampler.get1d(Sampler.THROUGH_LENS);
    double lensPdf = sample(u, sampler.get2d(Sampler.THROUGH_LENS + 1), crossing, light);
    if (lensPdf == 0) {
      return;
    }
    boolean isBlocked = context.isOccluded(scene, crossing.lens);
    double lightPdf = crossing.probability * light.pdf();
    double misWeight = heuristic.lightWeight(lightPdf, lensPdf);
    // The density of lens points takes the place of the BSDF.
    BsdfValue value = context.scratch.value;
    value.set(Rgb.gray(lensPdf), lensPdf);
    context.listener.lightSampled(
        Source.LENS, crossing.emitter, light, value, lightPdf, misWeight, isBlocked);
    if (!isBlocked) {
      double weight = lensPdf * misWeight / lightPdf;
      context.add(light.r() * weight, light.g() * weight, light.b() * weight);
    }
  }

  /** Returns the density per solid angle of a ray from a random lens point. */
  private double pdf(double cosine) {
    double distance = camera.focusDistance() / cosine;
    return distance * distance / (area * cosine);
  }

  /**
   * Selects a light and samples it from the crossing.
   *
   * @param u uniform in [0,1); selects the light
   * @param point uniform in [0,1)²
   * @param light receives the sample
   * @return the density per solid angle with which a random lens point draws the direction to the
   *     light; 0 if no light is found or the direction misses the lens
   */
  private double sample(double u, Point2 point, Crossing crossing, LightSample light) {
    int[] candidates = listed[crossing.cell];
    if (candidates.length == 0) {
      return 0;
    }
    double[] sums = cumulative[crossing.cell];
    int chosen = 0;
    while (chosen < candidates.length - 1 && u >= sums[chosen]) {
      chosen++;
    }
    crossing.emitter = candidates[chosen];
    crossing.probability = probability(sums, chosen);
    emitters[crossing.emitter].sample(
        crossing.x, crossing.y, crossing.z, point.x(), point.y(), light);
    return light.isEmpty() ? 0 : towards(light.wi(), crossing);
  }

  /** Sets the lens point of a direction from the crossing; returns the direction's density. */
  private double towards(Vec3 direction, Crossing crossing) {
    Frame axes = camera.axes();
    double cosine = direction.dot(axes.normal());
    if (!(cosine > 0)) {
      return 0;
    }
    Vec3 crossed = new Vec3(crossing.x, crossing.y, crossing.z);
    crossing.lens = crossed.plus(-camera.focusDistance() / cosine, direction);
    Vec3 local = axes.toLocal(crossing.lens.minus(camera.position()));
    double size = camera.apertureSize();
    return camera.aperture().contains(local.x() / size, local.y() / size) ? pdf(cosine) : 0;
  }

  /** Camera rays have a density only because they come from random points of the lens. */
  @Override
  public boolean mightFind(int depth, RenderContext context) {
    return depth == 0 && context.crossing.isUsed;
  }

  @Override
  public double rayPdf(RenderContext context) {
    return context.crossing.rayPdf;
  }

  @Override
  public double pdf(int emitter, SurfaceHit hit, RenderContext context) {
    Crossing crossing = context.crossing;
    int place = Arrays.binarySearch(listed[crossing.cell], emitter);
    if (place < 0) {
      return 0;
    }
    Vec3 crossed = new Vec3(crossing.x, crossing.y, crossing.z);
    return probability(cumulative[crossing.cell], place) * emitters[emitter].pdf(crossed, hit);
  }

  private static double probability(double[] sums, int place) {
    return place == 0 ? sums[0] : sums[place] - sums[place - 1];
  }
}
