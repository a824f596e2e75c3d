package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonObject;
import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.image.internal.LinearReader;
import io.github.lumbre.testing.Folders;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;

/** Tests {@code lumbre denoise}, and {@code --denoise} of other commands. */
class DenoiseCommandTest extends CommandFixture {
  private String scene;

  @BeforeEach
  void writeScene() {
    scene = TinyScene.write(directory, TinyScene.JSON).toString();
  }

  private static Outcome run(String... line) {
    return Outcome.of(line).done();
  }

  @Test
  void scenesAreDenoisedOnDemand() throws IOException {
    for (String ending : new String[] {"png", "jpg", "pfm", "exr"}) {
      String plain = "plain." + ending;
      Outcome noisy = run("render", scene, "-s", "8", "-o", path(plain));
      assertThat(noisy.err()).doesNotContain("denoised");
      run("render", scene, "-s", "8", "-o", path("no." + ending), "--no-denoise");
      Outcome outcome = run("render", scene, "-s", "8", "-o", path("x." + ending), "--denoise");
      assertThat(outcome.err()).containsPattern("denoised: ");
      assertThat(light("no." + ending)).isEqualTo(light(plain));
      assertThat(light("x." + ending)).isNotEqualTo(light(plain));
    }
    assertThat(Folders.files(directory)).as("no file beside a picture").hasSize(13);
  }

  private float[] light(String name) throws IOException {
    return LinearReader.read(directory.resolve(name)).rgb();
  }

  @Test
  void theNoiseBeforeAndTheErrorAfterAreTold() {
    String said =
        "denoised: estimated noise before [0-9.]+ %, estimated error left" + " [0-9.]+ %\n";
    Outcome render =
        run("render", scene, "-s", "8", "-o", path("x.png"), "--denoise", "--size", "32x32");
    assertThat(render.err()).containsPattern("noise about [0-9.]+ %").containsPattern(said);
    run("render", scene, "-s", "8", "-o", path("x.exr"), "--layers", "denoise");
    assertThat(run("denoise", path("x.exr"), "-o", path("y.png")).err())
        .containsPattern("y.png: " + said);
  }

  @Test
  void metadataSayWhatWasDone() throws IOException {
    for (String ending : new String[] {"png", "jpg", "exr"}) {
      run("render", scene, "-s", "8", "-o", path("x." + ending), "--denoise");
      run("render", scene, "-s", "8", "-o", path("noisy." + ending));
      String denoised = new String(bytes("x." + ending), StandardCharsets.ISO_8859_1);
      assertThat(denoised)
          .containsPattern("Denoised\\W+(string\\W+)?builtin [0-9a-f]{8}")
          .contains("DenoisedChange", "DenoisedNoiseBefore", "DenoisedErrorAfter");
      String noisy = new String(bytes("noisy." + ending), StandardCharsets.ISO_8859_1);
      assertThat(noisy).doesNotContain("Denoised");
    }
  }

  @Test
  void theJsonSummaryHasBothErrors() {
    Outcome outcome =
        run("render", scene, "-s", "8", "-o", path("x.png"), "--denoise", "--json", "--quiet");
    JsonObject summary = outcome.json();
    JsonObject denoised = summary.getAsJsonObject("denoised");
    assertThat(denoised.get("denoiser").getAsString()).matches("builtin [0-9a-f]{8}");
    assertThat(denoised.get("relative_rmse_after").getAsDouble())
        .isPositive()
        .isLessThan(denoised.get("relative_rmse_before").getAsDouble());
    assertThat(outcome.err()).isEmpty();
    Outcome noisy = run("render", scene, "-s", "8", "-o", path("y.png"), "--json", "--quiet");
    assertThat(noisy.out()).doesNotContain("denoised");
  }

