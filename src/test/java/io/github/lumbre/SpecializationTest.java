package io.github.lumbre;

import static io.github.lumbre.testing.Folders.scenes;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.render.PictureRenderer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.internal.SceneInside;
import io.github.lumbre.scene.internal.Specialization;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneParser;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** Renders with and without specializations are bit-identical. */
class SpecializationTest {
  private static RenderSettings tiny(RenderSettings settings) {
    return settings.toBuilder().size(24, 16).samples(2).build();
  }

  @Test
  void picturesAreTheSameWithoutShortcuts() throws Exception {
    Set<Specialization> taken = EnumSet.noneOf(Specialization.class);
    for (Path scene : scenes()) {
      SceneFile file = new SceneParser().overriding(SpecializationTest::tiny).parse(scene);
      PictureRenderer renderer = new PictureRenderer(file.settings());
      Scene general = file.scene();
      for (Specialization shortcut : Specialization.values()) {
        if (SceneInside.of(general).takes(shortcut)) {
          taken.add(shortcut);
        }
        general = SceneInside.of(general).without(shortcut);
        assertThat(SceneInside.of(general).takes(shortcut)).isFalse();
      }
      assertThat(renderer.render(general))
          .as("%s", scene)
          .usingRecursiveComparison()
          .isEqualTo(renderer.render(file.scene()));
    }
    assertThat(taken).containsExactlyInAnyOrder(Specialization.values());
  }
}
