package io.github.lumbre.scenefile;

import io.github.lumbre.base.file.FileContent;
import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.internal.Sha256;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.internal.ModelReader;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.internal.SceneInside;
import io.github.lumbre.scenefile.SceneFormatException.Kind;
import io.github.lumbre.scenefile.internal.CountingParser;
import io.github.lumbre.scenefile.internal.FileHashes;
import io.github.lumbre.scenefile.internal.ModelSequence;
import io.github.lumbre.scenefile.internal.ParsedScene;
import io.github.lumbre.stage.drawing.LineDrawing;
import io.github.lumbre.texture.internal.ImageTexture.Filter;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.LongAdder;
import java.util.function.UnaryOperator;

/** Reads scene files. Immutable: each configuration method returns a new parser. */
public final class SceneParser {
  /** The default limit of the full frame: width × height in pixels. */
  public static final int MAX_PIXELS = 1 << 28;

  /** The largest limit that can be set: width × height in pixels. */
  public static final int MAX_PIXELS_EVER = 1 << 29;

  static {
    CountingParser.madeBy(SceneParser::counting);
    ModelSequence.madeBy(SceneParser::sequence);
  }

  private final boolean lenient;
  private final SettingsChange settings;
  private final TextureChange textures;
  private final Optional<Kernel> kernel;
  private final List<Path> assets;

  /** Creates a parser without overrides: missing assets are errors, settings are the file's. */
  public SceneParser() {
    this(false, SettingsChange.NONE, TextureChange.NONE, Optional.empty(), List.of());
  }

  private SceneParser(
      boolean lenient,
      SettingsChange settings,
      TextureChange textures,
      Optional<Kernel> kernel,
      List<Path> assets) {
    this.lenient = lenient;
    this.settings = settings;
    this.textures = textures;
    this.kernel = kernel;
    this.assets = List.copyOf(assets);
  }

  /**
   * Returns a parser that reports references to missing assets, and missing pictures of glTF models
   * in scenes, as warnings, not errors.
   */
  public SceneParser lenient() {
    return new SceneParser(true, settings, textures, kernel, assets);
  }

  /** Returns a parser that overrides the render mode of the file. */
  public SceneParser inMode(RenderSettings.Mode newMode) {
    return new SceneParser(lenient, settings.inMode(newMode), textures, kernel, assets);
  }

  /** Returns a parser that applies a function to the file's settings before it uses them. */
  public SceneParser overriding(UnaryOperator<RenderSettings> newChange) {
    return new SceneParser(lenient, settings.overriding(newChange), textures, kernel, assets);
  }

  /**
   * Returns a parser that rejects scenes whose full frame exceeds a limit. The default is {@link
   * #MAX_PIXELS}, 2^28 pixels.
   *
   * @param newMaxPixels limit of width × height in pixels, from 1 to {@link #MAX_PIXELS_EVER}
   * @throws IllegalArgumentException if the limit is out of range
   */
  public SceneParser limitedTo(int newMaxPixels) {
    if (newMaxPixels < 1 || newMaxPixels > MAX_PIXELS_EVER) {
      throw new IllegalArgumentException("pixels: expected 1 to 2^29, found " + newMaxPixels);
    }
    return limitedTo(limits().withPixels(newMaxPixels));
  }

  /**
   * Returns a parser that rejects what exceeds limits, as early as possible: files before they are
   * read, pictures and meshes before memory is allocated for them.
   *
   * @param newLimits of one scene with all its assets; pixels in addition at most {@link
   *     #MAX_PIXELS_EVER}
   */
  public SceneParser limitedTo(Limits newLimits) {
    return new SceneParser(lenient, settings.limitedTo(newLimits), textures, kernel, assets);
  }

  /**
   * Returns a parser that overrides the filter of all textures.
   *
   * @param interpolated whether a texture is interpolated bilinearly between its texels
   */
  public SceneParser interpolatingTextures(boolean interpolated) {
    TextureChange changed = textures.filtering(interpolated ? Filter.BILINEAR : Filter.NEAREST);
    return new SceneParser(lenient, settings, changed, kernel, assets);
  }

  private SceneParser counting(LongAdder lookUps) {
    TextureChange changed = textures.counting(Objects.requireNonNull(lookUps, "lookUps"));
    return new SceneParser(lenient, settings, changed, kernel, assets);
  }

  /** Returns a parser whose scenes use a traversal kernel; the default is {@link Kernel#AUTO}. */
  public SceneParser searchedBy(Kernel newKernel) {
    return new SceneParser(lenient, settings, textures, Optional.of(newKernel), assets);
  }

