package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonObject;
import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.image.internal.LinearReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Arrays;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Pictures of models for the screen are denoised by default, and others are not. */
class DenoisedModelsTest extends CommandFixture {
  private static final String SMALL = " --size 24x18 -s 4";
  private static final String DENOISED = "denoised: ";

  @BeforeEach
  void writeModel() throws IOException {
    ModelSample.write(directory);
  }

  private float[] light(String name) throws IOException {
    return LinearReader.read(directory.resolve(name)).rgb();
  }

  @ParameterizedTest
  @ValueSource(strings = {"png", "jpg"})
  void picturesForTheScreenAreDenoised(String ending) throws IOException {
    String model = "render T/sample.glb" + SMALL + " -o T/";
    assertThat(said(model + "a." + ending)).contains(DENOISED);
    assertThat(said(model + "same." + ending + " --denoise")).contains(DENOISED);
    assertThat(said(model + "noisy." + ending + " --no-denoise")).doesNotContain("denoised");
    assertThat(pixels("same." + ending)).isEqualTo(pixels("a." + ending));
    assertThat(pixels("noisy." + ending)).isNotEqualTo(pixels("a." + ending));
  }

  @ParameterizedTest
  @ValueSource(strings = {"exr", "pfm"})
  void linearPicturesKeepTheirNoise(String ending) throws IOException {
    String model = "render T/sample.glb" + SMALL + " -o T/";
    assertThat(said(model + "a." + ending)).doesNotContain("denoised");
    runs(model + "noisy." + ending + " --no-denoise");
    assertThat(said(model + "clean." + ending + " --denoise")).contains(DENOISED);
    assertThat(light("a." + ending))
        .isEqualTo(light("noisy." + ending))
        .isNotEqualTo(light("clean." + ending));
  }

  @Test
  void anImportedSceneHasTheNoisyPicture() throws IOException {
    runs("import T/sample.glb -o T/scene.json");
    assertThat(said("render T/scene.json -o T/scene.png" + SMALL)).doesNotContain("denoised");
    runs("render T/sample.glb -o T/noisy.png --no-denoise" + SMALL);
    assertThat(pixels("scene.png")).isEqualTo(pixels("noisy.png"));
  }

  /** With a checkpoint file, the picture equals the one that commands make of the file. */
  @Test
  void filmsAndTheirPicturesKeepTheirNoise() throws IOException {
    String model = "render T/sample.glb --size 24x18";
    runs(model + " -s 4 -o T/noisy.png --no-denoise");
    assertThat(said(model + " -s 4 -o T/a.png --checkpoint T/a.film")).doesNotContain("denoised");
    assertThat(pixels("a.png")).isEqualTo(pixels("noisy.png"));
    runs(model + " -s 2 -o T/r.png --checkpoint T/r.film");
    assertThat(said("resume T/r.film -s 4")).doesNotContain("denoised");
    assertThat(pixels("r.png")).isEqualTo(pixels("noisy.png"));
    for (int i = 0; i < 2; i++) {
      runs(model + " -s 4 -o T/part.png --share I/2 --checkpoint T/I.film".replace("I", "" + i));
    }
    assertThat(said("merge T/0.film T/1.film -o T/merged.png")).doesNotContain("denoised");
    assertThat(pixels("merged.png")).isEqualTo(pixels("noisy.png"));
    runs("develop T/a.film -o T/developed.png");
    assertThat(pixels("developed.png")).isEqualTo(pixels("noisy.png"));
    assertThat(said(model + " -s 4 -o T/b.png --checkpoint T/b.film --denoise")).contains(DENOISED);
    runs(model + " -s 4 -o T/clean.png");
    assertThat(pixels("b.png")).isEqualTo(pixels("clean.png"));
  }

  @Test
  void rayModeHasNoNoiseToRemove() throws IOException {
    String model = "render T/sample.glb --mode ray" + SMALL + " -o T/";
    assertThat(said(model + "a.png")).doesNotContain("denoised");
    runs(model + "noisy.png --no-denoise");
    assertThat(pixels("a.png")).isEqualTo(pixels("noisy.png"));
  }

  @Test
  void viewsAndTurntablesAreDenoised() throws IOException {
    runs("views T/sample.glb -o T/views" + SMALL);
    assertThat(said("views T/sample.glb -o T/noisy --no-denoise" + SMALL))
        .doesNotContain("denoised");
    for (String views : new String[] {"", "--no-denoise "}) {
      String folder = views.isEmpty() ? "views" : "noisy";
      runs("render T/sample.glb --view iso -o T/iso.png --overwrite " + views + SMALL.strip());
      assertThat(pixels(folder + "/iso.png")).isEqualTo(pixels("iso.png"));
    }
    assertThat(pixels("views/views.png")).isNotEqualTo(pixels("noisy/views.png"));
    String turned = said("render T/sample.glb --view iso --turntable 2 -o T/turn.png" + SMALL);
    assertThat(turned).contains("2 of 2 pictures written, denoised: ");
    assertThat(
            said("render T/sample.glb --view iso --turntable 2 --no-denoise -o T/no.png" + SMALL))
        .contains("2 of 2 pictures written: ");
    for (String frame : new String[] {"000", "001"}) {
      assertThat(pixels("turn-" + frame + ".png")).isNotEqualTo(pixels("no-" + frame + ".png"));
    }
  }

