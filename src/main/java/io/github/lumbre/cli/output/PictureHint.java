package io.github.lumbre.cli.output;

import io.github.lumbre.base.text.Numbers;
import io.github.lumbre.image.Image;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.render.denoise.Denoised;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.internal.ModelContents;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * Finds what is wrong with a picture for certain, and which flag would help.
 *
 * @param model what the scene's model offers; empty for other scenes
 */
public record PictureHint(Summary summary, Scene scene, Optional<ModelContents> model) {
  /** The luminance after exposure below which a pixel is dark. */
  private static final double DARK = .1;

  /** The luminance after exposure above which a surface is burnt out: twice as bright as white. */
  private static final double BURNT = 2;

  /** The relative error of a denoised picture from which on smears of the denoiser are seen. */
  private static final double VISIBLE_ERROR = .05;

  /** The denoiser's estimate of the error of fewer pixels says little. */
  private static final long LEAST_PIXELS = 1 << 14;

  /** The samples per pixel that suffice for most reflections and shadows. */
  private static final int MANY_SAMPLES = 200;

  /** A model stands on a plane if it is not farther from it than this part of its size. */
  private static final double STANDS = 1e-6;

  /** A model that stands on a plane reaches this part of its size below others. */
  private static final double BELOW = .1;

  /** Returns the hint about a complete picture that shows nothing, or is dark or burnt. */
  public Optional<String> ofLight() {
    if (!summary.result().complete()) {
      return Optional.empty();
    }
    Visible visible = new Visible(scene, summary.settings());
    if (visible.isNothing()) {
      return Optional.of(
          "nothing is in view: no camera ray hits an object; "
              + (hasCameras() ? "--view iso shows the whole model" : "turn or move the camera"));
    }
    if (summary.brightest() == 0 && scene.emitters().isEmpty() && scene.ambient().isBlack()) {
      return Optional.of("the picture is black, because the scene has no light; " + lighting());
    }
    if (summary.settings().exposure().stops().isEmpty()) {
      return Optional.empty();
    }
    return isDark()
        ? Optional.of("99 % of the picture is darker than " + DARK + "; try --exposure auto")
        : burnt(visible.medianLuminance(summary.result().image()));
  }

  private boolean hasCameras() {
    return model.map(contents -> !contents.cameras().isEmpty()).orElse(false);
  }

  private String lighting() {
    return model.isPresent()
        ? "without --sky and --sky-intensity, a studio lights it"
        : "add one, such as a Dome";
  }

  private Optional<String> burnt(OptionalDouble median) {
    double factor = summary.settings().exposure().factor(summary.result().image());
    double shown = median.isPresent() ? median.getAsDouble() * factor : 0;
    return shown > BURNT
        ? Optional.of(
            String.format(
                Locale.ROOT,
                "half of what is in view is burnt out, %s times as bright as white;"
                    + " try --exposure %.1f",
                String.format(Locale.ROOT, shown < 10 ? "%.1f" : "%.0f", shown),
                Visible.stops(median.getAsDouble())))
        : Optional.empty();
  }

  private boolean isDark() {
    Image image = summary.light();
    double threshold = DARK / summary.settings().exposure().factor(image);
    long left = ((long) image.width() * image.height() + 99) / 100;
    for (int y = 0; y < image.height(); y++) {
      for (int x = 0; x < image.width(); x++) {
        if (image.pixel(x, y).luminance() >= threshold && --left == 0) {
          return false;
        }
      }
    }
    return true;
  }

  /**
   * Returns the hint that a denoised picture needs more samples, by the denoiser's own estimate.
   *
   * @param denoised the picture; empty if it is not denoised
   */
  public Optional<String> ofNoise(Optional<Denoised> denoised) {
    RenderSettings settings = summary.settings();
    OptionalDouble error =
        denoised.map(Denoised::relativeError).orElse(OptionalDouble.empty());
    boolean isVisible =
        error.orElse(0) >= VISIBLE_ERROR && settings.window().pixels() >= LEAST_PIXELS;
    return isVisible && settings.samples() <= MANY_SAMPLES / 2
        ? Optional.of(
            "the denoised picture has an error of about %s; -s %d makes it smaller"
                .formatted(Numbers.percent(error.getAsDouble()), MANY_SAMPLES))
        : Optional.empty();
  }

  /**
   * Returns the hint that +Z is up in an STL file, which states no axes: the model stands on the
   * plane z = 0, is higher than it is wide and deep, and reaches below y = 0.
   *
   * @param path of the model, which is shown with +Y up
   */
  public static Optional<String> ofAxes(Path path, SceneFile file) {
    boolean isStl = path.toString().toLowerCase(Locale.ROOT).endsWith(".stl");
    return file.parsed()
        .model()
        .filter(contents -> isStl && standsOnZ(contents))
        .map(
            contents ->
                "the model stands on the plane z = 0, and is shown with +Y up; --up z stands it"
                    + " upright");
  }

  private static boolean standsOnZ(ModelContents contents) {
    Vec3 sides = contents.max().minus(contents.min());
    double size = sides.length();
    return Math.abs(contents.min().z()) <= STANDS * size
        && contents.min().y() < -BELOW * size
        && sides.z() > Math.max(sides.x(), sides.y());
  }
}