  /**
   * Returns a parser for the text of a scene around a model that was read with further folders of
   * files, see {@link ModelOption#ASSETS}: that model gets them again. Scenes that name models
   * among other objects get none.
   */
  public SceneParser withAssets(List<Path> folders) {
    return new SceneParser(lenient, settings, textures, kernel, folders);
  }

  /**
   * Reads a scene and the asset files it uses.
   *
   * @throws SceneFormatException if the scene does not exist or cannot be used; it lists the errors
   * @throws CancellationException if the calling thread is interrupted; the parser reacts within a
   *     fraction of a second and leaves the interrupt status set
   * @throws IOException if the file exists but cannot be read
   */
  public SceneFile parse(Path file) throws SceneFormatException, IOException {
    Problems problems = new Problems(String.valueOf(file.getFileName()));
    return TimedReading.of(
        limits(),
        problems,
        () -> {
          byte[] text = InputFile.read(file, problems, "scene", "bytes", limits().bytes());
          return parse(file, text, Optional.empty(), Map.of(), Optional.empty(), problems);
        });
  }

  /**
   * Reads a model and builds the scene around it. The parser's settings may state the picture's
   * size; otherwise its longer side is 1024, with the aspect ratio of the model's camera, or 4:3.
   * The model may lack pictures.
   *
   * @param model path of a glTF, OBJ, PLY, STL, OFF, 3MF or ZIP file
   * @throws SceneFormatException if the model does not exist or cannot be used; it lists the errors
   * @throws IOException if the model exists but cannot be read, or the thread is interrupted
   */
  public SceneFile parse(Path model, Stage stage) throws SceneFormatException, IOException {
    return TimedReading.of(
        limits(), problemsOf(model), () -> staged(model, inMotion(stage), false).scene(this));
  }

  private Stage inMotion(Stage stage) {
    return stage.reading(settings.inMotion(stage.options()));
  }

  /**
   * Builds the scene around a model in one file, such as a GLB file or a ZIP archive, whose bytes
   * are known; see {@link #parse(String, byte[], ModelFolder, Stage)}.
   */
  public SceneFile parse(String name, byte[] model, Stage stage)
      throws SceneFormatException, IOException {
    return parse(name, model, ModelFolder.NONE, stage);
  }

  /**
   * Builds the scene around a model whose bytes are known; see {@link #parse(Path, Stage)}. Nothing
   * is read from files, except what the folder reads and a picture of a sky that the stage names.
   *
   * @param name of the model without folders; its ending chooses the format
   * @param model bytes of the file
   * @param files has other files that the model names
   * @throws SceneFormatException if the model cannot be used; it lists the errors
   * @throws IOException if the calling thread is interrupted
   */
  public SceneFile parse(String name, byte[] model, ModelFolder files, Stage stage)
      throws SceneFormatException, IOException {
    Path file = inNoFolder(name);
    return TimedReading.of(
        limits(),
        problemsOf(file),
        () -> staged(file, model, files, inMotion(stage), false).scene(this));
  }

  private static Path inNoFolder(String name) {
    Path here = Path.of("").toAbsolutePath();
    Path file = here.resolve(name).normalize();
    if (!here.equals(file.getParent())) {
      throw new IllegalArgumentException(
          "name: expected a name without folders, found " + PrintableText.quoted(name));
    }
    return file;
  }

  private StagedModel staged(
      Path file, byte[] model, ModelFolder files, Stage stage, boolean isFrame)
      throws SceneFormatException, IOException {
    Stage lenient = stage.reading(stage.options().lenient(true));
    return new StagedModel(
        lenient, stage.folderOf(file), file, model, Optional.of(files), limits(), isFrame);
  }

  /**
   * Reads a model and builds the scene around it for several views. The scenes share meshes,
   * hierarchies and textures; their pictures have the bits of {@link #parse(Path, Stage)} with
   * {@link Stage#seenFrom}.
   *
   * @param model path of a glTF, OBJ, PLY, STL, OFF, 3MF or ZIP file
   * @param views at least one
   * @throws SceneFormatException if the model does not exist or cannot be used; it lists the errors
   * @throws IOException if the model exists but cannot be read, or the thread is interrupted
   */
  public ModelViews parse(Path model, Stage stage, List<Stage.View> views)
      throws SceneFormatException, IOException {
    return TimedReading.of(
        limits(),
        problemsOf(model),
        () -> new ModelViews(staged(model, stage.seenFrom(views.get(0)), false), views, this));
  }