  /** Guides that were recorded for the denoiser alone are not written. */
  @Test
  void layersOfADenoisedPictureAreThoseThatAreAskedFor() throws IOException {
    run("render", scene, "-s", "8", "-o", path("x.exr"), "--denoise", "--layers", "depth");
    assertThat(run("layers", path("x.exr")).out())
        .contains("depth")
        .doesNotContain("denoisingAlbedo", "variance");
    run("render", scene, "-s", "8", "-o", path("noisy.exr"), "--layers", "depth");
    run("compare", path("x.exr"), path("noisy.exr"), "--layer", "depth");
  }

  @Test
  void onlyOneOfTheFlagsIsGiven() {
    Outcome.of("render", scene, "-o", path("x.png"), "--denoise", "--no-denoise")
        .assertFailed(ExitCodes.USAGE, "--denoise", "--no-denoise");
  }

  @Test
  void filmsAndRendersAreDenoisedAlike() throws IOException {
    run(
        "render",
        scene,
        "-s",
        "8",
        "-o",
        path("x.pfm"),
        "--denoise",
        "--checkpoint",
        path("x.film"));
    run("denoise", path("x.film"), "-o", path("of-film.pfm"));
    run("develop", path("x.film"), "-o", path("d.pfm"), "--denoise");
    run("develop", path("x.film"), "-o", path("noisy.pfm"), "--no-denoise");
    assertThat(bytes("of-film.pfm")).isEqualTo(bytes("x.pfm"));
    assertThat(bytes("d.pfm")).isEqualTo(bytes("x.pfm"));
    assertThat(bytes("noisy.pfm")).isNotEqualTo(bytes("x.pfm"));
  }

  @Test
  void pictureFilesWithLayersAreDenoisedAboutAlike() throws IOException {
    run("render", scene, "-s", "8", "-o", path("x.pfm"), "--denoise");
    run("render", scene, "-s", "8", "-o", path("x.exr"), "--layers", "denoise");
    run("denoise", path("x.exr"), "-o", path("of-exr.pfm"), "--threads", "1");
    float[] ofExr = light("of-exr.pfm");
    float[] ofFilm = light("x.pfm");
    double squares = 0;
    double all = 0;
    for (int i = 0; i < ofExr.length; i++) {
      squares += (ofExr[i] - ofFilm[i]) * (ofExr[i] - ofFilm[i]);
      all += ofFilm[i] * ofFilm[i];
    }
    assertThat(Math.sqrt(squares / all)).isLessThan(.1);
  }

  @Test
  void missingLayersAreTold() throws IOException {
    run("render", scene, "-s", "8", "-o", path("x.exr"), "--checkpoint", path("x.film"));
    Outcome ofExr = run("denoise", path("x.exr"), "-o", path("of-exr.pfm"));
    assertThat(ofExr.err())
        .contains("warning: " + path("x.exr") + ": lacks the layer denoisingAlbedo")
        .contains("its noise", "--layers denoise");
    Outcome ofFilm = run("develop", path("x.film"), "-o", path("z.png"), "--denoise");
    assertThat(ofFilm.err()).contains("denoisingNormal; without", "--layers denoise");
    run("render", scene, "-s", "8", "-o", path("y.exr"), "--layers", "denoise");
    assertThat(run("denoise", path("y.exr"), "-o", path("y.png")).err()).doesNotContain("lacks");
  }

  @Test
  void oneSampleIsDenoisedWithoutAnEstimate() {
    Outcome outcome = run("render", scene, "-s", "1", "-o", path("x.png"), "--denoise");
    assertThat(outcome.err())
        .contains("lacks its noise", "denoised")
        .doesNotContain("error left", "--layers");
  }

  @Test
  void checkpointsHoldNoDenoisedPicture() {
    run("render", scene, "-o", path("x.png"), "--checkpoint", path("x.film"));
    Outcome.of("merge", path("x.film"), "-o", path("y.film"), "--denoise")
        .assertFailed(ExitCodes.USAGE, "--denoise", "y.film");
  }

