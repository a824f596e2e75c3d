package io.github.lumbre.material;

import static io.github.lumbre.material.BsdfLaws.direction;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.Ggx;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.testing.InParallel;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.Test;

/** Tests the tables of directional albedos against quadratures. */
class GgxAlbedoTest {
  private static final Path RESOURCES = Path.of("src/main/resources/io/github/lumbre/material");

  private static final double ERROR = 2e-3;
  private static final double[] COSINES = {1, .93, .7, .45, .3, .2, .11, .06, .03, .01};
  private static final double[] ALPHAS = {1e-3, .004, .01, .03, .1, .2, .33, .5, .71, .9, 1};

  private static double quadrature(double f0, double f90, double cosine, double alpha) {
    FacetMap map = new FacetMap(MicrofacetDistribution.GGX, alpha);
    Bsdf bsdf = new SchlickReflection(Rgb.gray(f0), f90, new Ggx(alpha));
    Vec3 wo = direction(cosine);
    return map.integral(wo, 0, 200, wi -> bsdf.evaluate(wo, wi).f().g());
  }

  /**
   * To compute the resource again: {@code ./mvnw test -Dtest=GgxAlbedoTest -Dlumbre.write=true}.
   */
  @Test
  void resourceHasTheBitsOfTheQuadrature() throws IOException {
    byte[] expected = GgxAlbedoQuadrature.table();
    if (Boolean.getBoolean("lumbre.write")) {
      Files.write(RESOURCES.resolve(GgxAlbedo.RESOURCE), expected);
    }
    try (InputStream in = GgxAlbedo.class.getResourceAsStream(GgxAlbedo.RESOURCE)) {
      assertThat(in.readAllBytes()).isEqualTo(expected);
    }
  }

  @Test
  void tablesAgreeWithQuadratures() {
    for (double alpha : ALPHAS) {
      for (double cosine : COSINES) {
        for (double[] f : new double[][] {{1, 1}, {.04, 1}, {.02, .5}}) {
          assertThat(GgxAlbedo.of(f[0], f[1], cosine, alpha))
              .as("F0 %s, F90 %s, cosine %s, alpha %s", f[0], f[1], cosine, alpha)
              .isCloseTo(quadrature(f[0], f[1], cosine, alpha), within(ERROR));
        }
      }
    }
  }

  @Test
  void meansAreThoseUnderUniformRadiance() {
    InParallel.forEach(
        Arrays.stream(ALPHAS).boxed().toList(),
        alpha -> {
          double mean = Quadrature.between(0, 1, c -> 2 * c * quadrature(.04, 1, c, alpha));
          assertThat(GgxAlbedo.mean(.04, 1, alpha)).as("%s", alpha).isCloseTo(mean, within(ERROR));
        });
    // Schlick's approximation for a mirror: F0 + (1 - F0) / 21.
    assertThat(GgxAlbedo.mean(.04, 1, 1e-3)).isCloseTo(.04 + .96 / 21, within(ERROR));
  }

  @Test
  void albedosAreFractions() {
    for (int i = 0; i <= 100; i++) {
      for (int j = 0; j <= 100; j++) {
        assertThat(GgxAlbedo.of(1, 1, i / 100.0, j / 100.0)).isBetween(0.0, 1 + 1e-12);
        assertThat(Sheen.albedo(i / 100.0, j / 100.0)).isBetween(0.0, 1 + 1e-12);
      }
    }
  }
}
