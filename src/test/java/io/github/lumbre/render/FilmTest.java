package io.github.lumbre.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.testing.Effort;
import java.math.BigDecimal;
import java.math.BigInteger;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Tests the exact sums, the encoding and the merging of films. */
class FilmTest {
  private static final double GRID = 0x1p-64;

  private static float develop(double... values) {
    Film film = new Film(new Crop(0, 0, 1, 1), false, 0);
    for (double value : values) {
      film.add(0, Rgb.gray(value), true);
    }
    return film.develop().rgb()[0];
  }

  @Test
  void oneSampleIsDevelopedAsItself() {
    Random random = new Random(30);
    for (int i = 0; i < 100_000; i++) {
      double value = random.nextDouble() * Math.scalb(1.0, random.nextInt(45) - 12);
      assertThat(develop(value)).isEqualTo((float) value);
    }
    for (double value : new double[] {0, 1, .5, .1, 255, Math.nextDown(1.0), 0x1p32, 0x1p-52}) {
      assertThat(develop(value)).isEqualTo((float) value);
    }
  }

  @Test
  void copyHoldsTheSameAndDoesNotChangeWithItsOriginal() {
    Film film = new Film(new Crop(3, 4, 2, 1), true, 9);
    Film empty = film.copy();
    film.add(0, new Rgb(.1, 2, 3e5), true);
    film.add(0, new Rgb(.3, 0, 1), false);
    film.add(1, Rgb.gray(7), true);
    Film copy = film.copy();
    byte[] before = encoded(film);
    assertThat(encoded(copy)).isEqualTo(before).isNotEqualTo(encoded(empty));
    assertThat(copy.firstSample()).isEqualTo(9);
    film.add(1, Rgb.gray(1), true);
    assertThat(encoded(copy)).isEqualTo(before).isNotEqualTo(encoded(film));
    film.set(copy);
    assertThat(encoded(film)).isEqualTo(before);
    assertThatThrownBy(() -> film.set(new Film(new Crop(3, 4, 1, 2), true, 9)))
        .isInstanceOf(IllegalArgumentException.class);
  }

  private static byte[] encoded(Film film) {
    ByteBuffer bytes = ByteBuffer.allocate(2 * Film.MAX_PIXEL_BYTES);
    film.encode(0, bytes);
    film.encode(1, bytes);
    return bytes.array();
  }

  @Test
  void smallSamplesAreRoundedToTheGrid() {
    assertThat(develop(GRID)).isEqualTo((float) GRID);
    assertThat(develop(1.5 * GRID)).isEqualTo((float) (2 * GRID));
    assertThat(develop(.75 * GRID)).isEqualTo((float) GRID);
    assertThat(develop(.25 * GRID)).isZero();
    assertThat(develop(Double.MIN_VALUE)).isZero();
    assertThat(develop(12345 * GRID)).isEqualTo((float) (12345 * GRID));
  }

  @Test
  void tooLargeSamplesAreCut() {
    assertThat(develop(0x1p33)).isEqualTo(0x1p32f);
    assertThat(develop(1e300)).isEqualTo(0x1p32f);
    assertThat(develop(Math.nextDown(0x1p32))).isEqualTo((float) Math.nextDown(0x1p32));
  }

  /**
   * Uses samples whose exact mean is halfway between two floats, so an error in the last bit of the
   * sum gives the wrong float.
   */
  @Test
  void sumIsExactInAnyOrder() {
    Random random = new Random(31);
    for (double tie : new double[] {1 + 0x1p-24, 1 + 0x3p-24}) {
      List<Double> samples = new ArrayList<>();
      for (int i = 0; i < 256; i++) {
        double part = random.nextDouble();
        BigDecimal rest = new BigDecimal(4 * tie).subtract(new BigDecimal(part));
        double most = Math.nextDown(rest.doubleValue());
        double least = rest.subtract(new BigDecimal(most)).doubleValue();
        samples.addAll(List.of(part, most, least, 0.0));
      }
      for (int run = 0; run < 50; run++) {
        Collections.shuffle(samples, random);
        double[] values = samples.stream().mapToDouble(x -> x).toArray();
        assertThat(develop(values)).isEqualTo((float) tie);
      }
    }
  }

