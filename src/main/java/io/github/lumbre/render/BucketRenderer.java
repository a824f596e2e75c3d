package io.github.lumbre.render;

import io.github.lumbre.image.Image;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.util.Objects;

/**
 * Renders scenes: divides the film into buckets, which threads take from a queue. Immutable and
 * reusable; the number of threads, the size of the buckets and the order of work do not change a
 * bit of the picture.
 */
public final class BucketRenderer {
  private final RenderSettings settings;

  public BucketRenderer(RenderSettings settings) {
    this.settings = Objects.requireNonNull(settings, "settings");
  }

  /** Renders without anybody listening. */
  public Image render(Scene scene) throws InterruptedException {
    return render(scene, Progress.NONE).image();
  }

  /**
   * Renders.
   *
   * @throws InterruptedException if the calling thread is interrupted; all workers have ended then
   * @throws RenderException if a worker failed
   */
  public RenderResult render(Scene scene, Progress progress) throws InterruptedException {
    throw new UnsupportedOperationException();
  }
}
