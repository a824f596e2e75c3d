package io.github.lumbre.model.internal;

import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.model.ModelFormatException;
import org.junit.jupiter.api.Test;

/** Tests what is refused before memory is allocated for it. */
class ModelLimitsTest {
  /** A million triangles were rendered with a heap of 155 MiB, and not with one of 146 MiB. */
  @Test
  void modelsThatCannotFitIntoTheHeapAreRefused() {
    assertThatCode(() -> ModelLimits.requireHeap("", 1_000_000, 155L << 20))
        .doesNotThrowAnyException();
    assertThatThrownBy(() -> ModelLimits.requireHeap("element face", 1_000_000, 100L << 20))
        .isInstanceOf(ModelFormatException.class)
        .hasMessage(
            "element face: expected a model that fits into the heap of 100 MiB, found 1000000"
                + " triangles, which take 134 MiB or more; Java's option -Xmx sets the heap");
  }
}
