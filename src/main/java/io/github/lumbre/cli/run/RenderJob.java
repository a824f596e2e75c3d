package io.github.lumbre.cli.run;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.base.text.Numbers;
import io.github.lumbre.cli.output.ForecastReport;
import io.github.lumbre.cli.output.JsonSummary;
import io.github.lumbre.cli.output.LaterStep;
import io.github.lumbre.cli.output.LightReport;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.output.NoiseReport;
import io.github.lumbre.cli.output.PictureHint;
import io.github.lumbre.cli.output.PictureMetadata;
import io.github.lumbre.cli.output.PictureOutput;
import io.github.lumbre.cli.output.ReplayCommand;
import io.github.lumbre.cli.output.Summary;
import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.ImageLayer;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.PassListener;
import io.github.lumbre.render.PassLoop;
import io.github.lumbre.render.PassResult;
import io.github.lumbre.render.RenderResult;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.render.checkpoint.FilmFile;
import io.github.lumbre.render.checkpoint.FilmHeader;
import io.github.lumbre.render.checkpoint.RecordedLayers;
import io.github.lumbre.render.checkpoint.internal.FilmPicture;
import io.github.lumbre.render.internal.GuideReport;
import io.github.lumbre.render.internal.RendererInside;
import io.github.lumbre.render.stopping.Forecast;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.stage.drawing.DisplayLight;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * Renders a film until it is complete or stopped, and saves the film and the picture.
 *
 * @param scene path of the scene
 * @param report receives the result
 * @param budget limits of the render other than its samples
 * @param options of the picture and the summary
 */
