package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonObject;
import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.image.ImageLayer;
import io.github.lumbre.image.LayeredImage;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.render.RenderStatistics.RejectedSample;
import io.github.lumbre.render.checkpoint.CheckpointFile;
import io.github.lumbre.render.checkpoint.FilmFile;
import io.github.lumbre.render.checkpoint.FilmHeader;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.Setting;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Tests the film commands {@code resume}, {@code merge} and {@code develop}. */
class FilmCommandsTest extends CommandFixture {
  private Outcome render(String picture, String... flags) {
    return withScene(TinyScene.JSON, "render T/tiny.json -o T/" + picture, flags);
  }

  private void assertSamePicture(String name) throws IOException {
    render("whole.pfm", "-s", "20").done();
    assertThat(bytes(name)).isEqualTo(bytes("whole.pfm"));
  }

  @Test
  void resumedRenderHasTheBitsOfOneThatWasNotStopped() throws IOException {
    render("a.pfm", "-s", "7", "--threads", "1", "--checkpoint", path("a.film")).done();
    Outcome.of("resume", path("a.film"), "-s", "13", "--threads", "3", "--bucket", "5").done();
    Outcome.of("resume", path("a.film"), "-s", "20").done();
    assertSamePicture("a.pfm");
  }

  @Test
  void splitPathsAreGoneOnWith() throws IOException {
    String[] split = {"-s", "20", "--split", "3"};
    render("whole.pfm", split).done();
    render("a.pfm", "-s", "9", "--split", "3", "--checkpoint", path("a.film")).done();
    Outcome.of("resume", path("a.film"), "-s", "20").done();
    assertThat(bytes("a.pfm")).isEqualTo(bytes("whole.pfm"));
    render("b.pfm", "-s", "20").done();
    assertThat(bytes("a.pfm")).isNotEqualTo(bytes("b.pfm"));
    // Samples of split paths differ from those of paths that are not split.
    render("c.pfm", "--samples-from", "20", "--checkpoint", path("c.film")).done();
    Outcome.of("merge", path("a.film"), path("c.film"), "-o", path("d.film"))
        .assertFailed(ExitCodes.SCENE, "split: ", "has 3", "has 1");
    render("e.pfm", "--split", "2", "--mode", "ray")
        .assertFailed(ExitCodes.USAGE, "--split: requires path mode, found ray");
  }

  @Test
  void resumedRenderReachesAnErrorWithTheSamplesOfOneThatWasNotStopped() throws IOException {
    assertThat(
            render("a.pfm", "--target-error", "1%", "-s", "40", "--checkpoint", path("a.film"))
                .exitCode())
        .isEqualTo(ExitCodes.TARGET);
    // It still has all requested samples.
    assertThat(Outcome.of("resume", path("a.film")).exitCode()).isEqualTo(ExitCodes.TARGET);
    Outcome.of("resume", path("a.film"), "--target-error", "1%", "--time", "1h").done();
    render("whole.pfm", "--target-error", "1%").done();
    assertThat(bytes("a.pfm")).isEqualTo(bytes("whole.pfm"));
    // Now it has reached the target error.
    Outcome.of("resume", path("a.film")).done();
    assertThat(bytes("a.pfm")).isEqualTo(bytes("whole.pfm"));
  }

  @Test
  void resumedRenderNeedsAnEnd() throws IOException {
    render("a.pfm", "--time", "1s", "--checkpoint", path("a.film")).done();
    byte[] film = bytes("a.film");
    Outcome.of("resume", path("a.film"))
        .assertFailed(ExitCodes.USAGE, "expected --samples, --time or --target-error");
    assertThat(bytes("a.film")).isEqualTo(film);
    Outcome.of("resume", path("a.film"), "--time", "1s").done();
    assertThat(bytes("a.film")).isNotEqualTo(film);
    Outcome.of("resume", path("a.film"), "--confidence", "2%")
        .assertFailed(ExitCodes.USAGE, "--confidence");
  }

  @Test
  void resumedRenderTellsProgressAndSummaryToPrograms() {
    render("a.pfm", "-s", "3", "--checkpoint", path("a.film")).done();
    Outcome outcome =
        Outcome.of("resume", path("a.film"), "-s", "7", "--json", "--progress", "json", "--quiet");
    JsonObject summary = outcome.json();
    assertThat(summary.get("command").getAsString()).isEqualTo("resume");
    assertThat(summary.get("film").getAsString()).isEqualTo(path("a.film"));
    assertThat(summary.get("scene").getAsString()).endsWith("tiny.json");
    assertThat(summary.get("samples").getAsInt()).isEqualTo(16 * 12 * 4);
    assertThat(summary.get("exit_code").getAsInt()).isZero();
    outcome.err().lines().forEach(line -> assertThat(line).startsWith("{\"done\":"));
    Outcome failed = Outcome.of("resume", path("a.film"), "-s", "1", "--json");
    assertThat(failed.json().get("exit_code").getAsInt()).isEqualTo(ExitCodes.USAGE);
  }

