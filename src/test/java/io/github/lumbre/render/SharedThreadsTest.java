package io.github.lumbre.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.camera.Lens;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.Integrator;
import io.github.lumbre.material.Matte;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.time.Duration;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Renders on the threads of an executor that is given. */
@Timeout(value = 60, unit = TimeUnit.SECONDS)
class SharedThreadsTest {
  private static final Scene SCENE =
      Scene.builder()
          .seenBy(Lens.pinhole(50).camera(new Vec3(0, 0, -3), Frame.WORLD, 1.5))
          .add(new Sphere(Transform.IDENTITY, 1), Matte.GRAY)
          .addBackground(Rgb.WHITE)
          .build();

  private static final RenderSettings SETTINGS =
      new RenderSettings.Builder().size(30, 20).samples(4).bucketSize(8).threads(4).build();

  /** Far more work than any test waits for. */
  private static final RenderSettings ENDLESS =
      SETTINGS.toBuilder().samples(RenderSettings.MAX_SAMPLES).build();

  private final ExecutorService pool = Executors.newFixedThreadPool(2);

  @AfterEach
  void endPool() throws InterruptedException {
    Thread.interrupted();
    pool.shutdownNow();
    assertThat(pool.awaitTermination(2, TimeUnit.SECONDS)).isTrue();
  }

  private static float[] picture(Executor executor) throws InterruptedException {
    return new PictureRenderer(SETTINGS).on(executor).render(SCENE).rgb();
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 4})
  void bitsAreThoseOfOwnThreads(int size) throws InterruptedException {
    ExecutorService other = Executors.newFixedThreadPool(size);
    try {
      assertThat(picture(other)).isEqualTo(new PictureRenderer(SETTINGS).render(SCENE).rgb());
    } finally {
      other.shutdown();
    }
  }

  @Test
  void executorMayRunTasksAtOnceNeverOrRejectThem() throws InterruptedException {
    float[] expected = new PictureRenderer(SETTINGS).render(SCENE).rgb();
    assertThat(picture(Runnable::run)).isEqualTo(expected);
    assertThat(picture(task -> {})).isEqualTo(expected);
    assertThat(
            picture(
                task -> {
                  throw new RejectedExecutionException("full");
                }))
        .isEqualTo(expected);
  }

  @Test
  void threadsOfFullPoolRenderInIt() throws Exception {
    Callable<float[]> render = () -> picture(pool);
    for (Future<float[]> done : pool.invokeAll(java.util.Collections.nCopies(8, render))) {
      assertThat(done.get()).isEqualTo(new PictureRenderer(SETTINGS).render(SCENE).rgb());
    }
  }

  @Test
  void threadsOfThePoolHelp() throws InterruptedException {
    Set<Thread> threads = ConcurrentHashMap.newKeySet();
    CountDownLatch three = new CountDownLatch(3);
    Integrator meeting =
        (ray, sampler, context) -> {
          if (threads.add(Thread.currentThread())) {
            three.countDown();
            awaitQuietly(three);
          }
          return Rgb.WHITE;
        };
    FilmRenderer renderer = new FilmRenderer(SETTINGS, SCENE, meeting).on(pool);
    renderer.addSamples(renderer.newFilm(), 1, Progress.NONE);
    assertThat(threads).hasSize(3).contains(Thread.currentThread());
  }

  static void awaitQuietly(CountDownLatch latch) {
    try {
      latch.await();
    } catch (InterruptedException e) {
      throw new AssertionError(e);
    }
  }

  @Test
  void interruptEndsTheRenderAndFreesThePool() throws InterruptedException {
    AtomicReference<Throwable> thrown = new AtomicReference<>();
    Thread caller =
        new Thread(
            () -> {
              try {
                new PictureRenderer(ENDLESS).on(pool).render(SCENE);
              } catch (InterruptedException | RuntimeException e) {
                thrown.set(e);
              }
            });
    caller.start();
    Thread.sleep(200);
    assertThat(caller.isAlive()).isTrue();
    caller.interrupt();
    caller.join(2000);
    assertThat(caller.isAlive()).isFalse();
    assertThat(thrown.get()).isInstanceOf(InterruptedException.class);
    // endPool checks that no thread of the pool is still at work.
  }

  @Test
  void interruptedThreadRendersNothing() {
    Thread.currentThread().interrupt();
    assertThatThrownBy(() -> picture(pool)).isInstanceOf(InterruptedException.class);
  }

  @Test
  void failureOfAnyThreadEndsTheRender() {
    Thread caller = Thread.currentThread();
    for (boolean ofCaller : new boolean[] {true, false}) {
      Integrator failing =
          (ray, sampler, context) -> {
            if ((Thread.currentThread() == caller) == ofCaller) {
              throw new IllegalStateException("planted");
            }
            return Rgb.WHITE;
          };
      FilmRenderer renderer = new FilmRenderer(ENDLESS, SCENE, failing).on(pool);
      assertThatThrownBy(() -> renderer.addSamples(renderer.newFilm(), 1 << 20, Progress.NONE))
          .isInstanceOf(RenderException.class)
          .hasMessageContaining("planted");
    }
  }

  @Test
  void timeLimitEndsWithPartialPicture() throws InterruptedException {
    Limits limits = Limits.NONE.withTime(Duration.ofMillis(100));
    RenderResult result =
        new PictureRenderer(ENDLESS).on(pool).limitedTo(limits).render(SCENE, Progress.NONE);
    assertThat(result.complete()).isFalse();
    assertThat(result.image().width()).isEqualTo(30);
  }

  @Test
  void limitsRefuseBeforeTheWork() {
    assertRefused(Limits.NONE.withPixels(599), "expected at most 599 pixels, found 600");
    assertRefused(Limits.NONE.withSamples(3), "expected at most 3 samples per pixel, found 4");
    assertRefused(Limits.NONE.withMemory(1 << 20), "expected at most 1048576 bytes, found");
  }

  private static void assertRefused(Limits limits, String message) {
    assertThatThrownBy(() -> new PictureRenderer(SETTINGS).limitedTo(limits).render(SCENE))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining(message);
  }
}
