package io.github.lumbre.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Tests the precision of packed colors. */
class PackedRgbTest {
  @Test
  void componentsAreKeptToAShareOfTheLargest() {
    Random random = new Random(1);
    for (int i = 0; i < 100_000; i++) {
      double scale = Math.scalb(1.0, random.nextInt(96) - 64);
      Rgb color =
          new Rgb(random.nextDouble() * scale, random.nextDouble() * scale, random.nextDouble());
      Rgb kept = PackedRgb.unpacked(PackedRgb.of(color.r(), color.g(), color.b()));
      double error = color.max() * 0x1p-18;
      assertThat(kept.r()).isCloseTo(color.r(), within(error));
      assertThat(kept.g()).isCloseTo(color.g(), within(error));
      assertThat(kept.b()).isCloseTo(color.b(), within(error));
    }
  }

  @Test
  void powersOfTwoAndWhatIsJustBelowThemAreKept() {
    for (double v : new double[] {0x1p-64, .5, 1, 2, 0x1p32, 0}) {
      assertThat(PackedRgb.unpacked(PackedRgb.of(v, v, v))).isEqualTo(Rgb.gray(v));
      double below = Math.nextDown(v + 1);
      assertThat(PackedRgb.unpacked(PackedRgb.of(below, 0, 0)).r())
          .isCloseTo(below, within((v + 1) * 0x1p-18));
    }
  }

  @Test
  void blackIsAColor() {
    assertThat(PackedRgb.of(0, 0, 0)).isNotEqualTo(PackedRgb.NONE);
  }
}
