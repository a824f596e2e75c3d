package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import io.github.lumbre.checkpoint.CheckpointFile;
import io.github.lumbre.checkpoint.FilmFile;
import io.github.lumbre.checkpoint.FilmHeader;
import io.github.lumbre.cli.output.ExitCodes;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that pictures of {@code --split auto} have one plan, however they are rendered. */
class SplitPlanFilmTest {
  @TempDir private Path directory;

  private String path(String name) {
    return directory.resolve(name).toString();
  }

  private Outcome render(String picture, String... flags) {
    List<String> args = new ArrayList<>(List.of("render", "scenes/cornell-box.json"));
    args.addAll(List.of("--size", "96x72", "--split", "auto", "-o", path(picture)));
    args.addAll(List.of(flags));
    return Outcome.of(args.toArray(String[]::new));
  }

  private static void assertDone(Outcome outcome) {
    assertThat(outcome.exitCode()).as(outcome.err()).isZero();
  }

  private byte[] bytes(String name) throws IOException {
    return Files.readAllBytes(directory.resolve(name));
  }

  @Test
  void thePictureDoesNotDependOnHowItIsRendered() throws IOException {
    Outcome whole = render("whole.pfm", "-s", "6", "--pilot", "4096", "--json");
    assertDone(whole);
    JsonObject splitting =
        JsonParser.parseString(whole.out()).getAsJsonObject().getAsJsonObject("splitting");
    assertThat(splitting.get("branches").getAsDouble()).isGreaterThan(1);
    String[] film = {"-s", "2", "--pilot", "4096", "--checkpoint", path("a.film")};
    assertDone(render("a.pfm", film));
    FilmHeader header = FilmFile.read(directory.resolve("a.film")).header();
    assertThat(header.identity())
        .containsEntry("split", "auto")
        .containsEntry("split-pilot", "4096")
        .containsEntry(FilmHeader.SPLIT_PLAN, splitting.get("plan").getAsString());
    assertDone(Outcome.of("resume", path("a.film"), "-s", "4", "--threads", "3", "--bucket", "5"));
    assertDone(
        render(
            "b.pfm",
            "-s",
            "2",
            "--samples-from",
            "4",
            "--pilot",
            "4096",
            "--kernel",
            "scalar",
            "--checkpoint",
            path("b.film")));
    assertDone(Outcome.of("merge", path("a.film"), path("b.film"), "-o", path("c.film")));
    assertDone(Outcome.of("develop", path("c.film"), "-o", path("c.pfm")));
    assertThat(bytes("c.pfm")).isEqualTo(bytes("whole.pfm"));

    assertDone(render("d.pfm", "-s", "2", "--checkpoint", path("d.film")));
    Outcome.of("merge", path("a.film"), path("d.film"), "-o", path("e.film"))
        .assertFailed(ExitCodes.SCENE, "split-pilot: ", "has 4096", "has 0");
  }

  @Test
  void aFilmIsNotResumedWithAnotherPlan() throws IOException {
    assertDone(render("a.pfm", "-s", "2", "--pilot", "256", "--checkpoint", path("a.film")));
    setPlan("0".repeat(64));
    Outcome.of("resume", path("a.film"), "-s", "4")
        .assertFailed(ExitCodes.SCENE, "split-plan: the film has 000", "start a new one");
    setPlan("");
    Outcome.of("resume", path("a.film"), "-s", "4")
        .assertFailed(ExitCodes.SCENE, "split-plan: the film has nothing");
    assertDone(Outcome.of("develop", path("a.film"), "-o", path("b.pfm")));
    assertThat(bytes("b.pfm")).isEqualTo(bytes("a.pfm"));
  }

  /** Sets the plan's hash in a film, or removes it. */
  private void setPlan(String hash) throws IOException {
    FilmFile film = FilmFile.read(directory.resolve("a.film"));
    Map<String, String> identity = new LinkedHashMap<>(film.header().identity());
    assertThat(identity).containsKey("split");
    identity.remove(FilmHeader.SPLIT_PLAN);
    if (!hash.isEmpty()) {
      identity.put(FilmHeader.SPLIT_PLAN, hash);
    }
    try (CheckpointFile file = CheckpointFile.reserve(directory.resolve("a.film"))) {
      FilmHeader header = film.header();
      file.save(
          FilmFile.of(identity, film.film(), header.layers(), header.notes(), header.faults()));
    }
  }

  @Test
  void shortRendersHaveNoPilot() {
    Outcome outcome = render("a.pfm", "-s", "2");
    assertDone(outcome);
    assertThat(outcome.err()).contains("paths are not split: the render is too short");
    render("b.pfm", "--pilot", "4097")
        .assertFailed(ExitCodes.USAGE, "--pilot: expected auto or 0 to 4096, found 4097");
  }
}