  /**
   * Builds the scenes around a model whose bytes are known for several views; see {@link
   * #parse(Path, Stage, List)} and {@link #parse(String, byte[], ModelFolder, Stage)}.
   */
  public ModelViews parse(
      String name, byte[] model, ModelFolder files, Stage stage, List<Stage.View> views)
      throws SceneFormatException, IOException {
    Path file = inNoFolder(name);
    return TimedReading.of(
        limits(),
        problemsOf(file),
        () ->
            new ModelViews(
                staged(file, model, files, stage.seenFrom(views.get(0)), false), views, this));
  }

  private ModelSequence sequence(
      Path model, Optional<byte[]> content, Stage stage, ModelSequence.Motion motion)
      throws SceneFormatException, IOException {
    Path file = content.isPresent() ? inNoFolder(model.toString()) : model;
    String name = String.valueOf(file.getFileName());
    StagedFrames.Source source =
        content.isPresent()
            ? (of, isFrame) -> staged(file, content.get(), ModelFolder.NONE, of, isFrame)
            : (of, isFrame) -> staged(file, of, isFrame);
    return TimedReading.of(
        limits(),
        problemsOf(file),
        () ->
            motion.turns() > 0
                ? new StagedTurntable(this, source, name, stage, motion.turns())
                : new StagedAnimation(
                    this, source, name, stage, motion.animation(), motion.rate()));
  }

  private static Problems problemsOf(Path model) {
    return new Problems(String.valueOf(model.getFileName()), true);
  }

  private StagedModel staged(Path model, Stage stage, boolean isFrame)
      throws SceneFormatException, IOException {
    Path file = model.toAbsolutePath().normalize();
    Stage lenient = stage.reading(stage.options().lenient(true));
    return staged(file, lenient, stage.folderOf(file), isFrame);
  }

  private StagedModel staged(Path file, Stage stage, Path folder, boolean isFrame)
      throws SceneFormatException, IOException {
    byte[] content =
        InputFile.read(file, problemsOf(file), "model", "bytes in all files", limits().bytes());
    return new StagedModel(stage, folder, file, content, Optional.empty(), limits(), isFrame);
  }

  /**
   * Reads a model and builds the scene around it, whose text is to be written to a file. A missing
   * picture is an error unless the options of the stage are lenient, as it is in a scene.
   *
   * @param folder where asset paths start; contains the model and the sky's picture
   * @throws SceneFormatException if the scene cannot be used; it lists the errors
   * @throws IOException if the model exists but cannot be read, or the thread is interrupted
   */
  public SceneFile parse(Path folder, Path model, Stage stage)
      throws SceneFormatException, IOException {
    Path file = model.toAbsolutePath().normalize();
    // In the scene, the model may use files of the scene's folder.
    Stage inScene = stage.reading(stage.options().with(ModelOption.ASSETS, List.of(folder)));
    return TimedReading.of(
        limits(), problemsOf(file), () -> staged(file, inScene, folder, false).scene(this));
  }

  /** Returns what the parser makes of settings. */
  SettingsChange settings() {
    return settings;
  }

  private Limits limits() {
    return settings.limits();
  }

  boolean isLenient() {
    return lenient;
  }

  TextureChange textures() {
    return textures;
  }

  Kernel kernel() {
    return kernel.orElse(Kernel.AUTO);
  }

  /**
   * Reads a scene from the content of a file.
   *
   * @param content the scene as JSON in UTF-8
   * @param file path of the scene file, which need not exist; asset paths start in its folder, and
   *     messages contain its name
   * @throws SceneFormatException if the scene cannot be used; it lists the errors
   * @throws CancellationException if the calling thread is interrupted
   */
  public SceneFile parse(byte[] content, Path file) throws SceneFormatException {
    return parse(new SceneText(content, file));
  }

  /**
   * Reads a scene that is not in a file; see {@link #parse(byte[], Path)}.
   *
   * @throws SceneFormatException if the scene cannot be used; it lists the errors
   * @throws CancellationException if the calling thread is interrupted
   */
  public SceneFile parse(SceneText text) throws SceneFormatException {
    return parse(text, Map.of(), Optional.empty());
  }

  /**
   * Reads a scene that is not in a file.
   *
   * @param files bytes of asset files that need not exist, by the names that assets use
   * @param known the same scene, if code has built it
   */
  SceneFile parse(SceneText text, Map<String, byte[]> files, Optional<Scene> known)
      throws SceneFormatException {
    Path file = text.path();
    Problems problems = new Problems(String.valueOf(file.getFileName()), ModelReader.isModel(file));
    try {
      return TimedReading.of(
          limits(),
          problems,
          () -> parse(file, text.json(), Optional.of(text), files, known, problems));
    } catch (IOException e) {
      throw new UncheckedIOException(e); // The content is in memory.
    }
  }

