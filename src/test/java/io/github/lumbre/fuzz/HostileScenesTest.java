package io.github.lumbre.fuzz;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.fuzz.HostileScenes.Ending;
import io.github.lumbre.testing.Effort;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Every hostile scene is rendered, or rejected with a reason. */
class HostileScenesTest {
  private static final int COUNT = 2000;

  @TempDir private Path folder;

  @Test
  @Timeout(value = 120, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
  void anySceneIsRenderedOrRefusedForAReason() {
    HostileScenes scenes = new HostileScenes(folder);
    Map<Integer, Long> endings =
        LongStream.range(0, COUNT)
            .mapToObj(i -> scenes.run(Effort.seed(0) + i))
            .collect(Collectors.groupingBy(Ending::exitCode, TreeMap::new, Collectors.counting()));
    assertThat(endings).containsOnlyKeys(0, 3, 4, 5);
    // If all scenes were rejected, or all rendered, the test would be useless.
    assertThat(endings.get(0)).isBetween(COUNT / 10L, COUNT * 9L / 10);
  }

  @Test
  void sameSeedIsTheSameScene() {
    HostileScenes scenes = new HostileScenes(folder);
    assertThat(scenes.text(7)).isEqualTo(scenes.text(7)).isNotEqualTo(scenes.text(8));
  }

  @Test
  @Tag("fuzz")
  void aMillionScenes() throws InterruptedException {
    FuzzRun run = FuzzRun.fromProperties("scenes", new HostileScenes(folder)::run);
    run.start();
    assertThat(run.failures()).isEmpty();
  }
}
