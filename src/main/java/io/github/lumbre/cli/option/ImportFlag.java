package io.github.lumbre.cli.option;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.base.file.ExternalProgram;
import io.github.lumbre.base.file.FileFailure;
import io.github.lumbre.cli.output.ShellText;
import io.github.lumbre.model.program.ImportProgram;
import io.github.lumbre.model.program.ImportProgram.Imported;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.stage.internal.ModelSource;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;

/** The flag that converts models by an installed program. Each model is converted once. */
@Command(optionListHeading = Headings.SCENE)
public final class ImportFlag extends Flags {
  private static final String FLAG = "--import-with";

  @Option(
      names = FLAG,
      paramLabel = "NAME|TEMPLATE",
      description =
          "Convert the models by an installed program: assimp, blender or step (Python with"
              + " cadquery-ocp), NAME=PATH, or '/path/program {in} {out}', which writes a GLB.")
  private Optional<String> text = Optional.empty();

  private Optional<ImportProgram> program = Optional.empty();
  private final Map<Path, Imported> done = new HashMap<>();

  public boolean isGiven() {
    return text.isPresent();
  }

  /**
   * Finds the program, before anything is read.
   *
   * @throws ParameterException if the value is wrong
   * @throws TaskException if the program is not found
   */
  public void validate() throws TaskException {
    if (text.isEmpty()) {
      return;
    }
    try {
      program = Optional.of(ImportProgram.of(text.get(), System.getenv()));
    } catch (InvalidPathException e) {
      throw failure(FileFailure.reason(e), e);
    } catch (IllegalArgumentException e) {
      throw failure(e.getMessage(), e);
    } catch (IOException e) {
      throw ExitCode.ABSENT.failure(FLAG + ": " + e.getMessage(), e);
    }
  }

  private ParameterException failure(String message, Exception cause) {
    return new ParameterException(spec.commandLine(), FLAG + ": " + message, cause);
  }

  /** Returns whether a file is converted: each but scenes, if the flag is given. */
  public boolean converts(Path file) {
    return isGiven() && !isScene(file);
  }

  private static boolean isScene(Path file) {
    return file.toString().toLowerCase(Locale.ROOT).endsWith(".json");
  }

  /**
   * Requires that a file is not a scene, if the flag is given.
   *
   * @throws ParameterException if it is
   */
  void requireSuits(Path file, boolean isStandardInput) {
    require(
        !isGiven() || !isStandardInput && !isScene(file),
        FLAG + ": requires a model in a file, found " + file);
  }

  /**
   * Returns the end of a message about a file that is no model: the flag with a program that is
   * installed and may convert it; nothing if there is none.
   */
  public String advice(Path file) {
    List<String> programs =
        isGiven() ? List.of() : ImportProgram.suiting(file.toString(), System.getenv());
    return programs.isEmpty()
        ? ""
        : ", or render it by 'lumbre render %s %s %s'"
            .formatted(ShellText.quoted(file.toString()), FLAG, programs.get(0));
  }

  /**
   * Returns a model, converted.
   *
   * @throws TaskException if that fails
   */
  public ModelSource source(SceneParser parser, Path file) throws TaskException {
    return ModelSource.converted(parser, file, imported(file));
  }

  /**
   * Returns a converted model.
   *
   * @throws TaskException if that fails
   */
  public Imported imported(Path file) throws TaskException {
    Path model = file.toAbsolutePath().normalize();
    if (!done.containsKey(model)) {
      done.put(model, converted(file));
    }
    return done.get(model);
  }

  private Imported converted(Path file) throws TaskException {
    if (!Files.isRegularFile(file)) {
      throw ExitCode.SCENE.failure(
          file + ": " + (Files.exists(file) ? "is not a file" : "does not exist"));
    }
    try {
      return program.orElseThrow().run(file);
    } catch (InterruptedException e) {
      CancellationException cancelled = new CancellationException("importing was interrupted");
      cancelled.initCause(e);
      throw cancelled;
    } catch (IOException e) {
      ExitCode code =
          e instanceof ExternalProgram.LimitException ? ExitCode.LIMIT : ExitCode.ASSET;
      throw code.failure(file + ": cannot be imported: " + FileFailure.reason(e), e);
    }
  }
}
