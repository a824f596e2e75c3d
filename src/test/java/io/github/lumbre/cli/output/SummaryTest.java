package io.github.lumbre.cli.output;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.Image;
import io.github.lumbre.lab.Markdown;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.RenderResult;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.render.RenderStatistics.RejectedSample;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.stopping.NoiseEstimate;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the summary of a render. */
class SummaryTest {
  private static final RenderSettings SETTINGS =
      new RenderSettings.Builder().size(4, 2).samples(10).seed(5).build();

  private static Summary summary(boolean complete, List<RejectedSample> rejected) {
    RenderStatistics statistics =
        new RenderStatistics(40, 100, 50, rejected.size(), rejected, 0, 0, 0, 0);
    return new Summary(SETTINGS, new RenderResult(Image.black(4, 2), complete, statistics), 2);
  }

  private static String lines(Consumer<Messages> print) {
    StringWriter text = new StringWriter();
    print.accept(new Messages(new PrintWriter(text)));
    return text.toString();
  }

  @Test
  void partialPicturesAreCalledThat() {
    Summary partial = summary(false, List.of());
    assertThat(lines(messages -> partial.print(Path.of("p.png"), messages)))
        .startsWith(
            "p.png: stopped early, partial picture of 4x2 pixels, 5 of 10 samples per pixel, 2.00"
                + " s")
        .contains("20 samples/s");
    assertThat(lines(partial::printIfDark)).isEmpty();
  }

  @ParameterizedTest
  @CsvSource({
    "1, 4000, 0.125 of 4000 samples per pixel",
    "198, 4000, 24.7 of 4000 samples per pixel",
    "7999, 1000, 999 of 1000 samples per pixel",
    "98765, 20000, 12345 of 20000 samples per pixel",
    "7, 1, 0.875 of 1 sample per pixel",
    "8, 1073741824, 1 sample per pixel",
    "198, 1073741824, 24.7 samples per pixel"
  })
  void progressIsTheMeanRoundedDown(long samples, int limit, String progress) {
    RenderSettings settings = SETTINGS.toBuilder().samples(limit).build();
    RenderResult result = new RenderResult(Image.black(4, 2), false, RenderStatistics.ZERO);
    assertThat(new Summary(settings, result, 2, samples).progress()).isEqualTo(progress);
  }

  @Test
  void countsAndStandardOutputReadWell() {
    RenderSettings one = SETTINGS.toBuilder().samples(1).build();
    RenderResult result = new RenderResult(Image.black(4, 2), true, RenderStatistics.ZERO);
    Summary summary = new Summary(one, result, 2);
    assertThat(lines(messages -> summary.print(Path.of("-"), messages)))
        .startsWith("standard output: 4x2 pixels, 1 sample per pixel, 2.00 s");
  }

  @ParameterizedTest
  @CsvSource({"9, one pixel carries 60 %", "1999, one pixel carries 60 %", "2000, 0.1 % of the"})
  void fewPixelsWithMostNoiseAreCounted(long pixels, String text) {
    NoiseEstimate noise = new NoiseEstimate(.1, .2, .95, .6, pixels);
    Film film = new Film(new RenderSettings.Crop(0, 0, 4, 2), false, 0);
    NoiseReport report =
        new NoiseReport(film, Optional.of(noise), OptionalDouble.empty(), false, "samples");
    assertThat(lines(report::printDoubts)).startsWith("warning: " + text);
  }

  @Test
  void rejectedSamplesCanBeFoundAgain() {
    Summary summary = summary(true, List.of(new RejectedSample(3, 1, 9)));
    Path scene = Path.of("my scene.json");
    assertThat(lines(messages -> summary.printRejected(scene, messages)))
        .contains("warning: rejected 1 sample with", "warning: pixel 3,1 sample 9: ")
        .contains("lumbre pixel 'my scene.json' 3,1 --sample 9 --seed 5 --size 4x2 --mode path");
    Summary flawless = summary(true, List.of());
    assertThat(lines(messages -> flawless.printRejected(scene, messages))).isEmpty();
  }

  @Test
  void ratesHaveThreeDigits() {
    assertThat(Markdown.rate(1_234_567, 1)).isEqualTo("1.23 M");
    assertThat(Markdown.rate(1_234_567, 10)).isEqualTo("123457");
    assertThat(Markdown.rate(5, 0)).isEqualTo("0");
  }
}
