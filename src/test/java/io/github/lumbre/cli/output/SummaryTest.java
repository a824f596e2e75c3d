package io.github.lumbre.cli.output;

import static io.github.lumbre.material.MaterialParameter.OPACITY;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.base.text.Numbers;
import io.github.lumbre.camera.Lens;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.Image;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.Matte;
import io.github.lumbre.material.MetallicRoughness;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.RenderResult;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.render.RenderStatistics.RejectedSample;
import io.github.lumbre.render.denoise.Denoised;
import io.github.lumbre.render.stopping.NoiseEstimate;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the summary of a render. */
class SummaryTest {
  private static final RenderSettings SETTINGS =
      new RenderSettings.Builder().size(4, 2).samples(10).seed(5).threads(1).build();

  private static Summary summary(boolean complete, List<RejectedSample> rejected) {
    RenderStatistics statistics =
        new RenderStatistics(40, 100, 50, rejected.size(), rejected, 0, 0, 0, 0);
    return new Summary(SETTINGS, new RenderResult(Image.black(4, 2), complete, statistics), 2, 40);
  }

  private static String lines(Consumer<Messages> print) {
    StringWriter text = new StringWriter();
    print.accept(new Messages(new PrintWriter(text)));
    return text.toString();
  }

  @Test
  void partialPicturesAreCalledThat() {
    Summary partial = summary(false, List.of());
    assertThat(lines(messages -> partial.print(Path.of("p.png"), "", "", messages)))
        .startsWith(
            "p.png: stopped early, partial picture of 4x2 pixels, 5 of 10 samples per pixel, 2.00"
                + " s")
        .contains("20 samples/s");
    assertThat(new PictureHint(partial, scene(3), Optional.empty()).ofLight()).isEmpty();
  }

  /** Films hold light from 2^-64 to 2^32; what they lose is said, unless it does not matter. */
  @ParameterizedTest
  @CsvSource({
    "0, 0, 0, ",
    "3, 0, 1, light above 2^32 was cut to 2^32 in 3 samples",
    "0, 4, 0, all light in the picture is below 1e-16",
    "0, 4, 1e-17, all light in the picture is below 1e-16",
    "0, 4, 1e-3, "
  })
  void lightThatFilmsCannotHoldIsNamed(long saturated, long faint, float light, String line) {
    RenderStatistics statistics =
        new RenderStatistics(40, 100, 50, 0, List.of(), saturated, 0, 0, 0, faint);
    float[] rgb = new float[24];
    rgb[5] = light;
    RenderResult result = new RenderResult(new Image(4, 2, rgb, new float[0]), true, statistics);
    String printed = lines(new Summary(SETTINGS, result, 2, 40)::printCutLight);
    if (line == null) {
      assertThat(printed).isEmpty();
    } else {
      assertThat(printed).startsWith("warning: " + line).hasLineCount(1);
    }
  }

  /** A short render, of 2 s, gains nothing by vectors. */
  @Test
  void longRendersSayWhyTheyUsedTheScalarKernel() {
    Supplier<Optional<String>> never =
        () -> {
          throw new AssertionError("loading the module takes time");
        };
    assertThat(summary(true, List.of()).kernelHint(never)).isEmpty();
    Supplier<Optional<String>> obstacle =
        () -> Optional.of("this Java has no module jdk.incubator.vector");
    RenderResult result = new RenderResult(Image.black(4, 2), true, RenderStatistics.ZERO);
    Summary longer = new Summary(SETTINGS, result, 11, 0);
    assertThat(longer.kernelHint(obstacle))
        .contains(
            "the scalar kernel rendered this picture, because this Java has no module"
                + " jdk.incubator.vector; on a processor with 256-bit vectors, the vector kernel"
                + " takes 10 % to 40 % less time");
    assertThat(longer.kernelHint(Optional::empty)).isEmpty();
  }

  /** Returns a scene of a sphere, at a distance in front of the camera, that covers the center. */
  private static Scene scene(double distance) {
    return scene(distance, Matte.GRAY);
  }

  private static Scene scene(double distance, Material material) {
    return Scene.builder()
        .seenBy(Lens.pinhole(60).camera(Vec3.ZERO, Frame.WORLD, 2))
        .add(new Sphere(Transform.translation(new Vec3(0, 0, distance)), 1), material)
        .build();
  }

