package io.github.lumbre.parser;

import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.util.List;

/**
 * What a scene file holds.
 *
 * @param warnings what is doubtful in the scene
 * @param hash SHA-256 of the file and of every file it refers to, in hexadecimal
 * @param files the hash of each of these files
 * @param contents what the scene is made of, for people
 * @param origins where in the file everything stands
 */
public record SceneFile(
    Scene scene,
    RenderSettings settings,
    List<Problem> warnings,
    String hash,
    FileHashes files,
    SceneContents contents,
    SceneOrigins origins) {
  public SceneFile {
    warnings = List.copyOf(warnings);
  }

  /** Returns the same with another scene. */
  public SceneFile with(Scene other) {
    return new SceneFile(other, settings, warnings, hash, files, contents, origins);
  }
}
