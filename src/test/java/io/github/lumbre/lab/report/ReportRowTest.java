package io.github.lumbre.lab.report;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Mode;
import java.math.BigDecimal;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the settings and the extrapolated times of report rows. */
class ReportRowTest {
  @ParameterizedTest
  @CsvSource({
    "1000,  0.01,   10",
    "250,   0.01,   3",
    "4,     0.01,   1",
    "4,     1e-9,   1",
    "100,   0.07,   7",
    "1000,  0.0011, 2",
    "40000, 1,      40000",
    "3,     0.34,   2"
  })
  void shareOfTheSamplesIsRoundedUp(int samples, BigDecimal share, int rendered) {
    assertThat(BenchmarkFixture.row(samples).samplesAt(share)).isEqualTo(rendered);
  }

  @Test
  void timeIsExtrapolatedInProportion() {
    ReportRow row = BenchmarkFixture.row(250);
    assertThat(row.extrapolated(6, 3)).isEqualTo(500);
    assertThat(row.extrapolated(6, 250)).isEqualTo(6);
  }

  @Test
  void whatTheRowPrescribesWinsOverTheScene() {
    RenderSettings inScene =
        new RenderSettings.Builder().mode(Mode.PATH).rayDepths(1, 3).seed(7).samples(9).build();
    RenderSettings path = BenchmarkFixture.row(250).over(inScene);
    assertThat(path.samples()).isEqualTo(250);
    assertThat(path.width()).isEqualTo(8);
    assertThat(path.height()).isEqualTo(4);
    assertThat(path.maxTraceDepth()).isEqualTo(5);
    assertThat(path.seed()).isEqualTo(7);
    RenderSettings ray = BenchmarkFixture.rayRow("").over(inScene);
    assertThat(ray.mode()).isEqualTo(Mode.RAY);
    assertThat(ray.bucketSize()).isEqualTo(30);
    assertThat(ray.reflectionTraceDepth()).isEqualTo(1);
    assertThat(ray.refractionTraceDepth()).isEqualTo(3);
  }

  @Test
  void settingsOutOfRangeAreRefused() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> BenchmarkFixture.row(0))
        .withMessageContaining("samples");
  }
}
