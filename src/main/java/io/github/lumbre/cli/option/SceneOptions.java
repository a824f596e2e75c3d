package io.github.lumbre.cli.option;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.base.file.FileFailure;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.output.OutputGuard;
import io.github.lumbre.cli.output.PictureOutput;
import io.github.lumbre.cli.output.ProblemText;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.internal.HeapNeed;
import io.github.lumbre.model.internal.ModelFormat;
import io.github.lumbre.model.internal.ModelReader;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.scenefile.SceneText;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.StagedModel;
import io.github.lumbre.stage.internal.ModelSequence;
import io.github.lumbre.stage.internal.ModelSequence.Motion;
import java.io.IOException;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;

/** The flags and arguments of all commands that read a scene. */
@Command(optionListHeading = Headings.SCENE)
public final class SceneOptions {
  private Optional<byte[]> text = Optional.empty();
  private Optional<OutputGuard> guard = Optional.empty();
  private Optional<Motion> motion = Optional.empty();
  private Optional<ModelSequence> sequence = Optional.empty();
  private Optional<ImportFlag> importing = Optional.empty();
  private int frame;
  private final Set<String> warned = new HashSet<>();

  @Mixin ModelFlags model = new ModelFlags();

  @Parameters(
      index = "0",
      paramLabel = "SCENE",
      description =
          "JSON scene, or model: "
              + ModelFormat.TITLES
              + "; - for standard input, where a model is one file, such as GLB.")
  private Path scene;

  @ArgGroup private Strictness strictness = new Strictness();

  /** The treatment of warnings; at most one of the two flags. */
  static final class Strictness {
    @Option(
        names = "--strict",
        description = "Treat warnings and rejected samples (negative, NaN or infinite) as errors.")
    private boolean strict;

    @Option(
        names = "--lenient",
        description =
            "Treat references to missing assets, missing pictures of a glTF model in a JSON scene,"
                + " and colors of a picture that are not finite, as warnings instead of errors.")
    private boolean lenient;
  }

  public Path scene() {
    return scene;
  }

  /** Returns the flags of models. */
  public ModelFlags model() {
    return model;
  }

  public boolean isStandardInput() {
    return scene.equals(PictureOutput.STANDARD);
  }

  /**
   * Returns whether the scene is a model.
   *
   * @throws TaskException if standard input cannot be read
   */
  public boolean isModel() throws TaskException {
    if (isStandardInput()) {
      return ModelReader.isModel(standardInput(), standardInput().length);
    }
    return isImported() || ModelReader.isModel(scene);
  }

  /** Makes a program convert the models. */
  public void importBy(ImportFlag flag) {
    importing = Optional.of(flag);
  }

  private boolean isImported() {
    return importing.filter(flag -> flag.converts(scene)).isPresent();
  }

  /** Chooses one of several scenes. */
  public void choose(Path chosen) {
    scene = chosen;
    warned.clear();
  }

  /**
   * Adds several scenes and their asset files to the files that a command reads, as {@link
   * #guardedBy} does. Models are read at once if a picture may replace one of their files, because
   * another scene's picture would be written before they are read.
   *
   * @throws ParameterException that names the scene, if a flag does not suit it
   */
  public void guardAll(List<Path> scenes, OutputGuard given) throws TaskException {
    Path chosen = scene;
    for (Path one : scenes) {
      choose(one);
      guardedBy(given);
      try {
        if (isImported()) {
          model.stage();
        } else if (isModel()) {
          Stage stage = model.stage();
          given.readsAssets(one, stage.options().get(ModelOption.ASSETS), () -> modelFiles(one));
        } else {
          model.requireNone();
        }
      } catch (ParameterException e) {
        throw new ParameterException(e.getCommandLine(), one + ": " + e.getMessage(), e);
      }
    }
    choose(chosen);
  }

  private Set<Path> modelFiles(Path file) throws SceneFormatException, IOException {
    SceneFile read = StagedModel.read(file, model.stage(), parser()).scene();
    return read.assetPaths(read.text().orElseThrow().path());
  }

  /**
   * Adds the scene and its asset files to the files that a command reads. The files that a model
   * names are checked when it has been read.
   *
   * @throws TaskException if standard input cannot be read
   */
  public OutputGuard guardedBy(OutputGuard given) throws TaskException {
    if (isModel()) {
      guard = Optional.of(given);
      return isStandardInput()
          ? given.reads(Path.of("/dev/stdin"), "standard input")
          : given.reads(scene, "the model");
    }
    if (!isStandardInput()) {
      return given.readsScene(scene);
    }
    byte[] content = standardInput();
    return given
        .reads(Path.of("/dev/stdin"), "standard input")
        .readsAssets(scene, () -> SceneParser.files(content, PictureOutput.STDIN));
  }

  /**
   * Returns the files that the scene depends on; those that cannot be found out are left out.
   *
   * @param last the scene as it was read last; empty if it was never valid
   */
  public Set<Path> files(Optional<SceneFile> last) {
    Set<Path> files = new LinkedHashSet<>(Set.of(scene.toAbsolutePath()));
    Optional<SceneText> around = last.flatMap(SceneFile::text);
    try {
      files.addAll(
          around.isPresent()
              ? last.get().assetPaths(around.get().path())
              : SceneParser.files(scene));
    } catch (SceneFormatException | IOException e) {
      // Reading the scene reports what is wrong with it.
      return files;
    }
    return files;
  }

