package io.github.lumbre.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.camera.Lens;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.Matte;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicLongArray;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Tests that passes, cancellation and crops do not change the samples. */
@Timeout(value = 60, unit = TimeUnit.SECONDS)
class FilmRendererTest {
  private static final int SAMPLES = 100;

  /** A scene whose pictures have noise everywhere and transparent corners. */
  private static final Scene SCENE =
      Scene.builder()
          .seenBy(Lens.fishEye(100).camera(new Vec3(0, 0, -3), Frame.WORLD, 1.5))
          .add(new Sphere(Transform.IDENTITY, 1), Matte.GRAY)
          .addBackground(Rgb.WHITE)
          .build();

  private static RenderSettings.Builder settings() {
    return new RenderSettings.Builder().size(30, 20).samples(SAMPLES).bucketSize(8).threads(2);
  }

  private static FilmRenderer renderer() {
    return new FilmRenderer(settings().build(), SCENE);
  }

  private static Image picture(int samples) throws InterruptedException {
    return new PictureRenderer(settings().samples(samples).build()).render(SCENE);
  }

  private static void assertSame(Image found, Image expected) {
    assertThat(found.rgb()).isEqualTo(expected.rgb());
    for (int y = 0; y < expected.height(); y++) {
      for (int x = 0; x < expected.width(); x++) {
        assertThat(found.alpha(x, y)).isEqualTo(expected.alpha(x, y));
      }
    }
  }

  @Test
  void anySplitIntoPassesGivesTheSameBits() throws InterruptedException {
    Image expected = picture(SAMPLES);
    Random random = new Random(40);
    for (int run = 0; run < 10; run++) {
      Film film = renderer().newFilm();
      for (int done = 0; done < SAMPLES; ) {
        done = Math.min(SAMPLES, done + 1 + random.nextInt(40));
        RenderSettings other =
            settings().threads(1 + random.nextInt(4)).bucketSize(1 + random.nextInt(40)).build();
        FilmRenderer renderer = new FilmRenderer(other, SCENE).inOrder(Orders.shuffled(random));
        renderer.addSamples(film, done, Progress.NONE);
      }
      assertSame(film.develop(), expected);
    }
  }

  /** Cancels passes after random numbers of samples until the film is complete. */
  @Test
  void cancelledPassesNeitherLoseNorDoubleSamples() throws InterruptedException {
    Image expected = picture(SAMPLES);
    Random random = new Random(41);
    for (int run = 0; run < 10; run++) {
      Film film = renderer().newFilm();
      long samples = 0;
      for (boolean complete = false; !complete; ) {
        PassResult pass = renderer().addSamples(film, SAMPLES, cancelAfter(random.nextInt(30_000)));
        samples += pass.statistics().samples();
        complete = pass.complete();
        assertThat(film.totalSamples()).isEqualTo(samples);
      }
      assertThat(samples).isEqualTo(30 * 20 * SAMPLES);
      assertSame(film.develop(), expected);
    }
  }

  /**
   * Randomly cancelled passes also report all rays: none for the corners, some for other pixels.
   */
  @Test
  void aTargetHearsOfEachPixelsRays() throws InterruptedException {
    Random random = new Random(43);
    AtomicLongArray heard = new AtomicLongArray(30 * 20);
    SampleTarget target =
        new SampleTarget() {
          @Override
          public int samples(int x, int y) {
            return SAMPLES;
          }

          @Override
          public void took(int x, int y, long rays) {
            heard.addAndGet(y * 30 + x, rays);
          }
        };
    Film film = renderer().newFilm();
    long rays = 0;
    for (boolean complete = false; !complete; ) {
      PassResult pass = renderer().addSamples(film, target, cancelAfter(random.nextInt(30_000)));
      rays += pass.statistics().rays() + pass.statistics().shadowRays();
      complete = pass.complete();
    }
    assertThat(IntStream.range(0, heard.length()).mapToLong(heard::get).sum()).isEqualTo(rays);
    assertThat(heard.get(0)).isZero();
    assertThat(heard.get(10 * 30 + 15)).isGreaterThanOrEqualTo(2 * SAMPLES);
  }

