package io.github.lumbre.stage.internal;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.program.ImportProgram.Imported;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.scenefile.internal.ModelParser;
import io.github.lumbre.stage.Stage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * Where a model comes from, and what reads it. Immutable.
 *
 * @param parser whose limits and changes count
 * @param file absolute path of the model
 * @param content bytes of the file; empty to read it
 * @param imported the model instead, if a program has converted it
 * @param files has other files that the model names; empty for those beside it
 */
public record ModelSource(
    ModelParser parser,
    Path file,
    Optional<byte[]> content,
    Optional<Imported> imported,
    Optional<ModelFolder> files) {
  /** Returns a model in a file. */
  public static ModelSource of(SceneParser parser, Path model) {
    Path file = model.toAbsolutePath().normalize();
    return new ModelSource(
        parser.ofModels(), file, Optional.empty(), Optional.empty(), Optional.empty());
  }

  /** Returns a model that a program has converted. It may name files beside the model. */
  public static ModelSource converted(SceneParser parser, Path model, Imported imported) {
    return new ModelSource(
        parser.ofModels(),
        model.toAbsolutePath().normalize(),
        Optional.empty(),
        Optional.of(imported),
        Optional.empty());
  }

  /**
   * Returns a model whose bytes are known.
   *
   * @param name of the model without folders; its ending chooses the format
   */
  public static ModelSource of(SceneParser parser, String name, byte[] content, ModelFolder files) {
    Path here = Path.of("").toAbsolutePath();
    Path file = here.resolve(name).normalize();
    if (!here.equals(file.getParent())) {
      throw new IllegalArgumentException(
          "name: expected a name without folders, found " + PrintableText.quoted(name));
    }
    return new ModelSource(
        parser.ofModels(), file, Optional.of(content), Optional.empty(), Optional.of(files));
  }

  /** Reads within the time limit; what went wrong is a problem of the model. */
  public <T> T timed(ModelParser.Step<T> step) throws SceneFormatException, IOException {
    return parser.timed(file, step);
  }

  /**
   * Reads the model, which may lack pictures.
   *
   * @param isFrame whether it may have nothing to show, in one frame of an animation
   */
  public Staging read(Stage stage, boolean isFrame) throws SceneFormatException, IOException {
    Stage lenient = stage.reading(stage.options().mayLackFiles(true));
    return read(lenient, folder(stage), isFrame);
  }

  /**
   * Returns the scene around the model on a stage.
   *
   * @throws SceneFormatException if the model cannot be used
   * @throws IOException if a file cannot be read, or the thread is interrupted
   */
  public SceneFile scene(Stage stage) throws SceneFormatException, IOException {
    return timed(() -> read(inMotion(stage), false).scene());
  }

  /** Returns the nearest folder that contains both the model and the sky's picture. */
  private Path folder(Stage stage) {
    Path folder = file.getParent();
    Path picture = stage.sky().picture().orElse(folder);
    while (folder.getParent() != null && !picture.startsWith(folder)) {
      folder = folder.getParent();
    }
    return folder;
  }

  /**
   * Reads the model for a scene in a folder, whose files the model may use. A missing picture is an
   * error unless the options of the stage are lenient, as it is in a scene.
   */
  public Staging readIn(Path folder, Stage stage) throws SceneFormatException, IOException {
    return read(
        stage.reading(stage.options().with(ModelOption.ASSETS, List.of(folder))), folder, false);
  }

  private Staging read(Stage stage, Path folder, boolean isFrame)
      throws SceneFormatException, IOException {
    return new Staging(
        parser,
        stage,
        new ModelParser.Source(
            folder, file, content, imported, files, stage.options(), isFrame));
  }

  /** Returns a stage with the motion of the model's pose, if the parser's caller wants one. */
  public Stage inMotion(Stage stage) {
    return stage.reading(stage.options().during(parser.changed(RenderSettings.DEFAULT)));
  }
}
