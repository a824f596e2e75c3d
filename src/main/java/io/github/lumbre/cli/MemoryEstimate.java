package io.github.lumbre.cli;

import io.github.lumbre.scene.RenderSettings;
import java.util.Locale;

/** Whether a picture fits into memory, asked before the work and not after it. */
final class MemoryEstimate {
  /** The film takes at most 56 bytes a pixel, and the picture made from it 16. */
  private static final int BYTES_PER_PIXEL = 72;

  /** For threads, the picture's encoding and the rest of the program. */
  private static final long MARGIN_BYTES = 16 << 20;

  private MemoryEstimate() {}

  /**
   * Passes if a render fits into a heap of so many bytes.
   *
   * @throws CommandException telling what is needed and what there is
   */
  static void require(RenderSettings settings, long maxHeapBytes) throws CommandException {
    RenderSettings.Crop window = settings.window();
    long pixels = (long) window.width() * window.height();
    long needed = BYTES_PER_PIXEL * pixels + MARGIN_BYTES;
    if (needed > maxHeapBytes) {
      throw new CommandException(
          ExitCodes.LIMIT,
          String.format(
              Locale.ROOT,
              "%dx%d pixels need %s of memory, but the heap is limited to %s"
                  + " (LUMBRE_JAVA_OPTS=-Xmx8g raises that)",
              window.width(),
              window.height(),
              mebibytes(needed),
              mebibytes(maxHeapBytes)));
    }
  }

  /** Returns a number of bytes for people: {@code 512 MiB}. */
  static String mebibytes(long bytes) {
    return (bytes + (1 << 20) - 1 >> 20) + " MiB";
  }
}
