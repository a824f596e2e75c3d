package io.github.lumbre.cli.view;

import io.github.lumbre.base.TaskException;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;

/** Reads the scene that is viewed, each time its files change. */
public interface SceneSource {
  /**
   * Reads the scene anew.
   *
   * @param layers the layers to record besides the layers of the command line
   */
  SceneFile read(Set<Layer> layers) throws SceneFormatException, TaskException, IOException;

  /** Returns the text of the scene; for a model, of the scene around it. */
  byte[] text() throws IOException;

  /** Returns the command line that renders the scene as it is read; empty if there is none. */
  default Optional<RenderLine> command() {
    return Optional.empty();
  }

  /** Returns the files that the scene depends on; those that cannot be found out are left out. */
  Set<Path> files();
}
