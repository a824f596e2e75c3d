package io.github.lumbre.integrator;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.camera.CameraRay;
import io.github.lumbre.integrator.guiding.Guide;
import io.github.lumbre.integrator.guiding.GuideBuilder;
import io.github.lumbre.integrator.guiding.GuideRecords;
import io.github.lumbre.integrator.path.PathVertex;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.math.sampling.internal.IndependentSampler;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneParser;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

/** Tests what is recorded for a guide where light sampling finds the light, too. */
class GuideRecorderTest {
  private static final int PATHS = 40_000;

  /** A floor under small lamps that light sampling finds: it does not need a guide. */
  @Test
  void aGuideTowardsLampsDoesNotMakeItselfSeemNeeded() throws Exception {
    SceneFile file =
        new SceneParser()
            .overriding(s -> s.toBuilder().size(64, 48).build())
            .parse(Path.of("scenes", "table-07-suited-figure.json"));
    RenderSettings settings = file.settings();
    Scene scene = file.scene().framed(settings.aspect());
    Guide guide = Guide.NONE;
    for (int pass = 0; pass < 3; pass++) {
      GuideRecords records = record(scene, guide, pass);
      guide = GuideBuilder.train(records, guide, () -> new GuideSight(scene));
    }
    guide = GuideBuilder.build(record(scene, guide, 3), guide, () -> new GuideSight(scene));
    // It is 0.15; with the weights of guided rays, it is 0.46.
    assertThat(followedPart(guide, scene)).isBetween(0., .25);
  }

  /** Returns the part of all directions that follow a guide, in paths without a guide. */
  private static double followedPart(Guide guide, Scene scene) {
    PathRecorder recorder = new PathRecorder();
    RenderContext context = RenderContext.recordedBy(recorder);
    double sum = 0;
    int count = 0;
    for (int path = 0; path < 1000; path++) {
      trace(new PathTracer(scene, 5), path, scene, new IndependentSampler(7), context);
      for (PathVertex vertex : recorder.vertices()) {
        if (vertex.hit().isEmpty()) {
          continue;
        }
        Vec3 p = vertex.hit().get().position();
        Vec3 normal = vertex.hit().get().shadingNormal();
        Vec3 n = normal.times(-Math.signum(normal.dot(vertex.ray().direction())));
        int cell = guide.cell(p.x(), p.y(), p.z(), n.x(), n.y(), n.z());
        sum += cell == Guide.NO_CELL ? 0 : guide.fraction(cell);
        count++;
      }
    }
    return sum / count;
  }

  private static GuideRecords record(Scene scene, Guide guide, int seed) {
    GuideRecords records = new GuideRecords();
    GuideRecorder recorder = new GuideRecorder(records);
    RenderContext context = RenderContext.recordedBy(recorder);
    PathTracer tracer = new PathTracer(scene, PathOptions.toDepth(5), guide);
    IndependentSampler sampler = new IndependentSampler(seed);
    for (int i = 0; i < PATHS; i++) {
      trace(tracer, i, scene, sampler, context);
      recorder.endPath();
    }
    return records;
  }

  private static void trace(
      PathTracer tracer, int number, Scene scene, Sampler sampler, RenderContext context) {
    CameraRay ray = new CameraRay();
    sampler.startSample(0, 0, number);
    context.startSample();
    double u = sampler.get1d(0);
    if (scene.camera().aim(u, sampler.get1d(1), sampler, ray)) {
      tracer.radiance(ray, sampler, context);
    }
  }
}
