package io.github.lumbre.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.camera.Lens;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.Integrator;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.render.internal.Passes;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.testing.Effort;
import java.nio.ByteBuffer;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIfSystemProperty;

/** Tests which pixels the adaptive schedule selects, and that the picture is unbiased. */
class AdaptiveScheduleTest {
  private static final int WIDTH = 24;
  private static final int HEIGHT = 16;
  private static final double RARE = 1 / 64.0;

  /** A placeholder that the integrators below do not use. */
  private static final Scene SCENE =
      Scene.builder().seenBy(Lens.pinhole(1).camera(Vec3.ZERO, Frame.WORLD, 1)).build();

  /**
   * The left half has constant radiance; the right half has light in one of 64 samples, with the
   * same mean.
   */
  private static final Integrator HALF_RARE =
      (ray, sampler, scratch) -> {
        if (ray.direction().x() < 0) {
          return Rgb.WHITE;
        }
        // These low digits are effectively independent between the samples of a pixel.
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
   * Of two equally noisy halves, the one with 16 times the rays per sample gets a quarter of the
   * samples. Counts are powers of two, so the tolerance is a factor of two.
   */
  @Test
  void dearSamplesAreFewer() {
    Film film = new Film(new Crop(0, 0, WIDTH, HEIGHT), false, 0);
    Schedule schedule = new AdaptiveSchedule(512, 1);
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

  /** One sample tells nothing about noise. */
  @Test
  void aSingleSampleIsEnoughIfNoMoreAreWanted() throws InterruptedException {
    Film film = rendered(settings().samples(1).build());
    assertThat(film.totalSamples()).isEqualTo((long) WIDTH * HEIGHT);
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

  /** Cancels a pass after each given number of samples, so that another pass continues it. */
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
   * The mean of many pictures is unbiased, although rare bright samples direct later samples. If a
   * pixel's own samples counted like one of 25, the mean would be 2.7 % too dark, which is 7
   * standard errors. The test fails by chance once in 16,000 seeds.
   */
  @Test
  @DisabledIfSystemProperty(named = Effort.BRIEF, matches = "true")
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

  /**
   * Gives a pixel black samples and then equally many white ones if it is noisy, otherwise gray
   * ones.
   */
  private static void fill(Film film, int pixel, int count, boolean noisy) {
    for (int i = 0; i < count; i++) {
      double white = 2.0 * i < count ? 0 : 1;
      film.add(pixel, Rgb.gray(noisy ? white : .5), true);
    }
  }

  private static SampleTarget next(Film film, int goal) {
    return new AdaptiveSchedule(goal, 1).next(film).orElseThrow();
  }

  /** Returns the pixels selected for more samples, as x + width * y. */
  private static Set<Integer> chosen(Film film, int goal) {
    SampleTarget target = next(film, goal);
    Crop window = film.window();
    Set<Integer> chosen = new TreeSet<>();
    for (int pixel = 0; pixel < window.width() * window.height(); pixel++) {
      int x = window.x() + pixel % window.width();
      int y = window.y() + pixel / window.width();
      int wanted = target.samples(x, y);
      if (wanted > film.samples(x, y)) {
        assertThat(wanted).isEqualTo(2 * film.samples(x, y));
        chosen.add(pixel);
      }
    }
    return chosen;
  }

  private static Film film(int width, int height, int count, int noisyX, int noisyY) {
    Film film = new Film(new Crop(3, 5, width, height), false, 0);
    for (int pixel = 0; pixel < width * height; pixel++) {
      fill(film, pixel, count, pixel == noisyX + width * noisyY);
    }
    return film;
  }

  /**
   * With work for 24 pixels, the schedule selects the 5x5 square around a noisy pixel, without that
   * pixel.
   */
  @Test
  void noiseOfAPixelGivesSamplesToThoseAroundAndNotToItself() {
    for (int[] at : new int[][] {{7, 7}, {4, 4}, {11, 11}, {4, 11}, {11, 4}}) {
      Set<Integer> around = new TreeSet<>();
      for (int i = 0; i < 25; i++) {
        around.add(at[0] - 2 + i % 5 + 16 * (at[1] - 2 + i / 5));
      }
      around.remove(at[0] + 16 * at[1]);
      assertThat(chosen(film(16, 16, 32, at[0], at[1]), 35)).isEqualTo(around);
    }
  }

  /** At a border, a pixel has fewer neighbors, so one noisy neighbor weighs more. */
  @Test
  void noiseInACornerWeighsMostWhereTheFewestPixelsAreAround() {
    for (int corner = 0; corner < 4; corner++) {
      int x = corner % 2 == 0 ? 0 : 15;
      int y = corner < 2 ? 0 : 7;
      int inX = x == 0 ? 1 : -1;
      int inY = y == 0 ? 1 : -1;
      assertThat(chosen(film(16, 8, 32, x, y), 33))
          .containsExactlyInAnyOrder(
              x + inX + 16 * y, x + 2 * inX + 16 * y, x + 16 * (y + inY), x + 16 * (y + 2 * inY));
    }
  }

  /** Of 32 pixels, one without noise has fewer samples than an eighth of the mean. */
  @Test
  void pixelsFarBelowTheMeanComeFirst() {
    Film film = new Film(new Crop(0, 0, 8, 4), false, 0);
    for (int pixel = 0; pixel < 32; pixel++) {
      fill(film, pixel, pixel == 0 ? 32 : pixel == 31 ? 64 : 512, pixel == 30);
    }
    assertThat(film.totalSamples()).isEqualTo(485 * 32 - 64);
    assertThat(chosen(film, 485)).containsExactly(0);
  }

  /** Gives a pixel many equal samples at once. */
  private static void fillAtOnce(Film film, int pixel, int count) {
    ByteBuffer bytes = ByteBuffer.allocate(Film.MAX_PIXEL_BYTES);
    for (int rest = count; rest != 0; rest >>>= 7) {
      bytes.put((byte) (rest & 0x7f | (rest > 0x7f ? 0x80 : 0)));
    }
    for (int channel = 0; channel < 3; channel++) {
      bytes.put((byte) 0).putLong(0);
    }
    film.decode(pixel, bytes.putLong(Long.reverseBytes(PackedRgb.of(0, 0, 0))).flip());
  }

  private static Film black(int width, int height, int count) {
    Film film = new Film(new Crop(0, 0, width, height), false, 0);
    for (int pixel = 0; pixel < width * height; pixel++) {
      fillAtOnce(film, pixel, count);
    }
    return film;
  }

  @Test
  void passesAreAsLongAsEvenOnes() {
    Film film = black(16, 16, 4096);
    assertThat(chosen(film, RenderSettings.MAX_SAMPLES)).hasSize(Passes.LONGEST * 256 / 4096);
  }

  /** A pass adds at most a quarter of the current number of samples. */
  @Test
  void noiseIsLookedAtFourTimesWhileTheSamplesDouble() {
    assertThat(chosen(black(16, 16, 32), 1_000)).hasSize(64);
  }

  @Test
  void noPixelHasMoreSamplesThanARenderMayHave() {
    int most = RenderSettings.MAX_SAMPLES;
    assertThat(new AdaptiveSchedule(most, 1).next(black(1, 1, most))).isEmpty();
    assertThat(chosen(black(1, 1, most / 2), most)).containsExactly(0);
    assertThat(new AdaptiveSchedule(most - 1, 1).next(black(1, 1, most / 2))).isEmpty();
    assertThat(new AdaptiveSchedule(most, 1).next(black(2, 2, most / 2 + 1))).isEmpty();
  }

  /** Where a pass is too short for any pixel, the one with the fewest samples is doubled. */
  @Test
  void picturesOfFewPixelsGoOnWhereItIsCheapest() {
    Film film = new Film(new Crop(0, 0, 3, 1), false, 0);
    fillAtOnce(film, 0, 1024);
    fillAtOnce(film, 1, 512);
    fillAtOnce(film, 2, 1024);
    assertThat(chosen(film, 1024)).containsExactly(1);
    assertThat(new AdaptiveSchedule(1023, 1).next(film)).isEmpty();
  }

  @Test
  void targetStaysTheSameUntilItIsMet() {
    Film film = film(16, 16, 32, 7, 7);
    Schedule schedule = new AdaptiveSchedule(64, 1);
    SampleTarget first = schedule.next(film).orElseThrow();
    fill(film, 0, 4096, true);
    SampleTarget again = schedule.next(film).orElseThrow();
    for (int i = 0; i < 256; i++) {
      assertThat(again.samples(3 + i % 16, 5 + i / 16))
          .isEqualTo(first.samples(3 + i % 16, 5 + i / 16));
    }
  }

  @Test
  void pilotIsEvenAndInPasses() {
    Film film = new Film(new Crop(0, 0, 4, 4), false, 0);
    Schedule schedule = new AdaptiveSchedule(1_000, 1);
    for (int expected = 1; expected <= AdaptiveSchedule.PILOT; expected *= 2) {
      SampleTarget target = schedule.next(film).orElseThrow();
      for (int pixel = 0; pixel < 16; pixel++) {
        assertThat(target.samples(pixel % 4, pixel / 4)).isEqualTo(expected);
        fill(film, pixel, expected - film.samples(pixel), false);
      }
    }
  }
}
