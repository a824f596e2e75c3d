package io.github.lumbre.render;

import io.github.lumbre.scene.RenderSettings;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * An estimate of the heap that a render needs, made before it starts.
 *
 * @param settings settings of the render
 * @param layers the layers that the film records besides the picture
 * @param sceneBytes bytes in use by the scene and the program
 * @param maxHeapBytes maximum heap size in bytes
 */
public record MemoryEstimate(
    RenderSettings settings, FilmLayers layers, long sceneBytes, long maxHeapBytes) {
  /** At most 64 bytes per pixel for the film, and 16 bytes per pixel for the developed picture. */
  private static final int BYTES_PER_PIXEL = 80;

  /**
   * Bytes per pixel of a copy of the film; the copy is released before the picture is developed.
   */
  private static final int BYTES_PER_COPIED_PIXEL = 64;

  /** Bytes per pixel for the distribution of adaptive samples. */
  private static final int BYTES_PER_ADAPTIVE_PIXEL = 10;

  /** Bytes per thread: its render context and its thread-local allocation buffer. */
  private static final long BYTES_PER_THREAD = 64 << 10;

  /** For the picture's encoding and the rest of the program. */
  private static final long MARGIN_BYTES = 8 << 20;

  /**
   * Returns the estimate for a scene that has just been read. Runs a full garbage collection only
   * if the render does not fit beside the memory in use, much of which may be garbage.
   */
  public static MemoryEstimate of(RenderSettings settings, FilmLayers layers) {
    MemoryEstimate quick = now(settings, layers);
    return quick.fits() ? quick : measured(settings, layers);
  }

  private static MemoryEstimate now(RenderSettings settings, FilmLayers layers) {
    return new MemoryEstimate(settings, layers, usedBytes(), Runtime.getRuntime().maxMemory());
  }

  /**
   * Returns whether this heap can hold a second film for a scene that has just been read. One film
   * can then be saved while the other receives samples.
   */
  public static boolean leavesRoomForCopy(RenderSettings settings, FilmLayers layers) {
    return now(settings, layers).fitsWithCopy() || measured(settings, layers).fitsWithCopy();
  }

  /** Returns the estimate for a scene that has just been read. Runs a full garbage collection. */
  public static MemoryEstimate measured(RenderSettings settings, FilmLayers layers) {
    Runtime.getRuntime().gc();
    return now(settings, layers);
  }

  private static long usedBytes() {
    return Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory();
  }

  /** Returns the number of pixels that will be rendered. */
  public long pixels() {
    return settings.window().pixels();
  }

  /** Returns the number of threads that will render. */
  public int threads() {
    return settings.threads() == 0
        ? Runtime.getRuntime().availableProcessors()
        : settings.threads();
  }

  /** Returns the bytes of the film and of the developed picture. */
  public long filmBytes() {
    int more = settings.adaptive() ? BYTES_PER_ADAPTIVE_PIXEL : 0;
    return (BYTES_PER_PIXEL + more) * pixels() + layerBytes();
  }

  /** Returns the bytes of the film's layers, without the bytes of the written file. */
  public long layerBytes() {
    return layers.bytesPerPixel() * pixels();
  }

  /** Returns the bytes of a second film; checkpoints are saved from it if it fits. */
  public long copyBytes() {
    return BYTES_PER_COPIED_PIXEL * pixels() + layerBytes();
  }

  /** Returns the bytes that the threads need for their own work. */
  public long threadBytes() {
    return BYTES_PER_THREAD * threads();
  }

  /** Returns the bytes of the pilot render of guiding and of its guide; 0 without guiding. */
  public long guideBytes() {
    return settings.guiding() == RenderSettings.Guiding.OFF ? 0 : GuidePilot.mostBytes(settings);
  }

  /** Returns the total number of bytes needed. */
  public long neededBytes() {
    return sceneBytes + filmBytes() + threadBytes() + guideBytes() + MARGIN_BYTES;
  }

  /** Returns whether the heap is large enough. */
  public boolean fits() {
    return neededBytes() <= maxHeapBytes;
  }

  /** Returns whether the heap is large enough for a second film. */
  boolean fitsWithCopy() {
    return neededBytes() + copyBytes() <= maxHeapBytes;
  }

  /** Returns a message that states the needed and the available memory, if it is too small. */
  public Optional<String> refusal() {
    RenderSettings.Crop window = settings.window();
    return fits()
        ? Optional.empty()
        : Optional.of(
            String.format(
                Locale.ROOT,
                "%dx%d pixels need %s of memory in addition to the scene's %s, but the maximum heap"
                    + " size is %s",
                window.width(),
                window.height(),
                mebibytes(neededBytes() - sceneBytes),
                mebibytes(sceneBytes),
                mebibytes(maxHeapBytes)));
  }

  /** Returns all numbers, one per line. */
  public List<String> lines() {
    RenderSettings.Crop window = settings.window();
    long perPixel = settings.samples();
    List<String> lines = new ArrayList<>();
    lines.add("pixels   " + pixels() + ": " + window.width() + "x" + window.height());
    lines.add("samples  " + perPixel * pixels() + ": " + perPixel + " per pixel");
    lines.add("film     " + mebibytes(filmBytes()));
    if (!layers.isEmpty()) {
      int each = layers.bytesPerPixel();
      lines.add(
          "layers   " + mebibytes(layerBytes()) + " of the film: " + each + " bytes per pixel");
    }
    lines.add("scene    " + mebibytes(sceneBytes));
    lines.add("threads  " + mebibytes(threadBytes()) + ": " + threads());
    lines.add("needed   " + mebibytes(neededBytes()));
    lines.add("copy     " + mebibytes(copyBytes()) + " more for checkpoints, if it fits");
    lines.add("heap     " + mebibytes(maxHeapBytes));
    return lines;
  }

  /** Returns a number of bytes in mebibytes, rounded up: {@code 512 MiB}. */
  public static String mebibytes(long bytes) {
    return (bytes + (1 << 20) - 1 >> 20) + " MiB";
  }
}
