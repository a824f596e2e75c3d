package io.github.lumbre.math.sampling.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.math.Point2;
import io.github.lumbre.math.sampling.Sampler;
import org.junit.jupiter.api.Test;

/** Tests the independence of the sampler's numbers. */
class IndependentSamplerTest {
  private static final int COUNT = 1 << 16;

  @Test
  void valueIsAFunctionOfTheAddressAlone() {
    IndependentSampler one = new IndependentSampler(7);
    IndependentSampler other = new IndependentSampler(7);
    one.startSample(3, 4, 5);
    other.startSample(9, 9, 9);
    other.get1d(2);
    other.startSample(3, 4, 5);
    assertThat(other.get1d(8)).isEqualTo(one.get1d(8));
    assertThat(other.get2d(8)).isEqualTo(new Point2(one.get1d(8), one.get1d(9)));
    other.startSample(4, 3, 5);
    assertThat(other.get1d(8)).isNotEqualTo(one.get1d(8));
    IndependentSampler ofAnotherSeed = new IndependentSampler(8);
    ofAnotherSeed.startSample(3, 4, 5);
    assertThat(ofAnotherSeed.get1d(8)).isNotEqualTo(one.get1d(8));
  }

  /** Means and products are within five standard errors of those of independent uniform numbers. */
  @Test
  void valuesAreUniformAndDoNotKnowOfEachOther() {
    IndependentSampler sampler = new IndependentSampler(1);
    double mean = 0;
    double square = 0;
    double next = 0;
    double acrossSamples = 0;
    double last = .5;
    for (int sample = 0; sample < COUNT; sample++) {
      sampler.startSample(10, 20, sample);
      Point2 p = sampler.get2d(Sampler.DIRECTION);
      mean += p.x() / COUNT;
      square += p.x() * p.x() / COUNT;
      next += (p.x() - .5) * (p.y() - .5) / COUNT;
      acrossSamples += (p.x() - .5) * (last - .5) / COUNT;
      last = p.x();
    }
    double root = Math.sqrt(COUNT);
    assertThat(mean).isCloseTo(.5, within(5 * .2887 / root));
    assertThat(square).isCloseTo(1 / 3., within(5 * .2981 / root));
    assertThat(next).isCloseTo(0, within(5 / 12. / root));
    assertThat(acrossSamples).isCloseTo(0, within(5 / 12. / root));
  }
}
