package io.github.lumbre.cli.run;

import io.github.lumbre.denoise.BuiltInDenoiser;
import io.github.lumbre.denoise.NoisyPicture;
import io.github.lumbre.image.Image;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.PassLoop;
import io.github.lumbre.render.Progress;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Setting;

/** Renders and denoises whole pictures that are not files. Stateless. */
public final class CleanPicture {
  private CleanPicture() {}

  /**
   * Returns the picture of a scene.
   *
   * @throws InterruptedException if the progress is cancelled or the thread interrupted
   */
  public static Image of(SceneFile file, Progress progress) throws InterruptedException {
    RenderSettings settings =
        file.settings().toBuilder().set(Setting.LAYERS, Layer.FOR_DENOISING).build();
    FilmRenderer renderer = new FilmRenderer(settings, file.scene());
    Film film = renderer.newFilm();
    if (!new PassLoop(renderer, film).run(progress).complete()) {
      throw new InterruptedException("cancelled");
    }
    int threads = Runtime.getRuntime().availableProcessors();
    return BuiltInDenoiser.denoise(NoisyPicture.of(film), threads).image();
  }
}
