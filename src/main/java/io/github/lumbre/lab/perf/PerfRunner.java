package io.github.lumbre.lab.perf;

import io.github.lumbre.base.TaskException;
import io.github.lumbre.image.Image;
import io.github.lumbre.lab.LabHost;
import io.github.lumbre.lab.metrics.PictureNoise;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * Renders scenes by a plan, and measures time, memory and noise.
 *
 * @param host reads the scenes and displays each render
 */
public record PerfRunner(PerfPlan plan, LabHost host) {
  /**
   * Measures a scene and returns one result for each number of threads.
   *
   * @throws TaskException if the picture does not fit into memory, or if two renders of the scene differ
   * @throws InterruptedException if the host cancels a render
   */
  public List<PerfResult> run(Path path)
      throws SceneFormatException, TaskException, IOException, InterruptedException {
    SceneParser parser = new SceneParser().overriding(plan::over);
    MeasuredScene scene = MeasuredScene.read(path, parser, plan::over, host);
    List<Measurement> renders = new ArrayList<>();
    List<WarmUp> warmUps = new ArrayList<>();
    for (int threads : plan.threads()) {
      RenderSettings settings = scene.settings().toBuilder().threads(threads).build();
      List<Double> cold = scene.warmUp(settings, plan.warmup());
      if (plan.warmup() > 0) {
        // Long renders, whose rate is measured here, would change the kernel sooner or later.
        scene.file().scene().changeKernel(() -> true);
      }
      renders.add(scene.measure(settings, plan.repeat()));
      int warmRenders = cold.isEmpty() ? 0 : PerfPlan.WARM_RENDERS;
      warmUps.add(new WarmUp(cold, scene.warmUp(settings, warmRenders)));
    }
    // Measure the noise last, because renders in between would warm up the timed ones.
    PictureNoise noise = noise(scene);
    List<PerfResult> results = new ArrayList<>();
    for (int i = 0; i < renders.size(); i++) {
      results.add(new PerfResult(renders.get(i), warmUps.get(i), noise));
    }
    return results;
  }

  private PictureNoise noise(MeasuredScene scene) throws InterruptedException {
    RenderSettings settings = scene.settings().toBuilder().threads(0).build();
    List<Image> pictures = new ArrayList<>(List.of(scene.picture()));
    while (pictures.size() < 2 * plan.pairs()) {
      long seed = settings.seed() + pictures.size();
      pictures.add(scene.render(settings.toBuilder().seed(seed).build()).picture());
    }
    return PictureNoise.of(pictures);
  }
}
