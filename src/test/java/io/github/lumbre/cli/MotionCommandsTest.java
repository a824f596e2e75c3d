package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.output.ExitCodes;
import java.io.IOException;
import java.nio.file.Files;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Pictures of moving models, and their checkpoint files. */
class MotionCommandsTest extends CommandFixture {
  private static final String LIFT =
      "render T/sample.glb --pose lift@0.25 --view front --size 12x9 --no-denoise";
  private static final String MOVING = LIFT + " --shutter 0.5 --fps 2 --poses 4";

  @BeforeEach
  void writeModel() throws IOException {
    ModelSample.write(directory);
  }

  private void fails(String line, int code, String message) {
    Outcome outcome = run(line);
    assertThat(outcome.err()).contains(message);
    assertThat(outcome.exitCode()).isEqualTo(code);
  }

  @Test
  void samplesAreRoundedUpToWholePoses() throws IOException {
    assertThat(said(MOVING + " -s 9 -o T/a.png")).contains("12 samples per pixel, noise about");
    assertThat(texts("a.png"))
        .containsEntry("Shutter", "0.25")
        .containsEntry("Poses", "4")
        .containsEntry("Samples", "12");
    // Four samples have no halves with all poses.
    assertThat(said(MOVING + " -s 1 -o T/b.png"))
        .contains("4 samples per pixel")
        .doesNotContain("noise about");
    assertThat(said(LIFT + " -s 9 -o T/c.png")).contains("9 samples per pixel");
  }

  /** A denoiser needs to know the noise. */
  @Test
  void denoisedPicturesHaveTwoSamplesOfEachPose() {
    String line = MOVING.replace("--poses 4", "--poses 16").replace(" --no-denoise", "");
    assertThat(said(line + " -o T/a.png")).contains("32 samples per pixel", "denoised");
  }

  @Test
  void framesOfAnimationsMove() throws IOException {
    String options = " --view front --no-denoise --size 12x9 -s 4 --fps 2 --shutter 0.5 --poses 4";
    runs("render T/sample.glb --animation lift -o T/a.png --continue" + options);
    runs("render T/sample.glb --animation lift -o T/b.pfm --frames 1" + options);
    String still = options.replace(" --shutter 0.5 --poses 4", "");
    runs("render T/sample.glb --animation lift -o T/c.pfm --frames 1" + still);
    assertThat(Files.mismatch(directory.resolve("b-001.pfm"), directory.resolve("c-001.pfm")))
        .isNotNegative();
    assertThat(texts("a-001.png")).containsEntry("Poses", "4");
    fails(
        "render T/sample.glb --animation lift -o T/a.png --continue"
            + options.replace("--poses 4", "--poses 2"),
        ExitCodes.USAGE,
        "Poses");
  }

  @Test
  void filmsAreResumedAndMergedWithTheirPoses() {
    runs(MOVING + " -s 16 -o T/whole.pfm");
    runs(MOVING + " -s 8 -o T/a.pfm --checkpoint T/a.film");
    runs("resume T/a.film -s 13 -o T/a.pfm");
    assertSame("a.pfm", "whole.pfm");
    runs(MOVING + " -s 14 --share 0/2 -o T/b.pfm --checkpoint T/b.film");
    runs(MOVING + " -s 14 --share 1/2 -o T/c.pfm --checkpoint T/c.film");
    assertThat(said("merge T/b.film T/c.film -o T/d.film")).contains("16 samples");
    runs("develop T/d.film -o T/d.pfm");
    assertSame("d.pfm", "whole.pfm");
    runs(MOVING.replace("--poses 4", "--poses 8") + " -s 8 -o T/e.pfm --checkpoint T/e.film");
    fails(
        "merge T/a.film T/e.film -o T/f.film",
        ExitCodes.SCENE,
        "poses: " + directory + "/a.film has 4, " + directory + "/e.film has 8");
    fails(
        MOVING + " --samples-from 2 --samples-to 8 -o T/g.pfm --checkpoint T/g.film",
        ExitCodes.USAGE,
        "--samples-from: expected a multiple of the number of poses, 4, found 2");
    fails(
        MOVING + " -s 4 --share 0/2 -o T/g.pfm --checkpoint T/g.film",
        ExitCodes.USAGE,
        "--share: expected at least one pose set for each share, found 1 pose set and 2 shares");
  }

  @ParameterizedTest
  @CsvSource({
    "--shutter 2, '--shutter: expected a fraction from 0 to 1, found 2.0'",
    "--shutter NaN, '--shutter: expected a fraction from 0 to 1, found NaN'",
    "--shutter -0.5, '--shutter: expected a fraction from 0 to 1, found -0.5'",
    "--poses 4, --poses: requires --shutter",
    "--shutter 1 --poses 3, '--poses: expected a power of two from 1 to 256, found 3'",
    "--shutter 1 --poses -1, '--poses: expected a power of two from 1 to 256, found -1'",
    "--shutter 1 --poses 512, '--poses: expected a power of two from 1 to 256, found 512'",
    "--shutter 1 --turntable 3, '--shutter: cannot be combined with --turntable'"
  })
  void wrongValuesAreRefused(String flags, String message) {
    fails(LIFT + " -o T/a.png " + flags, ExitCodes.USAGE, message);
  }

  @Test
  void modelsWithoutAPoseStandStill() {
    fails(
        "render T/sample.glb -o T/a.png --shutter 0.5",
        ExitCodes.USAGE,
        "--shutter: requires --animation, or --pose for a single picture");
  }
}
