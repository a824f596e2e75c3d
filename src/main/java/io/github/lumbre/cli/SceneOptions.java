package io.github.lumbre.cli;

import io.github.lumbre.image.FileFailure;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.parser.SceneFormatException;
import io.github.lumbre.parser.SceneParser;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** What all commands that read a scene take. */
final class SceneOptions {
  /** The name of a scene from standard input: its assets are relative to the working directory. */
  static final Path STDIN = Path.of("stdin");

  private Optional<byte[]> text = Optional.empty();

  @Parameters(
      index = "0",
      paramLabel = "SCENE",
      description = "The scene, a JSON file; - reads standard input.")
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

  boolean isStandardInput() {
    return scene.equals(PictureOutput.STANDARD);
  }

  /**
   * Adds the scene and all files that its assets name to the files that a command reads.
   *
   * @throws CommandException if standard input cannot be read
   */
  OutputGuard guardedBy(OutputGuard guard) throws CommandException {
    if (!isStandardInput()) {
      return guard.readsScene(scene);
    }
    byte[] content = standardInput();
    return guard
        .reads(Path.of("/dev/stdin"), "standard input")
        .readsAssets(scene, () -> SceneParser.files(content, STDIN));
  }

  private byte[] standardInput() throws CommandException {
    try {
      if (text.isEmpty()) {
        text = Optional.of(System.in.readAllBytes());
      }
      return text.get();
    } catch (IOException e) {
      throw new CommandException(
          ExitCodes.SCENE, "standard input cannot be read: " + FileFailure.reason(e), e);
    }
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
    if (isStandardInput()) {
      return parser.parse(standardInput(), STDIN);
    }
    try {
      return parser.parse(scene);
    } catch (IOException e) {
      throw new CommandException(
          ExitCodes.SCENE, scene + ": cannot be read: " + FileFailure.reason(e), e);
    }
  }
}
