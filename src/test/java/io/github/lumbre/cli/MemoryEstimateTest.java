package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import io.github.lumbre.scene.RenderSettings;
import org.junit.jupiter.api.Test;

class MemoryEstimateTest {
  private static final RenderSettings LARGE =
      new RenderSettings.Builder().size(16384, 16384).build();

  @Test
  void picturesTooLargeForTheHeapAreRefusedWithBothFigures() {
    CommandException thrown =
        catchThrowableOfType(
            CommandException.class, () -> MemoryEstimate.require(LARGE, 512L << 20));
    assertThat(thrown.exitCode()).isEqualTo(ExitCodes.LIMIT);
    assertThat(thrown).hasMessageContaining("18448 MiB").hasMessageContaining("512 MiB");
  }

  @Test
  void onlyTheCropCounts() {
    RenderSettings cropped =
        LARGE.toBuilder().crop(new RenderSettings.Crop(9, 9, 100, 100)).build();
    assertThatCode(() -> MemoryEstimate.require(cropped, 64L << 20)).doesNotThrowAnyException();
  }
}
