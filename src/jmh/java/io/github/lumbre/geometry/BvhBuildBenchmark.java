package io.github.lumbre.geometry;

import io.github.lumbre.MicroBenchmark;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Setup;

/** Building the hierarchy over a mesh; a call is the whole mesh. */
@OutputTimeUnit(TimeUnit.MILLISECONDS)
public class BvhBuildBenchmark extends MicroBenchmark {
  @Param({"20000", "200000"})
  private int triangles;

  private List<Shape> shapes;

  @Setup
  public void prepare() {
    shapes = List.of(BenchmarkShapes.mesh(triangles));
  }

  @Benchmark
  public Bvh build() {
    return Bvh.over(shapes);
  }
}
