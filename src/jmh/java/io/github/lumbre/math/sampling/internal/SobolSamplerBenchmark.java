package io.github.lumbre.math.sampling.internal;

import io.github.lumbre.MicroBenchmark;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.sampling.Sampler;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.OperationsPerInvocation;

/** Drawing numbers, every one for a sample of its own. */
public class SobolSamplerBenchmark extends MicroBenchmark {
  private final SobolSampler sampler = new SobolSampler(1);

  @Benchmark
  @OperationsPerInvocation(COUNT)
  public double number() {
    double sum = 0;
    for (int i = 0; i < COUNT; i++) {
      sampler.startSample(i & 63, i >> 6, i);
      sum += sampler.get1d(Sampler.vertex(0) + Sampler.LOBE);
    }
    return sum;
  }

  @Benchmark
  @OperationsPerInvocation(COUNT)
  public double pair() {
    double sum = 0;
    for (int i = 0; i < COUNT; i++) {
      sampler.startSample(i & 63, i >> 6, i);
      Point2 point = sampler.get2d(Sampler.vertex(0) + Sampler.DIRECTION);
      sum += point.x() + point.y();
    }
    return sum;
  }
}
