package io.github.lumbre.cli;

import io.github.lumbre.checkpoint.RecordedLayers;
import io.github.lumbre.cli.run.Engine;
import io.github.lumbre.cli.run.RenderJob;
import io.github.lumbre.cli.view.DisplayServer;
import io.github.lumbre.lab.TaskException;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.preview.PreviewRenderer;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.PassRenderer;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.Optional;

/** Shows the passes of an engine on a display server. Mutable, for one render. */
final class DisplayedEngine implements Engine, AutoCloseable {
  private final Engine engine;
  private final DisplayServer display;
  private Optional<PreviewRenderer> renderer = Optional.empty();

  DisplayedEngine(Engine engine, DisplayServer display) {
    this.engine = engine;
    this.display = display;
  }

  @Override
  public PassRenderer over(Path path, SceneFile scene, FilmRenderer local, boolean isTimed)
      throws TaskException {
    PreviewRenderer displayed =
        new PreviewRenderer(
            engine.over(path, scene, local, isTimed),
            RecordedLayers.of(scene.settings(), scene.scene()),
            display);
    renderer = Optional.of(displayed);
    return displayed;
  }

  /** Runs a job with an engine. */
  interface Run {
    int of(RenderJob job) throws TaskException;
  }

  /** Runs a job, and shows its passes on a display server if there is an address. */
  static int showing(Optional<InetSocketAddress> viewer, RenderJob job, Run run)
      throws TaskException {
    if (viewer.isEmpty()) {
      return run.of(job);
    }
    String name = String.valueOf(job.scene().getFileName());
    DisplayServer server = DisplayServer.start(viewer.get(), name, job.messages()::line);
    try (DisplayedEngine displayed = new DisplayedEngine(job.engine(), server)) {
      return run.of(job.by(displayed));
    }
  }

  /** Shows the last samples, and closes the connection. */
  @Override
  public void close() {
    display.end();
    renderer.ifPresent(PreviewRenderer::finish);
    display.close();
  }
}
