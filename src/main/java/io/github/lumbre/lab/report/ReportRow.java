package io.github.lumbre.lab.report;

import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Mode;
import io.github.lumbre.scene.RenderSettings.Size;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.OptionalInt;

/**
 * A row of the report's table: the render, its hardware and its time.
 *
 * @param number row number in the table
 * @param scene name of the project's scene file for the row, without its extension
 * @param samples samples per pixel
 * @param depth path depth, or the reflection and refraction depth in ray mode; empty for the
 *     scene's
 * @param note note on a peculiarity of the row in the report; may be empty
 */
public record ReportRow(
    int number,
    String name,
    String scene,
    Size size,
    Mode mode,
    int samples,
    int bucket,
    OptionalInt depth,
    int reportThreads,
    String reportHardware,
    String reportTime,
    String note) {
  /**
   * @throws IllegalArgumentException if a setting is out of its range
   */
  public ReportRow {
    settings(RenderSettings.DEFAULT, size, mode, samples, bucket, depth);
  }

  /**
   * Returns a share of the row's samples, rounded up, so at least 1.
   *
   * @param share in (0,1]
   */
  int samplesAt(BigDecimal share) {
    return share.multiply(BigDecimal.valueOf(samples)).setScale(0, RoundingMode.CEILING).intValue();
  }

  /** Returns the time for all samples, extrapolated from the time of some of them. */
  double extrapolated(double seconds, int rendered) {
    return seconds * samples / rendered;
  }

  /** Returns a scene's settings, overridden by the row's settings. */
  RenderSettings over(RenderSettings inScene) {
    return settings(inScene, size, mode, samples, bucket, depth);
  }

  private static RenderSettings settings(
      RenderSettings inScene, Size size, Mode mode, int samples, int bucket, OptionalInt depth) {
    RenderSettings.Builder builder =
        inScene.toBuilder()
            .size(size.width(), size.height())
            .mode(mode)
            .samples(samples)
            .bucketSize(bucket);
    depth.ifPresent(
        n -> {
          if (mode == Mode.PATH) {
            builder.maxTraceDepth(n);
          } else {
            builder.rayDepths(n, n);
          }
        });
    return builder.build();
  }
}
