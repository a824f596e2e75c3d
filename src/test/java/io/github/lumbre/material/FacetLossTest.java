package io.github.lumbre.material;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.testing.Effort;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.Test;

/** Tests the table of light that single scattering loses. */
class FacetLossTest {
  private static final Path RESOURCE =
      Path.of("src/main/resources/io/github/lumbre/material", FacetLoss.RESOURCE);

  /** The error of the quadrature in the test of sums, found with many more points. */
  private static final double ERROR = 1.5e-3;

  private static final double[] INDICES = {1.02, 1.05, 1.2, 1.5, 2.1, 2.4, 1e9};
  private static final double[] ALPHAS = {1e-3, .01, .03, .1, .33, .5, .85, 1};
  private static final double[] COSINES = {1, .93, .6, .45, .2, .06, .01};

  /**
   * To compute the resource again, in minutes: {@code -Dtest=FacetLossTest -Dlumbre.write=true}.
   */
  @Test
  void resourceHasTheBitsOfTheQuadrature() throws IOException {
    if (Boolean.getBoolean("lumbre.write")) {
      Files.write(RESOURCE, FacetLossQuadrature.table());
    }
    byte[] resource = Files.readAllBytes(RESOURCE);
    assertThat(resource).hasSize(FacetLossQuadrature.BYTES);
    ByteBuffer bytes = ByteBuffer.wrap(resource);
    int[] entries = new int[FacetLossQuadrature.ENTRIES];
    Arrays.setAll(entries, i -> bytes.getShort() & 0xffff);
    int step = Effort.count(101, 1);
    for (int i = 0; i < entries.length; i += step) {
      assertThat(entries[i]).as("entry %s", i).isEqualTo(FacetLossQuadrature.entry(i));
    }
    assertThat(FacetLossQuadrature.table(entries)).as("means").isEqualTo(resource);
  }

  /**
   * What single scattering keeps and what it loses are at most 1, within the error of the
   * quadrature here, and at least 0.99 or, with an index of 1.02, at least 0.985.
   */
  @Test
  void albedosAndLossesAddUpToOne() {
    for (double ior : INDICES) {
      double least = ior < 1.05 ? .985 : .99;
      for (double alpha : ALPHAS) {
        FacetLoss lost = FacetLoss.of(ior, alpha);
        for (double cosine : COSINES) {
          double above = FacetLossQuadrature.albedo(cosine, alpha, ior, 60, 24);
          double below = FacetLossQuadrature.albedo(cosine, alpha, 1 / ior, 60, 24);
          assertThat(above + lost.at(cosine))
              .as("index %s, alpha %s, cosine %s", ior, alpha, cosine)
              .isBetween(least, 1 + ERROR);
          assertThat(below + lost.at(-cosine))
              .as("index %s, alpha %s, cosine %s", ior, alpha, -cosine)
              .isBetween(least, 1 + ERROR);
        }
      }
    }
  }

  /** The denser side is below for an index above 1, and above for an index below 1. */
  @Test
  void sidesAreExchangedWithTheInverseIndex() {
    FacetLoss glass = FacetLoss.of(1.5, .4);
    FacetLoss bubble = FacetLoss.of(1 / 1.5, .4);
    assertThat(bubble.at(.3)).isCloseTo(glass.at(-.3), within(1e-12));
    assertThat(bubble.mean(true)).isCloseTo(glass.mean(false), within(1e-12));
    assertThat(glass.at(.3)).isNotCloseTo(glass.at(-.3), within(.05));
  }

  @Test
  void meansAreThoseUnderUniformRadiance() {
    for (double alpha : ALPHAS) {
      FacetLoss lost = FacetLoss.of(1.5, alpha);
      for (double side : new double[] {1, -1}) {
        double mean = 0;
        int steps = 4000;
        for (int i = 0; i < steps; i++) {
          double mu = (i + .5) / steps;
          mean += 2 * mu * lost.at(side * mu) / steps;
        }
        assertThat(lost.mean(side < 0)).isCloseTo(mean, within(1e-5));
      }
    }
  }
}
