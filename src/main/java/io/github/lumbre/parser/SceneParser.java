package io.github.lumbre.parser;

import io.github.lumbre.scene.RenderSettings;
import java.io.IOException;
import java.nio.file.Path;
import java.util.function.UnaryOperator;

/** Reads scene files. Immutable: each method that changes how it reads returns another parser. */
public final class SceneParser {
  /** Returns a parser that takes references to missing assets as warnings. */
  public SceneParser lenient() {
    throw new UnsupportedOperationException();
  }

  /** Returns a parser that renders in the given mode, whatever the file says. */
  public SceneParser inMode(RenderSettings.Mode mode) {
    throw new UnsupportedOperationException();
  }

  /** Returns a parser that changes the settings that the file gives before it uses them. */
  public SceneParser overriding(UnaryOperator<RenderSettings> change) {
    throw new UnsupportedOperationException();
  }

  /**
   * Reads a scene.
   *
   * @throws SceneFormatException if the scene cannot be used, with all that is wrong
   * @throws IOException if the file exists but cannot be read
   */
  public SceneFile parse(Path file) throws SceneFormatException, IOException {
    throw new UnsupportedOperationException();
  }
}
