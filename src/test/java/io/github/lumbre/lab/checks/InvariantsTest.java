package io.github.lumbre.lab.checks;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.testing.Effort;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The checks of {@code lumbre selftest} pass on this machine. */
class InvariantsTest {
  private static final Tries TRIES = new Tries(Effort.count(1, 10), Effort.seed(0));

  static Stream<Invariant> laws() {
    return Invariants.all().stream();
  }

  @ParameterizedTest
  @MethodSource("laws")
  void lawHolds(Invariant law) {
    assertThat(law.measure(TRIES).worst()).as(law.name()).isBetween(0.0, law.limit());
  }

  @Test
  void namesAreDistinct() {
    List<String> names = laws().map(Invariant::name).toList();
    assertThat(names).doesNotHaveDuplicates().allMatch(name -> name.matches("[a-z0-9-]+"));
  }

  @Test
  void whatIsNoNumberDoesNotHold() {
    assertThat(law(.9).measure(TRIES).holds()).isTrue();
    assertThat(law(1.1).measure(TRIES).holds()).isFalse();
    assertThat(law(Double.NaN).measure(TRIES).holds()).isFalse();
    assertThat(law(Double.POSITIVE_INFINITY).measure(TRIES).holds()).isFalse();
  }

  private static Invariant law(double worst) {
    return new Invariant("some", "what", "where", 1, tries -> worst);
  }
}