public record RenderJob(
    Path scene,
    SceneFile file,
    PictureOutput picture,
    FilmKeeper keeper,
    RenderMonitor monitor,
    Messages messages,
    JsonSummary report,
    RunBudget budget,
    Options options,
    Engine engine) {
  /**
   * The options of the picture and the summary.
   *
   * @param bits bits per channel of a PNG
   * @param jpegQuality quality of a JPEG, 1 to 100
   * @param strict whether rejected samples and invalid texture coordinates are errors
   * @param denoising removes the noise from the picture; if empty, it stays
   * @param layers the layers to write if the picture's format holds layers
   * @param exposing chooses the exposure
   * @param receiver receives the picture with its lines and labels
   * @param hints receives finders of hints in the order of their weight
   * @param dithered whether an 8-bit PNG is dithered; frames that are joined into one file are not,
   *     because their still places would no longer be equal in all of them
   * @param window the frames with which the picture is denoised, and which is rendered; empty if it
   *     is denoised by itself
   */
  public record Options(
      int bits,
      int jpegQuality,
      boolean quiet,
      boolean stats,
      boolean strict,
      Optional<Denoising> denoising,
      Set<Layer> layers,
      PictureExposure exposing,
      Consumer<DisplayLight> receiver,
      Consumer<Supplier<Optional<String>>> hints,
      boolean dithered,
      Optional<FrameWindow> window) {
    /** Returns these options, with dithering or without. */
    public Options withDither(boolean isWanted) {
      return new Options(
          bits,
          jpegQuality,
          quiet,
          stats,
          strict,
          denoising,
          layers,
          exposing,
          receiver,
          hints,
          isWanted,
          window);
    }

    /** Returns these options, for a frame that is denoised with others. */
    public Options withWindow(Optional<FrameWindow> frames) {
      return new Options(
          bits,
          jpegQuality,
          quiet,
          stats,
          strict,
          denoising,
          layers,
          exposing,
          receiver,
          hints,
          dithered,
          frames);
    }
  }

  /** Renders a new film. */
  public ExitCode run(int firstSample) throws TaskException, InterruptedException {
    if (options.window().isPresent()) {
      FrameWindow.Sampled frame = options.window().get().sampled();
      return run(frame.renderer(), frame.film(), Optional.empty(), frame.statistics());
    }
    FilmRenderer renderer = new FilmRenderer(file.settings(), file.scene());
    return run(
        renderer, renderer.newFilm(firstSample), Optional.empty(), RenderStatistics.ZERO);
  }

  /** Renders the remaining samples of a film and returns the exit code. */
  public ExitCode run(FilmFile begun) throws TaskException, InterruptedException {
    budget.watch().resume(begun.film());
    FilmRenderer renderer = new FilmRenderer(file.settings(), file.scene());
    return run(
        renderer, begun.film(), Optional.of(begun.header()), begun.header().faults());
  }

  /**
   * Renders a film.
   *
   * @param header of the film's existing samples, if they are from a file
   * @param faults of the film's existing samples
   */
  private ExitCode run(
      FilmRenderer renderer, Film film, Optional<FilmHeader> header, RenderStatistics faults)
      throws TaskException, InterruptedException {
    try (monitor) {
      long start = System.nanoTime();
      boolean isForVectors = file.scene().mayChangeKernel();
      boolean isTimed = budget.secondsLeft().isPresent();
      // A frame of a window has all its samples: a cluster would get its scene again.
      Engine passing = options.window().isPresent() ? Engine.LOCAL : engine;
      PassLoop loop = new PassLoop(passing.over(scene, file, renderer, isTimed), film);
      PassResult passes;
      try {
        plan(renderer, header);
        begin(film);
        passes = loop.run(budget.watch(), new Listener(), monitor);
        monitor.busy("developing");
      } finally {
        // Save here: the JVM may exit as soon as no output is pending.
        try (keeper) {
          keeper.saveLast(film);
        }
      }
      requireSamples(film);
      RenderStatistics statistics = faults.plus(passes.statistics());
      RendererInside.of(renderer).guiding().ifPresent(g -> tell("guiding", g.text(), g.values()));
      RenderResult result = new RenderResult(film.develop(), passes.complete(), statistics);
      NoiseReport noise = budget.report(film);
      double seconds = 1e-9 * (System.nanoTime() - start);
      double before = options.window().map(window -> window.sampled().seconds()).orElse(0.);
      finish(film, result, noise, before + seconds, isForVectors);
      return exitCode(result.statistics(), noise);
    }
  }

  /**
   * Renders the pilot of guiding, if there is one, and stores the hash of its guide in the film.
   *
   * @throws TaskException if the film has samples of another guide
   */
  private void plan(FilmRenderer renderer, Optional<FilmHeader> header)
      throws TaskException, InterruptedException {
    Optional<GuideReport> guiding = RendererInside.of(renderer).plan(monitor);
    if (guiding.isEmpty()) {
      return;
    }
    String hash = guiding.get().hashText();
    if (header.isPresent()) {
      String found = header.get().identity().getOrDefault(FilmHeader.GUIDE_HASH, "nothing");
      if (!found.equals(hash)) {
        throw new TaskException(
            ExitCode.SCENE,
            "%s: the film has %s, the pilot render of --guide now has %s; the film cannot be"
                    .formatted(FilmHeader.GUIDE_HASH, found, hash)
                + " resumed, only developed: start a new one");
      }
    }
    keeper.identify(FilmHeader.GUIDE_HASH, hash);
  }

  private void begin(Film film) {
    monitor.limited(budget);
    long all = film.window().pixels() * file.settings().samples();
    monitor.started(budget.isOpen() ? 0 : Math.max(0, all - film.totalSamples()));
    monitor.film(film);
    warn(budget.doubt(film));
  }

  /** Saves the film when it is due, and shows its noise and the forecast of the first check. */
  private final class Listener implements PassListener {
    private final long start = System.nanoTime();
    private boolean isForecast;

    @Override
    public boolean isDue() {
      return keeper.isDue();
    }

    @Override
    public void passed(Film film, PassResult soFar) {
      keeper.passed(film, soFar);
      monitor.estimable(() -> budget.noise(film));
      Optional<Forecast> forecast = budget.watch().forecast();
      if (!isForecast && !budget.isOver() && forecast.isPresent()) {
        isForecast = true;
        tell(forecast.get(), (System.nanoTime() - start) * 1e-9, film);
      }
    }
  }

  private void warn(Optional<String> text) {
    if (!options.quiet()) {
      text.ifPresent(messages::line);
    }
  }

  /**
   * Prints the forecast of the rendering time after the first error check.
   *
   * @param seconds rendering time so far
   */
  private void tell(Forecast forecast, double seconds, Film film) {
    double likely = Math.min(forecast.likely(), file.settings().samples());
    if (budget.isOpen()) {
      double all = film.window().pixels() * likely;
      monitor.expected(Math.max(1, (long) all - film.totalSamples()));
    }
    if (!options.quiet()) {
      OptionalDouble left = budget.secondsLeft();
      ForecastReport told =
          new ForecastReport(
              forecast,
              seconds / film.meanSamples(),
              file.settings().samples(),
              left.isPresent()
                  ? OptionalDouble.of(seconds + left.getAsDouble())
                  : OptionalDouble.empty());
      messages.line(told.line());
    }
  }

  private void warnOfInvalidCoordinates(long points) {
    if (points != 0) {
      messages.line(
          "warning: "
              + points
              + " invalid texture coordinates (NaN or infinite) were replaced by (0, 0); reduce the"
              + " scale or offset of the texture");
    }
  }

  private static void requireSamples(Film film) {
    if (film.totalSamples() == 0) {
      throw new CancellationException("stopped without a sample");
    }
  }

  /** Does the steps after the samples, and writes the picture. */
  private void finish(
      Film film, RenderResult result, NoiseReport noise, double seconds, boolean isForVectors)
      throws TaskException, InterruptedException {
    warnOfInvalidCoordinates(result.statistics().invalidCoordinates());
    Exposure exposure = options.exposing().of(file, result.image());
    LaterSteps later = LaterSteps.of(this, film, result, exposure);
    Summary summary =
        new Summary(file.settings(), result, seconds, film.totalSamples(), later.missing());
    write(film, later, metadata(summary, exposure, noise, later.loss()));
    monitor.close();
    tell(film, summary, noise, later);
    hint(summary, later, isForVectors);
    report(summary, noise, later.loss());
    if (keeper.failure().isPresent()) {
      throw new TaskException(ExitCode.OUTPUT, keeper.failure().get());
    }
    later.denoised().requireDone();
  }

  private ExitCode exitCode(RenderStatistics statistics, NoiseReport noise) {
    if (options.strict() && statistics.rejected() != 0) {
      return ExitCode.INTERNAL;
    }
    if (options.strict() && statistics.invalidCoordinates() != 0) {
      return ExitCode.WARNINGS;
    }
    return noise.isMissed() ? ExitCode.TARGET : ExitCode.OK;
  }

  private Map<String, String> metadata(
      Summary summary, Exposure exposure, NoiseReport noise, LightReport light) {
    RenderSettings settings = file.settings();
    Map<String, String> metadata = PictureMetadata.of(scene, file, settings, summary.seconds());
    if (!summary.isComplete()) {
      metadata.put(PictureMetadata.PARTIAL, summary.progress());
    }
    options
        .window()
        .ifPresent(window -> metadata.put(PictureMetadata.DENOISED_WITH, window.note()));
    noise.putInto(metadata);
    light.putInto(metadata);
    if (settings.exposure().stops().isEmpty()) {
      exposure
          .stops()
          .ifPresent(stops -> metadata.put(PictureMetadata.CHOSEN_EXPOSURE, "" + stops));
    }
    return metadata;
  }

  /** Writes the picture, and the layers if its format has them. */
  private void write(Film film, LaterSteps later, Map<String, String> metadata)
      throws TaskException {
    monitor.busy("writing " + picture.target().getFileName());
    List<ImageLayer> layers = List.of();
    if (picture.hasLayers() && !options.layers().isEmpty()) {
      RecordedLayers recorded = RecordedLayers.of(file.settings(), file.scene());
      FilmPicture developed = FilmPicture.of(film, recorded, options.layers());
      layers = developed.layers();
      metadata.putAll(developed.metadata());
    }
    options.receiver().accept(later.light());
    picture.write(later.light().image(), layers, later.options(metadata));
  }

  private void report(Summary summary, NoiseReport noise, LightReport light) {
    report.putScene(file);
    report.put("output", picture.target().toString());
    report.putResult(summary.result(), summary.seconds());
    noise.putInto(report);
    if (!summary.isComplete()) {
      report.put("complete", false);
      report.put("missing", summary.missing().stream().map(LaterStep::key).toList());
    }
    if (!summary.isComplete() && monitor.isCancelled()) {
      String end = monitor.isOutOfTime() ? "timeout" : "signal";
      report.put("stopped_by", end);
      report.put("ended_by", end);
    }
    light.putInto(report);
  }

  /** Returns the printer of what {@code --quiet} leaves out. */
  Messages said() {
    return options.quiet() ? Messages.NONE : messages;
  }

  private static String continuation(Path film) {
    return film + ": holds the samples so far; continue with: " + ReplayCommand.resume(film);
  }

  /** Returns the warning that pixels have no sample, or only one because --time was short. */
  private Optional<String> coverage(Film film) {
    double share = film.shareWithoutSamples();
    if (share > 0) {
      return Optional.of(
          "warning: %s of the pixels have no sample and are %s"
              .formatted(
                  Numbers.percent(share), film.hasAlpha() ? "as the background" : "black"));
    }
    return budget.isOutOfTime() && film.mostSamples() == film.poses()
        ? Optional.of(
            "warning: --time was too short: only the first pass of "
                + Numbers.count(film.poses(), "sample")
                + " per pixel was rendered, which is always completed")
        : Optional.empty();
  }

  /** Returns the warning that the render ended before adaptive sampling started. */
  private Optional<String> evenness(Film film) {
    return file.settings().adaptive() && film.mostSamples() <= FilmRenderer.ADAPTIVE_PILOT
        ? Optional.of(
            ("warning: --adaptive had no effect: it chooses pixels after their first %d samples,"
                    + " and the render ended with %s per pixel")
                .formatted(
                    FilmRenderer.ADAPTIVE_PILOT, Numbers.count(film.mostSamples(), "sample")))
        : Optional.empty();
  }

  /** Reports what a pilot render chose. */
  private void tell(String name, String text, Map<String, Object> values) {
    if (!options.quiet()) {
      messages.line(text);
    }
    report.put(name, values);
  }

  private void hint(Summary summary, LaterSteps later, boolean isForVectors) {
    if (picture.isForScreen()) {
      PictureHint hint = new PictureHint(summary, file.scene(), file.parsed().model());
      options.hints().accept(hint::ofLight);
      if (!budget.isOpen()) {
        options.hints().accept(() -> hint.ofNoise(later.denoised().denoised()));
      }
    }
    if (isForVectors) {
      options.hints().accept(summary::kernelHint);
    }
  }

  private void tell(Film film, Summary summary, NoiseReport noise, LaterSteps later) {
    summary.printRejected(scene, messages);
    if (!options.quiet()) {
      summary.print(picture.target(), noise, messages);
      summary.printCutLight(messages);
      later.loss().print(messages);
      noise.printDoubts(messages);
    }
    if (options.stats()) {
      summary.printStatistics(messages);
    }
    later.denoised().tell(said(), report);
    warn(summary.isComplete() ? Optional.empty() : keeper.saved().map(RenderJob::continuation));
    warn(coverage(film));
    warn(evenness(film));
  }
}