  /**
   * Uses pairs of full-precision doubles whose means are halfway between floats; running sums of
   * doubles have an error of 2e-10.
   */
  @Test
  void tenMillionAdditionsLoseNothing() {
    float[] low = {.1f, Math.nextUp(.1f), 10.7f};
    double[] ties = new double[3];
    double[] part = new double[3];
    for (int i = 0; i < 3; i++) {
      ties[i] = .5 * ((double) low[i] + Math.nextUp(low[i]));
      part[i] = ties[i] * Math.sqrt(1.5);
    }
    Rgb one = new Rgb(part[0], part[1], part[2]);
    // Exact, because the operands differ by at most a factor of 2 (Sterbenz 1974).
    Rgb other = new Rgb(2 * ties[0] - part[0], 2 * ties[1] - part[1], 2 * ties[2] - part[2]);
    Film film = new Film(new Crop(0, 0, 1, 1), false, 0);
    for (int i = 0; i < 10_000_000; i++) {
      film.add(0, i < 5_000_000 ? one : other, true);
    }
    assertThat(film.develop().rgb())
        .containsExactly((float) ties[0], (float) ties[1], (float) ties[2]);
  }

  /**
   * After this many samples, running sums of doubles have an error of 1e-11, and those of floats
   * lose nearly everything.
   */
  @Test
  @Tag(Effort.EXHAUSTIVE)
  void aBillionSamplesOfOnePixelLoseNothing() {
    SplittableRandom random = new SplittableRandom(Effort.seed(34));
    Film film = new Film(new Crop(0, 0, 1, 1), false, 0);
    int n = 1_000_000_000;
    // The sum in units of 2^-53, in two parts so that neither overflows.
    long high = 0;
    long low = 0;
    for (int i = 0; i < n; i++) {
      double value = random.nextDouble();
      long units = (long) (value * 0x1p53);
      high += units >>> 32;
      low += units & 0xffff_ffffL;
      film.add(0, Rgb.gray(value), true);
    }
    ByteBuffer bytes = ByteBuffer.allocate(Film.MAX_PIXEL_BYTES);
    film.encode(0, bytes);
    bytes.flip();
    assertThat(number(bytes)).isEqualTo(n);
    BigInteger sum = BigInteger.valueOf(high).shiftLeft(32).add(BigInteger.valueOf(low));
    for (int channel = 0; channel < 3; channel++) {
      BigInteger whole = BigInteger.valueOf(number(bytes));
      String fraction = Long.toUnsignedString(Long.reverseBytes(bytes.getLong()));
      assertThat(whole.shiftLeft(64).add(new BigInteger(fraction))).isEqualTo(sum.shiftLeft(11));
    }
    float mean = new BigDecimal(sum).divide(new BigDecimal(n)).floatValue();
    assertThat(film.develop().rgb()[0]).isCloseTo(mean * 0x1p-53f, within(0x1p-24f));
  }

  /** Reads seven bits per byte, the lowest first. */
  private static long number(ByteBuffer bytes) {
    long number = 0;
    int shift = 0;
    byte bits;
    do {
      bits = bytes.get();
      number |= (bits & 0x7fL) << shift;
      shift += 7;
    } while (bits < 0);
    return number;
  }

  @Test
  void everyBitOfTheFractionIsSummed() {
    Film film = new Film(new Crop(0, 0, 1, 1), false, 0);
    int n = 1 << 20;
    for (int i = 0; i < n; i++) {
      // 2^-44 - 2^-64 and 2^-64 alternately: 2^-44 per pair.
      film.add(0, Rgb.gray(i % 2 == 0 ? 0x1p-44 - GRID : GRID), true);
    }
    assertThat(film.develop().rgb()[0]).isEqualTo(0x1p-45f);
    Film carry = new Film(new Crop(0, 0, 1, 1), false, 0);
    for (int i = 0; i < 1 << 12; i++) {
      carry.add(0, Rgb.gray(Math.nextDown(1.0)), true);
    }
    assertThat(carry.develop().rgb()[0]).isEqualTo((float) Math.nextDown(1.0));
    assertThat(develop(.75, .75, .75, .75)).isEqualTo(.75f);
  }

