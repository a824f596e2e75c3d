package io.github.lumbre.spark;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.cli.run.Engine;
import io.github.lumbre.render.FilmLayers;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.PassRenderer;
import io.github.lumbre.scenefile.SceneFile;
import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import org.apache.spark.api.java.JavaSparkContext;
import org.apache.spark.broadcast.Broadcast;

/** Renders passes on the executors of a Spark context. */
final class SparkEngine implements Engine {
  private final JavaSparkContext spark;
  private final double unitSeconds;
  private final Consumer<String> messages;
  private final AtomicBoolean isReported = new AtomicBoolean();

  /**
   * @param unitSeconds time that a unit of work should take
   * @param messages receives lines for the user
   */
  SparkEngine(JavaSparkContext spark, double unitSeconds, Consumer<String> messages) {
    this.spark = spark;
    this.unitSeconds = unitSeconds;
    this.messages = messages;
  }

  @Override
  public PassRenderer over(Path path, SceneFile scene, FilmRenderer local, boolean isTimed)
      throws TaskException {
    try {
      FilmLayers layers = FilmLayers.of(scene.settings(), scene.scene());
      SceneBundle files = SceneBundle.of(path, scene);
      ExecutorPlan plan =
          SparkFailures.explained(
              spark, () -> ExecutorPlan.of(spark, scene.settings(), layers, files.bytes()));
      if (isReported.compareAndSet(false, true)) {
        messages.accept(plan.line());
      }
      plan.require();
      Broadcast<SceneBundle> bundle = SparkFailures.explained(spark, () -> spark.broadcast(files));
      int goal = scene.settings().samples();
      return new SparkPasses(spark, bundle, local, goal, unitSeconds, isTimed, messages);
    } catch (IOException e) {
      throw new TaskException(ExitCode.SCENE, e.getMessage(), e);
    }
  }
}
