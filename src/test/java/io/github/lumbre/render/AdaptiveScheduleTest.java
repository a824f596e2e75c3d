package io.github.lumbre.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.camera.PinholeCamera;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.Integrator;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.testing.Effort;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class AdaptiveScheduleTest {
  private static final int WIDTH = 24;
  private static final int HEIGHT = 16;
  private static final double RARE = 1 / 64.0;

  /** Never met: the integrators below do not look at it. */
  private static final Scene SCENE =
      Scene.seenBy(new PinholeCamera(Vec3.ZERO, Frame.WORLD, 1, 1)).build();

  /** The left half shines evenly, the right one in one sample of 64, as bright in the mean. */
  private static final Integrator HALF_RARE =
      (ray, sampler, scratch) -> {
        if (ray.direction().x() < 0) {
          return Rgb.WHITE;
        }
        // Digits so low that the samples of a pixel are as good as independent.
        double digits = sampler.get1d(7) * 0x1p16 % 1;
        return digits < RARE ? Rgb.WHITE.times(1 / RARE) : Rgb.BLACK;
      };

  private static RenderSettings.Builder settings() {
    return new RenderSettings.Builder().size(WIDTH, HEIGHT).adaptive(true).threads(2).bucketSize(8);
  }

  private static FilmRenderer renderer(RenderSettings settings) {
    return new FilmRenderer(settings, SCENE, HALF_RARE);
  }

  private static Film rendered(RenderSettings settings) throws InterruptedException {
    FilmRenderer renderer = renderer(settings);
    Film film = renderer.newFilm();
    finish(renderer, renderer.schedule(), film, Progress.NONE);
    return film;
  }

  private static void finish(FilmRenderer renderer, Schedule schedule, Film film, Progress progress)
      throws InterruptedException {
    for (Optional<SampleTarget> target = schedule.next(film);
        target.isPresent();
        target = schedule.next(film)) {
      renderer.addSamples(film, target.get(), progress);
    }
  }

  @Test
  void samplesGoWhereTheNoiseIs() throws InterruptedException {
    Film film = rendered(settings().samples(256).build());

    assertThat(film.samples(2, 5)).isEqualTo(32);
    assertThat(film.samples(20, 5)).isBetween(256, 1024);
    assertThat(film.meanSamples()).isBetween(250.0, 256.0);
    for (int y = 0; y < HEIGHT; y++) {
      for (int x = 0; x < WIDTH; x++) {
        assertThat(Integer.bitCount(film.samples(x, y))).isEqualTo(1);
        assertThat(film.samples(x, y)).isGreaterThanOrEqualTo(16);
      }
    }
  }

  /**
   * Of two halves as noisy, the one whose samples take 16 times the rays gets a quarter of the
   * samples, to a factor of two since numbers are powers of two.
   */
  @Test
  void dearSamplesAreFewer() {
    Film film = new Film(new Crop(0, 0, WIDTH, HEIGHT), false, 0);
    Schedule schedule = new AdaptiveSchedule(512);
    Random random = new Random(7);
    for (Optional<SampleTarget> target = schedule.next(film);
        target.isPresent();
        target = schedule.next(film)) {
      for (int pixel = 0; pixel < WIDTH * HEIGHT; pixel++) {
        int x = pixel % WIDTH;
        int more = target.get().samples(x, pixel / WIDTH) - film.samples(pixel);
        for (int i = 0; i < more; i++) {
          film.add(pixel, Rgb.WHITE.times(random.nextDouble()), true);
        }
        target.get().took(x, pixel / WIDTH, more * (x < WIDTH / 2 ? 1 : 31));
      }
    }

    double cheap = meanSamples(film, 0, WIDTH / 2 - 2);
    double dear = meanSamples(film, WIDTH / 2 + 2, WIDTH);
    assertThat(cheap / dear).isBetween(2.8, 5.7);
    assertThat(film.meanSamples()).isBetween(500.0, 512.0);
  }

  private static double meanSamples(Film film, int left, int right) {
    return IntStream.range(left, right)
        .flatMap(x -> IntStream.range(0, HEIGHT).map(y -> film.samples(x, y)))
        .average()
        .getAsDouble();
  }

  @Test
  void fewSamplesAreEven() throws InterruptedException {
    assertThat(rendered(settings().samples(20).build()).fewestSamples()).isEqualTo(20);
    assertThat(rendered(settings().samples(20).build()).mostSamples()).isEqualTo(20);
  }

  @Test
  void smallPicturesEndToo() throws InterruptedException {
    Film one = rendered(settings().samples(1000).crop(new Crop(20, 4, 1, 1)).build());
    assertThat(one.mostSamples()).isEqualTo(512);
    Film two = rendered(settings().samples(1000).crop(new Crop(20, 4, 2, 1)).build());
    assertThat(two.totalSamples()).isBetween(1000L, 2000L);
  }

  @Test
  void threadsBucketsTheirOrderAndPausesChangeNothing() throws InterruptedException {
    Film expected = rendered(settings().samples(200).build());
    Random random = new Random(42);
    for (int run = 0; run < 10; run++) {
      RenderSettings other =
          settings()
              .samples(200)
              .threads(1 + random.nextInt(4))
              .bucketSize(1 + random.nextInt(30))
              .build();
      FilmRenderer renderer = renderer(other).inOrder(Orders.shuffled(random));
      Film film = renderer.newFilm();
      finish(renderer, renderer.schedule(), film, pausingAfter(1 + random.nextInt(20_000)));
      assertThat(film.develop().rgb()).isEqualTo(expected.develop().rgb());
      assertThat(film.totalSamples()).isEqualTo(expected.totalSamples());
    }
  }

  /** Cancels a pass whenever there were so many samples, so that another one goes on with it. */
  private static Progress pausingAfter(long samples) {
    AtomicLong left = new AtomicLong(samples);
    return new Progress() {
      @Override
      public void advanced(long more) {
        left.addAndGet(-more);
      }

      @Override
      public boolean isCancelled() {
        return left.get() < 0 && left.getAndSet(samples) < 0;
      }
    };
  }

  /**
   * The mean of many pictures is the truth, though rare bright samples steer where the next go: a
   * pixel whose own samples had a say in their number, like one of 25, would be 2.7 % too dark
   * here, 7 standard errors. Fails by chance once in 16,000 seeds.
   */
  @Test
  void rareBrightSamplesLoseNothing() throws InterruptedException {
    int renders = Effort.count(300, 6_000);
    double sum = 0;
    double squares = 0;
    for (int i = 0; i < renders; i++) {
      long seed = Effort.seed(i);
      Image image = rendered(settings().samples(64).threads(1).seed(seed).build()).develop();
      double light = 0;
      for (int y = 0; y < HEIGHT; y++) {
        for (int x = WIDTH / 2; x < WIDTH; x++) {
          light += image.pixel(x, y).g() / (HEIGHT * WIDTH / 2.0);
        }
      }
      sum += light / renders;
      squares += light * light / renders;
    }
    double error = Math.sqrt((squares - sum * sum) / (renders - 1));
    if (Effort.isExhaustive()) {
      System.out.println("rare bright samples: " + sum + " of 1 +- " + error);
    }
    assertThat(sum).isCloseTo(1, within(4 * error));
  }
}
