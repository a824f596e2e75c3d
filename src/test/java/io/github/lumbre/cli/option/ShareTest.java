package io.github.lumbre.cli.option;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Map;
import org.junit.jupiter.api.Test;

/** Shares of a job array. */
class ShareTest {
  @Test
  void sharesFollowOnEachOtherAndTogetherAreAll() {
    for (int count = 1; count <= 40; count++) {
      for (int samples = count; samples < 200; samples += 7) {
        int end = 0;
        for (int i = 0; i < count; i++) {
          Share share = new Share(i, count);
          assertThat(share.first(samples, "sample")).isEqualTo(end);
          end = share.end(samples);
          assertThat(end - share.first(samples, "sample"))
              .isBetween(samples / count, samples / count + 1);
        }
        assertThat(end).isEqualTo(samples);
      }
    }
    assertThat(new Share(1023, 1024).end(1 << 30)).isEqualTo(1 << 30);
  }

  @Test
  void textsNameShares() {
    assertThat(Share.parse("3/8", Map.of())).isEqualTo(new Share(3, 8));
    assertFails("8/8", Map.of(), "expected a share from 0 to 7, found 8");
    assertFails("-1/8", Map.of(), "expected a share from 0 to 7, found -1");
    assertFails("0/0", Map.of(), "expected 1 to 1048576 shares, found 0");
    assertFails("half", Map.of(), "expected I/N, such as 0/8, or auto, found half");
    assertFails("a/8", Map.of(), "I/N: expected an integer, found a");
    assertThatThrownBy(() -> new Share(0, 9).first(8, "sample"))
        .hasMessage("expected at least one sample for each share, found 8 samples and 9 shares");
  }

  @Test
  void jobArraysNameTheirShares() {
    Map<String, String> slurm =
        Map.of(
            "SLURM_ARRAY_TASK_ID", "14",
            "SLURM_ARRAY_TASK_MIN", "10",
            "SLURM_ARRAY_TASK_STEP", "2",
            "SLURM_ARRAY_TASK_COUNT", "6");
    assertThat(Share.parse("auto", slurm)).isEqualTo(new Share(2, 6));
    Map<String, String> batch =
        Map.of("AWS_BATCH_JOB_ARRAY_INDEX", "7", "AWS_BATCH_JOB_ARRAY_SIZE", "9");
    assertThat(Share.parse("auto", batch)).isEqualTo(new Share(7, 9));
    Map<String, String> kubernetes = Map.of("JOB_COMPLETION_INDEX", "4", Share.COUNT, "5");
    assertThat(Share.parse("auto", kubernetes)).isEqualTo(new Share(4, 5));
    assertFails(
        "auto",
        Map.of("JOB_COMPLETION_INDEX", "4"),
        "auto: expected the variable LUMBRE_SHARES, found none");
    assertFails(
        "auto",
        Map.of("JOB_COMPLETION_INDEX", "x", Share.COUNT, "5"),
        "auto: JOB_COMPLETION_INDEX: expected an integer, found x");
    assertThatThrownBy(() -> Share.parse("auto", Map.of()))
        .hasMessageContaining("give the share as I/N");
  }

  private static void assertFails(String text, Map<String, String> environment, String message) {
    assertThatThrownBy(() -> Share.parse(text, environment))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage(message);
  }
}
