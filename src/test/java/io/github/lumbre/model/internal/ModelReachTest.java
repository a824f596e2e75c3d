package io.github.lumbre.model.internal;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.ModelOptions.Up;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests which sizes of models can be computed with. */
class ModelReachTest {
  private static ModelFixture triangle(String size, double unit) {
    String obj = "v 0 0 0\nv S 0 0\nv 0 S 0\nf 1 2 3\n".replace("S", size);
    ModelOptions options = new ModelOptions(Optional.empty(), Optional.empty(), Up.Z, unit);
    return new ModelFixture("a.obj", obj.getBytes(StandardCharsets.US_ASCII)).with(options);
  }

  @ParameterizedTest
  @CsvSource({"1, 1e-99", "1e-99, 1", "1, 1e99", "1e99, 1", "1e90, 1e-90", "1e-90, 1e90"})
  void sizesWithinTheBoundsAreRead(String size, double unit) throws ModelFormatException {
    assertThat(triangle(size, unit).read().parts()).hasSize(1);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "1e-101 | 1 | expected a model of at least 1e-100 in size, found 1",
        "1e-2 | 1e-99 | expected a model of at least 1e-100 in size, found 1",
        "1e-60 | 1e-60 | expected a model of at least 1e-100 in size, found 1",
        "1.1e100 | 1 | expected a part within 1e100 of the origin",
        "1e60 | 1e60 | expected a part within 1e100 of the origin",
        "1e-160 | 1 | expected a model of at least 1e-100 in size, found 1",
        "1e-310 | 1e-10 | expected a model of at least 1e-100 in size, found 1",
        "1e150 | 1e-10 | expected a part within 1e100 of the origin"
      })
  void otherSizesAreRefused(String size, double unit, String message) {
    assertThat(triangle(size, unit).refusal()).startsWith("MALFORMED ").contains(message);
  }

  /** The section is computed only if the model can be. */
  @ParameterizedTest
  @CsvSource({"1e-320, 1", "1e-60, 1e-100", "1e150, 1", "1e60, 1e60"})
  void sectionsOfSuchModelsAreRefused(String size, double unit) {
    ModelOptions options = new ModelOptions(Optional.empty(), Optional.empty(), Up.Y, unit);
    ModelOptions cut = options.with(ModelOption.SECTION, List.of("x=0"));
    assertThat(triangle(size, unit).with(cut).refusal())
        .startsWith("MALFORMED ")
        .containsPattern("expected (a part within 1e100|a model of at)");
  }
}
