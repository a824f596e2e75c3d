package io.github.lumbre.scenefile;

import com.google.gson.GsonBuilder;
import com.google.gson.JsonElement;
import com.google.gson.JsonParser;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Objects;

/**
 * A scene that is not in a file of its own.
 *
 * @param json the scene in UTF-8; not copied
 * @param path a path in the folder where asset paths start; its name appears in messages
 */
public record SceneText(byte[] json, Path path) {
  public SceneText {
    Objects.requireNonNull(json, "json");
    Objects.requireNonNull(path, "path");
  }

  /** Returns the scene with line breaks and indentation. */
  public String pretty() {
    JsonElement scene = JsonParser.parseString(new String(json, StandardCharsets.UTF_8));
    return new GsonBuilder().setPrettyPrinting().disableHtmlEscaping().create().toJson(scene);
  }
}
