package io.github.lumbre.image.animation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests rates of frames, and times in hundredths of a second. */
class FrameRateTest {
  @ParameterizedTest
  @CsvSource({
    "25, 25, 1",
    "12.5, 25, 2",
    "29.97, 2997, 100",
    "30000/1001, 30000, 1001",
    "0.5, 1, 2",
    "1/600, 1, 600",
    "050/2, 25, 1",
    "65535, 65535, 1"
  })
  void textsAreReducedFractions(String text, int frames, int seconds) {
    assertThat(FrameRate.parse(text)).isEqualTo(new FrameRate(frames, seconds));
    assertThat(FrameRate.parse(text).frames()).isEqualTo(frames);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"", "0", "0.0", "1/0", "0/0", "-25", "+25", "1e3", "25.", ".5", "25 ", "NaN"})
  void otherTextsAreRefused(String text) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> FrameRate.parse(text))
        .withMessageContaining("frames per second")
        .withMessageContaining("found");
  }

  @ParameterizedTest
  @ValueSource(strings = {"65536", "99999.9999", "1/601", "1.00001", "0.0001"})
  void ratesOutOfRangeAreRefused(String text) {
    assertThatIllegalArgumentException().isThrownBy(() -> FrameRate.parse(text));
  }

  /** The requirement itself: each partial sum is within half a hundredth of the exact time. */
  @Test
  void eachPartialSumIsRightToAHundredth() {
    for (int perSecond = 1; perSecond <= 50; perSecond++) {
      assertSums(new FrameRate(perSecond, 1));
    }
    assertSums(new FrameRate(30000, 1001));
    assertSums(new FrameRate(1, 600));
  }

  private static void assertSums(FrameRate rate) {
    long sum = 0;
    for (int frame = 0; frame < 10_000; frame++) {
      int time = rate.hundredths(frame);
      assertThat(time).isBetween(2, 65535);
      sum += time;
      long exact = 100L * (frame + 1) * rate.seconds();
      assertThat(2 * Math.abs(sum * rate.frames() - exact)).isLessThanOrEqualTo(rate.frames());
    }
  }

  @Test
  void timesAreThoseThatPeopleExpect() {
    assertThat(new FrameRate(25, 1).hundredths(7)).isEqualTo(4);
    FrameRate thirty = new FrameRate(30, 1);
    assertThat(new int[] {thirty.hundredths(0), thirty.hundredths(1), thirty.hundredths(2)})
        .containsExactly(3, 4, 3);
  }
}
