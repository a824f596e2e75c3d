package io.github.lumbre.cli.output;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.base.TaskException;
import io.github.lumbre.render.FilmLayers;
import io.github.lumbre.render.MemoryEstimate;
import io.github.lumbre.scene.RenderSettings;
import org.junit.jupiter.api.Test;

/** Tests the advice about the heap when a picture does not fit into it. */
class MemoryCheckTest {
  private static final long MEBIBYTE = 1 << 20;

  @Test
  void theAdviceIsEnoughForTheNeed() {
    assertThat(MemoryCheck.advice(21 * MEBIBYTE))
        .isEqualTo("raise it with LUMBRE_JAVA_OPTS=-Xmx64m");
    assertThat(MemoryCheck.advice(128 * MEBIBYTE)).endsWith("=-Xmx192m");
    assertThat(MemoryCheck.advice(900 * MEBIBYTE)).endsWith("=-Xmx1g");
    assertThat(MemoryCheck.advice(1000 * MEBIBYTE)).endsWith("=-Xmx2g");
    assertThat(MemoryCheck.advice(19540 * MEBIBYTE)).endsWith("=-Xmx22g");
  }

  @Test
  void refusalsAdviseTheHeapThatTheRenderNeeds() {
    RenderSettings large = new RenderSettings.Builder().size(16384, 16384).threads(16).build();
    MemoryEstimate estimate =
        new MemoryEstimate(large, FilmLayers.NONE, 100 * MEBIBYTE, 512 * MEBIBYTE);
    assertThatThrownBy(() -> MemoryCheck.require(estimate))
        .isInstanceOf(TaskException.class)
        .hasMessageEndingWith("is 512 MiB; raise it with LUMBRE_JAVA_OPTS=-Xmx23g");
  }
}
