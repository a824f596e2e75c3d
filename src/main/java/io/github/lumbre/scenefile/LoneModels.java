package io.github.lumbre.scenefile;

import io.github.lumbre.model.program.ImportProgram.Imported;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scenefile.internal.LoneModel;
import io.github.lumbre.scenefile.internal.ModelParser;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;

/** Reads models with the limits and changes of a parser. */
record LoneModels(SceneParser parser) implements ModelParser {
  private static Problems problemsOf(Path model) {
    return new Problems(String.valueOf(model.getFileName()), true);
  }

  /** Returns the content of a model's file. */
  static byte[] content(Path file, long most) throws SceneFormatException, IOException {
    return InputFile.read(file, problemsOf(file), "model", "bytes in all files", most);
  }

  @Override
  public <T> T timed(Path model, Step<T> step) throws SceneFormatException, IOException {
    return TimedReading.of(parser.settings().limits(), problemsOf(model), step::read);
  }

  @Override
  public LoneModel read(Source source) throws SceneFormatException, IOException {
    return new ReadModel(parser, source);
  }

  @Override
  public SceneFile parse(SceneText text, Imported imported) throws SceneFormatException {
    return parser.parse(text, Optional.of(imported));
  }

  @Override
  public RenderSettings defaults() {
    return parser.settings().defaults();
  }

  @Override
  public RenderSettings changed(RenderSettings inFile) {
    return parser.settings().change().apply(inFile);
  }
}
