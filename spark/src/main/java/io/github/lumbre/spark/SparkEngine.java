package io.github.lumbre.spark;

import io.github.lumbre.cli.run.Engine;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.PassRenderer;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import org.apache.spark.api.java.JavaSparkContext;
import org.apache.spark.broadcast.Broadcast;

/** Renders passes on the executors of a Spark context. */
final class SparkEngine implements Engine {
  private final JavaSparkContext spark;
  private final double unitSeconds;

  /**
   * @param unitSeconds time that a unit of work should take
   */
  SparkEngine(JavaSparkContext spark, double unitSeconds) {
    this.spark = spark;
    this.unitSeconds = unitSeconds;
  }

  @Override
  public PassRenderer over(Path path, SceneFile scene, FilmRenderer local, boolean isTimed) {
    try {
      Broadcast<SceneBundle> bundle = spark.broadcast(SceneBundle.of(path, scene));
      int goal = scene.settings().samples();
      return new SparkPasses(spark, bundle, local, goal, unitSeconds, isTimed);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
