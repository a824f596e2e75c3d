package io.github.lumbre.cli.output;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.TinyScene;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneParser;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Tests the texts in a picture's file. */
class PictureMetadataTest {
  private static final Path SCENE = Path.of("tiny.json");

  private static Map<String, String> texts(double seconds, Map<String, String> environment)
      throws Exception {
    byte[] text = TinyScene.JSON.getBytes(StandardCharsets.UTF_8);
    SceneFile file = new SceneParser().parse(text, SCENE);
    return PictureMetadata.of(SCENE, file, file.settings(), seconds, environment);
  }

  @Test
  void theTimeIsLeftOutOfReproducibleFiles() throws Exception {
    Map<String, String> reproducible = Map.of("SOURCE_DATE_EPOCH", "0");
    assertThat(texts(1, Map.of())).containsEntry("Time", "1.00");
    assertThat(texts(1, reproducible)).doesNotContainKey("Time");
    assertThat(texts(1, reproducible)).isEqualTo(texts(2, reproducible));
  }
}
