package io.github.lumbre.scenefile;

import io.github.lumbre.base.file.FileFailure;
import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.AllowedFolders;
import io.github.lumbre.model.internal.FileSearch;
import io.github.lumbre.model.internal.ModelReader;
import io.github.lumbre.model.program.ImportProgram.Imported;
import io.github.lumbre.scenefile.SceneFormatException.Kind;
import io.github.lumbre.scenefile.internal.LateHash;
import java.io.IOException;
import java.nio.channels.ClosedByInterruptException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Arrays;
import java.util.Base64;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Pattern;

/**
 * Reads the bytes of assets: base64 text inside the scene file, or files in the scene's folder or
 * below. Files outside this folder are rejected.
 */
final class AssetData {
  private static final Pattern URL = Pattern.compile("^[A-Za-z][A-Za-z0-9+.-]*:.*", Pattern.DOTALL);

  /** The largest file, in bytes, that fits into a Java array. */
  static final long MAX_BYTES = Integer.MAX_VALUE - 8L;

  private final Path sceneFile;
  private final ContentHash hash;
  private final Allowance allowance;
  private final Map<String, LateHash> hashes = new TreeMap<>();

  /** Bytes of files that wait to be hashed. */
  private long waiting;


  /** Files that need not exist: their bytes by the names that assets use. */
  private final Map<String, byte[]> inMemory;

  private final List<Path> modelAssets;

  /** The model for which the scene stands, if a program has converted it. */
  private final Optional<Imported> imported;

  /**
   * @param sceneFile path of the scene file; relative asset paths start in its folder
   * @param hash receives the bytes of all files that are read
   * @param allowance what may be read
   * @param inMemory bytes of files that are not read from the folder, by their names
   * @param modelAssets further folders of the model for which a scene stands; others have none
   * @param imported the model for which the scene stands, if a program has converted it
   */
  AssetData(
      Path sceneFile,
      ContentHash hash,
      Allowance allowance,
      Map<String, byte[]> inMemory,
      List<Path> modelAssets,
      Optional<Imported> imported) {
    this.sceneFile = sceneFile;
    this.hash = hash;
    this.allowance = allowance;
    this.inMemory = Map.copyOf(inMemory);
    this.modelAssets = List.copyOf(modelAssets);
    this.imported = imported;
  }

  /** Returns the model for which the scene stands, if a program has converted it. */
  Optional<Imported> imported() {
    return imported;
  }

  /** Returns further folders of files of the model for which the scene stands. */
  List<Path> modelAssets() {
    return modelAssets;
  }

  /** Returns what may be read of the scene. */
  Allowance allowance() {
    return allowance;
  }

  /** The bytes of an asset, and the place at which their problems are reported. */
  record Content(ProblemPlace place, byte[] bytes) {
    void error(Kind kind, String message) {
      place.error(kind, message);
    }

    void warn(String message) {
      place.warn(message);
    }
  }

  /**
   * Returns the bytes of an asset; empty, with an error added, if they cannot be read.
   *
   * @param base64 key of the base64 text; ignored with a warning if the asset names a file
   */
  Optional<Content> read(JsonNode asset, Key<String> base64) {
    if (ObjectKeys.FILE.isIn(asset)) {
      if (base64.isIn(asset)) {
        base64.warn(asset, "is ignored, because the asset names a file");
      }
      return ObjectKeys.FILE
          .stated(asset)
          .flatMap(name -> file(asset.problemPlace(ObjectKeys.FILE.name()), name));
    }
    if (!base64.isIn(asset)) {
      base64.error(asset, "expected " + base64.name() + " or file, found neither");
      return Optional.empty();
    }
    return base64.stated(asset).flatMap(text -> decoded(asset.problemPlace(base64.name()), text));
  }

  /**
   * Returns the files that assets or objects name, if they exist and are in the scene's folder or
   * below.
   *
   * @param key that holds the name
   */
  Set<Path> files(List<JsonNode> assets, Key<String> key) throws IOException {
    Path folder = folder();
    Set<Path> files = new LinkedHashSet<>();
    for (JsonNode asset : assets) {
      key.stated(asset)
          .flatMap(AssetData::validRelative)
          .map(path -> folder.resolve(path).normalize())
          .filter(path -> path.startsWith(folder) && Files.isRegularFile(path))
          .ifPresent(files::add);
    }
    return files;
  }

  /**
   * Returns access to the files that a model names, relative to the model's own folder. It adds no
   * errors to the scene: a model may do without some of its files.
   *
   * @param model name of the model file, relative to the scene's folder
   */
  ModelFolder folderOf(String model) {
    String parent = model.substring(0, model.lastIndexOf('/') + 1);
    Path folder = sceneFile.toAbsolutePath().normalize().getParent();
    Optional<FileSearch> search =
        validRelative(parent + "x")
            .map(path -> folder.resolve(path).normalize().getParent())
            .filter(path -> path.startsWith(folder))
            .map(FileSearch::new);
    ModelFolder files =
        (name, location) -> {
          try {
            return bytes(parent + name);
          } catch (Unusable e) {
            throw e.inModel(location);
          }
        };
    return files.searchedBy(name -> search.map(s -> s.of(name)).orElse(List.of()));
  }

