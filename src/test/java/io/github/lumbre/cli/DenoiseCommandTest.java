package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.image.internal.LinearReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Tests {@code lumbre denoise}, and {@code --denoise} of other commands. */
class DenoiseCommandTest {
  @TempDir private Path directory;
  private String scene;

  @BeforeEach
  void writeScene() {
    scene = TinyScene.write(directory, TinyScene.JSON).toString();
  }

  private String path(String name) {
    return directory.resolve(name).toString();
  }

  private static Outcome run(String... line) {
    Outcome outcome = Outcome.of(line);
    assertThat(outcome.exitCode()).as(outcome.err()).isZero();
    return outcome;
  }

  private byte[] bytes(String name) throws IOException {
    return Files.readAllBytes(directory.resolve(name));
  }

  @Test
  void theNoisyPictureIsKeptAsItIs() throws IOException {
    run("render", scene, "-s", "8", "-o", path("plain.pfm"));
    Outcome outcome = run("render", scene, "-s", "8", "-o", path("x.pfm"), "--denoise");
    assertThat(bytes("x.pfm")).isEqualTo(bytes("plain.pfm"));
    assertThat(bytes("x.denoised.pfm")).isNotEqualTo(bytes("plain.pfm"));
    assertThat(outcome.err()).contains("x.denoised.pfm: denoised (built-in)");
  }

  @Test
  void anErrorOnAnotherScaleThanTheNoiseOfTheRenderIsSaidToBe() {
    String said =
        "denoised \\(built-in\\): \\d+\\.\\d\\d % changed, noise before roughly [0-9.]+ %, error"
            + " left roughly [0-9.]+ %; not comparable with the noise of the render";
    Outcome render =
        run("render", scene, "-s", "8", "-o", path("x.exr"), "--denoise", "--size", "32x32");
    assertThat(render.err()).containsPattern("noise about [0-9.]+ %").containsPattern(said);
    assertThat(run("denoise", path("x.exr"), "-o", path("y.png")).err()).containsPattern(said);
  }

  @Test
  void metadataSayWhatWasDone() throws IOException {
    run("render", scene, "-s", "8", "-o", path("x.png"), "--denoise");
    String png = new String(bytes("x.denoised.png"), StandardCharsets.ISO_8859_1);
    assertThat(png).contains("Denoiser\0built-in", "DenoiserChange", "DenoiserNoiseBefore");
    assertThat(png).contains("DenoiserErrorEstimate");
    assertThat(new String(bytes("x.png"), StandardCharsets.ISO_8859_1)).doesNotContain("Denoiser");
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
    assertThat(bytes("of-film.pfm")).isEqualTo(bytes("x.denoised.pfm"));
    assertThat(bytes("d.denoised.pfm")).isEqualTo(bytes("x.denoised.pfm"));
  }

  @Test
  void pictureFilesWithLayersAreDenoisedAboutAlike() throws IOException {
    run("render", scene, "-s", "8", "-o", path("x.exr"), "--denoise");
    run("denoise", path("x.exr"), "-o", path("of-exr.pfm"), "--threads", "1");
    float[] ofExr = LinearReader.read(directory.resolve("of-exr.pfm")).rgb();
    float[] ofFilm = LinearReader.read(directory.resolve("x.denoised.exr")).rgb();
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
    assertThat(ofFilm.err()).contains("denoisingNormal; without", "--denoise");
    assertThat(directory.resolve("z.denoised.png")).exists();
    run("render", scene, "-s", "8", "-o", path("y.exr"), "--denoise");
    assertThat(run("denoise", path("y.exr"), "-o", path("y.png")).err()).doesNotContain("lacks");
  }

  @Test
  void oneSampleIsDenoisedWithoutAnEstimate() {
    Outcome outcome = run("render", scene, "-s", "1", "-o", path("x.png"), "--denoise");
    assertThat(outcome.err()).contains("lacks its noise", "denoised").doesNotContain("an estimate");
  }

  @Test
  void standardOutputAndCheckpointsHoldNoTwoPictures() {
    Outcome.of("render", scene, "-o", "-", "--denoise").assertFailed(ExitCodes.USAGE, "--denoise");
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
    for (String script : new String[] {"sleep 60", "exit 1", "exit 0"}) {
      Files.deleteIfExists(directory.resolve("x.png"));
      Path program = program(script + "\n");
      Outcome outcome =
          Outcome.of(
              "render",
              scene,
              "--quiet",
              "-o",
              path("x.png"),
              "--denoise",
              "--oidn",
              program.toString(),
              "--denoise-timeout",
              "0.5s");
      assertThat(outcome.exitCode()).isEqualTo(ExitCodes.OUTPUT);
      assertThat(outcome.err()).contains("oidnDenoise", "the noisy picture is", "x.png");
      assertThat(directory.resolve("x.png")).isNotEmptyFile();
      assertThat(directory.resolve("x.denoised.png")).doesNotExist();
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
    assertThat(bytes("x.denoised.pfm")).isEqualTo(bytes("x.pfm"));
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

  @Test
  void thePictureBesideIsGuarded() throws IOException {
    Path own = Files.writeString(directory.resolve("x.denoised.png"), "# notes");
    Outcome.of("render", scene, "-o", path("x.png"), "--denoise")
        .assertFailed(ExitCodes.OUTPUT, "x.denoised.png", "--overwrite");
    assertThat(own).hasContent("# notes");
    try (Stream<Path> files = Files.list(directory)) {
      assertThat(files).hasSize(2);
    }
  }
}
