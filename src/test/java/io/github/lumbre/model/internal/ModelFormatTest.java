package io.github.lumbre.model.internal;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Locale;
import org.junit.jupiter.api.Test;

class ModelFormatTest {
  @Test
  void titlesNameEachEnding() {
    String titles = ModelFormat.TITLES.toLowerCase(Locale.ROOT).replace("collada", "dae");
    assertThat(titles.replace(" or ", ", ").split(", "))
        .containsExactly(ModelFormat.ENDINGS.replace(".", "").split(", "));
  }
}
