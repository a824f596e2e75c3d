package io.github.lumbre.spark;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.Progress;
import io.github.lumbre.render.RenderException;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneParser;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.TreeMap;
import org.apache.spark.SparkConf;
import org.apache.spark.api.java.JavaSparkContext;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/**
 * Executors that do not have the driver's scene or program stop the render with a clear message.
 */
class ExecutorFailuresTest {
  private static final Path SCENE = Path.of("..", "scenes", "camera-pinhole.json");

  private static int seed = 1000;

  private static JavaSparkContext spark;
  private static SceneFile scene;
  private static SceneBundle bundle;

  @BeforeAll
  static void start() throws Exception {
    SparkConf conf = new SparkConf().setMaster("local[2]").setAppName("test");
    conf.set("spark.ui.enabled", "false").set("spark.driver.host", "localhost");
    spark = new JavaSparkContext(conf);
    scene =
        new SceneParser()
            .overriding(settings -> settings.toBuilder().size(16, 16).samples(2).build())
            .parse(SCENE);
    bundle = SceneBundle.of(SCENE, scene);
  }

  @AfterAll
  static void stop() {
    spark.close();
  }

  private void render(SceneBundle sent) throws InterruptedException {
    FilmRenderer local = new FilmRenderer(scene.settings(), scene.scene());
    SparkPasses passes =
        new SparkPasses(spark, spark.broadcast(sent), local, 2, 1, false, line -> {});
    Film film = local.newFilm(0);
    passes.addSamples(film, passes.schedule().next(film).orElseThrow(), Progress.NONE);
    assertThat(film.fewestSamples()).isPositive();
  }

  private SceneBundle with(byte[] text, TreeMap<String, byte[]> assets, int revision) {
    // Executors keep scenes by their hashes and settings; another seed makes another scene.
    LinkedHashMap<String, String> settings = new LinkedHashMap<>(bundle.settings());
    settings.put(Setting.SEED.name(), String.valueOf(seed++));
    return new SceneBundle(
        bundle.name(), text, assets, List.of(), bundle.hash(), settings, revision);
  }

  @Test
  void theDriversSceneIsRendered() throws InterruptedException {
    render(with(bundle.text(), bundle.assets(), bundle.revision()));
  }

  @Test
  void aSceneThatChangedIsRefused() {
    byte[] changed =
        (new String(bundle.text(), StandardCharsets.UTF_8) + " ").getBytes(StandardCharsets.UTF_8);
    assertThatThrownBy(() -> render(with(changed, bundle.assets(), bundle.revision())))
        .isInstanceOf(RenderException.class)
        .hasMessageStartingWith(
            "rendering on Spark failed: camera-pinhole.json: the executor's scene has the hash")
        .hasMessageContaining("do not change the scene's files while it renders");
  }

  @Test
  void aMissingFileIsNamed() {
    String text = new String(bundle.text(), StandardCharsets.UTF_8);
    byte[] more =
        text.replaceFirst(
                "\"assets\": \\[",
                "\"assets\": [{\"assetType\": \"Mesh\", \"id\": 99, \"file\": \"gone.obj\"},")
            .replaceFirst(
                "\"objects\": \\[",
                "\"objects\": [{\"type\": \"Shape\", \"shapeType\": \"Mesh\", \"meshId\": 99},")
            .getBytes(StandardCharsets.UTF_8);
    assertThatThrownBy(() -> render(with(more, bundle.assets(), bundle.revision())))
        .isInstanceOf(RenderException.class)
        .hasMessageContaining("found none at \"gone.obj\"");
  }

  @Test
  void anotherRevisionIsRefused() {
    assertThatThrownBy(() -> render(with(bundle.text(), bundle.assets(), 1 + bundle.revision())))
        .isInstanceOf(RenderException.class)
        .hasMessageContaining("has Lumbre's samples of revision " + FilmRenderer.REVISION)
        .hasMessageContaining("give all executors the same lumbre-spark.jar");
  }
}
