package io.github.lumbre.lab.checks;

import io.github.lumbre.camera.Lens;
import io.github.lumbre.geometry.Box;
import io.github.lumbre.geometry.Mesh;
import io.github.lumbre.geometry.Rectangle;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.Integrator;
import io.github.lumbre.integrator.PathTracer;
import io.github.lumbre.integrator.RenderContext;
import io.github.lumbre.light.DirectionalLight;
import io.github.lumbre.light.Emission;
import io.github.lumbre.material.Glass;
import io.github.lumbre.material.Matte;
import io.github.lumbre.material.Phong;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.PictureRenderer;
import io.github.lumbre.render.Progress;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.texture.ScalarTexture;
import io.github.lumbre.texture.Texture;
import java.util.List;

/** Invariants of light transport and whole pictures. */
final class PictureInvariants {
  private static final int WIDTH = 32;
  private static final int HEIGHT = 24;
  private static final int SAMPLES = 8;
  private static final int REPLICATES = 256;
  private static final int SAMPLES_EACH = 64;

  /** The relative tolerance where the standard error is 0 except for rounding. */
  private static final double ROUNDING = 1e-11;

  private PictureInvariants() {}

  static List<Invariant> all() {
    return List.of(
        new Invariant(
            "enclosure-series",
            "deviation of radiance in an enclosure from ρ (1 - ρ^N) / (1 - ρ), in standard errors",
            "reflectances 0.2 to 0.95, depths 1 to 100, with Russian roulette",
            4.8916,
            tries -> enclosures()),
        new Invariant(
            "scale-invariance",
            "pixels that change when the scene is scaled by a power of two",
            "scales 2^-30 to 2^30; matte, glossy, glass; area light, directional light, background",
            0,
            tries -> scaledDifferences()),
        new Invariant(
            "schedule-independence",
            "pixels that change with the number of threads, the bucket size or the crop window",
            "1 to 5 threads, bucket sizes 1 to 100, two crop windows",
            0,
            tries -> scheduleDifferences()),
        new Invariant(
            "film-exact",
            "pixels that change when samples are split into passes or into films that are added",
            "8 samples as 1+7, 3+5, 7+1 and one by one; films added in both orders",
            0,
            tries -> passDifferences()));
  }

  private static double enclosures() {
    double worst = 0;
    for (double reflectance : new double[] {.2, .5, .8, .95}) {
      for (int depth : new int[] {1, 2, 5, 10, 100}) {
        worst = Math.max(worst, enclosure(reflectance, depth));
      }
    }
    return worst;
  }

  /**
   * Returns the deviation in standard errors. Each vertex adds an ambient irradiance of π, and a
   * path has at most {@code depth} vertices that reflect.
   */
  private static double enclosure(double reflectance, int depth) {
    Scene scene =
        Scene.builder()
            .seenBy(Lens.pinhole(60).camera(Vec3.ZERO, Frame.WORLD, 1))
            .add(
                new Sphere(Transform.IDENTITY, 1),
                new Matte(Texture.constant(Rgb.gray(reflectance))))
            .addAmbient(Rgb.gray(Math.PI))
            .build();
    Integrator integrator = new PathTracer(scene, depth);
    Sampler sampler = new SobolSampler(41);
    RenderContext scratch = new RenderContext();
    double sum = 0;
    double squares = 0;
    for (int replicate = 0; replicate < REPLICATES; replicate++) {
      double mean = 0;
      for (int sample = 0; sample < SAMPLES_EACH; sample++) {
        sampler.startSample(replicate, 0, sample);
        Ray ray = new Ray(Vec3.ZERO, Vec3.Z);
        mean += integrator.radiance(ray, sampler, scratch).g() / SAMPLES_EACH;
      }
      sum += mean;
      squares += mean * mean;
    }
    double power = 1;
    for (int i = 0; i < depth; i++) {
      power *= reflectance;
    }
    double expected = reflectance * (1 - power) / (1 - reflectance);
    double mean = sum / REPLICATES;
    double distance = Math.abs(mean - expected);
    double variance = Math.max(0, squares / REPLICATES - mean * mean) / (REPLICATES - 1);
    return distance <= ROUNDING * expected ? 0 : distance / Math.sqrt(variance);
  }

