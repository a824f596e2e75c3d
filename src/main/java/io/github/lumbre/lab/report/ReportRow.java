package io.github.lumbre.lab.report;

import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Mode;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.OptionalInt;

/**
 * A row of the report's table: what was rendered, on which hardware, and how long that took.
 *
 * @param number in the table
 * @param scene name of the project's own scene file for it, without ending
 * @param samples per pixel
 * @param depth of paths, or of mirrors and of glass in ray mode; empty means as the scene says
 * @param note what is odd about the row in the report, or nothing
 */
public record ReportRow(
    int number,
    String name,
    String scene,
    int width,
    int height,
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
    settings(RenderSettings.DEFAULT, width, height, mode, samples, bucket, depth);
  }

  /** Returns {@code 1280x720}. */
  String size() {
    return width + "x" + height;
  }

  /**
   * Returns how many samples a share of the row's is: rounded up, and so at least 1.
   *
   * @param share in (0,1]
   */
  int samplesAt(BigDecimal share) {
    return share.multiply(BigDecimal.valueOf(samples)).setScale(0, RoundingMode.CEILING).intValue();
  }

  /** Returns the time for all samples if some of them took so many seconds. */
  double extrapolated(double seconds, int rendered) {
    return seconds * samples / rendered;
  }

  /** Returns a scene's settings, but with everything that the row prescribes. */
  RenderSettings over(RenderSettings inScene) {
    return settings(inScene, width, height, mode, samples, bucket, depth);
  }

  private static RenderSettings settings(
      RenderSettings inScene,
      int width,
      int height,
      Mode mode,
      int samples,
      int bucket,
      OptionalInt depth) {
    RenderSettings.Builder builder =
        inScene.toBuilder().size(width, height).mode(mode).samples(samples).bucketSize(bucket);
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
