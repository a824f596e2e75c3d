package io.github.lumbre.image.animation;

import io.github.lumbre.base.file.OutputFile;
import java.io.IOException;
import java.util.Map;

/** Writes animations of one format. */
@FunctionalInterface
public interface AnimationWriter {
  /**
   * Checks that this writer can write frames of a size; to be called before they are rendered.
   *
   * @throws IllegalArgumentException if it cannot; the message states what to choose instead
   */
  default void requireFits(int width, int height) {
    AnimationFormat.requireFits("an animation", AnimationFormat.MAX_SIDE, width, height);
  }

  /**
   * Writes an animation to a reserved file and commits it. If it fails, the file stays reserved,
   * and the frames stay as they are.
   *
   * @param texts metadata by keyword, as in {@link
   *     io.github.lumbre.image.ImageWriter.Options#metadata}; only APNG keeps them
   * @throws IllegalArgumentException if {@link AnimationFormat#requireFits} refuses the frames
   * @throws IOException if a frame cannot be read, the file cannot be written, or the installed
   *     program fails or takes too long
   * @throws InterruptedException if the thread is interrupted
   */
  void write(AnimationFrames frames, Map<String, String> texts, OutputFile output)
      throws IOException, InterruptedException;
}
