package io.github.lumbre.render;

import static io.github.lumbre.render.SharedThreadsTest.awaitQuietly;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.camera.Lens;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.Integrator;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Tests the reports of stalled buckets. */
@Timeout(value = 60, unit = TimeUnit.SECONDS)
class WatchdogTest {
  private static final Scene SCENE =
      Scene.builder()
          .seenBy(Lens.pinhole(60).camera(Vec3.ZERO, Frame.WORLD, 1))
          .addBackground(Rgb.WHITE)
          .build();

  private static final RenderSettings SETTINGS =
      new RenderSettings.Builder().size(8, 8).samples(40).threads(1).build();

  private final List<String> told = new ArrayList<>();
  private final Progress listener =
      new Progress() {
        @Override
        public void stalled(Crop bucket, double seconds) {
          told.add(bucket.x() + "," + bucket.y() + " " + seconds);
        }
      };

  @Test
  void stalledBucketsAreToldOfAfterAMinuteTwoAndFour() throws InterruptedException {
    CountDownLatch blocked = new CountDownLatch(1);
    CountDownLatch release = new CountDownLatch(1);
    BucketRenderer worker = worker(blockingAt(100, blocked, release));
    Watchdog watchdog = new Watchdog(List.of(worker), 0, listener);
    Thread thread = new Thread(worker);
    thread.start();
    blocked.await();
    // The first check finds new samples.
    for (double now : new double[] {10, 69, 70, 71, 129, 130, 131, 249, 250, 251}) {
      watchdog.look(now);
    }
    assertThat(told).containsExactly("0,0 60.0", "0,0 120.0", "0,0 240.0");
    release.countDown();
    thread.join();
    watchdog.look(1000);
    watchdog.look(2000);
    assertThat(told).hasSize(3);
  }

  private static BucketRenderer worker(Integrator integrator) {
    FilmRenderer renderer = new FilmRenderer(SETTINGS, SCENE, integrator);
    RenderQueue queue = new RenderQueue(List.of(new Crop(0, 0, 8, 8)), Progress.NONE);
    return new BucketRenderer(
        SETTINGS,
        SCENE,
        List.of(new TracedPose(SCENE, integrator)),
        new SobolSampler(0),
        renderer.newFilm(),
        (x, y) -> SETTINGS.samples(),
        queue);
  }

  private static Integrator blockingAt(int call, CountDownLatch blocked, CountDownLatch release) {
    int[] calls = {0};
    return (ray, sampler, scratch) -> {
      if (++calls[0] == call) {
        blocked.countDown();
        awaitQuietly(release);
      }
      return Rgb.WHITE;
    };
  }

  @Test
  void oneRendererServesManyThreadsAtOnceAndLeavesNone() throws Exception {
    RenderSettings settings =
        new RenderSettings.Builder().size(30, 20).samples(3).bucketSize(8).threads(3).build();
    PictureRenderer renderer = new PictureRenderer(settings);
    Image alone = renderer.render(SCENE);
    ExecutorService callers = Executors.newFixedThreadPool(4);
    List<Callable<Image>> renders = new ArrayList<>();
    for (int i = 0; i < 12; i++) {
      renders.add(() -> renderer.render(SCENE));
    }
    for (Future<Image> image : callers.invokeAll(renders)) {
      for (int i = 0; i < 30 * 20; i++) {
        assertThat(image.get().pixel(i % 30, i / 30)).isEqualTo(alone.pixel(i % 30, i / 30));
      }
    }
    callers.shutdown();
    assertThat(Thread.getAllStackTraces().keySet())
        .noneMatch(thread -> thread.getName().startsWith("lumbre-render") && thread.isAlive());
  }
}
