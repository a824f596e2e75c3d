package io.github.lumbre.spark;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.Progress;
import io.github.lumbre.render.RenderException;
import io.github.lumbre.render.SampleTarget;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneParser;
import java.nio.file.Path;
import org.apache.spark.SparkConf;
import org.apache.spark.SparkException;
import org.apache.spark.api.java.JavaSparkContext;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Test;

/** Spark stops by itself if no executor can start; the message names that cause. */
class StoppedSparkTest {
  private static final Path SCENE = Path.of("..", "scenes", "camera-pinhole.json");

  private static JavaSparkContext context() {
    SparkConf conf = new SparkConf().setMaster("local[1]").setAppName("test");
    conf.set("spark.ui.enabled", "false").set("spark.driver.host", "localhost");
    return new JavaSparkContext(conf);
  }

  private static void assertExplained(JavaSparkContext spark, ThrowingCallable work) {
    String application = spark.sc().applicationId();
    assertThatThrownBy(work)
        .isInstanceOf(RenderException.class)
        .hasMessage(
            "rendering on Spark failed: the executors could not start, or all have ended; the logs"
                + " of the workers and work/"
                + application
                + "/*/stderr there name the cause");
  }

  @Test
  void theCauseOfAStoppedSparkIsNamed() throws Exception {
    SceneFile scene =
        new SceneParser()
            .overriding(settings -> settings.toBuilder().size(16, 16).samples(2).build())
            .parse(SCENE);
    FilmRenderer local = new FilmRenderer(scene.settings(), scene.scene());
    try (JavaSparkContext spark = context()) {
      SparkPasses passes =
          new SparkPasses(
              spark, spark.broadcast(SceneBundle.of(SCENE, scene)), local, 2, 1, false, line -> {});
      Film film = local.newFilm(0);
      SampleTarget target = passes.schedule().next(film).orElseThrow();
      spark.stop();
      assertExplained(spark, () -> passes.addSamples(film, target, Progress.NONE));
      assertExplained(spark, () -> passes.seconds(film, target));
      SparkEngine engine = new SparkEngine(spark, 1, line -> {});
      assertExplained(spark, () -> engine.over(SCENE, scene, local, false));
    }
  }

  /** A job may fail before Spark has stopped. */
  @Test
  void theEndOfTheApplicationIsExplained() {
    try (JavaSparkContext spark = context()) {
      Exception failure =
          new SparkException(
              "Job aborted due to stage failure: Master removed our application: FAILED");
      assertExplained(
          spark,
          () -> {
            throw SparkFailures.failure(spark, failure);
          });
    }
  }
}