  private static Progress cancelAfter(long samples) {
    AtomicLong left = new AtomicLong(samples);
    return new Progress() {
      @Override
      public void advanced(long more) {
        left.addAndGet(-more);
      }

      @Override
      public boolean isCancelled() {
        return left.get() < 0;
      }
    };
  }

  @Test
  void pixelsMayHaveDifferentNumbersOfSamples() throws InterruptedException {
    Film film = renderer().newFilm();
    renderer().addSamples(film, (x, y) -> x < 10 ? 3 : 7, Progress.NONE);
    renderer().addSamples(film, (x, y) -> y < 10 ? 5 : 0, Progress.NONE);

    assertThat(film.samples(9, 9)).isEqualTo(5);
    assertThat(film.samples(9, 10)).isEqualTo(3);
    assertThat(film.samples(10, 9)).isEqualTo(7);
    assertThat(film.fewestSamples()).isEqualTo(3);
    assertThat(film.mostSamples()).isEqualTo(7);
    assertThat(film.totalSamples()).isEqualTo(100 * 5 + 100 * 3 + 400 * 7);
    assertThat(film.develop().pixel(9, 9)).isEqualTo(picture(5).pixel(9, 9));
    assertThat(film.develop().pixel(9, 10)).isEqualTo(picture(3).pixel(9, 10));
    assertThat(film.develop().pixel(10, 10)).isEqualTo(picture(7).pixel(10, 10));
  }

  @Test
  void firstSampleMovesTheNumbersOfAllSamples() throws InterruptedException {
    Film late = renderer().newFilm(6);
    renderer().addSamples(late, 2, Progress.NONE);

    // Eight samples are six plus two: means of dyadic fractions with few bits add exactly.
    double six = 6 * picture(6).alpha(4, 2);
    double two = 2 * late.develop().alpha(4, 2);
    assertThat(8 * picture(8).alpha(4, 2)).isEqualTo((float) (six + two));
    assertThat(late.develop().rgb()).isNotEqualTo(picture(2).rgb());
  }

  @Test
  void cropsArePartsOfTheWhole() throws InterruptedException {
    Crop window = new Crop(7, 5, 11, 9);
    FilmRenderer renderer = new FilmRenderer(settings().crop(window).build(), SCENE);
    Film film = renderer.newFilm();
    renderer.addSamples(film, (x, y) -> x == 7 && y == 6 ? 9 : 0, Progress.NONE);

    assertThat(film.samples(7, 6)).isEqualTo(9);
    assertThat(film.totalSamples()).isEqualTo(9);
    assertThat(film.develop().pixel(0, 1)).isEqualTo(picture(9).pixel(7, 6));
  }

  @Test
  void severalThreadsMayUseOneRendererAtOnce() throws Exception {
    FilmRenderer renderer = renderer();
    Callable<Image> work =
        () -> {
          Film film = renderer.newFilm();
          renderer.addSamples(film, 16, Progress.NONE);
          return film.develop();
        };
    ExecutorService pool = Executors.newFixedThreadPool(4);
    try {
      List<Future<Image>> images = new ArrayList<>();
      for (int i = 0; i < 4; i++) {
        images.add(pool.submit(work));
      }
      for (Future<Image> image : images) {
        assertSame(image.get(), picture(16));
      }
    } finally {
      pool.shutdownNow();
    }
  }

  @Test
  void filmsOfOtherWindowsAreRefused() {
    assertThatThrownBy(
            () ->
                renderer().addSamples(new Film(new Crop(0, 0, 30, 19), true, 0), 1, Progress.NONE))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("film: expected the window 0,0,30,20 with alpha, found 0,0,30,19 with");
    assertThatThrownBy(
            () ->
                renderer().addSamples(new Film(new Crop(0, 0, 30, 20), false, 0), 1, Progress.NONE))
        .isInstanceOf(IllegalArgumentException.class);
  }
}
