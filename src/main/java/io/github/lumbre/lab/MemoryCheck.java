package io.github.lumbre.lab;

import io.github.lumbre.lab.TaskException.Kind;
import io.github.lumbre.render.FilmLayers;
import io.github.lumbre.render.MemoryEstimate;
import io.github.lumbre.scene.RenderSettings;

/** Refuses renders that do not fit into the heap. Stateless. */
public final class MemoryCheck {
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
      throw new TaskException(
          Kind.LIMIT, estimate.refusal().get() + "; raise it with LUMBRE_JAVA_OPTS=-Xmx8g");
    }
  }
}