  @Test
  void alphaIsTheShareThatCoversAndColorIsStraight() {
    Film film = new Film(new Crop(0, 0, 2, 1), true, 0);
    film.add(0, new Rgb(.5, .25, 1), true);
    film.add(0, Rgb.BLACK, false);
    film.add(0, Rgb.BLACK, false);
    film.add(0, new Rgb(.5, .75, 0), true);
    film.add(1, Rgb.BLACK, false);
    Image image = film.develop();
    assertThat(image.alpha(0, 0)).isEqualTo(.5f);
    assertThat(image.pixel(0, 0)).isEqualTo(new Rgb(.5, .5, .5));
    assertThat(image.alpha(1, 0)).isZero();
    assertThat(image.pixel(1, 0)).isEqualTo(Rgb.BLACK);
  }

  @Test
  void filmWithoutAlphaAveragesOverAllSamples() {
    Film film = new Film(new Crop(0, 0, 1, 1), false, 0);
    film.add(0, Rgb.WHITE, true);
    film.add(0, Rgb.BLACK, false);
    assertThat(film.develop().pixel(0, 0)).isEqualTo(Rgb.gray(.5));
    assertThat(film.develop().hasAlpha()).isFalse();
  }

  @Test
  void pixelsAndChannelsAreTheirOwn() {
    Film film = new Film(new Crop(0, 0, 3, 2), true, 0);
    for (int pixel = 0; pixel < 6; pixel++) {
      film.add(pixel, new Rgb(pixel, 10 * pixel, 100 * pixel), true);
    }
    Image image = film.develop();
    assertThat(image.pixel(2, 1)).isEqualTo(new Rgb(5, 50, 500));
    assertThat(image.pixel(1, 0)).isEqualTo(new Rgb(1, 10, 100));
  }

  @Test
  void pixelsWithoutSamplesAreBlackAndTransparent() {
    assertThat(new Film(new Crop(0, 0, 1, 1), false, 0).develop().pixel(0, 0)).isEqualTo(Rgb.BLACK);
    assertThat(new Film(new Crop(0, 0, 1, 1), true, 0).develop().alpha(0, 0)).isZero();
  }

  @Test
  void halvesAreTheMeansBeforeAndAfterThePowerOfTwo() {
    Film film = new Film(new Crop(5, 7, 1, 1), false, 0);
    double[] sums = new double[101];
    for (int i = 1; i <= 100; i++) {
      film.add(0, new Rgb(i, 2 * i, 0), true);
      sums[i] = sums[i - 1] + i;
      if (i == 1) {
        assertThat(film.halves(5, 7)).isEmpty();
        continue;
      }
      int first = Integer.highestOneBit(i - 1);
      PixelHalves halves = film.halves(5, 7).orElseThrow();
      assertThat(halves.firstCount()).isEqualTo(first);
      assertThat(halves.secondCount()).isEqualTo(i - first);
      double firstMean = sums[first] / first;
      double secondMean = (sums[i] - sums[first]) / (i - first);
      assertThat(halves.first().r()).isCloseTo(firstMean, withinPercentage(.001));
      assertThat(halves.first().g()).isCloseTo(2 * firstMean, withinPercentage(.001));
      double slack = firstMean * first / (i - first) * 2e-5;
      assertThat(halves.second().r()).isCloseTo(secondMean, within(slack));
      assertThat(halves.second().b()).isZero();
    }
  }

  @Test
  void valuesThatAreNoRadianceAreBugs() {
    Film film = new Film(new Crop(0, 0, 1, 1), false, 0);
    for (double value : new double[] {Double.NaN, -1, Double.POSITIVE_INFINITY}) {
      assertThatThrownBy(() -> film.add(0, Rgb.gray(value), true))
          .isInstanceOf(AssertionError.class);
    }
  }

  @Test
  void pixelsAreReadAsTheyWereWritten() {
    Random random = new Random(32);
    Film film = new Film(new Crop(0, 0, 50, 4), true, 0);
    for (int i = 0; i < 2_000; i++) {
      double scale = Math.scalb(1.0, random.nextInt(140) - 100);
      Rgb value = new Rgb(random.nextDouble() * scale, random.nextDouble(), 0);
      film.add(random.nextInt(150), value, random.nextBoolean());
    }
    film.add(199, Rgb.gray(Film.LARGEST), true);
    ByteBuffer bytes = ByteBuffer.allocate(200 * Film.MAX_PIXEL_BYTES);
    for (int pixel = 0; pixel < 200; pixel++) {
      int before = bytes.position();
      film.encode(pixel, bytes);
      assertThat(bytes.position() - before).isBetween(1, Film.MAX_PIXEL_BYTES);
    }
    Film read = new Film(new Crop(0, 0, 50, 4), true, 0);
    bytes.flip();
    for (int pixel = 0; pixel < 200; pixel++) {
      read.decode(pixel, bytes);
    }
    assertThat(bytes.hasRemaining()).isFalse();
    assertThat(read.develop().rgb()).isEqualTo(film.develop().rgb());
    assertThat(read.totalSamples()).isEqualTo(2_001);
    for (int x = 0; x < 50; x++) {
      assertThat(read.develop().alpha(x, 0)).isEqualTo(film.develop().alpha(x, 0));
    }
  }

