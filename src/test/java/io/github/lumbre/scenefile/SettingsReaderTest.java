package io.github.lumbre.scenefile;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.ToneCurve;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.Backplate;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Mode;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the reading of render settings. */
class SettingsReaderTest {
  private final Problems problems = new Problems("s.json");

  private JsonNode options(String text) {
    try {
      return JsonNode.read(text.getBytes(StandardCharsets.UTF_8), problems, Limits.NONE);
    } catch (SceneFormatException e) {
      throw new AssertionError(e);
    }
  }

  private RenderSettings read(String text) {
    return SettingsReader.read(options(text), Optional.empty());
  }

  @Test
  void nothingMeansTheDefaults() {
    assertThat(read("{}")).isEqualTo(RenderSettings.DEFAULT);
    assertThat(SettingsReader.defaults(Optional.empty())).isEqualTo(RenderSettings.DEFAULT);
    assertThat(SettingsReader.defaults(Optional.of(Mode.RAY)).samples()).isEqualTo(4);
  }

  @Test
  void everyKeyHasItsPlace() {
    RenderSettings read =
        read(
            """
            {"width": 640, "height": 480, "threads": 3, "bucketSize": 16, "maxTraceDepth": 7,
             "reflectionTraceDepth": 8, "refractionTraceDepth": 9, "samples": 11, "mode": "path",
             "seed": -9223372036854775808, "exposure": -1.5, "toneMap": "aces",
             "background": "transparent"}
            """);
    assertThat(read)
        .isEqualTo(
            new RenderSettings.Builder()
                .size(640, 480)
                .threads(3)
                .bucketSize(16)
                .maxTraceDepth(7)
                .rayDepths(8, 9)
                .samples(11)
                .mode(Mode.PATH)
                .seed(Long.MIN_VALUE)
                .exposure(Exposure.of(-1.5))
                .toneCurve(ToneCurve.ACES)
                .transparent(true)
                .build());
    assertThat(problems.warnings()).isEmpty();
  }

  @ParameterizedTest
  @CsvSource({
    "-1, 4",
    "0, 1",
    "1, 4",
    "2, 4",
    "3, 16",
    "4, 16",
    "6, 64",
    "7, 256",
    "8, 256",
    "16, 65536"
  })
  void antialiasingIsAnEvenPowerOfTwoInRayModeOnly(int exponent, int samples) {
    JsonNode options = options("{\"samples\": 5, \"antialiasing\": " + exponent + "}");
    assertThat(SettingsReader.read(options, Optional.of(Mode.RAY)).samples()).isEqualTo(samples);
    assertThat(SettingsReader.read(options, Optional.of(Mode.PATH)).samples()).isEqualTo(5);
  }

  @Test
  void theChosenModeWinsOverTheFiles() {
    JsonNode options = options("{\"mode\": \"ray\"}");
    assertThat(SettingsReader.read(options, Optional.empty()).mode()).isEqualTo(Mode.RAY);
    assertThat(SettingsReader.read(options, Optional.of(Mode.PATH)).mode()).isEqualTo(Mode.PATH);
  }

  @Test
  void exposureMayBeAutomatic() {
    assertThat(read("{\"exposure\": \"auto\"}").exposure()).isEqualTo(Exposure.AUTO);
  }

  @Test
  void backgroundIsAColorOrNothing() {
    assertThat(SettingsReader.background(options("{}"))).isEmpty();
    assertThat(SettingsReader.background(options("{\"background\": \"transparent\"}"))).isEmpty();
    assertThat(SettingsReader.background(options("{\"background\": {\"r\": 2, \"g\": 0}}")))
        .contains(new Rgb(2, 0, 1));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "\"width\": 0|$.width: expected an integer from 1 to 65535, found 0",
        "\"height\": 65536|$.height: expected an integer from 1 to 65535, found 65536",
        "\"height\": 8.5|$.height: expected an integer from 1 to 65535, found 8.5",
        "\"samples\": 0|$.samples: expected an integer from 1 to 1073741824, found 0",
        "\"bucketSize\": 0|$.bucketSize: expected an integer >= 1, found 0",
        "\"threads\": 1025|$.threads: expected an integer from 0 to 1024, found 1025",
        "\"antialiasing\": 17|$.antialiasing: expected an integer from -1 to 16, found 17",
        "\"maxTraceDepth\": -1|$.maxTraceDepth: expected an integer from 0 to 1000000, found -1",
        "\"seed\": 0.5|$.seed: expected an integer, found 0.5",
        "\"mode\": \"fast\"|$.mode: expected one of ray, path, found \"fast\"",
        "\"toneMap\": 3|$.toneMap: expected one of srgb, gamma22, reinhard, aces, neutral, agx,"
            + " found 3",
        "\"exposure\": \"Auto\"|$.exposure: expected a finite number or \"auto\", found \"Auto\""
      })
  void wrongSettingsAreErrors(String option, String message) {
    assertThat(read("{" + option + "}")).isEqualTo(RenderSettings.DEFAULT);
    assertThat(problems.exception()).hasMessage("s.json: " + message);
  }

  @Test
  void backgroundOfAnotherTypeIsAnError() {
    SettingsReader.background(options("{\"background\": \"blue\"}"));
    assertThat(problems.exception())
        .hasMessage(
            "s.json: $.background: expected an object such as {\"r\": 1, \"g\": 1, \"b\": 1} or"
                + " \"transparent\", found \"blue\"");
  }

  private Optional<Backplate> backplate(String text) {
    return SettingsReader.backplate(options("{\"backplate\": " + text + "}"));
  }

  @Test
  void backplatesHaveTheShadowOfABox() {
    String corners =
        "{'shadowMin': {'x': -1, 'y': 2, 'z': 3}, 'shadowMax': {'x': 4, 'y': 2, 'z': 6}}";
    Bounds3 box = new Bounds3(new Vec3(-1, 2, 3), new Vec3(4, 2, 6));
    assertThat(backplate(corners.replace('\'', '"')))
        .contains(Backplate.plain(Rgb.WHITE).withShadowOf(box));
    assertThat(problems.hasErrors()).isFalse();
  }

  @Test
  void cornersOfShadowsAreInOrder() {
    backplate("{\"top\": {\"r\": 1}, \"shadowMin\": {\"y\": 2}}");
    assertThat(problems.exception())
        .hasMessage(
            "s.json: $.backplate.shadowMax: expected at least shadowMin on each axis, found less");
  }
}
