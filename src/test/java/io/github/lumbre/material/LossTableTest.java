package io.github.lumbre.material;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.Ggx;
import io.github.lumbre.material.internal.RoughDielectric;
import io.github.lumbre.math.Vec3;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The albedos in the manual are those of the program. */
class LossTableTest {
  private static final Path MANUAL = Path.of("docs", "materials.md");
  private static final double[] DEGREES = {0, 30, 60, 75, 85};

  /** The quadrature points per side; with 500, no entry differs by more than 0.001. */
  private static final int POINTS = 200;

  @ParameterizedTest
  @CsvSource({
    "BECKMANN, .1", "BECKMANN, .2", "BECKMANN, .3", "BECKMANN, .5", "BECKMANN, .7", "BECKMANN, 1",
    "GGX, .1", "GGX, .2", "GGX, .3", "GGX, .5", "GGX, .7", "GGX, 1",
  })
  void facetsThatReflectEverything(MicrofacetDistribution kind, double alpha) throws IOException {
    FacetMap map = new FacetMap(kind, alpha);
    Bsdf bsdf =
        new MicrofacetReflection(Rgb.WHITE, MicrofacetReflectionTest.PERFECT, map.distribution());
    String name = kind == MicrofacetDistribution.GGX ? "`ggx`" : "`beckmann`";
    assertManualHas(
        name,
        alpha,
        degrees -> {
          Vec3 wo = direction(degrees, 1);
          return map.integral(wo, 0, POINTS, wi -> bsdf.evaluate(wo, wi).f().g());
        });
  }

  @ParameterizedTest
  @CsvSource({
    "outside, .1", "outside, .2", "outside, .3", "outside, .5", "outside, .7", "outside, 1",
    "inside, .1", "inside, .2", "inside, .3", "inside, .5", "inside, .7", "inside, 1",
  })
  void roughGlass(String side, double alpha) throws IOException {
    RoughDielectric glass = new RoughDielectric(Rgb.WHITE, Rgb.WHITE, 1.5, new Ggx(alpha));
    assertManualHas(
        "glass, from " + side,
        alpha,
        degrees -> {
          Vec3 wo = direction(degrees, side.equals("inside") ? -1 : 1);
          return RoughDielectricTest.albedo(glass, wo, false, POINTS)
              + RoughDielectricTest.albedo(glass, wo, true, POINTS);
        });
  }

  private static Vec3 direction(double degrees, double side) {
    return BsdfLaws.direction(side * Math.cos(Math.toRadians(degrees)));
  }

  /** An albedo as a function of the angle in degrees. */
  private interface Albedo {
    double at(double degrees);
  }

  private static void assertManualHas(String name, double alpha, Albedo albedo) throws IOException {
    String start = "| " + name + " | " + alpha + " |";
    List<String> rows =
        Files.readAllLines(MANUAL).stream().filter(line -> line.startsWith(start)).toList();
    assertThat(rows).as(start).hasSize(1);
    String[] cells = rows.get(0).substring(start.length()).split("\\|");
    assertThat(cells).hasSize(DEGREES.length);
    for (int i = 0; i < DEGREES.length; i++) {
      assertThat(Double.parseDouble(cells[i])).isCloseTo(albedo.at(DEGREES[i]), within(1e-3));
    }
  }
}
