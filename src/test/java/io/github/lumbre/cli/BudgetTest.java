package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.google.gson.JsonObject;
import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.image.internal.LinearReader;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests renders that end at a time limit or a target error. */
class BudgetTest extends CommandFixture {
  private Outcome render(String picture, String... flags) {
    return withScene(TinyScene.JSON, "render T/tiny.json -o T/" + picture, flags);
  }

  @Test
  void anErrorEndsARenderThatHasTheBitsOfItsSamples() throws IOException {
    Outcome outcome = render("error.pfm", "--target-error", "5%", "--json").done();
    JsonObject summary = outcome.json();
    assertThat(summary.get("ended_by").getAsString()).isEqualTo("error");
    assertThat(summary.get("target_reached").getAsBoolean()).isTrue();
    JsonObject noise = summary.getAsJsonObject("noise");
    assertThat(noise.get("at_most").getAsDouble()).isLessThanOrEqualTo(.05);
    assertThat(noise.get("relative_rmse").getAsDouble()).isPositive();
    int samples = summary.getAsJsonObject("pixel_samples").get("max").getAsInt();
    assertThat(samples).isGreaterThanOrEqualTo(32);

    assertThat(render("samples.pfm", "-s", "" + samples).exitCode()).isZero();
    assertThat(directory.resolve("error.pfm"))
        .hasSameBinaryContentAs(directory.resolve("samples.pfm"));
  }

  @Test
  void samplesMayEndItBeforeTheError() {
    Outcome outcome = render("a.png", "--target-error", "0.01%", "-s", "40");
    assertThat(outcome.exitCode()).isEqualTo(ExitCodes.TARGET);
    assertThat(outcome.err())
        .contains(
            "40 samples per pixel, noise about", "the target error of 0.010 % is not reached");
    assertThat(directory.resolve("a.png")).exists();
  }

  @Test
  void aTimeEndsARenderThatIsComplete() throws IOException {
    Outcome outcome = render("time.exr", "--time", "1s", "--json").done();
    JsonObject summary = outcome.json();
    assertThat(summary.get("complete").getAsBoolean()).isTrue();
    assertThat(summary.get("ended_by").getAsString()).isEqualTo("time");
    assertThat(summary.get("seconds").getAsDouble()).isBetween(.3, 20.0);
    byte[] file = Files.readAllBytes(directory.resolve("time.exr"));
    assertThat(new String(file, StandardCharsets.ISO_8859_1))
        .contains("NoiseBound", "with a confidence of 95 %")
        .doesNotContain("Partial");
    assertThat(LinearReader.read(directory.resolve("time.exr")).width()).isEqualTo(16);
  }

  @Test
  void adaptiveRendersTellTheSamplesOfTheirPixels() {
    Outcome outcome = render("a.exr", "-s", "128", "--adaptive", "--json").done();
    JsonObject summary = outcome.json();
    assertThat(summary.get("adaptive").getAsBoolean()).isTrue();
    JsonObject samples = summary.getAsJsonObject("pixel_samples");
    assertThat(samples.get("min").getAsInt()).isLessThan(128);
    assertThat(samples.get("max").getAsInt()).isGreaterThan(128);
    double mean = samples.get("mean").getAsDouble();
    assertThat(mean).isBetween(100.0, 128.0);
    assertThat(summary.get("samples").getAsDouble()).isEqualTo(mean * 16 * 12);
    assertThat(outcome.err()).containsPattern("\\d+ to \\d+ \\(median \\d+, mean \\S+\\) samples");

    Outcome target = render("b.exr", "--target-error", "5%", "--adaptive", "--json").done();
    assertThat(target.json().getAsJsonObject("noise").get("at_most").getAsDouble())
        .isLessThanOrEqualTo(.05);
  }

  @Test
  void clampedLightIsTold() {
    Outcome plain = render("plain.pfm", "-s", "64", "--json");
    assertThat(plain.json().has("light_clamped")).isFalse();
    Outcome outcome = render("clamped.pfm", "-s", "64", "--clamp", "0.3", "--json").done();
    JsonObject clamped = outcome.json().getAsJsonObject("light_clamped");
    double share = clamped.get("share").getAsDouble();
    assertThat(share).isBetween(.01, .99);
    assertThat(outcome.err()).contains("energy lost to clamping: ", " samples above 0.3");

    // The light that the picture lacks is the light that the clamp removed.
    double all = light("plain.pfm");
    assertThat(light("clamped.pfm")).isCloseTo(all * (1 - share), within(1e-4 * all));
    render("a.png", "--clamp", "0").assertFailed(ExitCodes.USAGE, "--clamp: expected more than 0");
  }

