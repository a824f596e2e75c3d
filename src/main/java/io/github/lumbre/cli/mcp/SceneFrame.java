package io.github.lumbre.cli.mcp;

import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Setting;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The size of a picture of a scene that has settings of its own: what a client states counts first,
 * then what the scene states, and the bounds of the tools count always. Mutable; used for one
 * scene.
 */
final class SceneFrame {
  private final Optional<Integer> width;
  private final Optional<Integer> height;
  private final Optional<Integer> samples;
  private final int mostPixels;
  private final int mostSamples;
  private final List<String> notes = new ArrayList<>();

  /**
   * @param width in pixels; empty for the scene's, or the one that keeps its aspect ratio
   * @param height in pixels, as the width
   * @param samples per pixel; empty for the scene's
   * @param mostPixels of a side
   * @param mostSamples per pixel
   */
  SceneFrame(
      Optional<Integer> width,
      Optional<Integer> height,
      Optional<Integer> samples,
      int mostPixels,
      int mostSamples) {
    this.width = width;
    this.height = height;
    this.samples = samples;
    this.mostPixels = mostPixels;
    this.mostSamples = mostSamples;
  }

  /** Returns the settings of a scene within the bounds: of its whole frame, by all processors. */
  RenderSettings within(RenderSettings own) {
    notes.clear();
    double aspect = own.aspect();
    double scale = Math.min(1, (double) mostPixels / Math.max(own.width(), own.height()));
    int wide =
        width.orElseGet(() -> side(height.map(h -> h * aspect).orElse(scale * own.width())));
    int high =
        height.orElseGet(() -> side(width.map(w -> w / aspect).orElse(scale * own.height())));
    if (scale < 1 && width.isEmpty() && height.isEmpty()) {
      notes.add(
          "size: %dx%d, not %dx%d as the scene states: a side has at most %d pixels here"
              .formatted(wide, high, own.width(), own.height(), mostPixels));
    }
    int count = samples.orElse(Math.min(own.samples(), mostSamples));
    if (samples.isEmpty() && own.samples() > mostSamples) {
      notes.add(
          "samples: %d per pixel, not %d as the scene states: the most here"
              .formatted(count, own.samples()));
    }
    int mostPoses = Integer.highestOneBit(mostSamples); // Each one has equally many samples.
    if (own.poses() > mostPoses) {
      notes.add(
          "poses: %d, not %d as the scene states: the most here"
              .formatted(mostPoses, own.poses()));
    }
    return own.toBuilder()
        .size(wide, high)
        .samples(count)
        .set(Setting.POSES, Math.min(own.get(Setting.POSES), mostPoses))
        .threads(RenderSettings.DEFAULT.threads())
        .build();
  }

  private int side(double exact) {
    return (int) Math.min(mostPixels, Math.max(1, Math.round(exact)));
  }

  /** Returns what of the last scene's settings does not count. */
  List<String> notes() {
    return List.copyOf(notes);
  }
}
