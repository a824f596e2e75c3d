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

/** Every malformed picture is compared, or rejected with a reason. */
class HostilePicturesTest {
  private static final int COUNT = 5000;

  @TempDir private Path folder;

  @Test
  @Timeout(value = 120, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
  void anyPictureIsComparedOrRefusedForAReason() {
    HostilePictures pictures = new HostilePictures(folder);
    Map<Integer, Long> endings =
        LongStream.range(0, COUNT)
            .mapToObj(i -> pictures.run(Effort.seed(0) + i))
            .collect(Collectors.groupingBy(Ending::exitCode, TreeMap::new, Collectors.counting()));
    assertThat(endings).containsOnlyKeys(0, 4, 5);
    assertThat(endings.get(0)).isBetween(COUNT / 10L, COUNT * 9L / 10);
  }

  @Test
  @Tag("fuzz")
  void aMillionPictures() throws InterruptedException {
    FuzzRun run = FuzzRun.fromProperties("pictures", new HostilePictures(folder)::run);
    run.start();
    assertThat(run.failures()).isEmpty();
  }
}
