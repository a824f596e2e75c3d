package io.github.lumbre.render.denoise.internal;

import io.github.lumbre.camera.CameraRay;
import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Image;
import io.github.lumbre.integrator.SampleLayers;
import io.github.lumbre.material.Bsdf;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.render.denoise.NoisyPicture;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.scene.Scene;
import java.util.Arrays;
import java.util.Optional;

/**
 * A frame that is denoised by itself, and which surface each of its pixels shows.
 *
 * <p>A pixel shows the surface that the ray through its center hits first, if the normal that the
 * denoiser was given agrees with it. It does not where the samples of a pixel hit several surfaces,
 * or what is seen is behind glass or in a mirror. Such pixels show no surface. Immutable.
 */
public final class SeenFrame {
  /** What a frame takes in memory: light, albedo, noise, and where each pixel's point is. */
  public static final int BYTES_PER_PIXEL = 12 + 12 + 4 + 4 + 4 + 8;

  /** Added to the albedo by which light is divided. */
  private static final float ALBEDO_FLOOR = .05f;

  /** The least product of the normals of what a pixel shows and of its center. */
  private static final double LEAST_AGREEMENT = .85;

  /** Pixels to each side whose noise is averaged. */
  private static final int NEAR = 2;

  /** The part of the variance that is not expected on surfaces without a diffuse lobe. */
  private static final double REFLECTING = .6;

  /** Surfaces that are passed in search of a visible one. */
  private static final int MOST_PASSED = 64;

  /** A variance that does not matter, for each square of light. */
  private static final double LEAST_VARIANCE = 1e-12;

  private static final int NONE = -1;

  /** The middle of the lens, and of everything else. */
  private static final Sampler MIDDLE =
      new Sampler() {
        @Override
        public void startSample(int x, int y, int sample) {}

        @Override
        public void startPart(int part, int parts) {}

        @Override
        public double get1d(int dimension) {
          return .5;
        }

        @Override
        public Point2 get2d(int dimension) {
          return new Point2(.5, .5);
        }
      };

  final RenderSettings settings;
  final Crop window;
  final Image image;
  final PosedSurfaces surfaces;

  /** By what light is divided, three values for each pixel. */
  final float[] divisors;

  /**
   * The variance of divided light that is left, summed over the channels. It is smaller on surfaces
   * that reflect more than their diffuse lobe does: reflections move unlike the surface, so that
   * differences in time count as changes sooner.
   */
  final float[] variances;

  /** The primitive that each pixel shows, or -1. */
  private final int[] primitives;

  private final int[] triangles;

  /** Two barycentric weights for each pixel. */
  private final float[] weights;

  private SeenFrame(RenderSettings settings, Image image, PosedSurfaces surfaces) {
    this.settings = settings;
    this.image = image;
    this.surfaces = surfaces;
    window = settings.window();
    int pixels = image.width() * image.height();
    divisors = new float[3 * pixels];
    variances = new float[pixels];
    primitives = new int[pixels];
    triangles = new int[pixels];
    weights = new float[2 * pixels];
    Arrays.fill(primitives, NONE);
  }

  /**
   * Looks at what a frame shows.
   *
   * @param noisy the frame before denoising, with guides
   * @param image the frame after denoising
   * @param left the noise that is left, of {@code BuiltInDenoiser}
   * @param like the frame before, which shares memory with this one where nothing moved
   * @throws InterruptedException if the calling thread is interrupted
   */
  public static SeenFrame of(
      Scene scene,
      RenderSettings settings,
      NoisyPicture noisy,
      Image image,
      float[] left,
      Optional<SeenFrame> like,
      int threads)
      throws InterruptedException {
    Scene framed = scene.framed(settings.aspect());
    PosedSurfaces posed = PosedSurfaces.of(framed, like.map(frame -> frame.surfaces));
    SeenFrame frame = new SeenFrame(settings, image, posed);
    frame.divideBy(noisy);
    if (noisy.normal().isPresent() && left.length > 0) {
      frame.addNoise(left, threads);
      float[] normals = noisy.normal().get().mean();
      Rows.compute(
          image.height(),
          threads,
          () -> {
            NearestHit hit = new NearestHit();
            CameraRay ray = new CameraRay();
            return y -> {
              for (int x = 0; x < image.width(); x++) {
                frame.look(framed, x, y, normals, noisy.alpha(), hit, ray);
              }
            };
          });
    }
    return frame;
  }

  private void divideBy(NoisyPicture noisy) {
    for (int i = 0; i < divisors.length; i++) {
      float albedo = noisy.albedo().isEmpty() ? 0 : noisy.albedo().get().mean()[i];
      divisors[i] = Math.max(0, Math.min(1, albedo)) + ALBEDO_FLOOR;
    }
  }