  @Test
  void pixelsThatCannotBeAreRefused() {
    byte[][] impossible = {
      {-1, -1, -1, -1, -1, 0}, // more samples than a render may have
      {2, 3}, // more samples cover the pixel than it has
      {1, 0, -127, -128, -128, -128, 16}, // a sum beyond the largest sample
      {-1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1}
    };
    for (byte[] bytes : impossible) {
      Film film = new Film(new Crop(0, 0, 1, 1), true, 0);
      assertThatThrownBy(() -> film.decode(0, ByteBuffer.wrap(bytes)))
          .isInstanceOf(IllegalArgumentException.class);
    }
  }

  @Test
  void sumOfFilmsIsTheFilmOfAllSamples() {
    Random random = new Random(33);
    for (int run = 0; run < 50; run++) {
      Film all = new Film(new Crop(3, 2, 2, 2), true, 0);
      Film one = new Film(new Crop(3, 2, 2, 2), true, 0);
      Film other = new Film(new Crop(4, 2, 1, 2), true, 0);
      for (int i = 0; i < 40; i++) {
        Rgb value = new Rgb(random.nextDouble(), 1e3 * random.nextDouble(), Math.nextDown(1.0));
        boolean covers = random.nextBoolean();
        boolean second = random.nextBoolean();
        int row = random.nextInt(2);
        all.add(2 * row + (second ? 1 : 0), value, covers);
        if (second) {
          other.add(row, value, covers);
        } else {
          one.add(2 * row, value, covers);
        }
      }
      one.addAll(other);
      assertThat(one.develop().rgb()).isEqualTo(all.develop().rgb());
      assertThat(one.develop().alpha(1, 1)).isEqualTo(all.develop().alpha(1, 1));
    }
  }

  /** Returns a film of one row whose pixels have the given numbers of equal samples. */
  private static Film row(Rgb value, int... counts) {
    Film film = new Film(new Crop(2, 3, counts.length, 1), false, 0);
    for (int pixel = 0; pixel < counts.length; pixel++) {
      for (int i = 0; i < counts[pixel]; i++) {
        film.add(pixel, value, true);
      }
    }
    return film;
  }

  @Test
  void countsOfAllPixelsAreSummedUp() {
    Film film = row(new Rgb(3, 6, .75), 6, 1, 2);
    assertThat(film.fewestSamples()).isEqualTo(1);
    assertThat(film.medianSamples()).isEqualTo(2);
    assertThat(film.mostSamples()).isEqualTo(6);
    assertThat(film.totalSamples()).isEqualTo(9);
    assertThat(film.meanSamples()).isEqualTo(3);
    assertThat(film.totalLight()).isCloseTo(9 * 3.25, within(1e-12));
  }

  @Test
  void filmsThatDoNotFitAreRefused() {
    Film film = new Film(new Crop(4, 4, 3, 3), true, 5);
    for (Crop outside :
        List.of(
            new Crop(3, 5, 1, 1),
            new Crop(7, 5, 1, 1),
            new Crop(5, 3, 1, 1),
            new Crop(5, 7, 1, 1),
            new Crop(4, 4, 4, 3),
            new Crop(4, 4, 3, 4))) {
      assertThatThrownBy(() -> film.addAll(new Film(outside, true, 5)))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessageContaining(outside.toString());
    }
    film.addAll(new Film(film.window(), true, 5));
    for (Film other :
        List.of(
            new Film(film.window(), false, 5),
            new Film(film.window(), true, 6),
            new Film(new Crop(4, 4, 3, 2), true, 5))) {
      assertThatThrownBy(() -> film.set(other)).isInstanceOf(IllegalArgumentException.class);
    }
    assertThatThrownBy(() -> film.addAll(new Film(film.window(), false, 5)))
        .isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> new Film(film.window(), true, -1))
        .isInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void pixelsOutsideOfTheWindowHaveNoSamples() {
    Film film = row(Rgb.WHITE, 1, 4);
    assertThat(film.samples(2, 3)).isEqualTo(1);
    assertThat(film.samples(3, 3)).isEqualTo(4);
    for (int[] outside : new int[][] {{1, 3}, {4, 3}, {2, 2}, {2, 4}}) {
      assertThatThrownBy(() -> film.samples(outside[0], outside[1]))
          .isInstanceOf(IndexOutOfBoundsException.class);
      assertThatThrownBy(() -> film.halves(outside[0], outside[1]))
          .isInstanceOf(IndexOutOfBoundsException.class);
    }
  }

