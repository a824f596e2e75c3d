package io.github.lumbre.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.camera.PixelFilter;
import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.ToneCurve;
import io.github.lumbre.scene.RenderSettings.Builder;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.scene.RenderSettings.Mode;
import io.github.lumbre.scene.RenderSettings.Size;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;

class RenderSettingsTest {
  /** One change of each kind. */
  private static final List<UnaryOperator<Builder>> CHANGES =
      List.of(
          b -> b.set(Setting.WIDTH, 640),
          b -> b.set(Setting.HEIGHT, 480),
          b -> b.transparent(true),
          b -> b.set(Setting.BACKPLATE, Optional.of(new Rgb(1, .5, 0))),
          b -> b.mode(Mode.RAY),
          b -> b.maxTraceDepth(7),
          b -> b.rayDepths(8, 2),
          b -> b.rayDepths(2, 9),
          b -> b.split(3),
          b -> b.clamp(12.5),
          b -> b.samples(11),
          b -> b.adaptive(true),
          b -> b.filter(PixelFilter.TENT),
          b -> b.seed(-42),
          b -> b.exposure(Exposure.AUTO),
          b -> b.toneCurve(ToneCurve.ACES),
          b -> b.set(Setting.LINE_WIDTH, 1.5),
          b -> b.set(Setting.CREASE_ANGLE, 45.),
          b -> b.set(Setting.LAYERS, Layer.FOR_DENOISING),
          b -> b.threads(4),
          b -> b.bucketSize(16),
          b -> b.crop(new Crop(1, 2, 3, 4)));

  private static RenderSettings all() {
    return new Builder()
        .size(640, 480)
        .transparent(true)
        .set(Setting.BACKPLATE, Optional.of(new Rgb(1, .5, .25)))
        .mode(Mode.RAY)
        .maxTraceDepth(7)
        .rayDepths(8, 9)
        .split(3)
        .guiding(RenderSettings.Guiding.ON)
        .clamp(12.5)
        .samples(11)
        .adaptive(true)
        .filter(PixelFilter.TENT)
        .set(Setting.SHUTTER, .02)
        .set(Setting.POSES, 8)
        .seed(-42)
        .exposure(Exposure.AUTO)
        .set(Setting.LINE_WIDTH, 1.5)
        .set(Setting.CREASE_ANGLE, 45.)
        .toneCurve(ToneCurve.ACES)
        .set(Setting.LAYERS, Layer.FOR_DENOISING)
        .threads(4)
        .bucketSize(16)
        .crop(new Crop(1, 2, 3, 4))
        .build();
  }

  @Test
  void valuesAreThoseThatWereSet() {
    RenderSettings settings = all();
    assertThat(settings.width()).isEqualTo(640);
    assertThat(settings.height()).isEqualTo(480);
    assertThat(settings.transparent()).isTrue();
    assertThat(settings.mode()).isEqualTo(Mode.RAY);
    assertThat(settings.maxTraceDepth()).isEqualTo(7);
    assertThat(settings.reflectionTraceDepth()).isEqualTo(8);
    assertThat(settings.refractionTraceDepth()).isEqualTo(9);
    assertThat(settings.split()).isEqualTo(3);
    assertThat(settings.guiding()).isEqualTo(RenderSettings.Guiding.ON);
    assertThat(settings.clamp()).isEqualTo(12.5);
    assertThat(settings.samples()).isEqualTo(11);
    assertThat(settings.adaptive()).isTrue();
    assertThat(settings.filter()).isEqualTo(PixelFilter.TENT);
    assertThat(settings.poses()).isEqualTo(8);
    assertThat(settings.seed()).isEqualTo(-42);
    assertThat(settings.exposure()).isEqualTo(Exposure.AUTO);
    assertThat(settings.toneCurve()).isEqualTo(ToneCurve.ACES);
    assertThat(settings.layers()).isEqualTo(Layer.FOR_DENOISING);
    assertThat(settings.threads()).isEqualTo(4);
    assertThat(settings.bucketSize()).isEqualTo(16);
    assertThat(settings.crop()).contains(new Crop(1, 2, 3, 4));
  }

  @Test
  void withoutChangesAllHaveTheirDefaults() {
    for (Setting<?> setting : Setting.all()) {
      assertThat(RenderSettings.DEFAULT.isSet(setting)).as("%s", setting).isFalse();
      assertThat(RenderSettings.DEFAULT.get(setting)).isEqualTo(setting.defaultValue());
      assertThat(all().isSet(setting)).as("%s", setting).isTrue();
    }
    assertThat(RenderSettings.DEFAULT.transparent()).isFalse();
    assertThat(RenderSettings.DEFAULT.adaptive()).isFalse();
    assertThat(RenderSettings.DEFAULT.crop()).isEmpty();
  }

  @Test
  void transparencyHidesTheColorOfTheBackground() {
    RenderSettings white =
        new Builder().set(Setting.BACKPLATE, Optional.of(Rgb.WHITE)).build();
    assertThat(white.background()).contains(Rgb.WHITE);
    assertThat(white.development().background()).contains(Rgb.WHITE);
    assertThat(white.countsCoverage()).isTrue();
    assertThat(all().background()).isEmpty();
    assertThat(all().countsCoverage()).isTrue();
    assertThat(RenderSettings.DEFAULT.countsCoverage()).isFalse();
    assertThatThrownBy(() -> new Builder().set(Setting.BACKPLATE, Optional.of(new Rgb(0, 2, 0))))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith("backplate: expected a color such as #ff8800");
  }

