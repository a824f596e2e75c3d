package io.github.lumbre.cli.run;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.base.text.Numbers;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.output.PictureMetadata;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.render.denoise.BuiltInDenoiser;
import io.github.lumbre.render.denoise.DenoiseException;
import io.github.lumbre.render.denoise.Denoised;
import io.github.lumbre.render.denoise.NoisyPicture;
import io.github.lumbre.render.denoise.OpenImageDenoise;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/**
 * Denoises pictures with a chosen denoiser.
 *
 * @param program the installed program; empty for the built-in denoiser
 * @param threads number of threads; 0 means one for each processor
 */
public record Denoising(Optional<OpenImageDenoise> program, int threads) {
  /**
   * The samples per pixel of a denoised picture of a model, if nothing else is asked for:
   * docs/measurements/2026-11-denoised-models.md.
   */
  public static final int MODEL_SAMPLES = 8;

  /** The same for each picture of all standard views: fewer, because seven are waited for. */
  public static final int VIEW_SAMPLES = 2;

  /** How the names of the built-in denoiser begin. */
  private static final String BUILT_IN = "builtin ";

  private static final String HOW_TO_RECORD =
      ". 'lumbre render --layers denoise' records the layers in an .exr picture or a checkpoint";

  /**
   * Says what a picture lacks that would help the built-in denoiser.
   *
   * @param name of the picture's file
   */
  public void advise(NoisyPicture noisy, String name, Messages messages) {
    List<String> missing = new ArrayList<>();
    if (noisy.albedo().isEmpty()) {
      missing.add("the layer denoisingAlbedo");
    }
    if (noisy.normal().isEmpty()) {
      missing.add("the layer denoisingNormal");
    }
    String advice = missing.isEmpty() ? "" : HOW_TO_RECORD;
    if (!noisy.light().isNoiseKnown()) {
      missing.add("its noise (2 samples in each pixel, and in an .exr file the layer variance)");
    }
    if (program.isEmpty() && !missing.isEmpty()) {
      messages.line(
          "warning: %s: lacks %s; without, less noise is removed%s"
              .formatted(name, String.join(" and ", missing), advice));
    }
  }

  /** Returns this denoiser with a number of threads; 0 means one for each processor. */
  public Denoising withThreads(int count) {
    return new Denoising(program.map(p -> p.withThreads(count)), count);
  }

  /** Returns the number of threads that are used, at least 1. */
  int usedThreads() {
    return threads > 0 ? threads : Runtime.getRuntime().availableProcessors();
  }

  /**
   * Denoises a picture.
   *
   * @throws TaskException if the denoiser fails
   * @throws InterruptedException if the thread is interrupted
   */
  public Denoised denoise(NoisyPicture noisy) throws TaskException, InterruptedException {
    try {
      return program.isPresent()
          ? program.get().denoise(noisy)
          : BuiltInDenoiser.denoise(noisy, usedThreads());
    } catch (DenoiseException e) {
      throw ExitCode.OUTPUT.failure(e.getMessage(), e);
    }
  }

  /** Returns how to write a denoised picture: the metadata of the denoiser are added. */
  public static ImageWriter.Options noting(Denoised denoised, ImageWriter.Options options) {
    Map<String, String> metadata = new LinkedHashMap<>(options.metadata());
    metadata.put(PictureMetadata.DENOISED, denoised.engine());
    metadata.put("DenoisedChange", percent(denoised.change()));
    denoised
        .relativeNoise()
        .ifPresent(noise -> metadata.put("DenoisedNoiseBefore", percent(noise)));
    denoised.relativeError().ifPresent(error -> metadata.put("DenoisedErrorAfter", percent(error)));
    return options.withMetadata(metadata);
  }

  /**
   * Returns with which errors before and after a picture was denoised, and the denoiser if it is
   * not the built-in one.
   */
  public static String line(Denoised denoised) {
    String before =
        denoised.relativeNoise().isPresent()
            ? ": estimated noise before " + Numbers.percent(denoised.relativeNoise().getAsDouble())
            : "";
    String after =
        denoised.relativeError().isPresent()
            ? ", estimated error left " + Numbers.percent(denoised.relativeError().getAsDouble())
            : "";
    String engine = denoised.engine().startsWith(BUILT_IN) ? "" : " (" + denoised.engine() + ")";
    return "denoised" + engine + before + after;
  }

  /** Returns the values of {@link #line} for the JSON summary. */
  public static Map<String, Object> values(Denoised denoised) {
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("denoiser", denoised.engine());
    values.put("change", denoised.change());
    denoised.relativeNoise().ifPresent(noise -> values.put("relative_rmse_before", noise));
    denoised.relativeError().ifPresent(error -> values.put("relative_rmse_after", error));
    return values;
  }

  private static String percent(double share) {
    return String.format(Locale.ROOT, "%.2f %%", 100 * share);
  }
}
