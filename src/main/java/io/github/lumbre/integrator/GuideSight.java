package io.github.lumbre.integrator;

import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.integrator.guiding.Sight;
import io.github.lumbre.scene.Scene;
import java.util.Objects;

/**
 * Tests by shadow rays whether points of surfaces see each other, for the training of a guide.
 * Glass and other surfaces that transmit light count as opaque. Mutable and confined to one thread.
 */
public final class GuideSight implements Sight {
  /** The part of the way that is left out at both ends: the points are rounded. */
  private static final double MARGIN = 1e-4;

  private final Scene scene;
  private final NearestHit ray = new NearestHit();

  public GuideSight(Scene scene) {
    this.scene = Objects.requireNonNull(scene, "scene");
  }

  @Override
  public boolean isClear(double x, double y, double z, double dx, double dy, double dz) {
    ray.aim(x + MARGIN * dx, y + MARGIN * dy, z + MARGIN * dz, dx, dy, dz, 1 - 2 * MARGIN);
    return !scene.isOccluded(ray);
  }
}
