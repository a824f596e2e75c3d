package io.github.lumbre.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.camera.Camera;
import io.github.lumbre.camera.Lens;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.Integrator;
import io.github.lumbre.material.Matte;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests whole renders: pixels, crops, threads, cancellation and failures. */
@Timeout(value = 60, unit = TimeUnit.SECONDS)
class PictureRendererTest {
  private static final Scene SCENE = sceneSeenBy(pinhole());

  private static Camera pinhole() {
    return Lens.pinhole(50).camera(new Vec3(0, 0, -3), Frame.WORLD, 1.5);
  }

  private static Scene sceneSeenBy(Camera camera) {
    return Scene.builder()
        .seenBy(camera)
        .add(new Sphere(Transform.IDENTITY, 1), Matte.GRAY)
        .addBackground(Rgb.WHITE)
        .build();
  }

  private static RenderSettings.Builder small() {
    return new RenderSettings.Builder().size(30, 20).samples(4).bucketSize(8).threads(2);
  }

  @Test
  void everyPixelIsRendered() throws InterruptedException {
    Image image = new PictureRenderer(small().build()).render(SCENE);

    assertThat(image.width()).isEqualTo(30);
    assertThat(image.height()).isEqualTo(20);
    for (int y = 0; y < 20; y++) {
      for (int x = 0; x < 30; x++) {
        assertThat(image.pixel(x, y).luminance()).as("pixel %d,%d", x, y).isPositive();
      }
    }
    assertThat(image.pixel(0, 0)).isEqualTo(Rgb.WHITE);
    assertThat(image.pixel(15, 10).r()).isBetween(.4, .6);
  }

  @Test
  void cropHasTheBitsOfTheFullFrame() throws InterruptedException {
    Image full = new PictureRenderer(small().build()).render(SCENE);
    Image crop =
        new PictureRenderer(small().crop(new Crop(7, 5, 11, 9)).bucketSize(3).build())
            .render(SCENE);

    for (int y = 0; y < 9; y++) {
      for (int x = 0; x < 11; x++) {
        assertThat(crop.pixel(x, y)).isEqualTo(full.pixel(7 + x, 5 + y));
      }
    }
  }

  @Test
  void seedsGiveDifferentPictures() throws InterruptedException {
    float[] one = new PictureRenderer(small().seed(1).build()).render(SCENE).rgb();
    float[] two = new PictureRenderer(small().seed(2).build()).render(SCENE).rgb();

    assertThat(one).isNotEqualTo(two);
  }

  @Test
  void listenerHearsOfEverySampleAndBucketOnce() throws InterruptedException {
    AtomicLong total = new AtomicLong();
    AtomicLong advanced = new AtomicLong();
    Set<Crop> buckets = ConcurrentHashMap.newKeySet();
    RenderResult result =
        new PictureRenderer(small().build())
            .render(
                SCENE,
                new Progress() {
                  @Override
                  public void started(long totalSamples) {
                    total.addAndGet(totalSamples);
                  }

                  @Override
                  public void advanced(long samples) {
                    advanced.addAndGet(samples);
                  }

                  @Override
                  public void finished(Crop bucket) {
                    buckets.add(bucket);
                  }
                });

    assertThat(total).hasValue(30 * 20 * 4);
    assertThat(advanced).hasValue(30 * 20 * 4);
    assertThat(buckets).hasSize(4 * 3);
    assertThat(buckets.stream().mapToInt(b -> b.width() * b.height()).sum()).isEqualTo(600);
    assertThat(result.complete()).isTrue();
    assertThat(result.statistics().samples()).isEqualTo(2400);
    assertThat(result.statistics().rays()).isGreaterThan(2400);
  }

