package io.github.lumbre.material;

import static io.github.lumbre.material.BsdfLaws.direction;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Vec3;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Tests the sheen of cloth. */
class SheenTest {
  private static final int POINTS = 400;

  private final SplittableRandom random = new SplittableRandom(62);

  static double quadrature(double cosine, double roughness) {
    Sheen sheen = new Sheen(Rgb.WHITE, roughness);
    Vec3 wo = direction(cosine);
    double sum = 0;
    for (int i = 0; i < POINTS; i++) {
      // Squares, because the value has a large slope at the horizon.
      double s = (i + .5) / POINTS;
      double z = s * s;
      double sin = Math.sqrt((1 - z) * (1 + z));
      for (int j = 0; j < POINTS; j++) {
        double phi = 2 * Math.PI * (j + .5) / POINTS;
        Vec3 wi = new Vec3(sin * Math.cos(phi), sin * Math.sin(phi), z);
        sum += 2 * s * sheen.evaluate(wo, wi).f().g();
      }
    }
    return sum * 2 * Math.PI / (POINTS * POINTS);
  }

  @Test
  void albedoIsTheIntegralAndAtMostOne() {
    for (double roughness : new double[] {0, .03, .1, .22, .4, .6, .77, 1}) {
      for (double cosine : new double[] {1, .9, .6, .4, .25, .15, .08, .04, .01, .002}) {
        double albedo = quadrature(cosine, roughness);
        assertThat(albedo).as("%s %s", cosine, roughness).isLessThanOrEqualTo(1 + 1e-3);
        assertThat(Sheen.albedo(cosine, roughness))
            .as("cosine %s, roughness %s", cosine, roughness)
            .isCloseTo(albedo, within(5e-3));
      }
    }
  }

  @Test
  void colorScalesTheLobe() {
    Rgb color = new Rgb(.9, .3, .1);
    Vec3 wo = direction(.4);
    Vec3 wi = direction(.7);
    Rgb white = new Sheen(Rgb.WHITE, .5).evaluate(wo, wi).f();
    Rgb tinted = new Sheen(color, .5).evaluate(wo, wi).f();
    assertThat(tinted.r()).isCloseTo(.9 * white.r(), within(1e-15));
    assertThat(tinted.b()).isCloseTo(.1 * white.b(), within(1e-15));
  }

  @Test
  void lobeObeysTheInvariants() {
    for (double roughness : new double[] {0, .3, 1}) {
      Sheen sheen = new Sheen(Rgb.WHITE, roughness);
      BsdfLaws.assertExtremesAreHarmless(sheen);
      BsdfLaws.assertWeightIsEvalOverPdf(sheen, direction(-.4), 1000, random, 1e-12);
      for (int i = 0; i < 1000; i++) {
        Vec3 a = direction(random);
        Vec3 b = direction(random);
        double there = sheen.evaluate(a, b).f().g() * Math.abs(a.z());
        double back = sheen.evaluate(b, a).f().g() * Math.abs(b.z());
        assertThat(there).isCloseTo(back, within(1e-12 * there + 1e-300));
      }
    }
  }
}
