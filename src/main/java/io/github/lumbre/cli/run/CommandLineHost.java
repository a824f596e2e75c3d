package io.github.lumbre.cli.run;

import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.lab.LabHost;
import io.github.lumbre.lab.SceneFolder;
import io.github.lumbre.lab.TaskException;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.parser.SceneFormatException;
import io.github.lumbre.parser.SceneParser;
import java.nio.file.Path;

/**
 * Runs measurements from the command line.
 *
 * @param hasDisplay whether each render shows a progress bar on standard error
 * @param messages printer of warnings
 */
public record CommandLineHost(Interruption interruption, boolean hasDisplay, Messages messages)
    implements LabHost {
  @Override
  public SceneFile read(Path scene, SceneParser parser) throws SceneFormatException, TaskException {
    try (RenderMonitor monitor = new RenderMonitor(interruption, hasDisplay)) {
      SceneFile file = monitor.reading(scene, () -> SceneFolder.load(scene, parser));
      messages.warnings(file.warnings());
      return file;
    }
  }

  @Override
  public Display display() {
    return new RenderMonitor(interruption, hasDisplay);
  }
}