  /** Returns a scene with many features, scaled about the origin. */
  private static Scene scene(double scale) {
    Transform whole = Transform.scale(new Vec3(scale, scale, scale));
    Texture<Rgb> white = Texture.constant(Rgb.WHITE);
    Texture<Rgb> gray = Texture.constant(Rgb.gray(.5));
    return Scene.builder()
        .seenBy(Lens.pinhole(50).camera(new Vec3(0, 1, -4).times(scale), Frame.WORLD, 4.0 / 3))
        .add(new Rectangle(whole, 20, 20, false), new Matte(gray))
        .add(
            new Sphere(whole.times(at(-1, .7, .3)), .7),
            new Glass(white, white, ScalarTexture.constant(1.5), ScalarTexture.constant(0)))
        .add(
            new Box(whole.times(at(1, .5, .5)), 1, 1, 1),
            new Phong(gray, gray, ScalarTexture.constant(20)))
        .add(Mesh.baked(Ball.of(8, .1).mesh(), whole.times(at(0, 1, 2))), new Matte(gray))
        .addAreaLight(new Sphere(whole.times(at(0, 3, -1)), .5), new Emission(white, false))
        .add(new DirectionalLight(new Vec3(.6, -.8, 0), Rgb.gray(.7)))
        .addBackground(new Rgb(.2, .3, .4))
        .build();
  }

  private static Transform at(double x, double y, double z) {
    return Transform.translation(new Vec3(x, y, z));
  }

  private static RenderSettings.Builder settings() {
    return RenderSettings.builder().size(WIDTH, HEIGHT).samples(SAMPLES).maxTraceDepth(8).seed(42);
  }

  private static Image render(Scene scene, RenderSettings settings) throws InterruptedException {
    return new PictureRenderer(settings).render(scene);
  }

  /**
   * Returns the number of pixels that differ between a window of a picture and a second picture.
   */
  private static int differences(Image whole, Image part, int x, int y) {
    int count = 0;
    for (int i = 0; i < part.width() * part.height(); i++) {
      int column = i % part.width();
      int row = Math.floorDiv(i, part.width());
      count += whole.pixel(x + column, y + row).equals(part.pixel(column, row)) ? 0 : 1;
    }
    return count;
  }

  private static double scaledDifferences() throws InterruptedException {
    Image expected = render(scene(1), settings().build());
    int count = 0;
    for (int exponent = -30; exponent <= 30; exponent += 6) {
      Image scaled = render(scene(Math.scalb(1, exponent)), settings().build());
      count += differences(expected, scaled, 0, 0);
    }
    return count;
  }

  private static double scheduleDifferences() throws InterruptedException {
    Scene scene = scene(1);
    Image expected = render(scene, settings().threads(1).build());
    int count = 0;
    for (int threads : new int[] {1, 2, 5}) {
      for (int bucket : new int[] {1, 7, 100}) {
        RenderSettings settings = settings().threads(threads).bucketSize(bucket).build();
        count += differences(expected, render(scene, settings), 0, 0);
      }
    }
    for (int x : new int[] {0, 5}) {
      RenderSettings.Crop window = new RenderSettings.Crop(x, 2 * x, 7, 9);
      count += differences(expected, render(scene, settings().crop(window).build()), x, 2 * x);
    }
    return count;
  }

  private static double passDifferences() throws InterruptedException {
    RenderSettings settings = settings().build();
    Scene scene = scene(1);
    Image expected = render(scene, settings);
    int count = 0;
    for (List<Integer> passes :
        List.of(List.of(1, 8), List.of(3, 8), List.of(7, 8), List.of(1, 2, 3, 4, 5, 6, 7, 8))) {
      FilmRenderer renderer = new FilmRenderer(settings, scene);
      Film film = renderer.newFilm();
      for (int samples : passes) {
        renderer.addSamples(film, samples, Progress.NONE);
      }
      count += differences(expected, film.develop(), 0, 0);
    }
    for (int split : new int[] {1, 3, 7}) {
      count += differences(expected, added(settings, scene, 0, split), 0, 0);
      count += differences(expected, added(settings, scene, split, 0), 0, 0);
    }
    return count;
  }

  /**
   * Renders two films, with the samples before and after a split point, and adds them.
   *
   * @param first index of the first sample of the film that receives the sum
   * @param second index of the first sample of the other film; one of the two is 0
   */
  private static Image added(RenderSettings settings, Scene scene, int first, int second)
      throws InterruptedException {
    int split = Math.max(first, second);
    FilmRenderer renderer = new FilmRenderer(settings, scene);
    Film sum = renderer.newFilm(first);
    Film other = renderer.newFilm(second);
    renderer.addSamples(sum, first == 0 ? split : SAMPLES - split, Progress.NONE);
    renderer.addSamples(other, second == 0 ? split : SAMPLES - split, Progress.NONE);
    sum.addAll(other);
    return sum.develop();
  }
}
