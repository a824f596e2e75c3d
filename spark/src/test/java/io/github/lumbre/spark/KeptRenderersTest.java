package io.github.lumbre.spark;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneParser;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** An executor keeps few renderers: a sequence has one for each frame. */
class KeptRenderersTest {
  private final List<String> made = new ArrayList<>();
  private final KeptRenderers kept = new KeptRenderers(2);
  private final FilmRenderer renderer;

  KeptRenderersTest() throws Exception {
    SceneFile scene = new SceneParser().parse(Path.of("..", "scenes", "camera-pinhole.json"));
    renderer = new FilmRenderer(scene.settings(), scene.scene());
  }

  private FilmRenderer get(String key) {
    return kept.get(
        key,
        () -> {
          made.add(key);
          return renderer;
        });
  }

  @Test
  void theRendererThatWasNotUsedForLongestGoes() {
    for (String key : List.of("a", "b", "a", "c", "a", "b")) {
      assertThat(get(key)).isSameAs(renderer);
    }
    assertThat(made).containsExactly("a", "b", "c", "b");
  }
}