  /** Pixels of the sphere have the luminance; those of the sky are dark or bright. */
  @ParameterizedTest
  @CsvSource({
    "2.5, .5, 0, 0, ",
    "2.5, .5, 100, 0, ",
    "2.5, 1.9, 0, 0, ",
    "2.5, 1.9, 0, 2, 7.6 times as bright as white; try --exposure -3.4",
    "2.5, 1440, 0, 0, try --exposure -13.0",
    "2.5, 1440, 0, -13, ",
    "2.5, .01, .01, 0, darker than 0.1; try --exposure auto",
    "-2.5, .01, .01, 0, nothing is in view",
    "-2.5, 5, 5, 0, nothing is in view"
  })
  void hintsNameTheCause(double distance, float luminance, float sky, double stops, String hint) {
    float[] rgb = new float[24];
    Arrays.fill(rgb, sky);
    for (int pixel : new int[] {1, 2, 5, 6}) {
      Arrays.fill(rgb, 3 * pixel, 3 * pixel + 3, luminance);
    }
    Image image = new Image(4, 2, rgb, new float[0]);
    RenderSettings settings = SETTINGS.toBuilder().exposure(Exposure.of(stops)).build();
    RenderResult result = new RenderResult(image, true, RenderStatistics.ZERO);
    Summary summary = new Summary(settings, result, 2, 0);
    Optional<String> found = new PictureHint(summary, scene(distance), Optional.empty()).ofLight();
    assertThat(found.isPresent()).isEqualTo(hint != null);
    assertThat(found.orElse("")).contains(hint == null ? "" : hint);
  }

  /** A dark or bright background does not change the exposure of the sphere. */
  @ParameterizedTest
  @CsvSource({"0, 1e-3", "1e6, 1e-3", "0, 1e6", "1, 1e6", "1e6, .3", ".5, 20"})
  void automaticExposureIsThatOfTheObjects(float sky, float luminance) {
    float[] rgb = new float[24];
    Arrays.fill(rgb, sky);
    for (int pixel : new int[] {1, 2, 5, 6}) {
      Arrays.fill(rgb, 3 * pixel, 3 * pixel + 3, luminance);
    }
    Image image = new Image(4, 2, rgb, new float[0]);
    RenderSettings settings = SETTINGS.toBuilder().exposure(Exposure.AUTO).build();
    double factor = new Visible(scene(2.5), settings).exposure(image).factor(image);
    assertThat(factor * luminance).isCloseTo(.18, within(1e-6));
    assertThat(new Visible(scene(-2.5), settings).exposure(image)).isEqualTo(Exposure.AUTO);
    assertThat(new Visible(scene(.5), settings).exposure(image)).isEqualTo(Exposure.AUTO);
  }

  /** Of pixels that the sphere covers in part, four times as many, the exposure knows nothing. */
  @ParameterizedTest
  @CsvSource({"0, .3", "1e6, .3", "1e-3, 1e6"})
  void automaticExposureIsThatOfWhollyCoveredPixels(float edge, float luminance) {
    float[] rgb = new float[96];
    Arrays.fill(rgb, edge);
    for (int pixel : new int[] {11, 12, 19, 20}) {
      Arrays.fill(rgb, 3 * pixel, 3 * pixel + 3, luminance);
    }
    assertThat(automaticFactor(rgb, scene(2.236, Matte.GRAY)) * luminance)
        .isCloseTo(.18, within(1e-6));
  }

  /** If more than half of a model is black, its other pixels decide, not the background. */
  @ParameterizedTest
  @CsvSource({"1e6, .3", "1, 1e6"})
  void automaticExposureOfAHalfBlackModelIsThatOfItsLitPart(float sky, float luminance) {
    float[] rgb = new float[96];
    Arrays.fill(rgb, sky);
    for (int pixel : new int[] {11, 12, 19, 20}) {
      Arrays.fill(rgb, 3 * pixel, 3 * pixel + 3, pixel == 11 ? luminance : 0);
    }
    assertThat(automaticFactor(rgb, scene(2.236, Matte.GRAY)) * luminance)
        .isCloseTo(.18, within(1e-6));
  }

