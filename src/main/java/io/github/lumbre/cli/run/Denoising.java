package io.github.lumbre.cli.run;

import io.github.lumbre.cli.output.JsonSummary;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.output.PictureOutput;
import io.github.lumbre.denoise.BuiltInDenoiser;
import io.github.lumbre.denoise.DenoiseException;
import io.github.lumbre.denoise.Denoised;
import io.github.lumbre.denoise.NoisyPicture;
import io.github.lumbre.denoise.OpenImageDenoise;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.lab.Numbers;
import io.github.lumbre.lab.TaskException;
import io.github.lumbre.lab.TaskException.Kind;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/**
 * Denoises pictures with a chosen denoiser and writes them.
 *
 * @param program the installed program; empty for the built-in denoiser
 * @param threads number of threads; 0 means one for each processor
 */
public record Denoising(Optional<OpenImageDenoise> program, int threads) {
  private static final String HOW_TO_RECORD =
      "; without, less noise is removed. --denoise, or --layers denoise into an .exr picture or a"
          + " checkpoint, records all";

  /** Returns the path of the denoised picture beside a noisy one: x.denoised.png for x.png. */
  public static Path beside(Path noisy) {
    String name = noisy.getFileName().toString();
    int dot = name.lastIndexOf('.');
    return noisy.resolveSibling(name.substring(0, dot) + ".denoised" + name.substring(dot));
  }

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
    if (!noisy.light().isNoiseKnown()) {
      missing.add("its noise (2 samples in each pixel, and in an .exr file the layer variance)");
    }
    if (program.isEmpty() && !missing.isEmpty()) {
      messages.line(
          "warning: %s: lacks %s%s".formatted(name, String.join(" and ", missing), HOW_TO_RECORD));
    }
  }

  /**
   * Denoises a picture and writes it.
   *
   * @param options how to write it; the metadata of the denoiser are added
   * @param kept where the noisy picture is, for messages
   * @throws TaskException if the denoiser fails or the picture cannot be written
   */
  public void write(
      NoisyPicture noisy,
      PictureOutput output,
      ImageWriter.Options options,
      String kept,
      Messages messages,
      JsonSummary report)
      throws TaskException {
    Denoised denoised = denoised(noisy, kept);
    Map<String, String> metadata = new LinkedHashMap<>(options.metadata());
    metadata.putAll(metadata(denoised));
    output.write(denoised.image(), List.of(), options.withMetadata(metadata));
    String noise =
        denoised.relativeNoise().isPresent()
            ? ", noise before roughly " + Numbers.percent(denoised.relativeNoise().getAsDouble())
            : "";
    String error =
        denoised.relativeError().isPresent()
            ? ", error left roughly %s; not comparable with the noise of the render"
                .formatted(Numbers.percent(denoised.relativeError().getAsDouble()))
            : "";
    messages.line(
        "%s: denoised (%s): %s changed%s%s"
            .formatted(
                output.target(), denoised.engine(), percent(denoised.change()), noise, error));
    report.put("denoised", output.target().toString());
    report.put("denoiser", denoised.engine());
  }

  /** Returns the metadata of a denoised picture: by what, and how strongly it was changed. */
  public static Map<String, String> metadata(Denoised denoised) {
    Map<String, String> metadata = new LinkedHashMap<>();
    metadata.put("Denoiser", denoised.engine());
    metadata.put("DenoiserChange", percent(denoised.change()));
    denoised
        .relativeNoise()
        .ifPresent(noise -> metadata.put("DenoiserNoiseBefore", percent(noise)));
    denoised
        .relativeError()
        .ifPresent(error -> metadata.put("DenoiserErrorEstimate", percent(error)));
    return metadata;
  }

  private Denoised denoised(NoisyPicture noisy, String kept) throws TaskException {
    int all = threads > 0 ? threads : Runtime.getRuntime().availableProcessors();
    try {
      return program.isPresent()
          ? program.get().denoise(noisy)
          : BuiltInDenoiser.denoise(noisy, all);
    } catch (DenoiseException e) {
      throw new TaskException(Kind.OUTPUT, e.getMessage() + "; the noisy picture is " + kept, e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new TaskException(Kind.STOPPED, "stopped; the noisy picture is " + kept, e);
    }
  }

  private static String percent(double share) {
    return String.format(Locale.ROOT, "%.2f %%", 100 * share);
  }
}
