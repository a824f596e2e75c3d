package io.github.lumbre.lab.gallery;

import io.github.lumbre.denoise.BuiltInDenoiser;
import io.github.lumbre.denoise.Denoised;
import io.github.lumbre.denoise.NoisyPicture;
import io.github.lumbre.image.Image;
import io.github.lumbre.lab.LabHost;
import io.github.lumbre.lab.MemoryCheck;
import io.github.lumbre.lab.SceneFolder;
import io.github.lumbre.lab.TaskException;
import io.github.lumbre.lab.perf.SampleBudget;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.parser.SceneFormatException;
import io.github.lumbre.parser.SceneParser;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmLayers;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.PassResult;
import io.github.lumbre.render.Progress;
import io.github.lumbre.render.RenderResult;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.render.SampleTarget;
import io.github.lumbre.render.Schedule;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.stopping.NoiseEstimate;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;

/** Renders each scene of a gallery in about the same time. */
public final class GalleryRenderer {
  /** The share of a picture's time for the timed part of its pilot render. */
  private static final double PILOT_SHARE = .03;

  private static final double MAX_PILOT_SECONDS = 5;

  /**
   * Duration of a second pilot where the first says that the time is too short: short pilots run
   * code that is not compiled yet.
   */
  private static final double WARM_PILOT_SECONDS = 2;

  private static final double CONFIDENCE = .95;

  private final SceneFolder scenes;
  private final double seconds;
  private final int threads;
  private final boolean denoises;
  private final LabHost host;

  /**
   * @param seconds approximate time per picture
   * @param threads number of threads; 0 means one per processor
   * @param denoises whether pictures are denoised, by the built-in denoiser
   * @param host reads the scenes and shows every render
   */
  public GalleryRenderer(
      SceneFolder scenes, double seconds, int threads, boolean denoises, LabHost host) {
    this.scenes = scenes;
    this.seconds = seconds;
    this.threads = threads;
    this.denoises = denoises;
    this.host = host;
  }

  /**
   * A rendered scene.
   *
   * @param result the noisy picture
   * @param seconds rendering time, without denoising
   * @param noise estimate of the noise of the noisy picture; empty if it is unknown
   * @param denoised the denoised picture; empty if pictures are not denoised
   */
  public record Rendered(
      SceneFile file,
      RenderSettings settings,
      RenderResult result,
      double seconds,
      Optional<NoiseEstimate> noise,
      Optional<Denoised> denoised) {
    /** Returns the picture of the gallery: the denoised one, if there is one. */
    public Image picture() {
      return denoised.map(Denoised::image).orElse(result.image());
    }
  }

  /** Renders a scene; returns empty if stopped. */
  public Optional<Rendered> render(String scene)
      throws SceneFormatException, TaskException, InterruptedException {
    SceneParser parser =
        new SceneParser().overriding(inScene -> overridden(inScene.toBuilder()).build());
    SceneFile file = host.read(scenes.file(scene), parser);
    MemoryCheck.require(file.settings(), FilmLayers.of(file.settings(), file.scene()));
    OptionalDouble rate = rate(file);
    return rate.isEmpty() ? Optional.empty() : render(scene, file, rate.getAsDouble());
  }

  private RenderSettings.Builder overridden(RenderSettings.Builder settings) {
    settings.threads(threads);
    return denoises ? settings.set(Setting.LAYERS, Layer.FOR_DENOISING) : settings;
  }

  private OptionalDouble rate(SceneFile file) throws InterruptedException {
    double pilot = Math.min(PILOT_SHARE * seconds, MAX_PILOT_SECONDS);
    try (LabHost.Display display = host.display()) {
      OptionalDouble rate = SampleBudget.rate(file, pilot, display);
      boolean isSlow =
          rate.isPresent()
              && SampleBudget.leastSeconds(rate.getAsDouble(), file.settings()) > seconds;
      return isSlow && pilot < WARM_PILOT_SECONDS
          ? SampleBudget.rate(file, WARM_PILOT_SECONDS, display)
          : rate;
    }
  }

  private Optional<Rendered> render(String scene, SceneFile file, double rate)
      throws InterruptedException {
    int samples = SampleBudget.samples(rate, seconds, file.settings());
    warnIfTooShort(scene, file.settings(), rate);
    RenderSettings settings = file.settings().toBuilder().samples(samples).build();
    long start = System.nanoTime();
    FilmRenderer renderer = new FilmRenderer(settings, file.scene());
    Film film = renderer.newFilm();
    PassResult all;
    try (LabHost.Display display = host.display()) {
      all = render(renderer, film, settings, display);
    }
    if (!all.complete()) {
      return Optional.empty();
    }
    double taken = (System.nanoTime() - start) * 1e-9;
    return Optional.of(
        new Rendered(
            file,
            settings,
            new RenderResult(film.develop(), true, all.statistics()),
            taken,
            NoiseEstimate.of(film, CONFIDENCE),
            denoises ? Optional.of(denoised(film)) : Optional.empty()));
  }

  private static PassResult render(
      FilmRenderer renderer, Film film, RenderSettings settings, Progress progress)
      throws InterruptedException {
    RenderSettings.Crop window = settings.window();
    progress.started((long) window.width() * window.height() * settings.samples());
    RenderStatistics statistics = RenderStatistics.ZERO;
    Schedule schedule = renderer.schedule();
    for (Optional<SampleTarget> target = schedule.next(film);
        target.isPresent();
        target = schedule.next(film)) {
      PassResult pass = renderer.addSamples(film, target.get(), progress);
      statistics = statistics.plus(pass.statistics());
      if (!pass.complete()) {
        return new PassResult(false, statistics);
      }
    }
    return new PassResult(true, statistics);
  }

  private Denoised denoised(Film film) throws InterruptedException {
    int all = threads == 0 ? Runtime.getRuntime().availableProcessors() : threads;
    return BuiltInDenoiser.denoise(NoisyPicture.of(film), all);
  }

  /** Prints a warning if the minimum number of samples takes longer than the given time. */
  public void warnIfTooShort(String scene, RenderSettings settings, double rate) {
    double least = SampleBudget.leastSeconds(rate, settings);
    if (least > seconds) {
      host.warn(
          String.format(
              Locale.ROOT,
              "%s: --seconds %.0f is too short for the minimum of %d samples per pixel, which take"
                  + " about %.0f s",
              scene,
              seconds,
              SampleBudget.LEAST,
              Math.ceil(least)));
    }
  }
}
