package io.github.lumbre.cli;

import io.github.lumbre.base.TaskException;
import io.github.lumbre.cli.output.MemoryCheck;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.run.Interruption;
import io.github.lumbre.cli.run.RenderMonitor;
import io.github.lumbre.lab.LabHost;
import io.github.lumbre.render.FilmLayers;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import java.io.IOException;
import java.nio.file.Path;

/**
 * Runs measurements from the command line.
 *
 * @param hasDisplay whether each render shows a progress bar on standard error
 * @param messages printer of warnings
 */
record CommandLineHost(Interruption interruption, boolean hasDisplay, Messages messages)
    implements LabHost {
  @Override
  public SceneFile read(Path scene, SceneParser parser) throws SceneFormatException, IOException {
    try (RenderMonitor monitor = new RenderMonitor(interruption, hasDisplay)) {
      Interruption.Wait reading = monitor.reading(scene);
      try (reading) {
        SceneFile file = parser.parse(scene);
        messages.warnings(file.warnings());
        return file;
      }
    }
  }

  @Override
  public void requireMemory(RenderSettings settings) throws TaskException {
    MemoryCheck.require(settings, FilmLayers.NONE);
  }

  @Override
  public <T> T displayed(Displayed<T> render) throws InterruptedException {
    try (RenderMonitor monitor = new RenderMonitor(interruption, hasDisplay)) {
      return render.render(monitor);
    }
  }
}
