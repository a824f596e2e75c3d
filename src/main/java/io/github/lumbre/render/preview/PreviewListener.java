package io.github.lumbre.render.preview;

import io.github.lumbre.scene.Layer;
import java.util.Set;

/**
 * Receives pictures of a running render. The rendering thread calls all methods, between passes or
 * while a pass is paused.
 */
@FunctionalInterface
public interface PreviewListener {
  /**
   * Receives a picture. The render waits until this method returns, so it should pass the picture
   * to another thread if it has more to do with it than to keep it.
   */
  void show(Preview preview);

  /**
   * Returns whether anybody is watching. If not, the render develops no picture and is not paused.
   * Several threads call this, many times per second.
   */
  default boolean isWatching() {
    return true;
  }

  /**
   * Returns whether a preview is needed now, for example because another layer was selected. It
   * does not wait until it is due, but later ones wait longer.
   */
  default boolean isUrgent() {
    return false;
  }

  /** Returns the layers to develop; those that the render does not record are left out. */
  default Set<Layer> layers() {
    return Set.of();
  }

  /** Returns whether to estimate the picture's error at the end of passes. */
  default boolean wantsNoise() {
    return false;
  }

  /**
   * Returns the time, in seconds, that earlier previews have cost outside of {@link #show} since
   * the last call, for example to send them. Previews become rarer if it is large.
   */
  default double secondsElsewhere() {
    return 0;
  }
}
