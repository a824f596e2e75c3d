package io.github.lumbre.render;

import io.github.lumbre.render.internal.RendererInside;

/** Shows a {@link FilmRenderer} to this program, with types that the exported class lacks. */
abstract class OpenRenderer extends RendererInside.Opener {
  OpenRenderer() {
    super(FilmRenderer::inside);
  }
}
