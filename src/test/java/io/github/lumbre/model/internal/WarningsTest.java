package io.github.lumbre.model.internal;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class WarningsTest {
  @Test
  void twentyOfAKindAreListedAndTheOthersCounted() {
    Warnings warnings = new Warnings();
    for (int i = 0; i < 23; i++) {
      warnings.add("lines", "line " + i, "found line " + i);
      warnings.add("line " + i, "points are left out");
    }
    List<String> all = warnings.all();
    assertThat(all).hasSize(42);
    assertThat(all.subList(38, 42))
        .containsExactly(
            "line 19: found line 19",
            "line 19: points are left out",
            "and 3 more: lines",
            "and 3 more: points are left out");
  }

  @Test
  void equalWarningsAreListedOnce() {
    Warnings warnings = new Warnings();
    warnings.add("a", "", "the same");
    warnings.add("b", "", "the same");
    warnings.once("c", "line 1", "first");
    warnings.once("c", "line 2", "second");
    assertThat(warnings.all()).containsExactly("the same", "line 1: first");
  }

  @Test
  void kindsAreLimited() {
    Warnings warnings = new Warnings();
    for (int i = 0; i < 1002; i++) {
      warnings.add("", "unknown statement " + i);
    }
    assertThat(warnings.all()).hasSize(1001).endsWith("and 2 more warnings");
  }
}
