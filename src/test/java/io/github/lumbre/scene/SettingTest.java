package io.github.lumbre.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;

class SettingTest {
  @Test
  void everySettingStandsAtItsIndexUnderANameOfItsOwn() {
    List<Setting<?>> all = Setting.all();
    for (int i = 0; i < all.size(); i++) {
      assertThat(all.get(i).index()).isEqualTo(i);
    }
    assertThat(all).extracting(Setting::name).doesNotHaveDuplicates().doesNotContain("");
    assertThat(all).contains(Setting.WIDTH, Setting.SPLIT, Setting.BUCKET_SIZE);
  }

  @Test
  void settingsOfAGroupStandTogether() {
    assertThat(Setting.all())
        .extracting(Setting::group)
        .isSorted()
        .contains(Setting.Group.values());
  }

  /** Files and the command line share one text form: a default that is written is read again. */
  @Test
  void defaultsAreInRangeAndTheirTextsAreRead() {
    Setting.all().forEach(SettingTest::assertDefaultIsRead);
  }

  private static <T> void assertDefaultIsRead(Setting<T> setting) {
    T value = setting.defaultValue();
    assertThat(setting.require(value)).isEqualTo(value);
    assertThat(setting.type().parse(setting.type().format(value))).isEqualTo(value);
  }

  @Test
  void flagsAreUniqueAndHaveAPlaceholder() {
    List<Setting<?>> flagged = Setting.all().stream().filter(s -> !s.flag().isEmpty()).toList();
    assertThat(flagged).extracting(Setting::flag).doesNotHaveDuplicates().contains("--seed");
    for (Setting<?> setting : Setting.all()) {
      assertThat(setting.label().isEmpty()).isEqualTo(setting.flag().isEmpty());
      assertThat(setting.flag()).matches("(--[a-z]+)?");
      assertThat(setting.label()).isUpperCase();
    }
  }

  /** The division of work and the development of the picture do not change samples. */
  @Test
  void samplesDependOnTheFrameAndTheTransportOnly() {
    for (Setting<?> setting : Setting.all()) {
      switch (setting.group()) {
        case FRAME, TRANSPORT -> assertThat(setting.changesSamples()).as("%s", setting).isTrue();
        case OUTPUT, EXECUTION -> assertThat(setting.changesSamples()).as("%s", setting).isFalse();
        case SAMPLING -> {
          boolean isCount = setting == Setting.SAMPLES || setting == Setting.ADAPTIVE;
          assertThat(setting.changesSamples()).as("%s", setting).isEqualTo(!isCount);
        }
      }
    }
  }

  /** Splitting and clamping belong to a run, not to a scene. */
  @Test
  void scenesStateSettingsOfThePictureOnly() {
    assertThat(Setting.WIDTH.isInScenes()).isTrue();
    assertThat(Setting.FILTER.isInScenes()).isTrue();
    assertThat(Setting.SPLIT.isInScenes()).isFalse();
    assertThat(Setting.CLAMP.isInScenes()).isFalse();
  }

  @Test
  void meaningsAreSentences() {
    assertThat(Setting.all()).extracting(Setting::meaning).allMatch(text -> text.endsWith("."));
    assertThat(Setting.SEED).hasToString("seed");
  }

  @Test
  void valuesOutOfRangeAreRefusedNamingTheSetting() {
    assertThatThrownBy(() -> Setting.SPLIT.require(257))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("split: expected 1 to 256, found 257");
    assertThatThrownBy(() -> Setting.CLAMP.require(0.0))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("clamp: expected more than 0, found 0.0");
    assertThatThrownBy(() -> Setting.MODE.require(null))
        .isInstanceOf(NullPointerException.class)
        .hasMessage("mode");
  }
}
