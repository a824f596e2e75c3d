package io.github.lumbre.parser;

import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.parser.SceneFormatException.Kind;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.texture.ImageTexture;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.channels.ClosedByInterruptException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.LongAdder;
import java.util.function.UnaryOperator;

/** Reads scene files. Immutable: each method that changes how it reads returns another parser. */
public final class SceneParser {
  /** The largest product of width and height, unless another limit is set. */
  public static final int MAX_PIXELS = 1 << 28;

  /** The largest product of width and height that can be set. */
  public static final int MAX_PIXELS_EVER = 1 << 29;

  /** Beyond this, an array of Java cannot hold a file. */
  private static final long MAX_BYTES = Integer.MAX_VALUE - 8L;

  /** Keys of a scene; {@code $schema} names the schema for editors. */
  static final Set<String> KEYS =
      Set.of("$schema", "mainCameraId", "renderOptions", "assets", "objects", "name");

  private final boolean lenient;
  private final Optional<RenderSettings.Mode> mode;
  private final UnaryOperator<RenderSettings> change;
  private final int maxPixels;
  private final TextureChange textures;
  private final boolean decodesUnused;
  private final Optional<Kernel> kernel;

  /** A parser that takes scene files as they are. */
  public SceneParser() {
    this(
        false,
        Optional.empty(),
        UnaryOperator.identity(),
        MAX_PIXELS,
        TextureChange.NONE,
        false,
        Optional.empty());
  }

  private SceneParser(
      boolean lenient,
      Optional<RenderSettings.Mode> mode,
      UnaryOperator<RenderSettings> change,
      int maxPixels,
      TextureChange textures,
      boolean decodesUnused,
      Optional<Kernel> kernel) {
    this.lenient = lenient;
    this.mode = mode;
    this.change = change;
    this.maxPixels = maxPixels;
    this.textures = textures;
    this.decodesUnused = decodesUnused;
    this.kernel = kernel;
  }

  /** Returns a parser that takes references to missing assets as warnings. */
  public SceneParser lenient() {
    return new SceneParser(true, mode, change, maxPixels, textures, decodesUnused, kernel);
  }

  /** Returns a parser that overrides the render mode of the file. */
  public SceneParser inMode(RenderSettings.Mode newMode) {
    return new SceneParser(
        lenient, Optional.of(newMode), change, maxPixels, textures, decodesUnused, kernel);
  }

  /** Returns a parser that changes the settings that the file gives before it uses them. */
  public SceneParser overriding(UnaryOperator<RenderSettings> newChange) {
    return new SceneParser(
        lenient,
        mode,
        Objects.requireNonNull(newChange, "newChange"),
        maxPixels,
        textures,
        decodesUnused,
        kernel);
  }

  /**
   * Returns a parser that refuses scenes whose full frame has more pixels, 2^28 of them by default.
   *
   * @param newMaxPixels from 1 to {@link #MAX_PIXELS_EVER}
   */
  public SceneParser limitedTo(int newMaxPixels) {
    if (newMaxPixels < 1 || newMaxPixels > MAX_PIXELS_EVER) {
      throw new IllegalArgumentException("pixels: expected 1 to 2^29, found " + newMaxPixels);
    }
    return new SceneParser(lenient, mode, change, newMaxPixels, textures, decodesUnused, kernel);
  }

  /** Returns a parser that overrides the filter of all textures. */
  public SceneParser filtering(ImageTexture.Filter filter) {
    TextureChange changed = textures.filtering(Objects.requireNonNull(filter, "filter"));
    return new SceneParser(lenient, mode, change, maxPixels, changed, decodesUnused, kernel);
  }

  /** Returns a parser whose textures count their look-ups. */
  public SceneParser countingTextures(LongAdder lookUps) {
    TextureChange changed = textures.counting(Objects.requireNonNull(lookUps, "lookUps"));
    return new SceneParser(lenient, mode, change, maxPixels, changed, decodesUnused, kernel);
  }

  /**
   * Returns a parser that decodes meshes and textures that nothing uses, too, and finds their
   * errors. The scene is the same; the difference in time is what skipping them saves.
   */
  public SceneParser decodingUnused() {
    return new SceneParser(lenient, mode, change, maxPixels, textures, true, kernel);
  }

  /**
   * Returns a parser whose scenes are searched by a kernel; without this, by {@link Kernel#AUTO}.
   */
  public SceneParser searchedBy(Kernel newKernel) {
    return new SceneParser(
        lenient, mode, change, maxPixels, textures, decodesUnused, Optional.of(newKernel));
  }

