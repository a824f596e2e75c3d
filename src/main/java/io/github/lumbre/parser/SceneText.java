package io.github.lumbre.parser;

import com.google.gson.GsonBuilder;
import com.google.gson.JsonElement;
import com.google.gson.JsonParser;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;

/**
 * A scene that is not in a file of its own.
 *
 * @param json the scene in UTF-8; not copied
 * @param path a path in the folder where asset paths start; its name appears in messages
 * @param model the content of the model that the scene is made around; empty for other scenes
 */
public record SceneText(byte[] json, Path path, Optional<ModelContents> model) {
  public SceneText {
    Objects.requireNonNull(json, "json");
    Objects.requireNonNull(path, "path");
    Objects.requireNonNull(model, "model");
  }

  /** A scene that is not made around a model. */
  public SceneText(byte[] json, Path path) {
    this(json, path, Optional.empty());
  }

  /** Returns the scene with line breaks and indentation. */
  public String pretty() {
    JsonElement scene = JsonParser.parseString(new String(json, StandardCharsets.UTF_8));
    return new GsonBuilder().setPrettyPrinting().disableHtmlEscaping().create().toJson(scene);
  }
}