  /**
   * Returns the existing files that a scene's assets name, whether the scene uses them or not.
   * Files outside the scene's folder are left out.
   *
   * @throws SceneFormatException if the file does not exist or contains no scene
   * @throws IOException if the file exists but cannot be read
   */
  public static Set<Path> files(Path file) throws SceneFormatException, IOException {
    Problems problems = new Problems(String.valueOf(file.getFileName()));
    return files(InputFile.read(file, problems, "scene", "bytes", AssetData.MAX_BYTES), file);
  }

  /**
   * Returns the existing files that a scene's assets name; see {@link #files(Path)} and {@link
   * #parse(byte[], Path)}.
   *
   * @throws SceneFormatException if the content is not a scene
   * @throws IOException if the folder cannot be read
   */
  public static Set<Path> files(byte[] content, Path file)
      throws SceneFormatException, IOException {
    return InputFile.namedBy(content, file);
  }

  private SceneFile parse(
      Path file,
      byte[] text,
      Optional<SceneText> source,
      Map<String, byte[]> files,
      Optional<Scene> known,
      Problems problems)
      throws SceneFormatException {
    Allowance allowance = new Allowance(limits());
    Optional<String> excess = allowance.addBytes(text.length);
    if (excess.isPresent()) {
      problems.error(Kind.LIMIT, () -> "$", excess.get());
      throw problems.exception();
    }
    InputFile.requireScene(text, file, problems);
    JsonNode root = JsonNode.read(text, problems, limits());
    if (root.asObject().isEmpty()) {
      throw problems.exception();
    }
    root.warnUnknown(Key.names(SceneKeys.ALL));
    Optional<JsonNode> options = root.object(SceneKeys.OPTIONS.name());
    RenderSettings used = settings.read(options, problems);
    Optional<Rgb> background = options.flatMap(SettingsReader::background);
    SceneHash hash = new SceneHash();
    hash.text(text);
    AssetTable table = new AssetTable(root, lenient);
    AssetData data = new AssetData(file, hash, allowance, files, assets);
    SceneReader world =
        new SceneReader(
            root, table, data, used, textures, kernel(), String.valueOf(file.getFileName()));
    world.read(used.aspect(), background);
    problems.throwIfAny();
    Scene scene = world.scene(known);
    requireNumbers(scene, used, problems);
    warnOfLines(scene, used, new Spot(problems, () -> "$.renderOptions.lineWidth"));
    return new ParsedScene(
        scene,
        used,
        problems.warnings(),
        hash.value(),
        new FileHashes(Sha256.of(text), data.hashes()),
        world.contents(),
        world.origins(),
        source,
        Optional.empty());
  }

  /** Warns of lines that settings ask for and a scene lacks. */
  static void warnOfLines(Scene scene, RenderSettings settings, Spot spot) {
    LineDrawing.lack(scene, settings).ifPresent(spot::warn);
  }

  /** Requires that all poses number their parts and lights alike if layers record the numbers. */
  static void requireNumbers(Scene scene, RenderSettings settings, Problems problems)
      throws SceneFormatException {
    SceneInside middle = SceneInside.of(scene);
    List<SceneInside> poses = scene.poses().stream().map(SceneInside::of).toList();
    boolean haveParts = poses.stream().allMatch(pose -> pose.names().equals(middle.names()));
    boolean haveLights =
        poses.stream().allMatch(pose -> pose.lightGroups().isLike(middle.lightGroups()));
    boolean areParts =
        settings.layers().contains(Layer.OBJECT) || settings.layers().contains(Layer.MATERIAL);
    if (areParts && !haveParts || settings.layers().contains(Layer.LIGHTS) && !haveLights) {
      problems.error(
          Kind.INVALID,
          () -> "layers",
          "expected the same parts and lights in all poses for layers of objects, materials and"
              + " lights, found some that appear or vanish");
      throw problems.exception();
    }
  }

  /**
   * Refuses a file that is neither a scene nor a model, by its first bytes, and names its kind.
   *
   * @throws SceneFormatException if it is of another kind; not if it does not exist
   * @throws IOException if it cannot be read
   */
  public static void requireScene(Path file) throws SceneFormatException, IOException {
    if (Files.isRegularFile(file)) {
      try (InputStream in = Files.newInputStream(file)) {
        Problems problems = new Problems(String.valueOf(file.getFileName()));
        InputFile.requireScene(in.readNBytes(FileContent.START), file, problems);
      }
    }
  }
}
