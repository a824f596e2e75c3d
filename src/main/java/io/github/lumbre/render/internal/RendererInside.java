package io.github.lumbre.render.internal;

import io.github.lumbre.integrator.Integrator;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.Progress;
import io.github.lumbre.render.RenderException;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.LongFunction;

/**
 * What the parts of this program do with a {@link FilmRenderer} and other programs do not need.
 */
public abstract class RendererInside {
  /** A superclass of renderers that this class can open, and no class of another package. */
  public abstract static class Opener {
    private final Function<FilmRenderer, RendererInside> opening;

    protected Opener(Function<FilmRenderer, RendererInside> opening) {
      this.opening = opening;
    }
  }

  public static RendererInside of(FilmRenderer renderer) {
    Opener opener = renderer;
    return opener.opening.apply(renderer);
  }

  /**
   * Returns the same renderer with other integrators and other random numbers. Its films cannot be
   * merged with films of other renderers.
   *
   * @param integrators creates the integrator of a pose of the scene
   * @param samplers creates the sampler of a seed; called once for each thread
   */
  public abstract FilmRenderer with(
      Function<Scene, Integrator> integrators, LongFunction<Sampler> samplers);

  /**
   * Renders the pilot of {@link RenderSettings#guiding} if there is none yet. The first pass does
   * so as well.
   *
   * @param progress can cancel it
   * @return the report; empty if the pilot was cancelled, and with other settings
   * @throws InterruptedException if the calling thread is interrupted
   * @throws RenderException if a path failed
   */
  public abstract Optional<GuideReport> plan(Progress progress) throws InterruptedException;

  /**
   * Returns the report on the pilot render of {@link RenderSettings#guiding}, which the first pass
   * begins with; empty before that and without guiding.
   */
  public abstract Optional<GuideReport> guiding();
}
