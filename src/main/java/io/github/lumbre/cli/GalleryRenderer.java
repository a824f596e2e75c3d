package io.github.lumbre.cli;

import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.parser.SceneFormatException;
import io.github.lumbre.parser.SceneParser;
import io.github.lumbre.render.BucketRenderer;
import io.github.lumbre.render.RenderResult;
import io.github.lumbre.scene.RenderSettings;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Supplier;

/** Renders the pictures of a gallery, each in about the same time. */
final class GalleryRenderer {
  private static final int BITS = 8;

  /** Which part of a picture's time the end of its pilot takes, and how long that is at most. */
  private static final double PILOT_SHARE = .03;

  private static final double MAX_PILOT_SECONDS = 5;

  private final SceneFolder scenes;
  private final Path directory;
  private final double seconds;
  private final int threads;
  private final Supplier<RenderMonitor> monitors;

  /**
   * @param directory of the pictures
   * @param seconds that each may take
   * @param threads of each render; 0 means one per processor
   * @param monitors gives each render one to report to
   */
  GalleryRenderer(
      SceneFolder scenes,
      Path directory,
      double seconds,
      int threads,
      Supplier<RenderMonitor> monitors) {
    this.scenes = scenes;
    this.directory = directory;
    this.seconds = seconds;
    this.threads = threads;
    this.monitors = monitors;
  }

  /**
   * Renders a scene and writes its picture; returns how it was made, or nothing if that was stopped
   * and an older picture is as it was.
   */
  Optional<GalleryPage.Entry> render(String scene, Messages messages)
      throws SceneFormatException, CommandException, InterruptedException {
    try (PictureOutput output = PictureOutput.reserve(GalleryPage.picture(directory, scene))) {
      SceneParser parser =
          new SceneParser().overriding(inScene -> inScene.toBuilder().threads(threads).build());
      SceneFile file;
      try (RenderMonitor monitor = monitors.get()) {
        Path path = scenes.file(scene);
        file = monitor.reading(path, () -> SceneFolder.load(path, parser, messages));
      }
      MemoryEstimate.require(file.settings());
      OptionalDouble rate = rate(file);
      return rate.isEmpty()
          ? Optional.empty()
          : render(scene, file, rate.getAsDouble(), output, messages);
    }
  }

  private OptionalDouble rate(SceneFile file) throws InterruptedException {
    double pilot = Math.min(PILOT_SHARE * seconds, MAX_PILOT_SECONDS);
    try (RenderMonitor monitor = monitors.get()) {
      return SampleBudget.rate(file, pilot, monitor);
    }
  }

  private Optional<GalleryPage.Entry> render(
      String scene, SceneFile file, double rate, PictureOutput output, Messages messages)
      throws CommandException, InterruptedException {
    int samples = SampleBudget.samples(rate, seconds, file.settings());
    warnIfTooShort(scene, file.settings(), rate, messages);
    RenderSettings settings = file.settings().toBuilder().samples(samples).build();
    long start = System.nanoTime();
    RenderResult result;
    try (RenderMonitor monitor = monitors.get()) {
      result = new BucketRenderer(settings).render(file.scene(), monitor);
    }
    double taken = (System.nanoTime() - start) * 1e-9;
    if (!result.complete()) {
      return Optional.empty();
    }
    Map<String, String> metadata = PictureMetadata.of(scenes.file(scene), file, settings, taken);
    output.write(
        result.image(),
        new ImageWriter.Options(settings.exposure(), settings.toneCurve(), BITS, metadata));
    Summary summary = new Summary(settings, result, taken);
    summary.printRejected(scenes.file(scene), messages);
    summary.print(output.target(), messages);
    Hardware hardware = Hardware.here();
    String size = result.image().width() + "x" + result.image().height();
    return Optional.of(
        new GalleryPage.Entry(
            scene,
            size,
            samples,
            taken,
            settings.threads() == 0 ? hardware.cores() : settings.threads(),
            hardware));
  }

  /** Prints a warning if the fewest samples of a gallery take longer than the time. */
  void warnIfTooShort(String scene, RenderSettings settings, double rate, Messages messages) {
    double least = SampleBudget.leastSeconds(rate, settings);
    if (least > seconds) {
      messages.line(
          String.format(
              Locale.ROOT,
              "warning: %s: --seconds %.0f is too short for %d samples per pixel, the fewest of a"
                  + " gallery; they take about %.0f s",
              scene,
              seconds,
              SampleBudget.LEAST,
              Math.ceil(least)));
    }
  }
}