  /**
   * Makes the scene one frame of a sequence.
   *
   * @throws ParameterException that names the flag, if a flag does not suit it
   */
  public void move(Motion newMotion) {
    model.requireSuits(newMotion);
    motion = Optional.of(newMotion);
  }

  /** Chooses one of the frames of the sequence. */
  public void choose(int index) {
    frame = index;
  }

  /**
   * Returns the frames of the sequence; reads the model if it has not been read.
   *
   * @throws IOException if the model cannot be read
   */
  public ModelSequence sequence(SceneParser parser)
      throws SceneFormatException, TaskException, IOException {
    if (sequence.isEmpty()) {
      Optional<byte[]> content =
          isStandardInput() ? Optional.of(standardInput()) : Optional.empty();
      Path named = isStandardInput() ? PictureOutput.STDIN : scene;
      Motion moving = motion.orElseThrow();
      sequence =
          Optional.of(
              isImported()
                  ? ModelSequence.of(
                      importing.orElseThrow().source(parser, scene), model.stage(), moving)
                  : ModelSequence.of(parser, named, content, model.stage(), moving));
    }
    return sequence.get();
  }

  /**
   * Returns the hash of the scene of a frame of the sequence that has been read.
   *
   * @throws IOException if the model cannot be read
   */
  public String hash(int index) throws SceneFormatException, IOException {
    return sequence.orElseThrow().hash(index);
  }

  private SceneFile parsed(byte[] content, SceneParser parser)
      throws SceneFormatException, TaskException, IOException {
    return isModel()
        ? StagedModel.read(
                PictureOutput.STDIN.toString(), content, ModelFolder.NONE, model.stage(), parser)
            .scene()
        : parser.parse(content, PictureOutput.STDIN);
  }

  private byte[] standardInput() throws TaskException {
    model.requireNoAssets();
    try {
      if (text.isEmpty()) {
        text = Optional.of(System.in.readAllBytes());
      }
      return text.get();
    } catch (IOException e) {
      throw ExitCode.SCENE.failure("standard input cannot be read: " + FileFailure.reason(e), e);
    }
  }

  public boolean isStrict() {
    return strictness.strict;
  }

  public boolean isLenient() {
    return strictness.lenient;
  }

  /** Returns a parser, lenient if the flags say so. */
  public SceneParser parser() {
    SceneParser parser = new SceneParser();
    return strictness.lenient ? parser.lenient() : parser;
  }

  /**
   * Prints the heap that a large model takes, before it is read; once.
   *
   * @throws TaskException if standard input cannot be read
   */
  public void announce(Messages messages) throws TaskException {
    if (!isStandardInput() && !isImported() && isModel()) {
      HeapNeed.note(scene).filter(warned::add).ifPresent(messages::line);
    }
  }

  /**
   * Reads the scene and prints its warnings, each once.
   *
   * @throws TaskException if there are warnings under {@code --strict}
   * @throws IOException if the scene cannot be read
   */
  public SceneFile load(SceneParser parser, Messages messages)
      throws SceneFormatException, TaskException, IOException {
    SceneFile file = read(parser);
    if (guard.isPresent() && isModel()) {
      guard.get().checkAssets(scene, file.assetPaths(file.text().orElseThrow().path()));
    }
    file.warnings().stream().map(ProblemText::of).filter(warned::add).forEach(messages::warning);
    if (isStrict() && !file.warnings().isEmpty()) {
      int count = file.warnings().size();
      String warnings = count == 1 ? "1 warning" : count + " warnings";
      throw ExitCode.WARNINGS.failure(
          scene + ": " + warnings + "; --strict treats warnings as errors");
    }
    return file;
  }

  /**
   * Reads the scene without printing its warnings.
   *
   * @throws IOException if the scene cannot be read
   */
  public SceneFile read(SceneParser parser)
      throws SceneFormatException, TaskException, IOException {
    if (motion.isPresent()) {
      return sequence(parser).frame(frame);
    }
    importing.ifPresent(flag -> flag.requireSuits(scene, isStandardInput()));
    if (isStandardInput()) {
      return parsed(standardInput(), parser);
    }
    if (isImported()) {
      Stage stage = model.stage();
      return importing.orElseThrow().source(parser, scene).scene(stage);
    }
    if (isModel()) {
      return StagedModel.read(scene, model.stage(), parser).scene();
    }
    requireScene();
    model.requireNone();
    return parser.parse(scene);
  }

  private void requireScene() throws SceneFormatException, TaskException, IOException {
    try {
      SceneParser.requireScene(scene);
    } catch (SceneFormatException e) {
      String advice = importing.map(flag -> flag.advice(scene)).orElse("");
      if (advice.isEmpty()) {
        throw e;
      }
      throw ExitCode.SCENE.failure(ProblemText.of(e.problems().get(0)) + advice, e);
    }
  }
}