  /**
   * Returns access to the files that a model names which is rendered by itself: those in its own
   * folder and in those of the options. It adds no errors to the scene.
   *
   * @param model name of the model file, relative to the scene's folder
   */
  ModelFolder ownFolderOf(String model, ModelOptions options) {
    String parent = model.substring(0, model.lastIndexOf('/') + 1);
    Path folder = sceneFile.toAbsolutePath().resolveSibling(parent).normalize();
    AllowedFolders allowed = AllowedFolders.of(folder, options);
    ModelFolder files =
        (name, location) -> {
          try {
            return inMemory.containsKey(parent + name)
                ? bytes(parent + name)
                : bytes(allowed, parent, name);
          } catch (Unusable e) {
            throw e.inModel(location);
          }
        };
    return files.searchedBy(allowed::similar);
  }

  private byte[] bytes(AllowedFolders allowed, String parent, String name) throws Unusable {
    try {
      Optional<Path> found = isPath(name) ? allowed.find(name) : Optional.empty();
      Path path = found.orElseThrow(() -> new Unusable(Kind.ASSET, allowed.refusal(name)));
      requireFile(name, path);
      byte[] bytes = Files.readAllBytes(path);
      note(allowed.isOwn(path) ? parent + name : slashed(path), bytes);
      return bytes;
    } catch (NoSuchFileException e) {
      throw Unusable.missing(name);
    } catch (ClosedByInterruptException e) {
      throw Interrupts.cancelled(e);
    } catch (InvalidPathException e) {
      throw Unusable.unreadable(name, FileFailure.reason(e));
    } catch (IOException e) {
      throw Unusable.unreadable(name, FileFailure.reason(e));
    }
  }

  /**
   * Returns a folder whose files are counted and noted as files of the scene. They are copied: the
   * caller may change them before they are hashed.
   */
  ModelFolder counted(ModelFolder files) {
    ModelFolder counting =
        (name, location) -> {
          byte[] bytes = files.read(name, location);
          Optional<String> excess = allowance.addBytes(bytes.length);
          if (excess.isPresent()) {
            throw ModelFormatException.Kind.TOO_LARGE.at(location, excess.get());
          }
          note(name, bytes.clone());
          return bytes;
        };
    return counting.searchedBy(files::similar);
  }

  /** Returns the model files that objects name, and the files that these name, if they exist. */
  Set<Path> modelFiles(List<JsonNode> models) throws IOException {
    Set<Path> all = new LinkedHashSet<>(files(models, ObjectKeys.FILE));
    for (Path model : List.copyOf(all)) {
      Path folder = model.getParent();
      ModelFolder recording =
          (name, location) -> {
            Optional<Path> file = validRelative(name).map(folder::resolve).map(Path::normalize);
            if (file.filter(Files::isRegularFile).isEmpty() || !file.get().startsWith(folder())) {
              throw ModelFormatException.Kind.ASSET.at(location, name);
            }
            all.add(file.get());
            return Files.readAllBytes(file.get());
          };
      try {
        ModelReader.read(
            model.getFileName().toString(),
            Files.readAllBytes(model),
            recording.searchedBy(new FileSearch(folder)::of),
            ModelOptions.DEFAULT.mayLackFiles(true));
      } catch (ModelFormatException e) {
        // Reading the scene reports the error.
        continue;
      }
    }
    return all;
  }

  private static Optional<Path> validRelative(String name) {
    try {
      return relative(name);
    } catch (InvalidPathException e) {
      return Optional.empty();
    }
  }

  private Path folder() throws IOException {
    return sceneFile.toAbsolutePath().getParent().toRealPath();
  }

  /** Returns the SHA-256 of each file that was read, in hexadecimal, by its name in the scene. */
  Map<String, LateHash> hashes() {
    return Map.copyOf(hashes);
  }

  private static Optional<Content> decoded(ProblemPlace place, String text) {
    byte[] letters = withoutLineBreaks(text);
    // The decoder itself accepts truncated text.
    if (letters.length == 0 || letters.length % 4 != 0) {
      place.error(Kind.ASSET, "expected base64, found truncated text");
      return Optional.empty();
    }
    try {
      return Optional.of(new Content(place, Base64.getDecoder().decode(letters)));
    } catch (IllegalArgumentException e) {
      place.error(Kind.ASSET, "expected base64, found invalid characters");
      return Optional.empty();
    }
  }

  private static byte[] withoutLineBreaks(String text) {
    byte[] letters = text.getBytes(StandardCharsets.ISO_8859_1);
    int count = 0;
    for (byte letter : letters) {
      if (letter != '\n' && letter != '\r' && letter != ' ' && letter != '\t') {
        letters[count++] = letter;
      }
    }
    return Arrays.copyOf(letters, count);
  }

  /** Thrown if a file cannot be read. */
  private static final class Unusable extends Exception {
    private static final long serialVersionUID = 1;

