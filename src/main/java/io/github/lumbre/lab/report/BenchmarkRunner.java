package io.github.lumbre.lab.report;

import io.github.lumbre.base.TaskException;
import io.github.lumbre.lab.LabHost;
import io.github.lumbre.lab.SceneFolder;
import io.github.lumbre.lab.perf.MeasuredScene;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import java.io.IOException;
import java.util.function.UnaryOperator;

/**
 * Renders rows of the report's table and measures their times.
 *
 * @param parser parser of the scenes
 * @param host reads the scenes and displays each render
 */
public record BenchmarkRunner(
    SceneFolder scenes, BenchmarkPlan plan, SceneParser parser, LabHost host) {
  /**
   * Measures a row and returns the result.
   *
   * @throws TaskException if the picture does not fit into memory, or if two renders of the row differ
   * @throws InterruptedException if the host cancels a render
   */
  public BenchmarkResult run(ReportRow row)
      throws SceneFormatException, TaskException, IOException, InterruptedException {
    SceneParser ofRow = parser.inMode(row.mode()).overriding(inScene -> settings(row, inScene));
    MeasuredScene scene =
        MeasuredScene.read(scenes.file(row.scene()), ofRow, UnaryOperator.identity(), host);
    scene.warmUp(scene.settings(), plan.warmup());
    return new BenchmarkResult(row, scene.measure(scene.settings(), plan.repeat()));
  }

  private RenderSettings settings(ReportRow row, RenderSettings inScene) {
    return row.over(inScene).toBuilder()
        .samples(row.samplesAt(plan.share()))
        .threads(plan.threads())
        .build();
  }
}