  @Test
  void samplesThatWereRejectedBeforeAreToldAfterwards() throws IOException {
    render("a.pfm", "-s", "3", "--checkpoint", path("a.film")).done();
    RenderStatistics faults =
        RenderStatistics.ofFaults(
            2, List.of(new RejectedSample(3, 1, 0), new RejectedSample(2, 5, 1)), 4);
    FilmFile film = FilmFile.read(directory.resolve("a.film"));
    try (CheckpointFile file = CheckpointFile.reserve(directory.resolve("a.film"))) {
      FilmHeader header = film.header();
      file.save(
          FilmFile.of(header.identity(), film.film(), header.layers(), header.notes(), faults));
    }
    Outcome outcome = Outcome.of("resume", path("a.film"), "-s", "5", "--json");
    JsonObject summary = outcome.json();
    assertThat(summary.get("rejected").getAsInt()).isEqualTo(2);
    assertThat(summary.get("first_rejected").toString()).isEqualTo("[[3,1,0],[2,5,1]]");
    assertThat(summary.get("saturated").getAsInt()).isEqualTo(4);
    assertThat(outcome.err())
        .contains("warning: rejected 2 samples with negative, NaN or infinite values");
    assertThat(FilmFile.read(directory.resolve("a.film")).header().faults()).isEqualTo(faults);
  }

  /** The film has no revision, like films of older versions. */
  @Test
  void filmsOfOtherVersionsAreDevelopedButNotGoneOnWith() throws IOException {
    render("a.pfm", "-s", "3", "--checkpoint", path("a.film")).done();
    changeIdentity("a.film", identity -> identity.remove(FilmHeader.REVISION));
    Outcome.of("resume", path("a.film"))
        .assertFailed(ExitCodes.SCENE, "revision: ", "a.film has nothing", "tiny.json has ");
    Outcome.of("develop", path("a.film"), "-o", path("b.pfm")).done();
    assertThat(bytes("b.pfm")).isEqualTo(bytes("a.pfm"));
  }

  @Test
  void filmsOfImpossibleSplitsAreNotGoneOnWith() throws IOException {
    render("a.pfm", "-s", "3", "--split", "2", "--checkpoint", path("a.film")).done();
    changeIdentity("a.film", identity -> identity.put(Setting.SPLIT.name(), "0"));
    Outcome.of("resume", path("a.film"))
        .assertFailed(ExitCodes.SCENE, "split in its header: expected 1 to 256, found 0");
  }

  /** An earlier version chose the numbers of branches by a pilot render. */
  @Test
  void filmsOfPlannedSplitsAreOnlyDeveloped() throws IOException {
    filmsAreOnlyDeveloped(
        Map.of("split", "auto", "split-pilot", "1024", "split-plan", "0".repeat(64)),
        "--split auto",
        "--split N");
  }

  /** An earlier version chose by a trial whether paths are guided. */
  @Test
  void filmsOfChosenGuidesAreOnlyDeveloped() throws IOException {
    filmsAreOnlyDeveloped(
        Map.of("guide", "auto", "guide-hash", "0".repeat(8)),
        "--guide auto",
        "--guide on or --guide off");
  }

  private void filmsAreOnlyDeveloped(Map<String, String> changed, String... said)
      throws IOException {
    render(
            "a.pfm",
            "-s",
            "3",
            "--split",
            "2",
            "--layers",
            "denoise",
            "--checkpoint",
            path("a.film"))
        .done();
    changeIdentity("a.film", identity -> identity.putAll(changed));
    Outcome.of("resume", path("a.film")).assertFailed(ExitCodes.SCENE, said);
    Outcome.of("merge", path("a.film"), path("a.film"), "-o", path("b.film"))
        .assertFailed(ExitCodes.SCENE, said);
    Outcome.of("layers", path("a.film")).done();
    Outcome.of("denoise", path("a.film"), "-o", path("c.png")).done();
    Outcome.of("develop", path("a.film"), "-o", path("b.pfm")).done();
    assertThat(bytes("b.pfm")).isEqualTo(bytes("a.pfm"));
  }

