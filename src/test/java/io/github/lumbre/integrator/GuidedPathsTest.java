package io.github.lumbre.integrator;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.camera.CameraRay;
import io.github.lumbre.integrator.guiding.Guide;
import io.github.lumbre.integrator.guiding.GuideBuilder;
import io.github.lumbre.integrator.guiding.GuideRecords;
import io.github.lumbre.math.sampling.internal.IndependentSampler;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.testing.Moments;
import java.nio.file.Path;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Compares the expected light of paths with a guide that is used everywhere, and without one. */
class GuidedPathsTest {
  private static final int DEPTH = 5;
  private static final int RECORDED = 20_000;
  private static final int SAMPLES = 150_000;

  private final SplittableRandom random = new SplittableRandom(6);
  private final CameraRay ray = new CameraRay();

  /**
   * Half of the directions follow the guide. A false alarm has a probability of 0.01 %. The
   * standard error of the difference is about 0.5 % of the mean in the Cornell box, so that 2 % are
   * found.
   */
  @ParameterizedTest
  @ValueSource(strings = {"cornell-box", "table-15-frog", "glass-and-mirror"})
  void guidedPathsHaveTheSameMean(String name) throws Exception {
    SceneFile file = new SceneParser().parse(Path.of("scenes", name + ".json"));
    Scene scene = file.scene().framed(file.settings().aspect());
    GuideRecords records = new GuideRecords();
    GuideRecorder recorder = new GuideRecorder(records);
    samples(scene, Guide.NONE, RECORDED, RenderContext.recordedBy(recorder));
    recorder.endPath();
    Guide guide = GuideBuilder.train(records, Guide.NONE, () -> new GuideSight(scene));
    assertThat(guide.isEmpty()).isFalse();
    Moments guided = samples(scene, guide, SAMPLES, new RenderContext());
    Moments unguided = samples(scene, Guide.NONE, SAMPLES, new RenderContext());
    assertThat(guided.z(unguided)).isBetween(-4.0, 4.0);
  }

  private Moments samples(Scene scene, Guide guide, int count, RenderContext context) {
    PathTracer tracer = new PathTracer(scene, PathOptions.toDepth(DEPTH), guide);
    IndependentSampler sampler = new IndependentSampler(random.nextLong());
    Moments moments = new Moments();
    for (int i = 0; i < count; i++) {
      sampler.startSample(0, 0, i);
      context.startSample();
      if (scene.camera().aim(random.nextDouble(), random.nextDouble(), sampler, ray)) {
        moments.add(tracer.radiance(ray, sampler, context).g());
      }
    }
    return moments;
  }
}
