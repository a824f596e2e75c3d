package io.github.lumbre.lab.trade;

import io.github.lumbre.image.Image;
import io.github.lumbre.integrator.Integrator;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.denoise.BuiltInDenoiser;
import io.github.lumbre.render.denoise.NoisyPicture;
import io.github.lumbre.render.internal.RendererInside;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.util.function.Function;
import java.util.function.LongFunction;

/**
 * A setting that a study measures at several numbers of samples.
 *
 * @param value value of the parameter, as on the command line if it has a flag
 * @param flags command line flags of the setting; empty if there are none
 * @param scene scene, read for the mode of the settings
 * @param method creates the integrator of a scene
 * @param samplers creates the sampler of a seed
 */
public record TradeSetting(
    Knob knob,
    String value,
    Kind kind,
    String flags,
    TradeScene scene,
    RenderSettings settings,
    Function<Scene, Integrator> method,
    LongFunction<Sampler> samplers) {

  /**
   * The effect of a setting besides the time; settings of different kinds are not ranked together.
   */
  public enum Kind {
    /** The setting is unbiased and changes only the noise. */
    NOISE,
    /** The setting is biased: its pictures converge to a different limit. */
    BIAS,
    /** The pictures are denoised; their bias falls with the noise. */
    DENOISED
  }

  /** Returns the smallest number of samples per pixel from which a picture can be made. */
  int leastSamples() {
    return kind == Kind.DENOISED ? 2 : 1;
  }

  /** Returns the picture of a film, denoised if that is the setting. */
  Image develop(Film film) throws InterruptedException {
    if (kind != Kind.DENOISED) {
      return film.develop();
    }
    int wanted = settings.threads();
    int threads = wanted == 0 ? Runtime.getRuntime().availableProcessors() : wanted;
    return BuiltInDenoiser.denoise(NoisyPicture.of(film), threads).image();
  }

  public boolean isUnbiased() {
    return kind == Kind.NOISE;
  }

  /** Returns the setting's display name. */
  public String label() {
    return knob.label(value);
  }

  FilmRenderer renderer(long seed) {
    return renderer(scene.scene(), settings.toBuilder().seed(seed).build());
  }

  /** Returns a renderer of the setting for another scene and other frame settings. */
  FilmRenderer renderer(Scene other, RenderSettings frame) {
    FilmRenderer renderer = new FilmRenderer(frame, other);
    return RendererInside.of(renderer).with(method, samplers);
  }
}
