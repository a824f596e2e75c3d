package io.github.lumbre.model.internal;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.testing.Effort;
import java.nio.charset.StandardCharsets;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Fast numbers have the bits of {@link Double#parseDouble}. */
class DecimalsTest {
  private static double exact(String text) {
    byte[] bytes = (" " + text + " ").getBytes(StandardCharsets.US_ASCII);
    return Decimals.exact(bytes, 1, bytes.length - 1);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "0",
        "-0",
        "1",
        "-1.5",
        ".5",
        "5.",
        "-.25",
        "0.1",
        "3.14159265358979",
        "1e22",
        "1E-5",
        "9007199254740e-22",
        "0.000001",
        "12.5e+03"
      })
  void simpleNumbersAreExact(String text) {
    assertThat(Double.doubleToRawLongBits(exact(text)))
        .isEqualTo(Double.doubleToRawLongBits(Double.parseDouble(text)));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "-",
        ".",
        "+1",
        "1e",
        "1e+",
        "1e23",
        "1e-23",
        "1e100",
        "nan",
        "1f",
        "0x1",
        "1.2.3",
        "9007199254740993",
        "1,5",
        "e5",
        "--1",
        "1e5.0"
      })
  void otherTextsAreLeftToTheSlowWay(String text) {
    assertThat(exact(text)).isNaN();
  }

  @Test
  void randomNumbersHaveTheSameBits() {
    Random random = new Random(Effort.seed(5));
    int exactOnes = 0;
    int count = Effort.count(5_000, 2_000_000);
    for (int i = 0; i < count; i++) {
      String text =
          switch (random.nextInt(3)) {
            case 0 -> Float.toString(random.nextFloat() * 1000 - 500);
            case 1 -> Double.toString(Math.scalb(random.nextGaussian(), random.nextInt(80) - 40));
            default -> random.nextInt() + "." + random.nextInt(1000) + "e" + random.nextInt(20);
          };
      double found = exact(text);
      if (!Double.isNaN(found)) {
        exactOnes++;
        assertThat(Double.doubleToRawLongBits(found))
            .as(text)
            .isEqualTo(Double.doubleToRawLongBits(Double.parseDouble(text)));
      }
    }
    assertThat(exactOnes).isGreaterThan(count / 3);
  }
}
