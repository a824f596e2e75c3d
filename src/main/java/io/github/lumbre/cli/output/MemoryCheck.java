package io.github.lumbre.cli.output;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.render.FilmLayers;
import io.github.lumbre.render.MemoryEstimate;
import io.github.lumbre.scene.RenderSettings;

/** Refuses renders that do not fit into the heap. Stateless. */
public final class MemoryCheck {
  private static final long MEBIBYTE = 1 << 20;

  /** Heap sizes below one gibibyte are multiples of this. */
  private static final long STEP_MEBIBYTES = 64;

  private MemoryCheck() {}

  /**
   * Requires that a scene that has just been read can be rendered on this heap.
   *
   * @throws TaskException that states the needed and the available memory, if it cannot
   */
  public static void require(RenderSettings settings, FilmLayers layers) throws TaskException {
    require(MemoryEstimate.of(settings, layers));
  }

  /**
   * Requires that the heap is large enough.
   *
   * @throws TaskException that states the needed and the available memory, if it is not
   */
  public static void require(MemoryEstimate estimate) throws TaskException {
    if (estimate.refusal().isPresent()) {
      throw ExitCode.LIMIT.failure(
          estimate.refusal().get() + "; " + advice(estimate.neededBytes()));
    }
  }

  /**
   * Returns how to raise the maximum heap size: {@code raise it with LUMBRE_JAVA_OPTS=-Xmx8g}.
   *
   * @param neededBytes what the heap has to hold; the advice is at least an eighth larger, because
   *     some garbage collectors keep a part of the heap empty
   */
  public static String advice(long neededBytes) {
    long mebibytes = (neededBytes + neededBytes / 8) / MEBIBYTE + 1;
    long steps = (mebibytes + STEP_MEBIBYTES - 1) / STEP_MEBIBYTES;
    String size =
        mebibytes < 1024 - STEP_MEBIBYTES
            ? steps * STEP_MEBIBYTES + "m"
            : (mebibytes + 1023) / 1024 + "g";
    return "raise it with LUMBRE_JAVA_OPTS=-Xmx" + size;
  }
}
