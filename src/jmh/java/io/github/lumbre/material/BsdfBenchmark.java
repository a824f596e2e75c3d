package io.github.lumbre.material;

import io.github.lumbre.MicroBenchmark;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.Beckmann;
import io.github.lumbre.material.internal.Ggx;
import io.github.lumbre.material.internal.RoughDielectric;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.internal.Warp;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Setup;

/** Scattering at a point: drawing directions, and evaluating given ones, with their density. */
public class BsdfBenchmark extends MicroBenchmark {
  @Param({"LAMBERTIAN", "PHONG", "BECKMANN", "GGX", "ROUGH_DIELECTRIC"})
  private Kind kind;

  private Bsdf bsdf;
  private Vec3[] outgoing;
  private Vec3[] incoming;
  private Point2[] numbers;

  /** Which scattering. */
  public enum Kind {
    LAMBERTIAN {
      @Override
      Bsdf make() {
        return new Lambertian(Rgb.gray(.8));
      }
    },
    PHONG {
      @Override
      Bsdf make() {
        return new PhongLobe(Rgb.gray(.8), 50);
      }
    },
    BECKMANN {
      @Override
      Bsdf make() {
        return new MicrofacetReflection(Rgb.WHITE, 1.5, new Beckmann(.3));
      }
    },
    GGX {
      @Override
      Bsdf make() {
        return new MicrofacetReflection(Rgb.WHITE, 1.5, new Ggx(.3));
      }
    },
    ROUGH_DIELECTRIC {
      @Override
      Bsdf make() {
        return new RoughDielectric(Rgb.WHITE, Rgb.WHITE, 1.5, new Ggx(.3));
      }
    };

    abstract Bsdf make();
  }

  @Setup
  public void prepare() {
    bsdf = kind.make();
    SplittableRandom random = new SplittableRandom(5);
    outgoing = new Vec3[COUNT];
    incoming = new Vec3[COUNT];
    numbers = new Point2[COUNT];
    Arrays.setAll(outgoing, i -> Warp.cosineHemisphere(point(random)));
    Arrays.setAll(incoming, i -> Warp.cosineHemisphere(point(random)));
    Arrays.setAll(numbers, i -> point(random));
  }

  private static Point2 point(SplittableRandom random) {
    return new Point2(random.nextDouble(), random.nextDouble());
  }

  @Benchmark
  @OperationsPerInvocation(COUNT)
  public double sample() {
    double sum = 0;
    for (int i = 0; i < COUNT; i++) {
      BsdfSample sample = bsdf.sample(outgoing[i], numbers[COUNT - 1 - i].x(), numbers[i]);
      sum += sample.wi().z() + sample.weight().g() + sample.pdf();
    }
    return sum;
  }

  @Benchmark
  @OperationsPerInvocation(COUNT)
  public double eval() {
    double sum = 0;
    for (int i = 0; i < COUNT; i++) {
      sum += bsdf.evaluate(outgoing[i], incoming[i]).f().g();
    }
    return sum;
  }

  @Benchmark
  @OperationsPerInvocation(COUNT)
  public double pdf() {
    double sum = 0;
    for (int i = 0; i < COUNT; i++) {
      sum += bsdf.pdf(outgoing[i], incoming[i]);
    }
    return sum;
  }
}
