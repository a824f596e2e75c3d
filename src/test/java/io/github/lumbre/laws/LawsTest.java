package io.github.lumbre.laws;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.testing.Effort;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What {@code lumbre selftest} measures on the user's machine holds on this one. */
class LawsTest {
  static Stream<Law> laws() {
    return Laws.all().stream();
  }

  @ParameterizedTest
  @MethodSource("laws")
  void lawHolds(Law law) {
    assertThat(law.measure(Effort.count(1, 10)).worst()).as(law.name()).isBetween(0.0, law.limit());
  }

  @Test
  void namesAreDistinct() {
    List<String> names = laws().map(Law::name).toList();
    assertThat(names).doesNotHaveDuplicates().allMatch(name -> name.matches("[a-z0-9-]+"));
  }

  @Test
  void whatIsNoNumberDoesNotHold() {
    assertThat(law(.9).measure(1).holds()).isTrue();
    assertThat(law(1.1).measure(1).holds()).isFalse();
    assertThat(law(Double.NaN).measure(1).holds()).isFalse();
    assertThat(law(Double.POSITIVE_INFINITY).measure(1).holds()).isFalse();
  }

  private static Law law(double worst) {
    return new Law("some", "what", "where", 1, effort -> worst);
  }
}
