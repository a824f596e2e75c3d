package io.github.lumbre.cli.view;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonParser;
import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.ToneCurve;
import io.github.lumbre.scene.RenderSettings;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What the page is told. */
class StateJsonTest {
  private static final RenderSettings SETTINGS =
      RenderSettings.DEFAULT.toBuilder().size(20, 10).samples(4000).build();

  private static String estimatedAt(List<ErrorPoint> errors, long samples) {
    Snapshot state =
        new Snapshot(
            1,
            "scene.json",
            Optional.empty(),
            "rendering",
            Optional.of(SETTINGS),
            List.of(),
            samples,
            100,
            50,
            OptionalDouble.empty(),
            errors,
            List.of(),
            false);
    String json =
        StateJson.of(
            state,
            new StateJson.Look(Exposure.NONE, ToneCurve.SRGB, false),
            new StateJson.Other("", false));
    return JsonParser.parseString(json)
        .getAsJsonObject()
        .getAsJsonObject("render")
        .get("estimatedAt")
        .getAsString();
  }

  /** 200 pixels; the estimates are of 1 and 4 samples per pixel. */
  @ParameterizedTest
  @CsvSource({"800, ''", "801, at 4 samples", "200000, at 4 samples"})
  void errorOfFewerSamplesThanThePictureHasIsLabeled(long samples, String label) {
    List<ErrorPoint> errors =
        List.of(new ErrorPoint(.1, 1, .99, 1.2, true), new ErrorPoint(1, 4, .86, 1, false));
    assertThat(estimatedAt(errors, samples)).isEqualTo(label);
  }

  @Test
  void noEstimateNeedsNoLabel() {
    assertThat(estimatedAt(List.of(), 300)).isEmpty();
  }
}
