package io.github.lumbre.render;

import io.github.lumbre.camera.CameraRay;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.Integrator;
import io.github.lumbre.integrator.PathRecorder;
import io.github.lumbre.integrator.RenderContext;
import io.github.lumbre.path.PathVertex;
import io.github.lumbre.sampling.Sampler;
import io.github.lumbre.sampling.SobolSampler;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * Repeats single samples of a render, bit for bit, and explains them. Mutable, and confined to one
 * thread.
 */
public final class PixelReplay {
  private final Scene scene;
  private final RenderSettings settings;
  private final Sampler sampler;
  private final Integrator integrator;
  private final SampleLimit limit;
  private final PathRecorder recorder = new PathRecorder();
  private final RenderContext context = RenderContext.recordedBy(recorder);
  private final CameraRay ray = new CameraRay();

  /**
   * @param settings those of the render whose samples are repeated
   */
  public PixelReplay(Scene scene, RenderSettings settings) {
    this.scene = scene;
    this.settings = settings;
    sampler = new SobolSampler(settings.seed());
    integrator = Integrator.of(scene, settings);
    limit = SampleLimit.of(settings);
  }

  /**
   * One sample and its path.
   *
   * @param number of the sample
   * @param vertices of the path; none if the camera images nothing there
   * @param radiance as the integrator returns it: the sum of the vertices' contributions
   * @param film what is added to the film: the radiance, clamped, or black if it is rejected
   * @param rejected whether the radiance is negative or not finite
   * @param clamped whether the radiance is brighter than the settings' clamp, and scaled down to it
   */
  public record Sample(
      int number,
      List<PathVertex> vertices,
      Rgb radiance,
      Rgb film,
      boolean rejected,
      boolean clamped) {
    public Sample {
      vertices = List.copyOf(vertices);
    }
  }

  /**
   * All samples of a pixel.
   *
   * @param samples how many there are
   * @param mean over the samples, as the film sums them; where the picture has alpha, over all
   *     samples and not the covering ones alone
   * @param variance of one sample, unbiased; 0 of a single one
   * @param rejected how many count as black
   * @param firstRejected the first of those
   * @param brightest samples by their largest component, falling
   */
  public record Pixel(
      int samples,
      Rgb mean,
      Rgb variance,
      int rejected,
      List<Sample> firstRejected,
      List<Sample> brightest) {
    public Pixel {
      firstRejected = List.copyOf(firstRejected);
      brightest = List.copyOf(brightest);
    }
  }

  /**
   * Repeats one sample.
   *
   * @param x of the pixel in the full frame
   * @param y likewise
   */
  public Sample sample(int x, int y, int number) {
    context.startSample();
    if (!CameraSamples.start(scene, settings, sampler, x, y, number, ray)) {
      return new Sample(number, List.of(), Rgb.BLACK, Rgb.BLACK, false, false);
    }
    Rgb radiance = integrator.radiance(ray, sampler, context);
    return new Sample(
        number,
        recorder.vertices(),
        radiance,
        limit.apply(radiance),
        SampleLimit.isRejected(radiance),
        limit.isClamped(radiance));
  }

  /**
   * Repeats all samples of a pixel.
   *
   * @param shown how many of the brightest, and of the rejected ones, are kept, at least 0
   */
  public Pixel pixel(int x, int y, int shown) {
    Film film = new Film(new RenderSettings.Crop(0, 0, 1, 1), false, 0);
    RgbMoments moments = new RgbMoments();
    List<Sample> rejected = new ArrayList<>();
    List<Sample> brightest = new ArrayList<>();
    Comparator<Sample> byBrightness = Comparator.comparingDouble(s -> -s.film().max());
    int rejects = 0;
    for (int number = 0; number < settings.samples(); number++) {
      Sample sample = sample(x, y, number);
      film.add(0, sample.film(), true);
      moments.add(sample.film());
      if (sample.rejected() && rejects++ < shown) {
        rejected.add(sample);
      }
      if (brightest.size() < shown
          || shown > 0 && sample.film().max() > brightest.get(brightest.size() - 1).film().max()) {
        brightest.add(sample);
        brightest.sort(byBrightness);
        brightest.subList(Math.min(shown, brightest.size()), brightest.size()).clear();
      }
    }
    return new Pixel(
        settings.samples(),
        film.develop().pixel(0, 0),
        moments.variance(),
        rejects,
        rejected,
        brightest);
  }
}
