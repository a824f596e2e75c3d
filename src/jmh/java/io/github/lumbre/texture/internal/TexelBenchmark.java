package io.github.lumbre.texture.internal;

import io.github.lumbre.MicroBenchmark;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.OperationsPerInvocation;

/** Computing texels for the first time; a call is a texel, with its share of what they need. */
public class TexelBenchmark extends MicroBenchmark {
  private static final int SIDE = 64;

  @Benchmark
  @OperationsPerInvocation(SIDE * SIDE)
  public double noise() {
    Noise noise = new Noise(1, SIDE, SIDE, SIDE / 2.0);
    double sum = 0;
    for (int row = 0; row < SIDE; row++) {
      for (int column = 0; column < SIDE; column++) {
        sum += noise.turbulence(column, row);
      }
    }
    return sum;
  }

  @Benchmark
  @OperationsPerInvocation(SIDE * SIDE)
  public double marble() {
    return sum(new MarbleTexture(1, SIDE, SIDE));
  }

  @Benchmark
  @OperationsPerInvocation(SIDE * SIDE)
  public double voronoi() {
    return sum(new VoronoiTexture(1, SIDE, SIDE, 100, false));
  }

  private static double sum(TexelTexture texture) {
    double sum = 0;
    for (int row = 0; row < SIDE; row++) {
      for (int column = 0; column < SIDE; column++) {
        sum += texture.texel(column, row).g();
      }
    }
    return sum;
  }
}