  @Test
  void renderStoppedAtAnyTimeIsGoneOnWith() throws IOException {
    Outcome outcome =
        render("a.pfm", "-s", "20000", "--timeout", "1s", "--checkpoint", path("a.film"));
    assertThat(outcome.err())
        .contains(
            "stopped early",
            "a.film: holds the samples so far; continue with: lumbre resume " + path("a.film"));
    Outcome.of("resume", path("a.film"), "-s", "20000", "--timeout", "0.3s").done();
    Outcome.of("resume", path("a.film")).done();
    render("whole.pfm", "-s", "20000").done();
    assertThat(bytes("a.pfm")).isEqualTo(bytes("whole.pfm"));
  }

  @Test
  void filmsOfRangesAndCropsAreJoinedToTheBitsOfOne() throws IOException {
    render("a.png", "--samples-to", "12", "--crop", "0,0,9,12", "--checkpoint", path("a")).done();
    render(
            "b.png",
            "--samples-from",
            "12",
            "-s",
            "8",
            "--crop",
            "0,0,9,12",
            "--checkpoint",
            path("b"))
        .done();
    render("c.png", "-s", "5", "--crop", "9,0,7,12", "--checkpoint", path("c")).done();
    Outcome.of("merge", path("b"), path("c"), "-o", path("bc")).done();
    Outcome.of("resume", path("c"), "-s", "20").done();
    Outcome.of("merge", path("a"), path("bc"), path("c"), "-o", path("no"))
        .assertFailed(ExitCodes.SCENE, "samples in common: ");
    Outcome.of("merge", path("b"), path("a"), path("c"), "-o", path("all.pfm")).done();
    Outcome.of("merge", path("c"), path("a"), path("b"), "-o", path("all")).done();
    assertSamePicture("all.pfm");
    Outcome.of("develop", path("all"), "-o", path("developed.pfm")).done();
    assertSamePicture("developed.pfm");
    Outcome.of("resume", path("all"), "-o", path("resumed.pfm")).done();
    assertSamePicture("resumed.pfm");
  }

  /** Many balls of a pixel have one name, and 12 samples give rounded shares of it. */
  @Test
  void everyLayerOfSharesAndOfResumedRendersHasTheSameBits() throws IOException {
    StringBuilder balls = new StringBuilder();
    for (int i = 0; i < 300; i++) {
      balls.append(
          """
          {"name": "ball", "type": "Shape", "shapeType": "Sphere", "materialID": 1, "radius": 0.1,
           "localPosition": {"x": %s, "y": %s, "z": -1}},
          """
              .formatted(.13 * (i % 20) - 1.3, .13 * (i / 20)));
    }
    Path scene =
        Files.writeString(
            directory.resolve("balls.json"),
            TinyScene.with("{\"id\": 2, \"type\"", balls + "{\"id\": 2, \"type\""));
    String[] all = {"render", scene.toString(), "--layers", "all", "-o"};
    Outcome.of(with(all, path("whole.exr"), "-s", "12")).done();
    for (int i = 0; i < 3; i++) {
      String film = path("part-" + i);
      String share = i + "/3";
      Outcome.of(with(all, path("p.exr"), "-s", "12", "--share", share, "--checkpoint", film))
          .done();
    }
    String[] parts = {path("part-2"), path("part-0"), path("part-1")};
    Outcome.of("merge", parts[0], parts[1], parts[2], "-o", path("merged.exr")).done();
    assertSameLayers("merged.exr");
    Outcome.of("merge", parts[0], parts[1], parts[2], "-o", path("merged.film")).done();
    Outcome.of("develop", path("merged.film"), "-o", path("developed.exr")).done();
    assertSameLayers("developed.exr");
    Outcome.of(with(all, path("resumed.exr"), "--checkpoint", path("a.film"), "-s", "5")).done();
    Outcome.of("resume", path("a.film"), "-s", "12").done();
    assertSameLayers("resumed.exr");
  }

  private static String[] with(String[] args, String... more) {
    return Stream.concat(Arrays.stream(args), Arrays.stream(more)).toArray(String[]::new);
  }

  private void assertSameLayers(String name) throws IOException {
    List<ImageLayer> layers = LayeredImage.read(directory.resolve(name)).layers();
    List<ImageLayer> expected = LayeredImage.read(directory.resolve("whole.exr")).layers();
    assertThat(layers).hasSameSizeAs(expected).hasSizeGreaterThan(Layer.values().length);
    for (int i = 0; i < expected.size(); i++) {
      assertThat(layers.get(i).name()).isEqualTo(expected.get(i).name());
      assertThat(layers.get(i).values())
          .as(name + ": " + expected.get(i).name())
          .isEqualTo(expected.get(i).values());
    }
  }