    private final Kind kind;

    Unusable(Kind kind, String message) {
      super(message);
      this.kind = kind;
    }

    static Unusable missing(String name) {
      return new Unusable(
          Kind.ASSET, "expected a file, found none at " + PrintableText.quoted(name));
    }

    ModelFormatException inModel(String location) {
      return new ModelFormatException(
          kind == Kind.LIMIT
              ? ModelFormatException.Kind.TOO_LARGE
              : ModelFormatException.Kind.ASSET,
          location,
          getMessage());
    }

    static Unusable unreadable(String name, String reason) {
      return new Unusable(
          Kind.ASSET,
          "expected a readable file, found " + PrintableText.quoted(name) + ": " + reason);
    }
  }

  /** Returns the bytes of a file; empty, with an error added at a place, if it cannot be read. */
  Optional<Content> file(ProblemPlace place, String name) {
    try {
      return Optional.of(new Content(place, bytes(name)));
    } catch (Unusable e) {
      place.error(e.kind, e.getMessage());
      return Optional.empty();
    }
  }

  private byte[] bytes(String name) throws Unusable {
    try {
      byte[] known = inMemory.get(name);
      if (known != null) {
        requireBytes(known.length);
      }
      byte[] bytes = known != null ? known : fileBytes(name);
      note(name, bytes);
      return bytes;
    } catch (ClosedByInterruptException e) {
      throw Interrupts.cancelled(e);
    } catch (IOException e) {
      throw Unusable.unreadable(name, FileFailure.reason(e));
    }
  }

  /** Notes the text of the scene, once. */
  void noteText(byte[] text) {
    hash.text(text);
  }

  /** Returns the hash of the scene and its files. Call it once, at the end. */
  LateHash hash() {
    return hash.value();
  }

  /** Notes the bytes of a file of the scene that has been read. */
  void note(String name, byte[] bytes) {
    hash.add(bytes);
    LateHash own = LateHash.of(bytes);
    hashes.put(name, own);
    waiting += bytes.length;
    if (waiting > LateHash.MOST_WAITING) {
      own.value();
      waiting -= bytes.length;
    }
  }

  private byte[] fileBytes(String name) throws IOException, Unusable {
    Path path = inFolder(name);
    requireFile(name, path);
    return Files.readAllBytes(path);
  }

  /** Checks that a path is a file small enough to be read. */
  private void requireFile(String name, Path path) throws IOException, Unusable {
    if (!Files.readAttributes(path, BasicFileAttributes.class).isRegularFile()) {
      String found = Files.isDirectory(path) ? "a folder" : "no regular file";
      throw new Unusable(
          Kind.ASSET, "expected a file, found " + found + " at " + PrintableText.quoted(name));
    }
    if (Files.size(path) > MAX_BYTES) {
      throw new Unusable(
          Kind.LIMIT, "expected at most " + MAX_BYTES + " bytes, found " + Files.size(path));
    }
    requireBytes(Files.size(path));
  }

  private void requireBytes(long bytes) throws Unusable {
    Optional<String> excess = allowance.addBytes(bytes);
    if (excess.isPresent()) {
      throw new Unusable(Kind.LIMIT, excess.get());
    }
  }

  /** Returns the real path of a file in the folder. */
  private Path inFolder(String name) throws IOException, Unusable {
    Path folder = folder();
    Optional<Path> path;
    try {
      path = relative(name).map(folder::resolve).map(Path::normalize);
    } catch (InvalidPathException e) {
      throw Unusable.unreadable(name, FileFailure.reason(e));
    }
    if (path.isEmpty() || !path.get().startsWith(folder)) {
      throw new Unusable(
          Kind.INVALID,
          "expected a relative path inside the scene's folder, found "
              + PrintableText.quoted(name));
    }
    Path real;
    try {
      real = path.get().toRealPath();
    } catch (NoSuchFileException e) {
      throw Unusable.missing(name);
    }
    if (!real.startsWith(folder)) {
      throw new Unusable(
          Kind.INVALID,
          "expected a file inside the scene's folder, found the link "
              + PrintableText.quoted(name)
              + ", which points outside it; copy the file into the folder");
    }
    return real;
  }

  /**
   * Returns a relative path from a scene; empty if it is empty, absolute, a URL, starts with a
   * backslash, or has a null character.
   *
   * @throws InvalidPathException if the file system cannot represent the name
   */
  private static Optional<Path> relative(String name) {
    return Optional.of(name)
        .filter(AssetData::isPath)
        .map(Path::of)
        .filter(path -> !path.isAbsolute());
  }

  /** Returns a path as scenes state it. */
  static String slashed(Path path) {
    return path.toString().replace('\\', '/');
  }

  /** Returns whether a name is neither empty nor a URL, and no path of another system. */
  private static boolean isPath(String name) {
    boolean isUrl = URL.matcher(name).matches();
    return !name.isEmpty() && !isUrl && !name.startsWith("\\") && name.indexOf(0) < 0;
  }
}
