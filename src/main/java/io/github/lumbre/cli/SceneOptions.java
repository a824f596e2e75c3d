package io.github.lumbre.cli;

import io.github.lumbre.image.FileFailure;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.parser.SceneFormatException;
import io.github.lumbre.parser.SceneParser;
import java.io.IOException;
import java.nio.file.Path;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** What all commands that read a scene take. */
final class SceneOptions {
  @Parameters(index = "0", paramLabel = "SCENE", description = "The scene, a JSON file.")
  private Path scene;

  @ArgGroup private Strictness strictness = new Strictness();

  @Option(names = "--debug", description = "Show the stack trace of an error.")
  private boolean debug;

  /** How to take what is doubtful; one of the two at most. */
  static final class Strictness {
    @Option(
        names = "--strict",
        description = "Make every warning an error, and every sample that is not a number.")
    private boolean strict;

    @Option(
        names = "--lenient",
        description = "Make references to missing assets warnings instead of errors.")
    private boolean lenient;
  }

  Path scene() {
    return scene;
  }

  boolean isStrict() {
    return strictness.strict;
  }

  boolean isLenient() {
    return strictness.lenient;
  }

  /** Returns a parser that is as lenient as asked for. */
  SceneParser parser() {
    SceneParser parser = new SceneParser();
    return strictness.lenient ? parser.lenient() : parser;
  }

  /**
   * Reads the scene and prints its warnings.
   *
   * @throws CommandException if there are warnings under {@code --strict}, or if the scene cannot
   *     be read
   */
  SceneFile load(SceneParser parser, Messages messages)
      throws SceneFormatException, CommandException {
    SceneFile file = read(parser);
    messages.warnings(file.warnings());
    if (isStrict() && !file.warnings().isEmpty()) {
      int count = file.warnings().size();
      String warnings = count == 1 ? "1 warning" : count + " warnings";
      throw new CommandException(
          ExitCodes.WARNINGS, scene + ": " + warnings + ", which --strict makes errors");
    }
    return file;
  }

  /**
   * Reads the scene and keeps its warnings for the caller.
   *
   * @throws CommandException if the scene cannot be read
   */
  SceneFile read(SceneParser parser) throws SceneFormatException, CommandException {
    try {
      return parser.parse(scene);
    } catch (IOException e) {
      throw new CommandException(
          ExitCodes.SCENE, scene + ": cannot be read: " + FileFailure.reason(e), e);
    }
  }
}
