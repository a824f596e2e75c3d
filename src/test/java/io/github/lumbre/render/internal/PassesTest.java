package io.github.lumbre.render.internal;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Tests the lengths of passes. */
class PassesTest {
  private static List<Integer> ends(int done, int goal) {
    List<Integer> ends = new ArrayList<>();
    for (int i = done; i < goal; ) {
      i = Passes.next(i, goal);
      ends.add(i);
    }
    return ends;
  }

  @Test
  void passesDoubleAndThenAreOfOneLength() {
    assertThat(ends(0, 1)).containsExactly(1);
    assertThat(ends(0, 100)).containsExactly(1, 2, 4, 8, 16, 32, 64, 100);
    assertThat(ends(0, 256)).containsExactly(1, 2, 4, 8, 16, 32, 64, 128, 192, 256);
  }

  @Test
  void passesMeetTheSameBoundariesWhereverTheyBegin() {
    assertThat(ends(5, 20)).containsExactly(8, 16, 20);
    assertThat(ends(63, 130)).containsExactly(64, 128, 130);
    assertThat(ends((1 << 30) - 70, 1 << 30)).containsExactly((1 << 30) - 64, 1 << 30);
  }
}