  @Test
  void sharesOfAJobArrayMergeToThePicture() throws IOException {
    render("whole.pfm", "-s", "7").done();
    for (int i = 0; i < 3; i++) {
      String film = path("part-" + i);
      render("p.png", "-s", "7", "--share", i + "/3", "--checkpoint", film).done();
    }
    Outcome.of("merge", path("part-2"), path("part-0"), path("part-1"), "-o", path("all.pfm"))
        .done();
    assertThat(bytes("all.pfm")).isEqualTo(bytes("whole.pfm"));
    render("p.png", "-s", "7", "--share", "0/8", "--checkpoint", path("x"))
        .assertFailed(ExitCodes.USAGE, "--share: expected at least one sample for each share");
    render("p.png", "--share", "0/2")
        .assertFailed(ExitCodes.USAGE, "--share: requires --checkpoint");
    render("p.png", "--share", "0/2", "--time", "5s", "--checkpoint", path("x"))
        .assertFailed(ExitCodes.USAGE, "--share: cannot be combined with --time");
    render("p.png", "--share", "auto", "--checkpoint", path("x"))
        .assertFailed(ExitCodes.USAGE, "--share: auto: expected one of the variables");
  }

  @Test
  void filmsWithGapsAreDevelopedButNotGoneOnWith() {
    render("a.png", "-s", "2", "--checkpoint", path("a")).done();
    render("b.png", "--samples-from", "3", "-s", "2", "--checkpoint", path("b")).done();
    for (Outcome outcome :
        List.of(
            Outcome.of("merge", path("a"), path("b"), "-o", path("ab")),
            Outcome.of("merge", path("a"), path("b"), "-o", path("merged.png")),
            Outcome.of("develop", path("ab"), "-o", path("ab.png")))) {
      outcome.done();
      assertThat(outcome.err())
          .contains(": 16x12 pixels, 4 samples per pixel\n")
          .contains(
              ": samples are missing; it has samples 0 to 1 of 16x12 pixels at 0,0, and samples 3"
                  + " to 4 of 16x12 pixels at 0,0");
    }
    for (Outcome outcome :
        List.of(
            Outcome.of("merge", path("a"), path("b"), "-o", path("quiet"), "--quiet"),
            Outcome.of("merge", path("a"), path("b"), "-o", path("q.png"), "--quiet", "--denoise"),
            Outcome.of("develop", path("ab"), "-o", path("q.pfm"), "--quiet"))) {
      outcome.done();
      assertThat(outcome.out()).isEmpty();
      assertThat(outcome.err())
          .doesNotContain("pixels,", "denoised")
          .contains("samples are missing");
    }
    Outcome.of("resume", path("ab")).assertFailed(ExitCodes.SCENE, "gaps");
  }

  @Test
  void mergedFilmsReplaceOnlyFilmsWhoseSamplesTheyHave() throws IOException {
    for (int i = 0; i < 3; i++) {
      String share = i + "/3";
      render("p.png", "-s", "6", "--share", share, "--checkpoint", path("p" + i)).done();
    }
    byte[] last = bytes("p2");
    Outcome.of("merge", path("p0"), path("p1"), "-o", path("p2"))
        .assertFailed(
            ExitCodes.OUTPUT, "p2: has samples 4 to 5 of ", "which the merged films lack");
    assertThat(bytes("p2")).isEqualTo(last);
    assertThat(directory.resolve("p2.bak")).doesNotExist();
    Outcome.of("merge", path("p0"), path("p1"), "-o", path("all")).done();
    Outcome.of("merge", path("p0"), path("p1"), "-o", path("all")).done();
    Outcome complete = Outcome.of("merge", path("p0"), path("p1"), path("p2"), "-o", path("all"));
    complete.done();
    assertThat(complete.err()).contains("all: 16x12 pixels, 6 samples per pixel, noise about");
    Outcome.of("merge", path("p0"), path("p1"), "-o", path("all"))
        .assertFailed(ExitCodes.OUTPUT, "all: has samples 0 to 5 of ");
    render("o.png", "--seed", "5", "--checkpoint", path("other")).done();
    Outcome.of("merge", path("p0"), "-o", path("other"))
        .assertFailed(ExitCodes.OUTPUT, "is a checkpoint file of another picture", "--overwrite");
    Outcome.of("merge", path("p0"), "-o", path("other"), "--overwrite").done();
  }

