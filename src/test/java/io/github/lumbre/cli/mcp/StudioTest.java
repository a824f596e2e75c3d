package io.github.lumbre.cli.mcp;

import static io.github.lumbre.testing.Refusals.assertCancelled;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.stage.Stage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class StudioTest {
  private static final String MODEL =
      "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl m\nf 1/1 2/1 3/1\n";

  @TempDir private Path folder;
  private Studio studio;

  @BeforeEach
  void write() throws IOException {
    Files.writeString(folder.resolve("a.obj"), MODEL);
    Files.writeString(folder.resolve("a.mtl"), "newmtl m\nKd 1 0 0\nmap_Kd later.png\n");
    studio = studio(Limits.UPLOADS);
  }

  private Studio studio(Limits limits) throws IOException {
    return new Studio(new Roots(List.of(folder)), limits);
  }

  private Studio.Staged model() throws ToolException {
    return studio.model("a.obj", Stage.DEFAULT);
  }

  @Test
  void aModelIsReadOnce() throws Exception {
    Studio.Staged first = model();
    assertThat(model()).isSameAs(first);
    assertThat(studio.model(folder.resolve("a.obj").toString(), Stage.DEFAULT)).isSameAs(first);
  }

  @ParameterizedTest
  @ValueSource(strings = {"a.obj", "a.mtl", "later.png"})
  void aChangedFileIsReadAnew(String name) throws Exception {
    Studio.Staged first = model();
    Path file = folder.resolve(name);
    Files.writeString(file, (Files.exists(file) ? Files.readString(file) : "") + "\n# new\n");
    Studio.Staged second = model();
    assertThat(second).isNotSameAs(first);
    assertThat(model()).isSameAs(second);
    Files.delete(folder.resolve("a.mtl"));
    assertThat(model()).isNotSameAs(second);
  }

  @Test
  void readingHasLimits() throws IOException {
    studio = studio(Limits.UPLOADS.withBytes(20));
    assertThatThrownBy(this::model).isInstanceOf(ToolException.class).hasMessageContaining("bytes");
    studio = studio(Limits.UPLOADS.withTriangles(0));
    assertThatThrownBy(this::model).hasMessageContaining("expected at most 0 triangles");
    // Reading it takes longer than a busy machine takes to notice that the time has passed.
    Files.writeString(folder.resolve("a.obj"), MODEL + "v 0 0 0\n".repeat(2_000_000));
    studio = studio(Limits.UPLOADS.withTime(Duration.ofNanos(1)));
    assertThatThrownBy(this::model).hasMessageContaining("read within");
  }

  @Test
  void anInterruptEndsReading() {
    assertCancelled(this::model);
  }

  @Test
  void theCacheKeepsWithinItsBound() {
    ModelCache<String> cache = new ModelCache<>(100);
    cache.put(1, "a", 40);
    cache.put(2, "b", 40);
    assertThat(cache.get(1)).contains("a");
    cache.put(3, "c", 60);
    assertThat(cache.get(2)).as("the one that was not used").isEmpty();
    assertThat(cache.get(1)).contains("a");
    cache.put(1, "A", 50);
    assertThat(cache.get(1)).contains("A");
    assertThat(cache.get(3)).as("110 bytes with the new value").isEmpty();
    cache.put(4, "d", 101);
    assertThat(cache.get(4)).isEmpty();
    assertThat(cache.get(1)).contains("A");
  }
}
