package io.github.lumbre.scenefile;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.scenefile.SceneFormatException.Kind;
import io.github.lumbre.scenefile.internal.Origin;

/** Where a model stands: its problems are reported there, and its parts have their places there. */
interface ModelPlace {
  /** Returns the place of problems that concern the whole model. */
  ProblemPlace problemPlace();

  /**
   * Returns the place of a part or material.
   *
   * @param location in the model's file
   * @param name in the model's file; empty if there is none
   */
  Origin origin(String location, String name);

  /** Adds a warning of the model's reader. */
  void warn(String warning);

  /** Adds the error of a model that cannot be used. */
  void error(ModelFormatException e);

  static Kind kind(ModelFormatException e) {
    return e.kind() == ModelFormatException.Kind.TOO_LARGE ? Kind.LIMIT : Kind.ASSET;
  }

  private static Origin shown(String path, String name) {
    return new Origin(PrintableText.path(path), PrintableText.shortened(name));
  }

  /** A model that is rendered by itself: all places are in its own file. */
  record OfFile(Problems problems) implements ModelPlace {
    @Override
    public ProblemPlace problemPlace() {
      return new ProblemPlace(problems, () -> "");
    }

    @Override
    public Origin origin(String location, String name) {
      return shown(location, name);
    }

    @Override
    public void warn(String warning) {
      problemPlace().warn(warning);
    }

    @Override
    public void error(ModelFormatException e) {
      problems.error(
          kind(e), () -> PrintableText.escaped(e.location()), PrintableText.escaped(e.detail()));
    }
  }

  /**
   * A model in a scene.
   *
   * @param object that names the file
   * @param key the key that names the file
   * @param file name of the model, as the object states it
   */
  record OfObject(JsonNode object, String key, String file) implements ModelPlace {
    @Override
    public ProblemPlace problemPlace() {
      return object.problemPlace();
    }

    @Override
    public Origin origin(String location, String name) {
      return shown(object.path() + ": " + file + ": " + location, name);
    }

    @Override
    public void warn(String warning) {
      object.warn(key, file + ": " + warning);
    }

    @Override
    public void error(ModelFormatException e) {
      String message = PrintableText.escaped(e.getMessage());
      object.error(kind(e), key, file + ": " + message);
    }
  }
}
