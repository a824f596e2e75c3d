package io.github.lumbre.render;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.scene.RenderSettings;
import org.junit.jupiter.api.Test;

/** Tests the memory estimate that rejects pictures too large for the heap. */
class MemoryEstimateTest {
  private static final long MEBIBYTE = 1 << 20;
  private static final RenderSettings LARGE =
      new RenderSettings.Builder().size(16384, 16384).threads(16).build();

  @Test
  void picturesTooLargeForTheHeapAreRefusedWithAllFigures() {
    MemoryEstimate estimate =
        new MemoryEstimate(LARGE, FilmLayers.NONE, 100 * MEBIBYTE, 512 * MEBIBYTE);
    assertThat(estimate.refusal().orElseThrow())
        .contains("16384x16384 pixels need 20489 MiB")
        .contains("in addition to the scene's 100 MiB")
        .contains("maximum heap size is 512 MiB");
  }

  @Test
  void onlyTheCropCounts() {
    RenderSettings cropped =
        LARGE.toBuilder().crop(new RenderSettings.Crop(9, 9, 100, 100)).build();
    assertThat(new MemoryEstimate(cropped, FilmLayers.NONE, 0, 64 * MEBIBYTE).refusal()).isEmpty();
  }

  @Test
  void sceneAndThreadsLeaveLessForTheFilm() {
    MemoryEstimate estimate = new MemoryEstimate(LARGE, FilmLayers.NONE, 0, 0);
    long heap = estimate.neededBytes();
    assertThat(new MemoryEstimate(LARGE, FilmLayers.NONE, 0, heap).fits()).isTrue();
    assertThat(new MemoryEstimate(LARGE, FilmLayers.NONE, 1, heap).fits()).isFalse();
    RenderSettings crowded = LARGE.toBuilder().threads(17).build();
    assertThat(new MemoryEstimate(crowded, FilmLayers.NONE, 0, heap).fits()).isFalse();
  }
}
