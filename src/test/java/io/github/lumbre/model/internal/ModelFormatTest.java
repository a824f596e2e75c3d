package io.github.lumbre.model.internal;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Locale;
import org.junit.jupiter.api.Test;

class ModelFormatTest {
  @Test
  void titlesNameEachEnding() {
    assertThat(ModelFormat.TITLES.toLowerCase(Locale.ROOT).replace(" or ", ", ").split(", "))
        .containsExactly(ModelFormat.ENDINGS.replace(".", "").split(", "));
  }
}
