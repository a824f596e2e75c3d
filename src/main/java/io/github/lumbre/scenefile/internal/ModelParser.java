package io.github.lumbre.scenefile.internal;

import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.program.ImportProgram.Imported;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneText;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;

/** A parser of scenes, as it reads models that are rendered by themselves. Immutable. */
public interface ModelParser {
  /**
   * A model to read.
   *
   * @param folder where asset paths start; contains the model and the sky's picture
   * @param file absolute path of the model
   * @param content of the file; empty to read it
   * @param imported the model instead, if a program has converted it
   * @param others has the files that the model names; empty for those in its own folder and in
   *     those of its options
   * @param isFrame whether the model may have nothing to show, in one frame of an animation
   */
  record Source(
      Path folder,
      Path file,
      Optional<byte[]> content,
      Optional<Imported> imported,
      Optional<ModelFolder> others,
      ModelOptions options,
      boolean isFrame) {}

  /** A part of the reading. */
  @FunctionalInterface
  interface Step<T> {
    T read() throws SceneFormatException, IOException;
  }

  /** Reads within the time limit; what went wrong is a problem of the model. */
  <T> T timed(Path model, Step<T> step) throws SceneFormatException, IOException;

  /**
   * Reads a model.
   *
   * @throws SceneFormatException if the model cannot be used
   * @throws IOException if a file cannot be read
   * @throws java.util.concurrent.CancellationException if the thread is interrupted
   */
  LoneModel read(Source source) throws SceneFormatException, IOException;

  /** Reads the scene that stands for a model which a program has converted. */
  SceneFile parse(SceneText text, Imported imported) throws SceneFormatException;

  /** Returns the settings of a scene that states none. */
  RenderSettings defaults();

  /** Returns settings with the changes that the parser's caller makes. */
  RenderSettings changed(RenderSettings inFile);
}