  @Test
  void cancelledRenderReturnsWhatItHas() throws InterruptedException {
    Set<Crop> done = ConcurrentHashMap.newKeySet();
    Progress afterTwo =
        new Progress() {
          @Override
          public void finished(Crop bucket) {
            done.add(bucket);
          }

          @Override
          public boolean isCancelled() {
            return done.size() >= 2;
          }
        };
    RenderResult result =
        new PictureRenderer(small().samples(64).threads(1).build()).render(SCENE, afterTwo);

    assertThat(result.complete()).isFalse();
    assertThat(result.image().pixel(0, 0)).isEqualTo(Rgb.WHITE);
    assertThat(result.image().pixel(29, 19)).isEqualTo(Rgb.BLACK);
  }

  /** Progress is reported every 1024 samples, and cancellation is checked every 16 samples. */
  @Test
  void cancelledRenderStopsInTheMiddleOfABucket() throws InterruptedException {
    AtomicLong told = new AtomicLong();
    Progress afterSome =
        new Progress() {
          @Override
          public void advanced(long samples) {
            told.addAndGet(samples);
          }

          @Override
          public boolean isCancelled() {
            return told.get() > 0;
          }
        };
    RenderSettings oneBucket = small().size(64, 64).bucketSize(64).threads(1).build();
    RenderResult result = new PictureRenderer(oneBucket).render(SCENE, afterSome);

    assertThat(result.complete()).isFalse();
    assertThat(result.statistics().samples()).isBetween(1024L, 1024L + 16);
  }

  @Test
  void workersExceptionEndsTheRenderWithItsCause() {
    IllegalStateException fault = new IllegalStateException("planted");
    Integrator failing =
        (ray, sampler, scratch) -> {
          if (sampler.get1d(0) > .9) {
            throw fault;
          }
          return Rgb.WHITE;
        };

    assertThatThrownBy(
            () ->
                new PictureRenderer(small().samples(1 << 30).build())
                    .render(SCENE, failing, Progress.NONE))
        .isInstanceOf(RenderException.class)
        .hasCause(fault);
    assertThat(liveWorkers()).isEmpty();
  }

  @Test
  void interruptionEndsAllWorkers() throws InterruptedException {
    Thread caller =
        new Thread(
            () -> {
              try {
                new PictureRenderer(small().samples(1 << 30).build()).render(SCENE);
              } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
              }
            });
    caller.start();
    while (liveWorkers().isEmpty()) {
      // Between two passes, there are no worker threads.
      Thread.sleep(1);
    }
    caller.interrupt();
    caller.join(10_000);

