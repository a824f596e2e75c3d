package io.github.lumbre.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.camera.PixelFilter;
import io.github.lumbre.image.Exposure;
import io.github.lumbre.scene.internal.SettingTypes.ChoiceType;
import io.github.lumbre.scene.internal.SettingTypes.ExposureType;
import io.github.lumbre.scene.internal.SettingTypes.FlagType;
import io.github.lumbre.scene.internal.SettingTypes.IntegerType;
import io.github.lumbre.scene.internal.SettingTypes.LimitType;
import io.github.lumbre.scene.internal.SettingTypes.LongType;
import java.util.List;
import org.junit.jupiter.api.Test;

class SettingTypeTest {
  private static <T> void assertTextsAreRead(SettingType<T> type, Iterable<T> values) {
    for (T value : values) {
      assertThat(type.accepts(value)).as("%s", value).isTrue();
      assertThat(type.parse(type.format(value))).isEqualTo(value);
    }
  }

  private static void assertRefused(SettingType<?> type, String text, String expected) {
    assertThatThrownBy(() -> type.parse(text))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("expected " + expected + ", found '" + text + "'");
  }

  @Test
  void rangesOfIntegersIncludeTheirEnds() {
    IntegerType type = new IntegerType(-3, 8);
    assertTextsAreRead(type, List.of(-3, 0, 8));
    assertThat(type.accepts(-4)).isFalse();
    assertThat(type.accepts(9)).isFalse();
    assertThat(type.expected()).isEqualTo("-3 to 8");
    for (String text : new String[] {"", "x", "1.5", "2147483648"}) {
      assertRefused(type, text, "an integer up to 2147483647");
    }
  }

  @Test
  void everyIntegerOf64BitsIsRead() {
    LongType type = new LongType();
    assertTextsAreRead(type, List.of(Long.MIN_VALUE, -1L, 0L, Long.MAX_VALUE));
    assertThat(type.expected()).isEqualTo("an integer up to 9223372036854775807");
    assertRefused(type, "9223372036854775808", type.expected());
    assertRefused(type, "0.5", type.expected());
  }

  @Test
  void limitsArePositiveAndMayBeAbsent() {
    LimitType type = new LimitType();
    assertTextsAreRead(type, List.of(Double.MIN_VALUE, 1.5, Double.POSITIVE_INFINITY));
    for (double value : new double[] {0, -0.0, -1, Double.NEGATIVE_INFINITY, Double.NaN}) {
      assertThat(type.accepts(value)).as("%s", value).isFalse();
    }
    assertThat(type.expected()).isEqualTo("more than 0");
    assertRefused(type, "much", "a number");
  }

  @Test
  void flagsAreTrueOrFalseAndNothingElse() {
    FlagType type = new FlagType();
    assertTextsAreRead(type, List.of(true, false));
    for (String text : new String[] {"", "True", "yes", "1"}) {
      assertRefused(type, text, "true or false");
    }
  }

  @Test
  void choicesAreTheConstantsInLowerCaseWithHyphens() {
    ChoiceType<PixelFilter> type = new ChoiceType<>(PixelFilter.class);
    assertTextsAreRead(type, List.of(PixelFilter.values()));
    assertThat(type.format(PixelFilter.BLACKMAN_HARRIS)).isEqualTo("blackman-harris");
    assertThat(type.choices().keySet())
        .containsExactly("box", "tent", "gaussian", "blackman-harris");
    assertThat(type.choices().values()).containsExactly(PixelFilter.values());
    assertThat(type.expected()).isEqualTo("one of box, tent, gaussian, blackman-harris");
    for (String text : new String[] {"", "BOX", "blackman_harris", "boxes"}) {
      assertRefused(type, text, type.expected());
    }
  }

  @Test
  void exposuresAreStopsOrAutomatic() {
    ExposureType type = new ExposureType();
    assertTextsAreRead(
        type, List.of(Exposure.AUTO, Exposure.NONE, Exposure.of(-1.5), Exposure.of(1e300)));
    assertThat(type.format(Exposure.AUTO)).isEqualTo("auto");
    for (String text : new String[] {"", "Auto", "NaN", "Infinity", "bright"}) {
      assertRefused(type, text, "auto or a finite number of stops");
    }
  }
}
