package io.github.lumbre.scenefile;

import io.github.lumbre.base.file.FileContent;
import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.internal.ModelReader;
import io.github.lumbre.model.program.ImportProgram.Imported;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scenefile.SceneFormatException.Kind;
import io.github.lumbre.scenefile.internal.FileHashes;
import io.github.lumbre.scenefile.internal.LateHash;
import io.github.lumbre.scenefile.internal.ModelParser;
import io.github.lumbre.scenefile.internal.ParsedScene;
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

  private final boolean lenient;
  private final SettingsChange settings;
  private final TextureChange textures;
  private final Optional<Kernel> kernel;
  private final boolean later;
  private final List<Path> assets;

  /** Creates a parser without overrides: missing assets are errors, settings are the file's. */
  public SceneParser() {
    this(false, SettingsChange.NONE, TextureChange.NONE, Optional.empty(), false, List.of());
  }

  private SceneParser(
      boolean lenient,
      SettingsChange settings,
      TextureChange textures,
      Optional<Kernel> kernel,
      boolean later,
      List<Path> assets) {
    this.lenient = lenient;
    this.settings = settings;
    this.textures = textures;
    this.kernel = kernel;
    this.later = later;
    this.assets = List.copyOf(assets);
  }

  /**
   * Returns a parser that reports references to missing assets, and missing pictures of glTF models
   * in scenes, as warnings, not errors.
   */
  public SceneParser lenient() {
    return new SceneParser(true, settings, textures, kernel, later, assets);
  }

  /** Returns a parser that overrides the render mode of the file. */
  public SceneParser inMode(RenderSettings.Mode newMode) {
    return new SceneParser(lenient, settings.inMode(newMode), textures, kernel, later, assets);
  }

  /** Returns a parser that applies a function to the file's settings before it uses them. */
  public SceneParser overriding(UnaryOperator<RenderSettings> newChange) {
    return new SceneParser(
        lenient, settings.overriding(newChange), textures, kernel, later, assets);
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
    return new SceneParser(lenient, settings.limitedTo(newLimits), textures, kernel, later, assets);
  }

  /**
   * Returns a parser that overrides the filter of all textures.
   *
   * @param interpolated whether a texture is interpolated bilinearly between its texels
   */
  public SceneParser interpolatingTextures(boolean interpolated) {
    TextureChange changed = textures.filtering(interpolated ? Filter.BILINEAR : Filter.NEAREST);
    return new SceneParser(lenient, settings, changed, kernel, later, assets);
  }

  /** Returns a parser whose textures increment a counter at each lookup, for measurements. */
  public SceneParser counting(LongAdder lookUps) {
    TextureChange changed = textures.counting(Objects.requireNonNull(lookUps, "lookUps"));
    return new SceneParser(lenient, settings, changed, kernel, later, assets);
  }

  /** Returns a parser whose scenes use a traversal kernel; the default is {@link Kernel#AUTO}. */
  public SceneParser searchedBy(Kernel newKernel) {
    return new SceneParser(lenient, settings, textures, Optional.of(newKernel), later, assets);
  }

  /**
   * Returns a parser whose scenes build their hierarchy when the first ray is traced, for those
   * that are checked and perhaps not rendered. Scenes in motion build it at once.
   */
  public SceneParser searchedLater() {
    return new SceneParser(lenient, settings, textures, kernel, true, assets);
  }

  /**
   * Returns a parser for the text of a scene around a model that was read with further folders of
   * files, see {@link ModelOption#ASSETS}: that model gets them again. Scenes that name models
   * among other objects get none.
   */
  public SceneParser withAssets(List<Path> folders) {
    return new SceneParser(lenient, settings, textures, kernel, later, folders);
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
          AssetData data = data(file, Map.of(), Optional.empty());
          return parse(file, text, Optional.empty(), data, Optional.empty(), problems);
        });
  }

  /** Returns this parser, as the stage of models uses it. */
  @SuppressWarnings("exports") // Other modules cannot name the type.
  public ModelParser ofModels() {
    return new LoneModels(this);
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

  boolean isSearchedLater() {
    return later;
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
    // The hash of the content is computed when it is asked for.
    return parse(new SceneText(content.clone(), file));
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
    return parse(text, data(text.path(), files, Optional.empty()), known);
  }

  /**
   * Reads a scene that stands for a model.
   *
   * @param imported the model, if a program has converted it
   */
  SceneFile parse(SceneText text, Optional<Imported> imported) throws SceneFormatException {
    return parse(text, data(text.path(), Map.of(), imported), Optional.empty());
  }

  private AssetData data(Path file, Map<String, byte[]> files, Optional<Imported> imported) {
    Allowance allowance = new Allowance(limits());
    return new AssetData(file, new ContentHash(), allowance, files, assets, imported);
  }

  private SceneFile parse(SceneText text, AssetData data, Optional<Scene> known)
      throws SceneFormatException {
    Path file = text.path();
    boolean isModel = data.imported().isPresent() || ModelReader.isModel(file);
    Problems problems = new Problems(String.valueOf(file.getFileName()), isModel);
    try {
      return TimedReading.of(
          limits(),
          problems,
          () -> parse(file, text.json(), Optional.of(text), data, known, problems));
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
      AssetData data,
      Optional<Scene> known,
      Problems problems)
      throws SceneFormatException {
    Optional<String> excess = data.allowance().addBytes(text.length);
    if (excess.isPresent()) {
      problems.error(Kind.LIMIT, () -> "$", excess.get());
      throw problems.exception();
    }
    InputFile.requireScene(text, file, problems);
    JsonNode root = JsonNode.read(text, problems, limits());
    if (root.asObject().isEmpty()) {
      throw problems.exception();
    }
    root.warnUnknown(Key.names(RootKeys.ALL));
    Optional<JsonNode> options = root.object(RootKeys.OPTIONS.name());
    RenderSettings used = settings.read(options, problems);
    Optional<Rgb> background = options.flatMap(SettingsReader::background);
    data.noteText(text);
    AssetTable table = new AssetTable(root, lenient);
    SceneReader world =
        new SceneReader(
            root,
            table,
            data,
            used,
            textures,
            kernel(),
            String.valueOf(file.getFileName()),
            Optional.empty());
    if (later) {
      world.searchLater();
    }
    world.read(used.aspect(), background);
    problems.throwIfAny();
    Scene scene = world.scene(known);
    SceneChecks.requireNumbers(scene, used, problems);
    SceneChecks.warnOfLines(
        scene, used, new ProblemPlace(problems, () -> "$.renderOptions.lineWidth"));
    return new ParsedScene(
        scene,
        used,
        problems.warnings(),
        data.hash(),
        new FileHashes(LateHash.of(text), data.hashes()),
        world.contents(),
        world.origins(),
        source,
        Optional.empty(),
        data.imported());
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