  @Test
  void eachOfSeveralInputsFollowsTheRule() throws IOException {
    runs("import T/sample.glb -o T/scene.json");
    runs("render T/sample.glb -o T/clean.png" + SMALL);
    runs("render T/scene.json -o T/noisy.png" + SMALL);
    for (String inputs : new String[] {"T/sample.glb T/scene.json", "T/scene.json T/sample.glb"}) {
      runs("render " + inputs + " -o T/out --overwrite" + SMALL);
      assertThat(pixels("out/sample.png")).isEqualTo(pixels("clean.png"));
      assertThat(pixels("out/scene.png")).isEqualTo(pixels("noisy.png"));
    }
  }

  @Test
  void alphaStays() throws IOException {
    String model = "render T/sample.glb --background transparent" + SMALL + " -o T/";
    runs(model + "a.png");
    runs(model + "noisy.png --no-denoise");
    int[] clean = pixels("a.png");
    int[] noisy = pixels("noisy.png");
    assertThat(clean).isNotEqualTo(noisy);
    assertThat(Arrays.stream(clean).map(argb -> argb >>> 24).toArray())
        .contains(0, 255)
        .isEqualTo(Arrays.stream(noisy).map(argb -> argb >>> 24).toArray());
  }

  @Test
  void aPartIsDenoisedFromItsOwnPixels() throws IOException {
    String part = "render T/sample.glb --crop 4,3,16,12" + SMALL + " -o T/";
    assertThat(said(part + "part.png")).contains(DENOISED);
    runs(part + "noisy.png --checkpoint T/part.film --layers denoise");
    runs("denoise T/part.film -o T/of-film.png");
    assertThat(pixels("part.png")).hasSize(16 * 12).isEqualTo(pixels("of-film.png"));
  }

  @Test
  void adaptiveSamplesAreDenoised() {
    assertThat(said("render T/sample.glb --adaptive --size 24x18 -s 48 -o T/a.png"))
        .contains(DENOISED);
  }

  /** A fixed number: it depends on nothing but the flags. */
  @ParameterizedTest
  @CsvSource({
    "-o T/a.png, 8",
    "-o T/a.jpg, 8",
    "-o T/a.pfm --denoise, 8",
    "-o T/a.png -s 3, 3",
    "-o T/a.png --no-denoise, 100",
    "-o T/a.exr, 100",
    "-o T/a.png --adaptive, 100",
    "-o T/a.png --checkpoint T/a.film, 100"
  })
  void denoisedModelsNeedFewSamples(String flags, int samples) {
    Outcome outcome = run("render T/sample.glb --size 24x18 --json --quiet " + flags);
    assertThat(outcome.out()).contains("\"samples_per_pixel\":" + samples + ",");
  }

  @Test
  void theMemoryOfTheDenoiserIsEstimated() {
    String render = "render T/sample.glb --dry-run --size 512x512 -o T/a.png";
    assertThat(run(render).out()).contains("denoise  94 MiB more after the render");
    assertThat(run(render + " --no-denoise").out()).contains("denoise  0 MiB");
    assertThat(run(render + " --json").out()).contains("\"denoise_bytes\":98304000");
  }

  @Test
  void denoisedViewsNeedFewSamples() {
    String views = "views T/sample.glb --size 24x18 -o T/v";
    assertThat(said(views)).contains(" 2 samples per pixel, denoised");
    assertThat(said(views + "2 --no-denoise")).contains(" 100 samples per pixel; ");
  }

  /** The stop rule sees the noise of the samples, which the denoiser does not change. */
  @Test
  void targetErrorsAreThoseOfTheNoisyPicture() {
    String model = "render T/sample.glb --size 24x18 --target-error 5% --json -o T/";
    JsonObject clean = run(model + "a.png").json();
    JsonObject noisy = run(model + "b.png --no-denoise").json();
    for (String key : new String[] {"pixel_samples", "noise", "target_reached", "ended_by"}) {
      assertThat(clean.get(key)).as(key).isNotNull().isEqualTo(noisy.get(key));
    }
    assertThat(clean.has("denoised")).isTrue();
  }

  @Test
  @DisabledOnOs(OS.WINDOWS)
  void aFailingDenoiserLeavesTheNoisyPicture() throws IOException {
    Path program = Files.writeString(directory.resolve("oidnDenoise"), "#!/bin/sh\nexit 1\n");
    Files.setPosixFilePermissions(program, PosixFilePermissions.fromString("rwxr-xr-x"));
    Outcome outcome = run("render T/sample.glb --oidn T/oidnDenoise -o T/a.png" + SMALL);
    assertThat(outcome.exitCode()).isEqualTo(ExitCodes.OUTPUT);
    assertThat(outcome.err()).contains("oidnDenoise", "the noisy picture is", "a.png");
    runs("render T/sample.glb --no-denoise -o T/noisy.png" + SMALL);
    assertThat(pixels("a.png")).isEqualTo(pixels("noisy.png"));
  }

  @Test
  void aStoppedRenderKeepsItsNoise() throws IOException {
    Outcome outcome =
        run("render T/sample.glb --size 64x48 -s 1000000 --timeout 2s -o T/a.png --json");
    assertThat(outcome.exitCode()).as(outcome.err()).isEqualTo(ExitCodes.OK);
    assertThat(outcome.err()).contains("not denoised, because the render was stopped");
    assertThat(outcome.out()).doesNotContain("\"denoised\"");
    assertThat(directory.resolve("a.png")).isNotEmptyFile();
  }
}
