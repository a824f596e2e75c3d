package io.github.lumbre.render;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.camera.Lens;
import io.github.lumbre.integrator.SampleLayers;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.Setting;
import java.util.Set;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests what values become in the sums of layers. */
class LayerSumsTest {
  private static final Scene SCENE =
      Scene.builder().seenBy(Lens.pinhole(1).camera(Vec3.ZERO, Frame.WORLD, 1)).build();

  @ParameterizedTest
  @CsvSource({
    "NaN, 0, 0",
    "Infinity, 1, 2147483648",
    "-Infinity, -1, -2147483648",
    "1.5, 1, 1.5",
    "-1e300, -1, -2147483648",
    "1, 1, 1",
    "-1, -1, -1",
    "0.25, 0.25, 0.25",
    "1e-30, 0, 0"
  })
  void valuesAreLimitedToTheirRange(double value, double narrow, double wide) {
    RenderSettings settings =
        new RenderSettings.Builder()
            .size(1, 1)
            .set(Setting.LAYERS, Set.of(Layer.ALBEDO, Layer.DEPTH))
            .build();
    LayerSums sums = new LayerSums(FilmLayers.of(settings, SCENE), 1);
    SampleLayers sample = new SampleLayers(sums.layers().stored(), SCENE);
    sample.of(Layer.ALBEDO)[1] = value;
    sample.of(Layer.DEPTH)[0] = value;
    sums.add(0, sample, 0);
    assertThat(sums.sum(Layer.ALBEDO, 1, 0)).isEqualTo(narrow);
    assertThat(sums.sum(Layer.ALBEDO, 0, 0)).isZero();
    assertThat(sums.sum(Layer.DEPTH, 0, 0)).isEqualTo(wide);
  }
}
