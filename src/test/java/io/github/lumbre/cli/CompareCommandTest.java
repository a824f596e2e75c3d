package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.google.gson.JsonObject;
import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.internal.LinearReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests {@code lumbre compare}. */
class CompareCommandTest {
  @TempDir private Path directory;
  private String half;
  private String more;

  @BeforeEach
  void writePictures() throws IOException {
    half = write("half.exr", .5f, 8, 6);
    more = write("more.pfm", .75f, 8, 6);
  }

  private String write(String name, float value, int width, int height) throws IOException {
    float[] rgb = new float[3 * width * height];
    Arrays.fill(rgb, value);
    Path file = directory.resolve(name);
    ImageWriter.write(new Image(width, height, rgb, new float[0]), file);
    return file.toString();
  }

  @Test
  void lossyAndGrayOpenExrIsCompared() {
    String gray = "src/test/resources/io/github/lumbre/image/format/exr/height.exr";
    Outcome same = Outcome.of("compare", gray, gray).done();
    assertThat(same.out()).contains("64x32 pixels: no difference");
  }

  @Test
  void figuresAreTold() {
    Outcome outcome = Outcome.of("compare", more, half).done();
    assertThat(outcome.err()).isEmpty();
    assertThat(outcome.out().lines())
        .containsExactly(
            more + " against " + half + ", 8x6 pixels, in linear light",
            "rmse    0.250000     root mean square of the difference",
            "relmse  0.240385     mean square relative to the reference; its root, 49 %, is"
                + " comparable to a render's noise",
            "bias    0.250000     mean difference: brighter than the reference",
            "p99.9   0.250000     99.9 % of the values differ by at most this",
            "max     0.250000     largest difference",
            "ssim    0.983929     structural similarity (1: identical)",
            "flip    0.352536     difference that is seen when the pictures alternate (0: none, 1:"
                + " largest)");
    assertThat(Outcome.of("compare", half, more).out())
        .contains("mean difference: darker than the reference");
    assertThat(Outcome.of("compare", half, half).out())
        .startsWith(half + " against " + half + ", 8x6 pixels: no difference\n")
        .contains("its root, 0 %,", "mean difference: as bright as the reference");
  }

  @Test
  void figuresAreToldToPrograms() {
    Outcome outcome = Outcome.of("compare", more, half, "--json", "--tolerance", "rmse=.1,bias=1");
    JsonObject values = outcome.json();
    assertThat(values.get("rmse").getAsDouble()).isEqualTo(.25);
    assertThat(values.get("relmse").getAsDouble()).isCloseTo(.0625 / .26, within(1e-9));
    assertThat(values.get("beyond")).hasToString("[\"rmse\"]");
    assertThat(outcome.exitCode()).isEqualTo(ExitCodes.DIFFERENT);
  }

  @Test
  void toleranceDecidesTheExitCode() {
    assertThat(Outcome.of("compare", more, half, "--tolerance", "rmse=.25").exitCode()).isZero();
    assertThat(Outcome.of("compare", more, half, "--tolerance", "rmse=.249").exitCode())
        .isEqualTo(ExitCodes.DIFFERENT);
    assertThat(Outcome.of("compare", half, more, "--tolerance", "bias=.2").exitCode())
        .isEqualTo(ExitCodes.DIFFERENT);
    assertThat(Outcome.of("compare", half, half, "--tolerance", "ssim=1,flip=0").exitCode())
        .isZero();
    assertThat(Outcome.of("compare", half, more, "--tolerance", "ssim=.999").out())
        .contains("outside the tolerance of 0.999");
    assertThat(Outcome.of("compare", half, half, "--tolerance", "rmse=0.0001").out())
        .contains("within the tolerance of 0.0001\n");
  }

  @Test
  void theMapIsWritten() throws IOException {
    Path map = directory.resolve("map.png");
    assertThat(Outcome.of("compare", more, half, "--error-map", map.toString()).exitCode())
        .isZero();
    assertThat(LinearReader.read(map).width()).isEqualTo(8);
  }

  @Test
  void picturesOfDifferentSizesAreAnError() throws IOException {
    String wide = write("wide.pfm", .5f, 9, 6);
    Outcome.of("compare", wide, half)
        .assertFailed(ExitCodes.USAGE, "wide.pfm has 9x6 pixels", "half.exr has 8x6");
  }

  @Test
  void whatCannotBeComparedIsAnError() throws IOException {
    Outcome.of("compare", directory + "/none.png", half)
        .assertFailed(ExitCodes.USAGE, "none.png: does not exist");
    Path text = Files.writeString(directory.resolve("text.png"), "no picture");
    Outcome.of("compare", text.toString(), half)
        .assertFailed(ExitCodes.ASSET, "expected an OpenEXR, Radiance HDR");
    byte[] file = Files.readAllBytes(Path.of(more));
    Arrays.fill(file, file.length - 4, file.length, (byte) 0xff);
    Path nan = Files.write(directory.resolve("nan.pfm"), file);
    Outcome.of("compare", nan.toString(), half)
        .assertFailed(ExitCodes.ASSET, "has NaN or infinite values");
  }

  @Test
  void wrongFlagsAreNamed() {
    Outcome.of("compare", half, half, "--tolerance", "mse=1")
        .assertFailed(ExitCodes.USAGE, "--tolerance: expected one of rmse, relmse");
    Outcome.of("compare", half, half, "--tolerance", "rmse=-1")
        .assertFailed(ExitCodes.USAGE, "--tolerance: expected numbers of at least 0");
    Outcome.of("compare", half, half, "--error-map", "map.exr")
        .assertFailed(ExitCodes.USAGE, "--error-map: expected a name that ends in .png");
  }
}
