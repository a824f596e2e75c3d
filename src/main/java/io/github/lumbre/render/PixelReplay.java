package io.github.lumbre.render;

import io.github.lumbre.camera.CameraRay;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.PathRecorder;
import io.github.lumbre.integrator.RenderContext;
import io.github.lumbre.integrator.path.PathVertex;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Repeats single samples of a render, bit-identically, and records their paths. Mutable; confined
 * to one thread.
 */
public final class PixelReplay {
  private final RenderSettings settings;
  private final Sampler sampler;
  private final List<TracedPose> poses;
  private final SampleLimit limit;
  private final PathRecorder recorder = new PathRecorder();
  private final RenderContext context = RenderContext.recordedBy(recorder);
  private final CameraRay ray = new CameraRay();

  /**
   * Creates a replay.
   *
   * @param settings the settings of the render whose samples are repeated
   */
  public PixelReplay(Scene scene, RenderSettings settings) {
    this.settings = settings;
    sampler = new SobolSampler(settings.seed());
    poses = poses(settings, scene.framed(settings.aspect()));
    limit = SampleLimit.of(settings);
  }

  /** Returns the poses; renders the pilot even if the calling thread is interrupted. */
  private static List<TracedPose> poses(RenderSettings settings, Scene scene) {
    boolean isInterrupted = Thread.interrupted();
    IntegratorSource source = IntegratorSource.of(settings, scene);
    while (true) {
      try {
        return source.get(PilotRows.of(settings));
      } catch (InterruptedException e) {
        isInterrupted = true;
      } finally {
        if (isInterrupted) {
          Thread.currentThread().interrupt();
        }
      }
    }
  }

  /**
   * One sample and its path.
   *
   * @param number the sample's number, from 0
   * @param vertices the vertices of the path; empty if the camera has no image at this film point
   * @param radiance the integrator's result: the sum of the vertices' contributions
   * @param film the value added to the film: the radiance, scaled down if it is clamped, or black
   *     if it is rejected
   * @param rejected whether the radiance is negative or not finite
   * @param clamped whether the radiance exceeds the settings' clamp
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
   * @param samples the number of samples
   * @param seen for each primitive that the camera rays of samples hit first, by its number in the
   *     scene: the number of these samples; the primitive of most samples first
   * @param mean the mean of all samples, summed as in a film; this includes samples that do not
   *     cover a pixel with alpha
   * @param variance the unbiased variance of one sample; 0 if there is only one
   * @param rejected the number of rejected samples (negative, NaN or infinite)
   * @param firstRejected the first rejected samples
   * @param brightest the brightest samples by their largest component, in decreasing order
   */
  public record Pixel(
      int samples,
      Map<Integer, Integer> seen,
      Rgb mean,
      Rgb variance,
      int rejected,
      List<Sample> firstRejected,
      List<Sample> brightest) {
    public Pixel {
      seen = Collections.unmodifiableMap(new LinkedHashMap<>(seen));
      firstRejected = List.copyOf(firstRejected);
      brightest = List.copyOf(brightest);
    }
  }

  /**
   * Repeats one sample.
   *
   * @param x the pixel's column in the full frame
   * @param y the pixel's row in the full frame
   * @param number the sample's number, from 0
   */
  public Sample sample(int x, int y, int number) {
    context.startSample(settings.down(y));
    TracedPose pose = poses.get(number & poses.size() - 1);
    if (!CameraSamples.start(pose.scene(), settings, sampler, x, y, number, ray)) {
      return new Sample(number, List.of(), Rgb.BLACK, Rgb.BLACK, false, false);
    }
    Rgb radiance = pose.integrator().radiance(ray, sampler, context);
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
   * @param x the pixel's column in the full frame
   * @param y the pixel's row in the full frame
   * @param shown the maximum number of brightest and of rejected samples in the result, at least 0
   */
  public Pixel pixel(int x, int y, int shown) {
    Film film = new Film(new RenderSettings.Crop(0, 0, 1, 1), false, 0);
    RgbMoments moments = new RgbMoments();
    List<Sample> rejected = new ArrayList<>();
    List<Sample> brightest = new ArrayList<>();
    Comparator<Sample> byBrightness = Comparator.comparingDouble(s -> -s.film().max());
    Map<Integer, Integer> hits = new TreeMap<>();
    int rejects = 0;
    for (int number = 0; number < settings.samples(); number++) {
      Sample sample = sample(x, y, number);
      film.add(0, sample.film(), true);
      moments.add(sample.film());
      sample.vertices().stream()
          .findFirst()
          .flatMap(PathVertex::hit)
          .ifPresent(hit -> hits.merge(hit.primitive(), 1, Integer::sum));
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
    Map<Integer, Integer> seen = new LinkedHashMap<>();
    hits.entrySet().stream()
        .sorted(Comparator.comparingInt(hit -> -hit.getValue()))
        .forEach(hit -> seen.put(hit.getKey(), hit.getValue()));
    return new Pixel(
        settings.samples(),
        seen,
        film.develop().pixel(0, 0),
        moments.variance(),
        rejects,
        rejected,
        brightest);
  }
}
