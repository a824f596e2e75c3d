package io.github.lumbre.material;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.SpecularReflection;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import org.junit.jupiter.api.Test;

/** Tests the mirror and the unlit surface. */
class SpecularReflectionTest {
  private static final Rgb TINT = new Rgb(.25, .5, 1);
  private static final Point2 U = new Point2(.3, .7);

  private final SpecularReflection mirror = new SpecularReflection(TINT);

  @Test
  void angleOfReflectionIsTheAngleOfIncidenceOnBothSides() {
    for (double side : new double[] {-1, 1}) {
      BsdfSample sample = mirror.sample(new Vec3(.36, -.48, .8 * side), .5, U);
      assertThat(sample.wi()).isEqualTo(new Vec3(-.36, .48, .8 * side));
      assertThat(sample.weight()).isEqualTo(TINT);
      assertThat(sample.isSpecular()).isTrue();
    }
  }

  @Test
  void mirrorIsNeverMetByChance() {
    assertThat(mirror.evaluate(Vec3.Z, Vec3.Z).f().isBlack()).isTrue();
    assertThat(mirror.pdf(Vec3.Z, Vec3.Z)).isZero();
    assertThat(mirror.isSpecular()).isTrue();
    assertThat(mirror.isTransmissive()).isFalse();
    assertThat(mirror.choosesLobe()).isFalse();
    assertThat(mirror.diffuseAlbedo()).isEqualTo(Rgb.BLACK);
  }

  @Test
  void unlitSurfacesScatterNothing() {
    Bsdf absorber = Unlit.INSTANCE.at(.3, .7);
    BsdfLaws.assertSamplesAlike(absorber, Vec3.Z, .5, U);
    assertThat(absorber.sample(Vec3.Z, .5, U).isAbsorbed()).isTrue();
    assertThat(absorber.evaluate(Vec3.Z, Vec3.Z).f()).isEqualTo(Rgb.BLACK);
    assertThat(absorber.isSpecular()).isTrue();
    assertThat(Unlit.INSTANCE.isUniform()).isTrue();
  }
}
