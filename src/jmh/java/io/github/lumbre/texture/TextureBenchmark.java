package io.github.lumbre.texture;

import io.github.lumbre.MicroBenchmark;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.texture.internal.BilinearTexture;
import io.github.lumbre.texture.internal.ImageTexture;
import io.github.lumbre.texture.internal.ImageTexture.Filter;
import io.github.lumbre.texture.internal.ImageTexture.Role;
import io.github.lumbre.texture.internal.MarbleTexture;
import io.github.lumbre.texture.internal.VoronoiTexture;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Setup;

/** Reading textures at random places, those that are computed once and kept when they are known. */
public class TextureBenchmark extends MicroBenchmark {
  private static final int SIDE = 512;

  @Param({"IMAGE_NEAREST", "IMAGE_BILINEAR", "MARBLE", "VORONOI", "VORONOI_BILINEAR"})
  private Kind kind;

  private Texture<Rgb> texture;
  private TexturePoint[] points;

  /** Which texture. */
  public enum Kind {
    IMAGE_NEAREST {
      @Override
      Texture<Rgb> make() {
        return image(Filter.NEAREST);
      }
    },
    IMAGE_BILINEAR {
      @Override
      Texture<Rgb> make() {
        return image(Filter.BILINEAR);
      }
    },
    MARBLE {
      @Override
      Texture<Rgb> make() {
        return new MarbleTexture(1, SIDE, SIDE);
      }
    },
    VORONOI {
      @Override
      Texture<Rgb> make() {
        return new VoronoiTexture(1, SIDE, SIDE, 1000, false);
      }
    },
    VORONOI_BILINEAR {
      @Override
      Texture<Rgb> make() {
        return new BilinearTexture(new VoronoiTexture(1, SIDE, SIDE, 1000, false));
      }
    };

    abstract Texture<Rgb> make();

    private static Texture<Rgb> image(Filter filter) {
      byte[] values = new byte[3 * SIDE * SIDE];
      new SplittableRandom(3).nextBytes(values);
      return new ImageTexture(Pixels.of(SIDE, SIDE, 3, values), Role.COLOR, filter);
    }
  }

  @Setup
  public void prepare() {
    texture = kind.make();
    SplittableRandom random = new SplittableRandom(4);
    points = new TexturePoint[COUNT];
    Arrays.setAll(points, i -> new TexturePoint(random.nextDouble(), random.nextDouble()));
  }

  @Benchmark
  @OperationsPerInvocation(COUNT)
  public double at() {
    double sum = 0;
    for (TexturePoint point : points) {
      sum += texture.at(point).g();
    }
    return sum;
  }
}
