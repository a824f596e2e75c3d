package io.github.lumbre.cli;

import io.github.lumbre.image.FileFailure;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.parser.SceneFormatException;
import io.github.lumbre.parser.SceneParser;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** A folder of scene files. */
record SceneFolder(Path directory) {
  private static final String ENDING = ".json";

  /**
   * Returns the names of all scenes without their ending, in order.
   *
   * @throws CommandException if the folder cannot be read
   */
  List<String> names() throws CommandException {
    try (Stream<Path> files = Files.list(directory)) {
      return files
          .filter(file -> file.getFileName().toString().endsWith(ENDING))
          .map(SceneFolder::name)
          .sorted()
          .toList();
    } catch (IOException e) {
      throw new CommandException(
          ExitCodes.USAGE,
          directory + ": cannot be read as a folder of scenes: " + FileFailure.reason(e),
          e);
    }
  }

  /** Returns the name of a scene file, without its ending. */
  static String name(Path file) {
    String name = String.valueOf(file.getFileName());
    return name.endsWith(ENDING) ? name.substring(0, name.length() - ENDING.length()) : name;
  }

  /** Returns the file of the scene with this name. */
  Path file(String name) {
    return directory.resolve(name + ENDING);
  }

  /**
   * Reads the scene with this name and prints its warnings.
   *
   * @throws CommandException if the file cannot be read
   */
  SceneFile load(String name, SceneParser parser, Messages messages)
      throws SceneFormatException, CommandException {
    return load(file(name), parser, messages);
  }

  /**
   * Reads a scene, of whatever folder, and prints its warnings.
   *
   * @throws CommandException if the file cannot be read
   */
  static SceneFile load(Path path, SceneParser parser, Messages messages)
      throws SceneFormatException, CommandException {
    try {
      SceneFile scene = parser.parse(path);
      messages.warnings(scene.warnings());
      return scene;
    } catch (IOException e) {
      throw new CommandException(
          ExitCodes.SCENE, path + ": cannot be read: " + FileFailure.reason(e), e);
    }
  }
}