  @Test
  void picturesOfNanAreRepairedOrRefused() throws IOException {
    Path file = directory.resolve("nan.exr");
    Files.write(file, NanExr.bytes(8, 6, Float.NaN));
    Outcome.of("denoise", file.toString(), "-o", path("x.png"))
        .assertFailed(ExitCodes.ASSET, "nan.exr", "finite");
    Files.write(file, NanExr.bytes(8, 6, .5f));
    assertThat(run("denoise", file.toString(), "-o", path("x.png")).err())
        .contains("NaN or infinite pixels: 1");
    if (!System.getProperty("os.name").startsWith("Windows")) {
      Outcome outcome =
          run("denoise", file.toString(), "-o", path("x.pfm"), "--oidn", copier().toString());
      assertThat(outcome.err()).contains("NaN or infinite pixels: 1", "denoised");
      assertThat(LinearReader.read(directory.resolve("x.pfm")).rgb()).containsOnly(.5f);
    }
  }

  private Path program(String script) throws IOException {
    Path file = Files.writeString(directory.resolve("oidnDenoise"), "#!/bin/sh\n" + script);
    return Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rwxr-xr-x"));
  }

  private Path copier() throws IOException {
    return program("from=\"$2\"\nwhile [ \"$1\" != -o ]; do shift; done\ncp \"$from\" \"$2\"\n");
  }

  @Test
  @DisabledOnOs(OS.WINDOWS)
  void aFailingProgramLeavesTheNoisyPicture() throws IOException {
    run("render", scene, "-o", path("plain.png"));
    for (String script : new String[] {"sleep 60", "exit 1", "exit 0"}) {
      Files.deleteIfExists(directory.resolve("x.png"));
      Path program = program(script + "\n");
      Outcome outcome =
          run(
              "render %s --quiet -o T/x.png --denoise --oidn %s --denoise-timeout 0.5s"
                  .formatted(scene, program));
      assertThat(outcome.exitCode()).isEqualTo(ExitCodes.OUTPUT);
      assertThat(outcome.err()).contains("oidnDenoise", "the noisy picture is", "x.png");
      assertThat(light("x.png")).isEqualTo(light("plain.png"));
    }
  }

  @Test
  @DisabledOnOs(OS.WINDOWS)
  void theProgramNeedsNoSecondSample() throws IOException {
    run(
        "render",
        scene,
        "-s",
        "1",
        "-o",
        path("x.pfm"),
        "--denoise",
        "--oidn",
        copier().toString());
    run("render", scene, "-s", "1", "-o", path("plain.pfm"));
    assertThat(bytes("x.pfm")).isEqualTo(bytes("plain.pfm"));
  }

  @Test
  void aMissingProgramIsToldBeforeAnythingIsRendered() {
    Outcome.of("render", scene, "-o", path("x.png"), "--denoise", "--oidn", path("none"))
        .assertFailed(ExitCodes.USAGE, "none", "pip install pyoidn", "LUMBRE_OIDN or with --oidn");
    assertThat(directory.resolve("x.png")).doesNotExist();
    Outcome.of("render", scene, "-o", path("x.png"), "--denoise", "--denoiser", "oidm")
        .assertFailed(ExitCodes.USAGE, "--denoiser", "one of builtin, oidn");
  }

  @Test
  void otherFilesAreRefused() throws IOException {
    Files.writeString(directory.resolve("x.exr"), "no picture");
    Outcome.of("denoise", path("x.exr"), "-o", path("y.png"))
        .assertFailed(ExitCodes.ASSET, "x.exr");
    Outcome.of("denoise", path("none.exr"), "-o", path("y.png"))
        .assertFailed(ExitCodes.USAGE, "none.exr");
    Outcome.of("denoise", path("x.exr"), "-o", path("y.txt"))
        .assertFailed(ExitCodes.USAGE, "y.txt");
  }
}