  @Test
  void mergedFilmHasNoPictureOfItsOwn() throws IOException {
    render("a.png", "-s", "2", "--checkpoint", path("a")).done();
    byte[] picture = bytes("a.png");
    Outcome.of("merge", path("a"), "-o", path("b")).done();
    Outcome.of("resume", path("b"), "-s", "3")
        .assertFailed(ExitCodes.USAGE, "b: has no picture yet, because it was merged", "-o");
    Outcome.of("resume", path("b"), "-s", "3", "-o", path("b.png")).done();
    Outcome.of("resume", path("b"), "-s", "4").done();
    assertThat(bytes("a.png")).isEqualTo(picture);
    assertThat(bytes("b.png")).isNotEqualTo(picture);
  }

  @Test
  void developedPictureHasTheExposureThatIsAskedFor() throws IOException {
    render("a.png", "--exposure", "1", "--checkpoint", path("a.film")).done();
    render("b.png", "--exposure", "-2").done();
    Outcome.of("develop", path("a.film"), "-o", path("same.png")).done();
    Outcome.of("develop", path("a.film"), "-o", path("dark.png"), "--exposure", "-2").done();
    assertThat(pixels("same.png")).isEqualTo(pixels("a.png"));
    assertThat(pixels("dark.png")).isEqualTo(pixels("b.png")).isNotEqualTo(pixels("a.png"));
  }

  @Test
  void changedScenesAreRefused() throws IOException {
    render("a.pfm", "--checkpoint", path("a.film")).done();
    byte[] film = bytes("a.film");
    TinyScene.write(directory, TinyScene.with("0.8", "0.7"));
    Outcome.of("resume", path("a.film"), "-s", "9")
        .assertFailed(ExitCodes.SCENE, "a.film: tiny.json has changed since", "--scene COPY");
    assertThat(bytes("a.film")).isEqualTo(film);
    Files.delete(directory.resolve("tiny.json"));
    Outcome.of("resume", path("a.film")).assertFailed(ExitCodes.SCENE, "tiny.json");
  }

  @Test
  void differentSettingsAreNotJoined() {
    render("a.png", "--checkpoint", path("a")).done();
    render("b.png", "--seed", "4", "--samples-from", "2", "--checkpoint", path("b")).done();
    render("c.png", "--size", "8x8", "--samples-from", "2", "--checkpoint", path("c")).done();
    Outcome.of("merge", path("a"), path("b"), "-o", path("no"))
        .assertFailed(ExitCodes.SCENE, "seed: ", " has 0", " has 4");
    Outcome.of("merge", path("a"), path("c"), "-o", path("no"))
        .assertFailed(ExitCodes.SCENE, "size: ", "16x12", "8x8");
    assertThat(directory.resolve("no")).doesNotExist();
  }

  @Test
  void filmsAreNeverStartedOver() throws IOException {
    render("a.pfm", "--checkpoint", path("a.film")).done();
    byte[] film = bytes("a.film");
    render("a.pfm", "--checkpoint", path("a.film"))
        .assertFailed(ExitCodes.OUTPUT, "a.film: already exists", "lumbre resume");
    assertThat(bytes("a.film")).isEqualTo(film);
    Outcome.of("resume", path("a.film"), "-s", "1")
        .assertFailed(ExitCodes.USAGE, "at least the 2 samples per pixel already", ", found 1");
  }

  @Test
  void damagedFilmFallsBackAndIsSetAside() throws IOException {
    render("a.pfm", "-s", "4", "--checkpoint", path("a.film")).done();
    Outcome.of("resume", path("a.film"), "-s", "8").done();
    byte[] damaged = bytes("a.film");
    damaged[damaged.length - 9] ^= 4;
    Files.write(directory.resolve("a.film"), damaged);
    Outcome outcome = Outcome.of("resume", path("a.film"), "-s", "20");
    outcome.done();
    assertThat(outcome.err()).contains("a.film: is damaged", "using ", "a.film.bak instead");
    assertThat(bytes("a.film.damaged")).isEqualTo(damaged);
    assertSamePicture("a.pfm");
  }

  @Test
  void whatIsNoFilmIsTold() throws IOException {
    Files.writeString(directory.resolve("x"), "hello");
    for (String command : List.of("develop", "merge")) {
      Outcome.of(command, path("x"), "-o", path("o.png"))
          .assertFailed(ExitCodes.SCENE, "is not a film");
      Outcome.of(command, path("y"), "-o", path("o.png"))
          .assertFailed(ExitCodes.SCENE, "does not exist");
    }
    Outcome.of("resume", path("x")).assertFailed(ExitCodes.SCENE, "is not a film");
    Outcome.of("resume", path("y")).assertFailed(ExitCodes.SCENE, "does not exist");
    assertThat(Files.readString(directory.resolve("x"))).isEqualTo("hello");
  }
}
