package io.github.lumbre.cli.output;

import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.Plane;
import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.Image;
import io.github.lumbre.material.Material;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.sampling.internal.IndependentSampler;
import io.github.lumbre.scene.Primitive;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scenefile.SceneFile;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;

/** What the camera sees of a scene's objects, by rays through the centers and corners of pixels. */
public final class Visible {
  /** The luminance after exposure of middle gray. */
  private static final double MIDDLE = .18;

  /** The largest number of pixels whose luminance is read. */
  private static final int MAX_READ = 1 << 15;

  /** The largest number of transparent surfaces that a ray passes. */
  private static final int MAX_PASSED = 256;

  private final Scene scene;
  private final RenderSettings settings;
  private final IndependentSampler sampler = new IndependentSampler(0);
  private final NearestHit hit = new NearestHit();
  private double scale = 1;
  private boolean isAll;

  Visible(Scene scene, RenderSettings settings) {
    this.scene = scene;
    this.settings = settings;
  }

  /**
   * Returns the exposure of a picture. An automatic one of a model that is rendered by itself
   * scales the median luminance of the pixels that objects other than infinite planes cover to 18 %
   * gray, if there are other pixels, too. Scene files keep the automatic exposure of the scene
   * format.
   *
   * @param image of the settings' window, in any size
   */
  public static Exposure exposure(Exposure wanted, SceneFile file, Image image) {
    return wanted.stops().isPresent() || file.text().isEmpty()
        ? wanted
        : new Visible(file.scene(), file.settings()).exposure(image);
  }

  /** Returns the automatic exposure of a model's picture. */
  Exposure exposure(Image image) {
    OptionalDouble median = medianOfSome(image);
    return median.isPresent() && median.getAsDouble() > 0
        ? Exposure.of(stops(median.getAsDouble()))
        : Exposure.AUTO;
  }

  /** Returns the stops that make a luminance middle gray. */
  static double stops(double luminance) {
    double limited = Math.max(1e-30, Math.min(luminance, Float.MAX_VALUE));
    return StrictMath.log(MIDDLE / limited) / StrictMath.log(2);
  }

  /** Returns whether the scene has objects, and no ray hits one. */
  boolean isNothing() {
    if (scene.primitives().isEmpty()) {
      return false;
    }
    RenderSettings.Crop window = settings.window();
    for (int y = 0; y < window.height(); y++) {
      for (int x = 0; x < window.width(); x++) {
        if (isHit(x + .5, y + .5)) {
          return false;
        }
      }
    }
    return true;
  }

  /**
   * Returns the median luminance, before exposure, of the pixels that objects other than infinite
   * planes cover wholly; empty if there are no such objects in view. Surfaces that let more than
   * half of the light pass cover nothing. Without such pixels, those count whose centers show a
   * surface.
   *
   * @param image of the settings' window, in any size
   */
  OptionalDouble medianLuminance(Image image) {
    return middle(luminances(image));
  }

  /**
   * Returns the same if there are pixels whose centers show no such surface; empty otherwise. If
   * the median is 0, black pixels are left out.
   */
  private OptionalDouble medianOfSome(Image image) {
    double[] all = luminances(image);
    if (isAll) {
      return OptionalDouble.empty();
    }
    OptionalDouble median = middle(all);
    return median.orElse(1) > 0
        ? median
        : middle(DoubleStream.of(all).filter(y -> y > 0).toArray());
  }

  /** Returns the luminances in ascending order, and finds whether the objects cover all centers. */
  private double[] luminances(Image image) {
    int step = 1;
    while ((long) (image.width() / step) * (image.height() / step) > MAX_READ) {
      step++;
    }
    DoubleStream.Builder clear = DoubleStream.builder();
    DoubleStream.Builder solid = DoubleStream.builder();
    DoubleStream.Builder whole = DoubleStream.builder();
    isAll = true;
    scale = (double) settings.window().width() / image.width();
    for (int y = step / 2; y < image.height(); y += step) {
      for (int x = step / 2; x < image.width(); x += step) {
        double luminance = image.pixel(x, y).luminance();
        if (isCovered(x + .5, y + .5, true)) {
          (isWhole(x, y) ? whole : solid).add(luminance);
        } else {
          isAll = false;
          if (isCovered(x + .5, y + .5, false)) {
            clear.add(luminance);
          }
        }
      }
    }
    return Stream.of(whole, solid, clear)
        .map(values -> values.build().sorted().toArray())
        .filter(values -> values.length > 0)
        .findFirst()
        .orElse(new double[0]);
  }

  private static OptionalDouble middle(double[] sorted) {
    return sorted.length == 0
        ? OptionalDouble.empty()
        : OptionalDouble.of(sorted[sorted.length / 2]);
  }

  private boolean isWhole(int x, int y) {
    return isCovered(x, y, true)
        && isCovered(x + 1, y, true)
        && isCovered(x, y + 1, true)
        && isCovered(x + 1, y + 1, true);
  }

  /**
   * Returns whether the ray through a point hits an object other than an infinite plane.
   *
   * @param bySolid whether it passes surfaces that let more than half of the light pass
   */
  private boolean isCovered(double x, double y, boolean bySolid) {
    boolean isHit = isHit(x, y);
    for (int passed = 0; isHit && passed < MAX_PASSED; passed++) {
      Primitive primitive = scene.primitiveAt(hit);
      Material material = primitive.material();
      if (!bySolid
          || material.isOpaque()
          || material.transmittance(scene.surfaceAt(hit)).max() <= .5) {
        return !(primitive.shape() instanceof Plane);
      }
      hit.pass();
      isHit = scene.intersect(hit);
    }
    return false;
  }

  private boolean isHit(double x, double y) {
    RenderSettings.Crop window = settings.window();
    Point2 film =
        new Point2(
            (window.x() + x * scale) / settings.width(),
            (window.y() + y * scale) / settings.height());
    Optional<Ray> ray = scene.camera().rayFor(film, sampler);
    return ray.isPresent() && scene.intersect(ray.get(), hit);
  }
}
