package io.github.lumbre.testing;

import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.Progress;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;

/** Rendered films for tests. */
public final class Renders {
  private Renders() {}

  /** Returns a film with all samples of the settings. */
  public static Film film(RenderSettings settings, Scene scene) throws InterruptedException {
    FilmRenderer renderer = new FilmRenderer(settings, scene);
    Film film = renderer.newFilm();
    renderer.addSamples(film, settings.samples(), Progress.NONE);
    return film;
  }
}
