package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonObject;
import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.render.checkpoint.FilmFile;
import io.github.lumbre.render.checkpoint.FilmHeader;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Tests that pictures of {@code --guide} have one guide, however they are rendered. */
class GuideFilmTest extends CommandFixture {
  private static final String[] ON = {"--guide", "on"};

  private Outcome render(String picture, String[] guide, String... flags) {
    List<String> args = new ArrayList<>(List.of("render", "scenes/door-ajar.json"));
    args.addAll(List.of("--size", "64x48", "-o", path(picture)));
    args.addAll(List.of(guide));
    args.addAll(List.of(flags));
    return Outcome.of(args.toArray(String[]::new));
  }

  /** Resumed and merged films, threads, buckets and both kernels give the bits of one render. */
  @Test
  void thePictureDoesNotDependOnHowItIsRendered() throws IOException {
    String kernel = Kernel.vectorObstacle().isEmpty() ? "vector" : "auto";
    Outcome whole = render("whole.pfm", ON, "-s", "6", "--kernel", kernel, "--json");
    whole.done();
    JsonObject guiding = whole.json().getAsJsonObject("guiding");
    assertThat(guiding.get("outcome").getAsString()).isEqualTo("guided");
    render("off.pfm", new String[0], "-s", "6").done();
    assertThat(bytes("off.pfm")).isNotEqualTo(bytes("whole.pfm"));
    render("scalar.pfm", ON, "-s", "6", "--kernel", "scalar").done();
    assertThat(bytes("scalar.pfm")).isEqualTo(bytes("whole.pfm"));

    render("a.pfm", ON, "-s", "2", "--checkpoint", path("a.film")).done();
    assertThat(FilmFile.read(directory.resolve("a.film")).header().identity())
        .containsEntry("guide", "on")
        .containsEntry(FilmHeader.GUIDE_HASH, guiding.get("hash").getAsString());
    Outcome.of("resume", path("a.film"), "-s", "4", "--threads", "3", "--bucket", "5").done();
    String[] rest = {"-s", "2", "--samples-from", "4", "--checkpoint", path("b.film")};
    render("b.pfm", ON, rest).done();
    Outcome.of("merge", path("a.film"), path("b.film"), "-o", path("c.film")).done();
    Outcome.of("develop", path("c.film"), "-o", path("c.pfm")).done();
    assertThat(bytes("c.pfm")).isEqualTo(bytes("whole.pfm"));
  }

  @Test
  void filmsOfAnotherSettingAreNotMerged() {
    render("a.pfm", ON, "-s", "2", "--checkpoint", path("a.film")).done();
    String[] rest = {"-s", "2", "--samples-from", "2", "--checkpoint", path("b.film")};
    render("b.pfm", new String[0], rest).done();
    Outcome.of("merge", path("a.film"), path("b.film"), "-o", path("c.film"))
        .assertFailed(ExitCodes.SCENE, "guide: ", "has on", "has off");
  }

  @Test
  void aFilmIsNotResumedWithAnotherGuide() throws IOException {
    render("a.pfm", ON, "-s", "2", "--checkpoint", path("a.film")).done();
    setIdentity(FilmHeader.GUIDE_HASH, "00000000");
    Outcome.of("resume", path("a.film"), "-s", "4")
        .assertFailed(ExitCodes.SCENE, "guide-hash: the film has 00000000", "start a new one");
    setIdentity(FilmHeader.GUIDE_HASH, "");
    Outcome.of("resume", path("a.film"), "-s", "4")
        .assertFailed(ExitCodes.SCENE, "guide-hash: the film has nothing");
    Outcome.of("develop", path("a.film"), "-o", path("b.pfm")).done();
    assertThat(bytes("b.pfm")).isEqualTo(bytes("a.pfm"));
  }

  /** Sets an entry of a film's identity, or removes it. */
  private void setIdentity(String name, String value) throws IOException {
    changeIdentity(
        "a.film",
        identity -> {
          identity.remove(name);
          if (!value.isEmpty()) {
            identity.put(name, value);
          }
        });
  }
}
