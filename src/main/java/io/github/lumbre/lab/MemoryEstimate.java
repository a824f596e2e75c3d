package io.github.lumbre.lab;

import io.github.lumbre.lab.TaskException.Kind;
import io.github.lumbre.scene.RenderSettings;
import java.util.List;
import java.util.Locale;

/**
 * What a render will take of the heap, known before it begins.
 *
 * @param settings of the render
 * @param sceneBytes what the scene and the program take already
 * @param maxHeapBytes what the heap may grow to
 */
public record MemoryEstimate(RenderSettings settings, long sceneBytes, long maxHeapBytes) {
  /** The film takes at most 64 bytes a pixel, and the picture made from it 16. */
  private static final int BYTES_PER_PIXEL = 80;

  /** What a copy of the film takes, beside the film but not beside the picture. */
  private static final int BYTES_PER_COPIED_PIXEL = 64;

  /** What tells which pixels are to get more samples. */
  private static final int BYTES_PER_ADAPTIVE_PIXEL = 10;

  /** What a thread keeps, and the part of the heap that is set aside for it alone. */
  private static final long BYTES_PER_THREAD = 64 << 10;

  /** For the picture's encoding and the rest of the program. */
  private static final long MARGIN_BYTES = 8 << 20;

  /**
   * Passes if a scene that has just been read can be rendered on this heap.
   *
   * @throws TaskException telling what is needed and what there is
   */
  public static void require(RenderSettings settings) throws TaskException {
    long maxHeapBytes = Runtime.getRuntime().maxMemory();
    if (!new MemoryEstimate(settings, usedBytes(), maxHeapBytes).fits()) {
      // Much of what is in use may be what reading the scene has left behind.
      measured(settings).require();
    }
  }

  /**
   * Tells whether a scene that has just been read can be rendered on this heap with a second film,
   * so that one can be saved while the other grows.
   */
  public static boolean leavesRoomForCopy(RenderSettings settings) {
    long maxHeapBytes = Runtime.getRuntime().maxMemory();
    return new MemoryEstimate(settings, usedBytes(), maxHeapBytes).fitsWithCopy()
        || measured(settings).fitsWithCopy();
  }

  /** Returns the estimate of a scene that has just been read, for this heap. Takes a moment. */
  public static MemoryEstimate measured(RenderSettings settings) {
    Runtime runtime = Runtime.getRuntime();
    runtime.gc();
    return new MemoryEstimate(settings, usedBytes(), runtime.maxMemory());
  }

  private static long usedBytes() {
    return Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory();
  }

  /** Returns the number of pixels that will be rendered. */
  public long pixels() {
    RenderSettings.Crop window = settings.window();
    return (long) window.width() * window.height();
  }

  /** Returns the number of threads that will render. */
  public int threads() {
    return settings.threads() == 0
        ? Runtime.getRuntime().availableProcessors()
        : settings.threads();
  }

  /** Returns what the sums of the samples and the picture made of them take. */
  public long filmBytes() {
    int more = settings.adaptive() ? BYTES_PER_ADAPTIVE_PIXEL : 0;
    return (BYTES_PER_PIXEL + more) * pixels();
  }

  /** Returns what a second film takes, which checkpoints are saved from if there is room for it. */
  public long copyBytes() {
    return BYTES_PER_COPIED_PIXEL * pixels();
  }

  public long threadBytes() {
    return BYTES_PER_THREAD * threads();
  }

  /** Returns what all will take together. */
  public long neededBytes() {
    return sceneBytes + filmBytes() + threadBytes() + MARGIN_BYTES;
  }

  /** Tells whether the heap is large enough. */
  public boolean fits() {
    return neededBytes() <= maxHeapBytes;
  }

  /** Tells whether the heap is large enough for a second film too. */
  boolean fitsWithCopy() {
    return neededBytes() + copyBytes() <= maxHeapBytes;
  }

  /**
   * Passes if the heap is large enough.
   *
   * @throws TaskException telling what is needed and what there is
   */
  public void require() throws TaskException {
    if (!fits()) {
      RenderSettings.Crop window = settings.window();
      throw new TaskException(
          Kind.LIMIT,
          String.format(
              Locale.ROOT,
              "%dx%d pixels need %s of memory beside %s of the scene, but the heap is limited to %s"
                  + " (LUMBRE_JAVA_OPTS=-Xmx8g raises that)",
              window.width(),
              window.height(),
              mebibytes(neededBytes() - sceneBytes),
              mebibytes(sceneBytes),
              mebibytes(maxHeapBytes)));
    }
  }

  /** Returns all figures, a line each. */
  public List<String> lines() {
    RenderSettings.Crop window = settings.window();
    long perPixel = settings.samples();
    return List.of(
        "pixels   " + pixels() + ": " + window.width() + "x" + window.height(),
        "samples  " + perPixel * pixels() + ": " + perPixel + " per pixel",
        "film     " + mebibytes(filmBytes()),
        "scene    " + mebibytes(sceneBytes),
        "threads  " + mebibytes(threadBytes()) + ": " + threads(),
        "needed   " + mebibytes(neededBytes()),
        "copy     " + mebibytes(copyBytes()) + " more for checkpoints, if there is room",
        "heap     " + mebibytes(maxHeapBytes));
  }

  /** Returns a number of bytes for people: {@code 512 MiB}. */
  public static String mebibytes(long bytes) {
    return (bytes + (1 << 20) - 1 >> 20) + " MiB";
  }
}
