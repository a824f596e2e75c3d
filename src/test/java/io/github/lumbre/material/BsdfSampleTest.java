package io.github.lumbre.material;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Vec3;
import org.junit.jupiter.api.Test;

/** Tests the accessors of BSDF samples. */
class BsdfSampleTest {
  private static final Rgb WEIGHT = new Rgb(.1, .2, .3);
  private static final Vec3 WI = new Vec3(.36, .48, .8);

  private final BsdfSample sample = new BsdfSample();

  @Test
  void componentsAreThoseOfDirectionAndWeight() {
    sample.set(WI, WEIGHT, 7);
    assertThat(new Vec3(sample.x(), sample.y(), sample.z())).isEqualTo(WI).isEqualTo(sample.wi());
    assertThat(new Rgb(sample.r(), sample.g(), sample.b()))
        .isEqualTo(WEIGHT)
        .isEqualTo(sample.weight());
    BsdfValue value = new BsdfValue();
    value.set(WEIGHT, 7);
    assertThat(new Rgb(value.r(), value.g(), value.b())).isEqualTo(WEIGHT).isEqualTo(value.f());
  }

  @Test
  void lightEndsOnlyIfNoComponentIsLeft() {
    assertThat(new BsdfSample().isAbsorbed()).isTrue();
    for (Rgb one : new Rgb[] {new Rgb(1, 0, 0), new Rgb(0, 1, 0), new Rgb(0, 0, 1)}) {
      sample.set(WI, one, 7);
      assertThat(sample.isAbsorbed()).isFalse();
    }
    sample.absorb();
    assertThat(sample.isAbsorbed()).isTrue();
    assertThat(sample.pdf()).isZero();
  }

  @Test
  void onlyDeltaLobesAreSpecular() {
    sample.setSpecular(WI, WEIGHT);
    assertThat(sample.isSpecular()).isTrue();
    sample.set(WI, WEIGHT, 1e300);
    assertThat(sample.isSpecular()).isFalse();
    sample.absorb();
    assertThat(sample.isSpecular()).isFalse();
  }
}