  /** Averages the noise of divided light over neighborhoods. */
  private void addNoise(float[] left, int threads) throws InterruptedException {
    float[] squares = new float[variances.length];
    for (int i = 0; i < left.length; i++) {
      double noise = (double) left[i] / divisors[i];
      squares[i / 3] += (float) (noise * noise);
    }
    Rows.compute(
        image.height(),
        threads,
        () -> {
          Sums around = new Sums(image.width(), image.height(), NEAR);
          float[] sums = new float[image.width()];
          return y -> {
            around.of(squares, y, sums);
            int rows = Math.min(y, NEAR) + Math.min(image.height() - 1 - y, NEAR) + 1;
            for (int x = 0; x < sums.length; x++) {
              int columns = Math.min(x, NEAR) + Math.min(sums.length - 1 - x, NEAR) + 1;
              variances[y * sums.length + x] = sums[x] / (rows * columns);
            }
          };
        });
  }

  /** Finds the point at the center of a pixel. */
  private void look(
      Scene scene, int x, int y, float[] normals, float[] alpha, NearestHit hit, CameraRay ray) {
    int pixel = y * image.width() + x;
    double u = (window.x() + x + .5) / settings.width();
    double v = (window.y() + y + .5) / settings.height();
    boolean isCovered = alpha.length == 0 || alpha[pixel] == 1;
    if (!isCovered || !scene.camera().aim(u, v, MIDDLE, ray)) {
      return;
    }
    hit.aim(ray.toRay());
    if (!findVisible(scene, hit) || !surfaces.isFollowed(hit.shape())) {
      return;
    }
    SurfaceHit surface = scene.surfaceAt(hit);
    Bsdf bsdf = scene.primitiveAt(hit).material().at(surface);
    if (SampleLayers.isClear(bsdf)) {
      return;
    }
    Vec3 normal = new Vec3(normals[3 * pixel], normals[3 * pixel + 1], normals[3 * pixel + 2]);
    double side = surface.shadingNormal().dot(surface.wo()) < 0 ? -1 : 1;
    if (!(side * surface.shadingNormal().dot(normal) >= LEAST_AGREEMENT)) {
      return;
    }
    Point2 at = surfaces.weights(hit.shape(), hit.element(), surface.position());
    primitives[pixel] = hit.shape();
    triangles[pixel] = hit.element();
    weights[2 * pixel] = (float) at.x();
    weights[2 * pixel + 1] = (float) at.y();
    variances[pixel] *= (float) (1 - REFLECTING * (1 - diffuseShare(bsdf)));
  }

  /** Returns the part of the reflected light that looks the same from everywhere. */
  private static double diffuseShare(Bsdf bsdf) {
    double all = bsdf.albedo().max();
    return all > 0 ? Math.min(1, bsdf.diffuseAlbedo().max() / all) : 1;
  }

  /** Finds the first surface that does not let most light straight through. */
  private static boolean findVisible(Scene scene, NearestHit hit) {
    for (int passed = 0; passed < MOST_PASSED && scene.intersect(hit); passed++) {
      SurfaceHit surface = scene.surfaceAt(hit);
      if (scene.primitiveAt(hit).material().transmittance(surface).max() <= .5) {
        return true;
      }
      hit.pass();
    }
    return false;
  }

  /** Returns whether another frame shows the same part of an equally large film. */
  public boolean hasSizeOf(SeenFrame other) {
    return window.equals(other.window)
        && settings.width() == other.settings.width()
        && settings.height() == other.settings.height();
  }

  /** Returns the primitive that a pixel shows, or -1. */
  int primitive(int pixel) {
    return primitives[pixel];
  }

  int triangle(int pixel) {
    return triangles[pixel];
  }

  /** Returns where the point of a pixel is in a pose in which its primitive has a number. */
  Vec3 point(int pixel, PosedSurfaces pose, int primitive) {
    return pose.point(primitive, triangles[pixel], weights[2 * pixel], weights[2 * pixel + 1]);
  }

  /** Returns the variance of divided light that is left out of account, as that of rounding is. */
  double leastVariance(int pixel) {
    double squares = 0;
    for (int c = 0; c < 3; c++) {
      squares += divided(pixel, c) * divided(pixel, c);
    }
    return LEAST_VARIANCE * squares;
  }

  /** Returns divided light. */
  double divided(int pixel, int channel) {
    return (double) image.rgb()[3 * pixel + channel] / divisors[3 * pixel + channel];
  }
}