  private double light(String picture) {
    try {
      float[] rgb = LinearReader.read(directory.resolve(picture)).rgb();
      double light = 0;
      for (float value : rgb) {
        light += value;
      }
      return light;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Test
  void lightBeyondTheDepthIsToldOfLongRenders() {
    assertThat(render("a.png", "-s", "64", "--json").json().has("light_beyond_depth")).isFalse();
    Outcome outcome = render("a.png", "-s", "11000", "--depth", "1", "--json");
    JsonObject cut = outcome.json().getAsJsonObject("light_beyond_depth");
    assertThat(cut.get("share").getAsDouble()).isBetween(0.0, 1.0);
    assertThat(outcome.err()).contains("energy lost to the path length limit: ");
  }

  @Test
  void everyRenderTellsItsNoise() {
    assertThat(render("a.png", "-s", "16").err()).containsPattern("noise about \\S+ % \\(at most ");
    assertThat(render("a.png", "-s", "1").err()).doesNotContain("noise");
  }

  @Test
  void aQualityIsAnErrorAndADepth() throws IOException {
    Outcome outcome = render("draft.pfm", "--quality", "draft", "--json", "--bucket", "64").done();
    JsonObject summary = outcome.json();
    assertThat(summary.get("target_error").getAsDouble()).isEqualTo(.2);
    String samples = summary.getAsJsonObject("pixel_samples").get("max").getAsString();
    assertThat(render("same.pfm", "-s", samples, "--depth", "3").exitCode()).isZero();
    assertThat(directory.resolve("draft.pfm"))
        .hasSameBinaryContentAs(directory.resolve("same.pfm"));
    Outcome finer = render("a.png", "--quality", "draft", "--target-error", "5%", "--json");
    assertThat(finer.json().get("target_error").getAsDouble()).isEqualTo(.05);
  }

  @Test
  void theTimeToAnErrorIsForecast() {
    Outcome outcome = render("a.png", "--target-error", "3%");
    assertThat(outcome.err())
        .containsPattern("forecast: the target error takes about \\d+ samples per pixel \\(");
    assertThat(render("a.png", "-s", "64").err()).doesNotContain("forecast");
    assertThat(render("a.png", "-s", "64", "--target-error", "0.1%").err())
        .containsPattern("forecast: .*; it will not be reached");
  }

  /** An error that no bound can confirm ends after a documented number of samples. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "--size 1x1 --target-error 50%",
        "--size 4x4 --target-error 5%",
        "--size 7x9 --quality draft",
        "--size 4x4 --target-error 5% --adaptive",
        "--crop 2,3,4,4 --target-error 5%"
      })
  @Timeout(value = 120, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
  void framesWithoutABoundEndAtADocumentedNumberOfSamples(String flags) {
    Outcome outcome = render("a.png", (flags + " --json").split(" "));
    assertThat(outcome.exitCode()).as(outcome.err()).isEqualTo(ExitCodes.TARGET);
    assertThat(outcome.err())
        .contains(
            "frames of fewer than 64 pixels have no noise bound; the render ends after 4096 samples"
                + " per pixel",
            "is not reached: no bound: too few pixels");
    JsonObject summary = outcome.json();
    assertThat(summary.get("complete").getAsBoolean()).isTrue();
    assertThat(summary.get("ended_by").getAsString()).isEqualTo("samples");
    assertThat(summary.getAsJsonObject("pixel_samples").get("mean").getAsDouble())
        .isBetween(4096.0, 5120.0);
    assertThat(directory.resolve("a.png")).exists();
  }

  @Test
  void otherLimitsEndFramesWithoutABound() {
    Outcome samples = render("a.png", "--size", "4x4", "--target-error", "5%", "-s", "5000");
    assertThat(samples.exitCode()).isEqualTo(ExitCodes.TARGET);
    assertThat(samples.err()).contains("--samples or --time ends the render", "5000 samples per");
    Outcome large = render("a.png", "--size", "8x8", "--target-error", "20%").done();
    assertThat(large.err()).doesNotContain("has no bound");
  }

  @Test
  @Timeout(value = 120, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
  void resumedFramesWithoutABoundEndToo() {
    String film = directory.resolve("a.film").toString();
    render("a.pfm", "--size", "4x4", "-s", "100", "--checkpoint", film);
    Outcome resumed = Outcome.of("resume", film, "--target-error", "5%", "--json");
    assertThat(resumed.exitCode()).as(resumed.err()).isEqualTo(ExitCodes.TARGET);
    assertThat(resumed.json().getAsJsonObject("pixel_samples").get("max").getAsInt())
        .isEqualTo(4096);
    Outcome again = Outcome.of("resume", film, "--target-error", "5%", "--json");
    assertThat(again.exitCode()).as(again.err()).isEqualTo(ExitCodes.TARGET);
    assertThat(again.json().getAsJsonObject("pixel_samples").get("max").getAsInt()).isEqualTo(4096);
  }

  /** The time limit of 1 ms ends before the first sample, but the first pass is still completed. */
  @Test
  void everyPixelHasASampleHoweverShortTheTime() {
    Outcome outcome = render("a.png", "--size", "300x200", "--time", "0.001s", "--json").done();
    JsonObject samples = outcome.json().getAsJsonObject("pixel_samples");
    assertThat(samples.get("min").getAsInt()).isEqualTo(1);
    assertThat(samples.get("max").getAsInt()).isEqualTo(1);
    assertThat(outcome.json().get("ended_by").getAsString()).isEqualTo("time");
    assertThat(outcome.err())
        .contains("--time was too short: only the first pass of 1 sample per pixel was rendered");
  }

  @Test
  void adaptiveRendersThatEndInTheirFirstSamplesSaySo() {
    assertThat(render("a.png", "--adaptive", "-s", "32").err())
        .contains(
            "--adaptive had no effect: it chooses pixels after their first 32 samples",
            "the render ended with 32");
    assertThat(render("a.png", "--adaptive", "-s", "32", "--quiet").err()).isEmpty();
    Outcome more = render("a.png", "--adaptive", "-s", "33", "--json");
    assertThat(more.err()).doesNotContain("no effect");
    assertThat(more.json().getAsJsonObject("pixel_samples").get("max").getAsInt()).isEqualTo(64);
  }

  /** With 64x64 pixels, 4 samples are enough to check an error of 20 %. */
  @Test
  void coarseErrorsEndBefore32Samples() {
    Outcome outcome = render("a.pfm", "--size", "64x64", "--target-error", "20%", "--json").done();
    assertThat(outcome.json().getAsJsonObject("noise").get("at_most").getAsDouble())
        .isLessThanOrEqualTo(.2);
    int samples = outcome.json().getAsJsonObject("pixel_samples").get("max").getAsInt();
    assertThat(samples).isIn(4, 8, 16);

    String film = directory.resolve("a.film").toString();
    render("b.pfm", "--size", "64x64", "-s", "2", "--checkpoint", film);
    Outcome resumed = Outcome.of("resume", film, "--target-error", "20%", "--json");
    assertThat(resumed.json().getAsJsonObject("pixel_samples").get("max").getAsInt())
        .isEqualTo(samples);
    assertThat(directory.resolve("b.pfm")).hasSameBinaryContentAs(directory.resolve("a.pfm"));
    Outcome again = Outcome.of("resume", film, "--target-error", "20%", "--json");
    assertThat(again.json().getAsJsonObject("pixel_samples").get("max").getAsInt())
        .isEqualTo(samples);
  }

  @Test
  void wrongFlagsAreNamed() {
    render("a.png", "--target-error", "0.02")
        .assertFailed(ExitCodes.USAGE, "--target-error", "expected a percentage above 0");
    render("a.png", "--target-error", "2%", "--confidence", "100%")
        .assertFailed(ExitCodes.USAGE, "--confidence: expected 50% to less than 100%");
    render("a.png", "--adaptive", "--checkpoint", directory.resolve("a.film").toString())
        .assertFailed(ExitCodes.USAGE, "--adaptive: cannot be combined with --checkpoint");
    render("a.png", "--adaptive", "--samples-from", "5")
        .assertFailed(ExitCodes.USAGE, "--adaptive: cannot be combined with --checkpoint");
    render("a.png", "--time", "0s").assertFailed(ExitCodes.USAGE, "--time");
  }
}
