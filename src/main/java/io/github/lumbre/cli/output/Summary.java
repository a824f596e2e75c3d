package io.github.lumbre.cli.output;

import io.github.lumbre.base.text.Numbers;
import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.internal.Backdrop;
import io.github.lumbre.render.MemoryEstimate;
import io.github.lumbre.render.RenderResult;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.scene.RenderSettings;
import java.lang.management.ManagementFactory;
import java.lang.management.MemoryPoolMXBean;
import java.lang.management.MemoryType;
import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Supplier;

/**
 * The summary that is printed after a render.
 *
 * @param seconds rendering time
 * @param samplesInAll number of samples of the picture, including samples of earlier runs
 * @param missing the steps after the samples that the picture lacks
 */
public record Summary(
    RenderSettings settings,
    RenderResult result,
    double seconds,
    long samplesInAll,
    Set<LaterStep> missing) {
  /** The brightest light that films hold. */
  private static final double BRIGHTEST = 0x1p32;

  /** Below this, light is coarse in films, as {@link RenderStatistics#faint} counts it. */
  private static final double FAINT = 1e-16;

  /** A render of more seconds, of all threads together, gains by the vector kernel. */
  private static final double LONG_SECONDS = 10;

  /** The number of digits of a mean number of samples. */
  private static final int DIGITS = 3;

  /** Creates the summary of a picture that has all steps after its samples. */
  public Summary(
      RenderSettings settings, RenderResult result, double seconds, long samplesInAll) {
    this(settings, result, seconds, samplesInAll, Set.of());
  }

  /** Returns whether the picture has all its samples and the steps after them. */
  public boolean isComplete() {
    return result.complete() && missing.isEmpty();
  }

  /** Prints the picture's path, its size, its samples, its noise and the rendering time. */
  public void print(Path output, NoiseReport noise, Messages messages) {
    print(output, noise.perPixel(), noise.line(), messages);
  }

  void print(Path output, String samples, String noise, Messages messages) {
    Image image = result.image();
    messages.line(
        String.format(
            Locale.ROOT,
            "%s: %s%dx%d pixels, %s%s, %.2f s, %s samples/s",
            output.equals(PictureOutput.STANDARD) ? "standard output" : output,
            (result.complete() ? "" : "stopped early, ")
                + (isComplete() ? "" : "partial picture of "),
            image.width(),
            image.height(),
            isComplete() ? samples : progress(),
            noise,
            seconds,
            Numbers.rate(result.statistics().samples(), seconds)));
  }

  /** Returns {@code 1 sample per pixel} or {@code 64 samples per pixel}. */
  static String perPixel(String samples) {
    return samples + (samples.equals("1") ? " sample" : " samples") + " per pixel";
  }

  /**
   * Returns what a partial picture has and lacks: {@code 24.7 of 4000 samples per pixel, not
   * denoised}. The mean number of finished samples is rounded down to three digits.
   */
  public String progress() {
    return LaterStep.text(sampled(), missing);
  }

  private String sampled() {
    Image image = result.image();
    long pixels = (long) image.width() * image.height();
    return sampled(samplesInAll, pixels, settings.samples());
  }

  /**
   * Returns {@code 24.7 of 4000 samples per pixel}: the mean, rounded down to three digits.
   *
   * @param samples of all pixels
   * @param limit samples per pixel of the complete picture
   */
  public static String sampled(long samples, long pixels, int limit) {
    BigDecimal mean = BigDecimal.valueOf((double) samples / pixels);
    int digits = Math.max(DIGITS, mean.precision() - mean.scale());
    String done =
        mean.round(new MathContext(digits, RoundingMode.DOWN)).stripTrailingZeros().toPlainString();
    return limit == RenderSettings.MAX_SAMPLES
        ? perPixel(done)
        : done + " of " + perPixel(String.valueOf(limit));
  }

  /** Prints the counters of the render. */
  public void printStatistics(Messages messages) {
    RenderStatistics statistics = result.statistics();
    long rays = statistics.rays() + statistics.shadowRays();
    messages.line("samples      " + statistics.samples());
    messages.line("rays         " + statistics.rays());
    messages.line("shadow rays  " + statistics.shadowRays());
    messages.line("rays/s       " + Numbers.rate(rays, seconds));
    messages.line("rejected     " + Numbers.count(statistics.rejected(), "sample"));
    messages.line("saturated    " + statistics.saturated() + " sample values");
    messages.line("threads      " + threads());
    messages.line("peak heap    " + MemoryEstimate.mebibytes(peakHeapBytes()));
  }

  /** Prints the first rejected samples, if there are any, with commands that repeat them. */
  public void printRejected(Path scene, Messages messages) {
    RenderStatistics statistics = result.statistics();
    if (statistics.rejected() == 0) {
      return;
    }
    messages.line(
        "warning: rejected "
            + Numbers.count(statistics.rejected(), "sample")
            + " with negative, NaN or infinite values, or with a ray through more than 65,536"
            + " transparent surfaces (counted as black); the first:");
    statistics
        .firstRejected()
        .forEach(
            s ->
                messages.line(
                    "warning: pixel %s,%s sample %s: %s"
                        .formatted(
                            s.x(), s.y(), s.sample(), ReplayCommand.of(scene, settings, s))));
  }

  /** Prints a warning if light is too bright or too faint for films, which cut it. */
  public void printCutLight(Messages messages) {
    RenderStatistics statistics = result.statistics();
    if (statistics.saturated() > 0 && settings.clamp() > BRIGHTEST) {
      messages.line(
          "warning: light above 2^32 was cut to 2^32 in "
              + Numbers.count(statistics.saturated(), "sample")
              + ", so that light is missing there and the noise is not known; make the lights"
              + " darker, for example by a factor in --sky-intensity");
    }
    if (statistics.faint() > 0 && brightest() < FAINT) {
      messages.line(
          "warning: all light in the picture is below 1e-16; films store light in steps of 2^-64"
              + " (5e-20), so that it is coarse or black; make the lights brighter");
    }
  }

  /** Returns the brightest value of the picture, in linear light. */
  double brightest() {
    double brightest = 0;
    Image light = light();
    for (float value : light.rgb()) {
      brightest = Math.max(brightest, value);
    }
    return brightest;
  }

  /** Returns the picture in linear light, with the background of its settings. */
  Image light() {
    return Backdrop.asLight(result.image(), settings.background());
  }

  /** Returns why a long render used the scalar kernel; empty if it is the processor. */
  public Optional<String> kernelHint() {
    return kernelHint(Kernel::moduleObstacle);
  }

  /**
   * @param obstacle is asked for after long renders only, since the answer loads the module
   */
  Optional<String> kernelHint(Supplier<Optional<String>> obstacle) {
    return seconds * threads() > LONG_SECONDS
        ? obstacle
            .get()
            .map(
                reason ->
                    "the scalar kernel rendered this picture, because "
                        + reason
                        + "; on a processor with 256-bit vectors, the vector kernel takes 10 % to"
                        + " 40 % less time")
        : Optional.empty();
  }

  private int threads() {
    return settings.threads() == 0
        ? Runtime.getRuntime().availableProcessors()
        : settings.threads();
  }

  /** Returns the sum of the heap pools' peak usages, an upper bound of the true peak. */
  static long peakHeapBytes() {
    return ManagementFactory.getMemoryPoolMXBeans().stream()
        .filter(pool -> pool.getType() == MemoryType.HEAP)
        .map(MemoryPoolMXBean::getPeakUsage)
        .mapToLong(usage -> usage.getUsed())
        .sum();
  }
}
