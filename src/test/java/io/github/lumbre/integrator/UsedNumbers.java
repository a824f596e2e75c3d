package io.github.lumbre.integrator;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.math.Point2;
import io.github.lumbre.math.sampling.Sampler;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** Passes on the numbers of a sampler and notes which are used. */
final class UsedNumbers implements Sampler {
  private final Sampler source;
  private final Set<Integer> singles = new HashSet<>();
  private final Set<Integer> points = new HashSet<>();
  private final List<Integer> all = new ArrayList<>();
  private int part;

  UsedNumbers(Sampler source) {
    this.source = source;
  }

  @Override
  public void startSample(int x, int y, int sample) {
    source.startSample(x, y, sample);
  }

  @Override
  public void startPart(int number, int parts) {
    part = number;
    source.startPart(number, parts);
  }

  @Override
  public double get1d(int dimension) {
    note(singles, dimension);
    return source.get1d(dimension);
  }

  @Override
  public Point2 get2d(int dimension) {
    note(points, dimension);
    return source.get2d(dimension);
  }

  private void note(Set<Integer> kind, int dimension) {
    assertThat(dimension).isGreaterThanOrEqualTo(FIRST_VERTEX);
    if (dimension < FIRST_MIRROR) {
      kind.add((dimension - FIRST_VERTEX) % VERTEX_STRIDE);
    } else {
      assertThat(kind).as("a search through glass").isSameAs(singles);
      assertThat((dimension - Sampler.glass(0)) % 4).isZero();
    }
    // Parts of a sample have different numbers at the same dimensions.
    all.add(dimension + 1_000_000 * part);
  }

  /** Returns how many numbers and points were used. */
  int count() {
    return all.size();
  }

  /** Returns whether numbers of an offset within a vertex were used. */
  boolean uses(int offset) {
    return singles.contains(offset) || points.contains(offset);
  }

  /** Checks that nothing was used twice, or at an offset of something else. */
  void assertUsedAsAgreed() {
    assertThat(all).doesNotHaveDuplicates();
    assertThat(Set.of(LIGHT_CHOICE, LOBE, ROULETTE)).containsAll(singles);
    assertThat(Set.of(LIGHT_POINT, DIRECTION)).containsAll(points);
  }
}
