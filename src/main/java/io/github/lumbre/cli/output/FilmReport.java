package io.github.lumbre.cli.output;

import io.github.lumbre.render.checkpoint.FilmFile;
import io.github.lumbre.render.checkpoint.FilmHeader;
import io.github.lumbre.render.checkpoint.FilmPart;
import io.github.lumbre.render.stopping.Budget;
import io.github.lumbre.render.stopping.NoiseEstimate;
import io.github.lumbre.scene.RenderSettings.Crop;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.OptionalDouble;
import java.util.stream.Collectors;

/**
 * Reports which samples a film has, when it becomes a picture or another film without a render.
 */
public record FilmReport(FilmFile file) {
  /**
   * Prints the path that was written, the size, the samples and the noise, and what is missing.
   *
   * @param summary receives what is not a warning
   */
  public void print(Path written, Messages summary, Messages messages) {
    FilmHeader header = file.header();
    Crop window = header.window();
    NoiseReport noise =
        new NoiseReport(
            file.film(),
            NoiseEstimate.of(file.film(), Budget.CONFIDENCE),
            OptionalDouble.empty(),
            false,
            "samples");
    summary.line(
        "%s: %dx%d pixels, %s%s"
            .formatted(written, window.width(), window.height(), samples(noise), noise.line()));
    if (header.hasGaps()) {
      messages.warning(written + ": samples are missing; it has " + parts());
    }
    if (noise.noise().isEmpty() && file.film().fewestSamples() > 1) {
      summary.line(
          "noise: not known; parts that meet at 2, 4, 8, ... samples per pixel, from the first on,"
              + " would keep it");
    }
    noise.printDoubts(messages);
  }

  private String samples(NoiseReport noise) {
    String each = noise.perPixel();
    int first = file.header().parts().stream().mapToInt(FilmPart::first).min().orElse(0);
    return first == 0 ? each : each + " from sample " + first;
  }

  private String parts() {
    return file.header().parts().stream()
        .sorted(Comparator.comparingInt(FilmPart::first))
        .map(FilmPart::toString)
        .collect(Collectors.joining(", and "));
  }
}