  /** Films that both begin at sample 0 do not follow on each other. */
  @Test
  void halvesAreKnownOfPixelsWhoseSamplesComeFromOneFilm() {
    Film sum = row(Rgb.WHITE, 4, 0, 4, 0);
    sum.addAll(row(Rgb.WHITE, 0, 4, 4, 0));
    assertThat(sum.halves(2, 3)).contains(new PixelHalves(2, Rgb.WHITE, 2, Rgb.WHITE));
    assertThat(sum.halves(3, 3)).contains(new PixelHalves(2, Rgb.WHITE, 2, Rgb.WHITE));
    assertThat(sum.halves(4, 3)).isEmpty();
    assertThat(sum.halves(5, 3)).isEmpty();
    assertThat(sum.samples(4, 3)).isEqualTo(8);
  }

  /**
   * Halves of a sum are those of one film with all samples, unless a power of two lies strictly
   * between the numbers of samples before and after a part is added.
   */
  @Test
  void filmsThatFollowOnEachOtherKnowTheirHalves() {
    Crop pixel = new Crop(0, 0, 1, 1);
    Random random = new Random(12);
    int known = 0;
    int unknown = 0;
    for (int run = 0; run < 2000; run++) {
      Film whole = new Film(pixel, false, 0);
      Film sum = new Film(pixel, false, 0);
      boolean isKnown = true;
      while (sum.samples(0, 0) < 40) {
        int before = sum.samples(0, 0);
        Film part = new Film(pixel, false, before);
        int count = 1 + random.nextInt(20);
        for (int i = 0; i < count; i++) {
          Rgb sample = new Rgb(random.nextDouble(), random.nextDouble(), random.nextDouble());
          whole.add(0, sample, true);
          part.add(0, sample, true);
        }
        sum.addAll(part);
        int last = Integer.highestOneBit(before + count - 1);
        isKnown = before == 0 || last == before || last < before && isKnown;
        if (isKnown) {
          assertThat(sum.halves(0, 0)).isEqualTo(whole.halves(0, 0));
          known++;
        } else {
          assertThat(sum.halves(0, 0)).isEmpty();
          unknown++;
        }
      }
    }
    assertThat(known).isGreaterThan(1000);
    assertThat(unknown).isGreaterThan(1000);
  }

  @Test
  void pixelMayBeCoveredByAllOfItsSamplesAndBeAsBrightAsCanBe() {
    Film film = new Film(new Crop(0, 0, 1, 1), true, 0);
    for (int i = 0; i < 200; i++) {
      film.add(0, Rgb.gray(Film.LARGEST), true);
    }
    ByteBuffer bytes = ByteBuffer.allocate(Film.MAX_PIXEL_BYTES);
    film.encode(0, bytes);
    Film read = new Film(new Crop(0, 0, 1, 1), true, 0);
    read.decode(0, bytes.flip());
    assertThat(read.develop().pixel(0, 0)).isEqualTo(Rgb.gray(Film.LARGEST));
    assertThat(read.develop().alpha(0, 0)).isEqualTo(1);
    assertThat(read.samples(0, 0)).isEqualTo(200);
  }

  @Test
  void pixelWithoutSamplesTakesAByte() {
    ByteBuffer bytes = ByteBuffer.allocate(Film.MAX_PIXEL_BYTES);
    new Film(new Crop(0, 0, 1, 1), true, 0).encode(0, bytes);
    assertThat(bytes.position()).isEqualTo(1);
  }
}
