package io.github.lumbre.cli.output;

import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.Plane;
import io.github.lumbre.image.Image;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Ray;
import io.github.lumbre.sampling.IndependentSampler;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.util.Arrays;
import java.util.Optional;
import java.util.OptionalDouble;

/** What the camera sees of a scene's objects, by one ray through the center of each pixel. */
final class Visible {
  /** The largest number of pixels whose luminance is read. */
  private static final int MAX_READ = 1 << 16;

  private final Scene scene;
  private final RenderSettings settings;
  private final IndependentSampler sampler = new IndependentSampler(0);
  private final NearestHit hit = new NearestHit();

  Visible(Scene scene, RenderSettings settings) {
    this.scene = scene;
    this.settings = settings;
  }

  /** Returns whether the scene has objects, and no ray hits one. */
  boolean isNothing() {
    if (scene.primitives().isEmpty()) {
      return false;
    }
    RenderSettings.Crop window = settings.window();
    for (int y = 0; y < window.height(); y++) {
      for (int x = 0; x < window.width(); x++) {
        if (isCovered(x, y)) {
          return false;
        }
      }
    }
    return true;
  }

  /**
   * Returns the median luminance of the pixels that objects other than infinite planes cover,
   * before exposure; empty if there are none.
   *
   * @param image of the settings' window
   */
  OptionalDouble medianLuminance(Image image) {
    return median(image, true);
  }

  /** Returns the same if there are pixels that no such object covers; empty otherwise. */
  OptionalDouble medianOfSome(Image image) {
    return median(image, false);
  }

  private OptionalDouble median(Image image, boolean mayBeAll) {
    int step = 1;
    while ((long) (image.width() / step) * (image.height() / step) > MAX_READ) {
      step++;
    }
    double[] found = new double[MAX_READ];
    int count = 0;
    int others = 0;
    for (int y = step / 2; y < image.height(); y += step) {
      for (int x = step / 2; x < image.width() && count < MAX_READ; x += step) {
        if (isCovered(x, y) && !(scene.primitiveAt(hit).shape() instanceof Plane)) {
          found[count++] = image.pixel(x, y).luminance();
        } else {
          others++;
        }
      }
    }
    Arrays.sort(found, 0, count);
    return count == 0 || others == 0 && !mayBeAll
        ? OptionalDouble.empty()
        : OptionalDouble.of(found[count / 2]);
  }

  private boolean isCovered(int x, int y) {
    RenderSettings.Crop window = settings.window();
    Point2 film =
        new Point2(
            (window.x() + x + .5) / settings.width(), (window.y() + y + .5) / settings.height());
    Optional<Ray> ray = scene.camera().rayFor(film, sampler);
    return ray.isPresent() && scene.intersect(ray.get(), hit);
  }
}
