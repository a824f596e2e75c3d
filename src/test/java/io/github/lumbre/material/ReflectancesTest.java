package io.github.lumbre.material;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.Dielectric;
import io.github.lumbre.material.internal.RoughDielectric;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.texture.ScalarTexture;
import io.github.lumbre.texture.Texture;
import io.github.lumbre.texture.TexturePoint;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Tests how materials evaluate their colors and numbers at a hit. */
class ReflectancesTest {
  private static final TexturePoint HIT = new TexturePoint(0, 0);
  private static final double JUST_BELOW = Math.nextDown(CookTorrance.SMOOTH);

  private static Texture<Rgb> color(double r, double g, double b) {
    return Texture.constant(new Rgb(r, g, b));
  }

  private static Bsdf cookTorrance(
      Texture<Rgb> diffuse, double roughness, MicrofacetDistribution kind) {
    return new CookTorrance(
            diffuse,
            color(1, 1, 1),
            ScalarTexture.constant(roughness),
            ScalarTexture.constant(MicrofacetReflectionTest.PERFECT),
            kind)
        .at(HIT);
  }

  private static Bsdf glass(double ior, double roughness) {
    return new Glass(
            color(1, 2, 1),
            color(.5, 1, 3),
            ScalarTexture.constant(ior),
            ScalarTexture.constant(roughness))
        .at(HIT);
  }

  @Test
  void colorsThatReflectTooMuchTogetherAreScaledAndKeepTheirHue() {
    Reflectances scaled = Reflectances.of(new Rgb(1, .5, 0), new Rgb(1, .5, .25));
    assertThat(scaled).isEqualTo(new Reflectances(new Rgb(.5, .25, 0), new Rgb(.5, .25, .125)));
    assertThat(Reflectances.of(Rgb.gray(1e300), Rgb.BLACK).diffuse()).isEqualTo(Rgb.WHITE);
  }

  @Test
  void colorsThatReflectNoMoreThanOneStay() {
    Rgb diffuse = new Rgb(.25, 0, 1);
    Rgb specular = new Rgb(.75, .5, 0);
    assertThat(Reflectances.of(diffuse, specular)).isEqualTo(new Reflectances(diffuse, specular));
  }

  @Test
  void blackPartsAreLeftOut() {
    Lobe lobe = new PhongLobe(Rgb.WHITE, 3);
    assertThat(new Reflectances(Rgb.BLACK, Rgb.WHITE).with(lobe)).isSameAs(lobe);
    assertThat(new Reflectances(Rgb.WHITE, Rgb.BLACK).with(lobe))
        .isEqualTo(new Lambertian(Rgb.WHITE));
    assertThat(new Reflectances(Rgb.gray(.5), Rgb.gray(.5)).with(lobe)).isInstanceOf(Mixture.class);
  }

  @Test
  void whiteMaterialsThatWouldDoubleTheLightKeepIt() {
    for (double cos : BsdfLaws.COSINES) {
      Vec3 wo = BsdfLaws.direction(cos);
      for (double exponent : new double[] {0, 10, 1e6}) {
        Bsdf phong =
            new Phong(color(1, 1, 1), color(1, 1, 1), ScalarTexture.constant(exponent)).at(HIT);
        assertThat(BsdfLaws.sampledAlbedo(phong, wo, 4000)).isLessThan(1.005);
      }
      for (double roughness : new double[] {0, .1, 1}) {
        Bsdf bsdf = cookTorrance(color(1, 1, 1), roughness, MicrofacetDistribution.BECKMANN);
        assertThat(BsdfLaws.sampledAlbedo(bsdf, wo, 4000)).isLessThan(1.005);
      }
    }
  }

  @ParameterizedTest
  @EnumSource(MicrofacetDistribution.class)
  void roughnessBelowAThousandthIsAMirror(MicrofacetDistribution kind) {
    Texture<Rgb> black = color(0, 0, 0);
    assertThat(cookTorrance(black, JUST_BELOW, kind)).isInstanceOf(FresnelMirror.class);
    assertThat(cookTorrance(black, 0, kind).isSpecular()).isTrue();
    assertThat(cookTorrance(black, CookTorrance.SMOOTH, kind))
        .isInstanceOf(MicrofacetReflection.class);
    assertThat(cookTorrance(color(.5, 0, 0), 0, kind).isSpecular()).isFalse();
  }

  @Test
  void mirrorOfFacetsReflectsByFresnelOnBothSides() {
    FresnelMirror mirror = new FresnelMirror(new Rgb(1, .5, 0), 1.5);
    for (Vec3 wo : new Vec3[] {Vec3.Z, Vec3.Z.negated()}) {
      BsdfSample sample = mirror.sample(wo, .5, new Point2(.5, .5));
      assertThat(sample.wi().z()).isEqualTo(wo.z());
      assertThat(sample.isSpecular()).isTrue();
      assertThat(sample.weight().r()).isCloseTo(.04, within(1e-15));
      assertThat(sample.weight().g()).isCloseTo(.02, within(1e-15));
    }
    assertThat(mirror.evaluate(Vec3.Z, Vec3.Z).f().isBlack()).isTrue();
    assertThat(mirror.pdf(Vec3.Z, Vec3.Z)).isZero();
  }

  @Test
  void glassIsSmoothWhereItsFacetsWouldNotShow() {
    Dielectric expected = new Dielectric(Rgb.WHITE, new Rgb(.5, 1, 1), 1.5);
    assertThat(glass(1.5, 0)).isEqualTo(expected);
    assertThat(glass(1.5, JUST_BELOW)).isEqualTo(expected);
    assertThat(glass(1, .5)).isInstanceOf(Dielectric.class);
    assertThat(glass(1 + 1e-12, .5)).isInstanceOf(Dielectric.class);
    assertThat(glass(1 + 1e-7, .5)).isInstanceOf(RoughDielectric.class);
    assertThat(glass(1.5, CookTorrance.SMOOTH)).isInstanceOf(RoughDielectric.class);
  }

  @Test
  void exponentsAreLimitedToWhatDirectionsCanTell() {
    for (double exponent : new double[] {1e12, 1e13, 1e300, Double.MAX_VALUE}) {
      Bsdf phong =
          new Phong(color(0, 0, 0), color(1, 1, 1), ScalarTexture.constant(exponent)).at(HIT);
      assertThat(BsdfLaws.sampledAlbedo(phong, Vec3.Z, 100)).isCloseTo(1, within(1e-9));
    }
  }
}