  private static <T> Builder setText(Builder builder, Setting<T> setting, String text) {
    return builder.set(setting, setting.type().parse(text));
  }

  @Test
  void textsOfAllValuesMakeTheSameSettings() {
    Builder builder = new Builder().crop(new Crop(1, 2, 3, 4));
    for (Setting<?> setting : Setting.all()) {
      assertThat(setText(builder, setting, all().text(setting))).isSameAs(builder);
    }
    assertThat(builder.build()).isEqualTo(all());
  }

  @Test
  void changedCopiesDifferInTheChangeAlone() {
    assertThat(all().toBuilder().build()).isEqualTo(all()).hasSameHashCodeAs(all());
    assertThat(RenderSettings.DEFAULT.toBuilder().build()).isEqualTo(RenderSettings.DEFAULT);
    for (UnaryOperator<Builder> change : CHANGES) {
      RenderSettings changed = change.apply(RenderSettings.DEFAULT.toBuilder()).build();
      assertThat(changed).isNotEqualTo(RenderSettings.DEFAULT);
      long set = Setting.all().stream().filter(changed::isSet).count();
      assertThat(set).isEqualTo(changed.crop().isPresent() ? 0 : 1);
    }
    assertThat(RenderSettings.DEFAULT).isNotEqualTo(new Builder());
    assertThat(all().hashCode()).isNotEqualTo(RenderSettings.DEFAULT.hashCode());
  }

  @Test
  void textNamesWhatIsNotTheDefault() {
    assertThat(RenderSettings.DEFAULT).hasToString("RenderSettings[]");
    assertThat(new Builder().seed(3).crop(new Crop(0, 1, 2, 3)).build())
        .hasToString("RenderSettings[seed=3, crop=0,1,2,3]");
  }

  @Test
  void windowIsTheCropOrTheFrame() {
    assertThat(all().window()).isEqualTo(new Crop(1, 2, 3, 4));
    RenderSettings whole = new Builder().size(30, 20).build();
    assertThat(whole.window()).isEqualTo(new Crop(0, 0, 30, 20));
    assertThat(whole.aspect()).isEqualTo(1.5);
  }

  @Test
  void cropsReachTheEdgesOfTheFrameAndNotBeyond() {
    Builder frame = new Builder().size(30, 20);
    for (Crop inside : List.of(new Crop(29, 19, 1, 1), new Crop(0, 0, 30, 20))) {
      assertThat(frame.crop(inside).build().window()).isEqualTo(inside);
    }
    for (Crop outside :
        List.of(new Crop(29, 0, 2, 1), new Crop(0, 19, 1, 2), new Crop(65535, 0, 65535, 1))) {
      assertThatThrownBy(() -> frame.crop(outside).build())
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessage("crop: expected a rectangle inside 30x20, found " + outside);
    }
  }

  @Test
  void cropsHaveAPlaceAndASize() {
    assertThat(new Crop(65535, 65535, 65535, 65535)).hasToString("65535,65535,65535,65535");
    assertThat(new Crop(0, 0, 1, 1)).hasToString("0,0,1,1");
    assertThatThrownBy(() -> new Crop(-1, 0, 1, 1))
        .hasMessage("crop x: expected 0 to 65535, found -1");
    assertThatThrownBy(() -> new Crop(0, 65536, 1, 1))
        .hasMessage("crop y: expected 0 to 65535, found 65536");
    assertThatThrownBy(() -> new Crop(0, 0, 0, 1))
        .hasMessage("crop width: expected 1 to 65535, found 0");
    assertThatThrownBy(() -> new Crop(0, 0, 1, 65536))
        .hasMessage("crop height: expected 1 to 65535, found 65536");
  }

  @Test
  void sizesAreReadFromTwoNumbers() {
    assertThat(Size.of("640x480")).isEqualTo(new Size(640, 480));
    for (String text : new String[] {"", "640", "640x", "640X480", "-1x5", "1234567890x1"}) {
      assertThatThrownBy(() -> Size.of(text))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessage("expected WxH, such as 640x480, found '" + text + "'");
    }
  }

  @Test
  void largestValuesAreTaken() {
    RenderSettings largest =
        new Builder()
            .size(RenderSettings.MAX_SIDE, RenderSettings.MAX_SIDE)
            .samples(RenderSettings.MAX_SAMPLES)
            .maxTraceDepth(RenderSettings.MAX_DEPTH)
            .split(RenderSettings.MAX_SPLIT)
            .threads(RenderSettings.MAX_THREADS)
            .build();
    assertThat(largest.samples()).isEqualTo(RenderSettings.MAX_SAMPLES);
    assertThatThrownBy(() -> new Builder().size(65536, 1))
        .hasMessage("width: expected 1 to 65535, found 65536");
    assertThatThrownBy(() -> setText(new Builder(), Setting.SAMPLES, "0"))
        .hasMessage("samples: expected 1 to 1073741824, found 0");
  }

  @Test
  void developmentHasTheExposureAndTheToneCurve() {
    ImageWriter.Options options = all().development();
    assertThat(options.exposure()).isEqualTo(Exposure.AUTO);
    assertThat(options.curve()).isEqualTo(ToneCurve.ACES);
    assertThat(RenderSettings.DEFAULT.development()).isEqualTo(ImageWriter.Options.DEFAULT);
  }
}