  /**
   * Reads a scene.
   *
   * @throws SceneFormatException if the scene cannot be used, with all that is wrong
   * @throws InterruptedIOException if the calling thread is interrupted, which is noticed within a
   *     fraction of a second; the interrupt status stays set
   * @throws IOException if the file exists but cannot be read
   */
  public SceneFile parse(Path file) throws SceneFormatException, IOException {
    Problems problems = new Problems(String.valueOf(file.getFileName()));
    try {
      return parse(file, read(file, problems), problems);
    } catch (OutOfMemoryError e) {
      // What was to hold the scene is free again, and nothing else was touched.
      problems.error(Kind.LIMIT, () -> "$", "expected a scene that fits into memory");
      throw problems.exception();
    } catch (CancellationException | ClosedByInterruptException e) {
      InterruptedIOException interrupted =
          new InterruptedIOException("reading the scene was interrupted");
      interrupted.initCause(e);
      throw interrupted;
    }
  }

  /**
   * Reads a scene from the content of a file, which need not exist.
   *
   * @param content the scene, UTF-8
   * @param file in whose folder assets are, and whose name is in messages
   * @throws SceneFormatException if the scene cannot be used, with all that is wrong
   */
  public SceneFile parse(byte[] content, Path file) throws SceneFormatException {
    Problems problems = new Problems(String.valueOf(file.getFileName()));
    try {
      return parse(file, content, problems);
    } catch (OutOfMemoryError e) {
      // What was to hold the scene is free again, and nothing else was touched.
      problems.error(Kind.LIMIT, () -> "$", "expected a scene that fits into memory");
      throw problems.exception();
    }
  }

  /**
   * Returns the files that a scene's assets name and that exist, whether the scene uses them or
   * not.
   *
   * @throws SceneFormatException if the file holds no scene
   * @throws IOException if the file exists but cannot be read
   */
  public static Set<Path> files(Path file) throws SceneFormatException, IOException {
    return files(read(file, new Problems(String.valueOf(file.getFileName()))), file);
  }

  /**
   * Returns the files that a scene's assets name; see {@link #files(Path)} and {@link
   * #parse(byte[], Path)}.
   *
   * @throws SceneFormatException if the content is no scene
   * @throws IOException if the folder cannot be read
   */
  public static Set<Path> files(byte[] content, Path file)
      throws SceneFormatException, IOException {
    Problems problems = new Problems(String.valueOf(file.getFileName()));
    JsonNode root = JsonTree.read(content, problems);
    if (root.asObject().isEmpty()) {
      throw problems.exception();
    }
    return new AssetData(file, Sha256.digest()).files(root.objects("assets"));
  }

  private static byte[] read(Path file, Problems problems)
      throws SceneFormatException, IOException {
    try {
      if (Files.size(file) > MAX_BYTES) {
        problems.error(
            Kind.LIMIT,
            () -> "$",
            "expected at most " + MAX_BYTES + " bytes, found " + Files.size(file));
        throw problems.exception();
      }
      return Files.readAllBytes(file);
    } catch (NoSuchFileException e) {
      problems.error(Kind.INVALID, () -> "$", "expected a scene file, found none");
      throw problems.exception();
    }
  }

  private SceneFile parse(Path file, byte[] text, Problems problems) throws SceneFormatException {
    JsonNode root = JsonTree.read(text, problems);
    if (root.asObject().isEmpty()) {
      throw problems.exception();
    }
    root.warnUnknown(KEYS);
    Optional<JsonNode> options = root.object("renderOptions");
    RenderSettings settings = settings(options, problems);
    Optional<Rgb> background = options.flatMap(SettingsReader::background);
    MessageDigest digest = Sha256.digest();
    digest.update(text);
    String ownHash = Sha256.soFar(digest);
    AssetTable assets = new AssetTable(root, lenient);
    AssetData data = new AssetData(file, digest);
    SceneReader world =
        new SceneReader(root, assets, data, settings.seed(), textures, kernel.orElse(Kernel.AUTO));
    world.read(settings.aspect(), background);
    problems.throwIfAny();
    Scene scene = world.scene();
    SceneFile made =
        new SceneFile(
            scene,
            settings,
            problems.warnings(),
            HexFormat.of().formatHex(digest.digest()),
            new FileHashes(ownHash, data.hashes()),
            world.contents(),
            world.origins());
    if (decodesUnused) {
      world.decodeUnused();
      problems.throwIfAny();
    }
    return made;
  }

  /** Returns the settings; if the file's have errors, without the caller's changes. */
  private RenderSettings settings(Optional<JsonNode> options, Problems problems) {
    boolean hadErrors = problems.hasErrors();
    RenderSettings inFile =
        options
            .map(o -> SettingsReader.read(o, mode))
            .orElseGet(() -> SettingsReader.missing(mode));
    if (problems.hasErrors() && !hadErrors) {
      return inFile;
    }
    RenderSettings used = change.apply(inFile);
    if ((long) used.width() * used.height() > maxPixels) {
      boolean isInFile = used.width() == inFile.width() && used.height() == inFile.height();
      problems.error(
          Kind.LIMIT,
          () -> isInFile ? "$.renderOptions" : "the size that replaces that of $.renderOptions",
          "expected width x height <= "
              + maxPixels
              + ", found "
              + used.width()
              + "x"
              + used.height());
    }
    return used;
  }
}