  /** A clear surface in front of the whole picture covers nothing, unless there is nothing else. */
  @Test
  void automaticExposureLooksThroughTransparentSurfaces() {
    Material clear = MetallicRoughness.builder().set(OPACITY, .1).build();
    Sphere pane = new Sphere(Transform.IDENTITY, .5);
    float[] rgb = new float[96];
    Arrays.fill(rgb, 1e6f);
    for (int pixel : new int[] {11, 12, 19, 20}) {
      Arrays.fill(rgb, 3 * pixel, 3 * pixel + 3, .3f);
    }
    Scene both = scene(2.236, Matte.GRAY).toBuilder().add(pane, clear).build();
    assertThat(automaticFactor(rgb, both) * .3).isCloseTo(.18, within(1e-6));
    Arrays.fill(rgb, 3e3f);
    assertThat(automaticFactor(rgb, scene(2.236, clear)) * 3e3).isCloseTo(.18, within(1e-6));
  }

  /**
   * Returns the factor for a picture of 8x4 pixels; the sphere covers 4 of them wholly, 8 in part.
   */
  private static double automaticFactor(float[] rgb, Scene scene) {
    Image image = new Image(8, 4, rgb, new float[0]);
    RenderSettings settings = SETTINGS.toBuilder().size(8, 4).exposure(Exposure.AUTO).build();
    return new Visible(scene, settings).exposure(image).factor(image);
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
    Summary summary = new Summary(one, result, 2, 0);
    assertThat(lines(messages -> summary.print(Path.of("-"), Summary.perPixel("1"), "", messages)))
        .startsWith("standard output: 4x2 pixels, 1 sample per pixel, 2.00 s");
  }

  private static NoiseReport report(Optional<NoiseEstimate> noise) {
    Film film = new Film(new RenderSettings.Crop(0, 0, 1, 1), false, 0);
    return new NoiseReport(film, noise, OptionalDouble.empty(), false, "samples");
  }

  @Test
  void aBoundOfFewBrightSamplesIsSaidToBeDoubtful() {
    NoiseEstimate noise = new NoiseEstimate(.1, .2, .95, .6, 100);
    NoiseReport report = report(Optional.of(noise));
    assertThat(lines(report::printDoubts))
        .isEqualTo(
            "warning: few bright samples carry 60 % of the noise, so its bound may not hold; take"
                + " more samples\n");
    Map<String, String> metadata = new LinkedHashMap<>();
    report.putInto(metadata);
    assertThat(metadata).containsKey("NoiseDoubt");
    NoiseEstimate sound = new NoiseEstimate(.1, .2, .95, .2, 100);
    assertThat(lines(report(Optional.of(sound))::printDoubts)).isEmpty();
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
    assertThat(Numbers.rate(1_234_567, 1)).isEqualTo("1.23 M");
    assertThat(Numbers.rate(1_234_567, 10)).isEqualTo("123457");
    assertThat(Numbers.rate(5, 0)).isEqualTo("0");
  }

  /** The denoiser's estimate is named from 5 % on, where a flag with more samples can help. */
  @ParameterizedTest
  @CsvSource({
    "200, 8, .06, true",
    "200, 8, .049, false",
    "200, 100, .06, true",
    "200, 101, .9, false",
    "100, 8, .9, false"
  })
  void noisyPicturesNeedMoreSamples(int side, int samples, double error, boolean isHint) {
    RenderSettings settings =
        new RenderSettings.Builder().size(side, side).samples(samples).build();
    Image image = Image.black(side, side);
    RenderResult result = new RenderResult(image, true, RenderStatistics.ZERO);
    PictureHint hint =
        new PictureHint(new Summary(settings, result, 2, 0), scene(3), Optional.empty());
    Denoised denoised =
        new Denoised(image, "builtin", 0, OptionalDouble.empty(), OptionalDouble.of(error));
    assertThat(hint.ofNoise(Optional.of(denoised)))
        .isEqualTo(
            isHint
                ? Optional.of(
                    "the denoised picture has an error of about 6.0 %; -s 200 makes it smaller")
                : Optional.empty());
    assertThat(hint.ofNoise(Optional.empty())).isEmpty();
  }
}