    assertThat(caller.isAlive()).isFalse();
    assertThat(liveWorkers()).isEmpty();
  }

  private static List<String> liveWorkers() {
    return Thread.getAllStackTraces().keySet().stream()
        .map(Thread::getName)
        .filter(name -> name.startsWith("lumbre-render"))
        .toList();
  }

  @Test
  void samplesThatAreNoRadianceCountAsBlackAndAreReported() throws InterruptedException {
    double[] bad = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, -1};
    AtomicLong calls = new AtomicLong();
    Integrator faulty =
        (ray, sampler, scratch) -> {
          int call = (int) calls.getAndIncrement();
          return call < 4 ? new Rgb(1, bad[call], 1) : Rgb.WHITE;
        };
    RenderResult result =
        new PictureRenderer(small().samples(8).threads(1).build())
            .render(SCENE, faulty, Progress.NONE);

    // The first pass takes one sample of each pixel, row by row from the left.
    for (int x = 0; x < 4; x++) {
      assertThat(result.image().pixel(x, 0)).isEqualTo(Rgb.gray(7 / 8.0));
    }
    assertThat(result.image().pixel(4, 0)).isEqualTo(Rgb.WHITE);
    assertThat(result.statistics().rejected()).isEqualTo(4);
    assertThat(result.statistics().firstRejected())
        .containsExactly(
            new RenderStatistics.RejectedSample(0, 0, 0),
            new RenderStatistics.RejectedSample(1, 0, 0),
            new RenderStatistics.RejectedSample(2, 0, 0),
            new RenderStatistics.RejectedSample(3, 0, 0));
  }

  @Test
  void transparencyIsTheShareOfSamplesThatMissed() throws InterruptedException {
    Scene glowing =
        Scene.builder()
            .seenBy(pinhole())
            .add(new Sphere(Transform.IDENTITY, 1), Matte.GRAY)
            .addAmbient(Rgb.gray(Math.PI))
            .build();
    RenderSettings settings = small().samples(64).transparent(true).build();
    Image image = new PictureRenderer(settings).render(glowing);

    assertThat(image.alpha(0, 0)).isZero();
    assertThat(image.alpha(15, 10)).isEqualTo(1);
    boolean partial = false;
    for (int x = 0; x < 30; x++) {
      float alpha = image.alpha(x, 10);
      partial |= alpha > 0 && alpha < 1;
      // Straight alpha: the edge has the sphere's own brightness.
      assertThat(image.pixel(x, 10).r()).isEqualTo(alpha == 0 ? 0 : .5);
    }
    assertThat(partial).isTrue();
  }

  @Test
  void fishEyeIsTransparentOutsideItsCircleOnly() throws InterruptedException {
    Scene scene = sceneSeenBy(Lens.fishEye(180).camera(Vec3.ZERO, Frame.WORLD, 1.5));
    Image image = new PictureRenderer(small().samples(16).build()).render(scene);

    assertThat(image.hasAlpha()).isTrue();
    assertThat(image.alpha(0, 0)).isZero();
    assertThat(image.alpha(0, 10)).isZero();
    assertThat(image.alpha(15, 10)).isEqualTo(1);
    assertThat(image.alpha(15, 1)).isEqualTo(1);
  }

  @Test
  void rendererIsReusable() throws InterruptedException {
    PictureRenderer renderer = new PictureRenderer(small().build());

    assertThat(renderer.render(SCENE).rgb()).isEqualTo(renderer.render(SCENE).rgb());
  }

  private static RenderStatistics statistics(RenderSettings settings, Rgb radiance)
      throws InterruptedException {
    return new PictureRenderer(settings)
        .render(SCENE, (ray, sampler, scratch) -> radiance, Progress.NONE)
        .statistics();
  }

  @Test
  void samplesBrighterThanTheClampAreDarkenedToIt() throws InterruptedException {
    RenderSettings settings = small().clamp(2).build();
    RenderResult result =
        new PictureRenderer(settings)
            .render(SCENE, (ray, sampler, scratch) -> new Rgb(4, 2, 1), Progress.NONE);
    assertThat(result.image().pixel(3, 3)).isEqualTo(new Rgb(2, 1, .5));
    assertThat(result.statistics().clamped()).isEqualTo(2400);
    assertThat(result.statistics().clampedLight()).isCloseTo(2400 * 3.5 / 3, within(1e-9));
    assertThat(result.statistics().saturated()).isZero();
    RenderStatistics atTheClamp = statistics(settings, new Rgb(1, 2, 1.5));
    assertThat(atTheClamp.clamped()).isZero();
    assertThat(atTheClamp.clampedLight()).isZero();
  }

  @Test
  void samplesTooBrightForTheFilmAreCounted() throws InterruptedException {
    RenderSettings settings = small().build();
    assertThat(statistics(settings, Rgb.gray(Film.LARGEST)).saturated()).isZero();
    RenderStatistics above = statistics(settings, Rgb.gray(Math.nextUp(Film.LARGEST)));
    assertThat(above.saturated()).isEqualTo(2400);
    assertThat(above.clamped()).isZero();
    RenderStatistics both = statistics(small().clamp(1e6).build(), Rgb.gray(1e12));
    assertThat(both.saturated()).isEqualTo(2400);
    assertThat(both.clamped()).isEqualTo(2400);
  }

  @Test
  void theFirstTenRejectedSamplesAreNamed() throws InterruptedException {
    RenderStatistics bad = statistics(small().threads(1).samples(1).build(), Rgb.gray(-1));
    assertThat(bad.rejected()).isEqualTo(600);
    assertThat(bad.firstRejected()).hasSize(10);
    assertThat(bad.firstRejected().get(7)).isEqualTo(new RenderStatistics.RejectedSample(7, 0, 0));
  }

  /** Each sample waits until the expected number of threads have started one. */
  @ParameterizedTest
  @CsvSource({"0, 8", "1, 8", "3, 8", "5, 20"})
  void asManyThreadsRenderAsAreAskedFor(int threads, int bucketSize) throws InterruptedException {
    int expected =
        Math.min(threads == 0 ? Runtime.getRuntime().availableProcessors() : threads, 12);
    int buckets = bucketSize == 8 ? 12 : 2;
    CountDownLatch begun = new CountDownLatch(Math.min(expected, buckets));
    Set<Thread> workers = ConcurrentHashMap.newKeySet();
    Integrator waiting =
        (ray, sampler, scratch) -> {
          if (workers.add(Thread.currentThread())) {
            begun.countDown();
          }
          awaitQuietly(begun);
          return Rgb.WHITE;
        };
    RenderSettings settings = small().samples(1).threads(threads).bucketSize(bucketSize).build();
    assertThat(new PictureRenderer(settings).render(SCENE, waiting, Progress.NONE).complete())
        .isTrue();
    assertThat(workers).hasSize(Math.min(expected, buckets)).allMatch(Thread::isDaemon);
    assertThat(workers).allMatch(worker -> worker.getName().startsWith("lumbre-render-"));
  }

  private static void awaitQuietly(CountDownLatch latch) {
    try {
      if (!latch.await(20, TimeUnit.SECONDS)) {
        throw new AssertionError("too few threads");
      }
    } catch (InterruptedException e) {
      throw new AssertionError(e);
    }
  }

  /** The render is interrupted, and again while it waits for its threads. */
  @Test
  void secondInterruptionIsKeptForLater() {
    Thread caller = Thread.currentThread();
    AtomicLong calls = new AtomicLong();
    Integrator interrupting =
        (ray, sampler, scratch) -> {
          if (calls.getAndIncrement() == 0) {
            awaitState(caller, Thread.State.TIMED_WAITING);
            caller.interrupt();
            awaitState(caller, Thread.State.WAITING);
            caller.interrupt();
            while (caller.isInterrupted()) {
              Thread.onSpinWait();
            }
            awaitState(caller, Thread.State.WAITING);
          }
          return Rgb.WHITE;
        };
    PictureRenderer renderer = new PictureRenderer(small().threads(1).build());
    assertThatThrownBy(() -> renderer.render(SCENE, interrupting, Progress.NONE))
        .isInstanceOf(InterruptedException.class);
    assertThat(Thread.interrupted()).isTrue();
    assertThat(liveWorkers()).isEmpty();
  }

  private static void awaitState(Thread thread, Thread.State state) {
    while (thread.getState() != state) {
      Thread.onSpinWait();
    }
  }

  /** Progress is reported during a bucket, and not only at its end. */
  @Test
  void longBucketsAreHeardOfMeanwhile() throws InterruptedException {
    List<Long> heard = new ArrayList<>();
    Progress listener =
        new Progress() {
          @Override
          public void advanced(long samples) {
            heard.add(samples);
          }
        };
    RenderSettings oneBucket = small().size(64, 64).samples(1).bucketSize(64).threads(1).build();
    new PictureRenderer(oneBucket).render(SCENE, listener);
    assertThat(heard).hasSizeGreaterThanOrEqualTo(4);
    assertThat(heard.stream().mapToLong(h -> h).sum()).isEqualTo(64 * 64);
    assertThat(heard).allMatch(h -> h <= 1024);
  }
}
