package io.github.lumbre.cli.run;

import static org.assertj.core.api.Assertions.assertThatCode;

import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.render.checkpoint.RecordedLayers;
import io.github.lumbre.scene.RenderSettings;
import java.util.Map;
import org.junit.jupiter.api.Test;

class FilmKeeperTest {
  /** The notes of a film have hashes of all files, which take a while. */
  @Test
  void withoutAFileNoNotesAreMade() {
    try (FilmKeeper keeper = FilmKeeper.none(Messages.NONE)) {
      assertThatCode(
              () ->
                  keeper.begin(
                      Map.of(),
                      RecordedLayers.NONE,
                      () -> {
                        throw new AssertionError("made");
                      },
                      RenderStatistics.ZERO,
                      RenderSettings.builder().build()))
          .doesNotThrowAnyException();
    }
  }
}
