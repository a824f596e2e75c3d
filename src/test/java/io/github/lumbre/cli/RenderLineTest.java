package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.view.RenderLine;
import io.github.lumbre.scene.RenderSettings;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;

/** The command line that renders what the page of a view shows. */
class RenderLineTest {
  private static final RenderSettings SMALL =
      RenderSettings.builder().size(300, 200).samples(64).build();

  private static RenderLine line(String... args) {
    CommandSpec view = new CommandLine(new ViewCommand()).getCommandSpec();
    CommandSpec render = new CommandLine(new RenderCommand()).getCommandSpec();
    return RenderLine.of(Path.of(args[1]), List.of(args), view, render);
  }

  @Test
  void flagsOfThePageAloneAreLeftOut() {
    assertThat(
            line("view", "a.glb", "--no-open", "--view", "iso", "--port=8080", "--ground", "-s9")
                .text(SMALL))
        .isEqualTo("lumbre render a.glb --view iso --ground -s9 -o a.png");
    assertThat(line("view", "a.glb", "--compare", "b.png").text(SMALL))
        .isEqualTo("lumbre render a.glb -s 64 -o a.png");
  }

  @Test
  void wordsAreQuotedForAShell() {
    assertThat(line("view", "my part's.stl", "--hide", "a b*", "--sky-rotation", "-30").text(SMALL))
        .isEqualTo(
            "lumbre render 'my part'\\''s.stl' --hide 'a b*' --sky-rotation -30 -s 64 -o"
                + " 'my part'\\''s.png'");
  }

  @Test
  void aMovedCameraReplacesTheFormerOne() {
    List<String> camera = List.of("--eye=1,2,3", "--fov=35");
    RenderLine line =
        line("view", "a.glb", "--view", "front", "--up", "z", "--zoom=2", "--fit", "w", "--fov=9");
    assertThat(line.movedTo(camera, SMALL).text(SMALL))
        .isEqualTo(
            "lumbre render a.glb --up z --size 300x200 --eye=1,2,3 --fov=35 -s 64 -o a.png");
    RenderLine sized = line("view", "a.glb", "--camera", "c", "--size", "300x200");
    assertThat(sized.movedTo(camera, SMALL).text(SMALL))
        .isEqualTo("lumbre render a.glb --size 300x200 --eye=1,2,3 --fov=35 -s 64 -o a.png");
  }
}
