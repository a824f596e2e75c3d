package io.github.lumbre.parser;

import io.github.lumbre.file.FileFailure;
import io.github.lumbre.parser.SceneFormatException.Kind;
import java.io.IOException;
import java.nio.channels.ClosedByInterruptException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.security.MessageDigest;
import java.util.Arrays;
import java.util.Base64;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.CancellationException;
import java.util.regex.Pattern;

/**
 * The bytes of assets, in base64 inside the scene file or in files in the same folder or below.
 * Files outside of it are refused.
 */
final class AssetData {
  static final String FILE_KEY = "file";

  private static final Pattern URL = Pattern.compile("^[A-Za-z][A-Za-z0-9+.-]*:.*", Pattern.DOTALL);

  /** Beyond this, an array of Java cannot hold a file. */
  private static final long MAX_BYTES = Integer.MAX_VALUE - 8L;

  /** Bytes between two checks for an interrupt; a power of two, so that sums do not overflow. */
  private static final int HASH_BLOCK = 1 << 24;

  private final Path sceneFile;
  private final MessageDigest digest;
  private final Map<String, String> hashes = new TreeMap<>();

  /**
   * @param digest receives the bytes of all files that are read
   */
  AssetData(Path sceneFile, MessageDigest digest) {
    this.sceneFile = sceneFile;
    this.digest = digest;
  }

  /** Bytes, and where to complain about them. */
  record Content(JsonNode asset, String key, byte[] bytes) {
    void error(Kind kind, String message) {
      asset.error(kind, key, message);
    }
  }

  /**
   * Returns the bytes of an asset, or adds an error.
   *
   * @param base64Key where the asset carries its bytes, if it does not name a file
   */
  Optional<Content> read(JsonNode asset, String base64Key) {
    if (asset.has(FILE_KEY)) {
      if (asset.has(base64Key)) {
        asset.warn(base64Key, "is not read, since there is a file");
      }
      return asset.string(FILE_KEY).flatMap(name -> file(asset, name));
    }
    if (!asset.has(base64Key)) {
      asset.error(base64Key, "expected " + base64Key + " or file, found neither");
      return Optional.empty();
    }
    return asset.string(base64Key).flatMap(text -> decoded(asset, base64Key, text));
  }

  /** Returns the files that assets name, as far as they exist and are in the scene's folder. */
  Set<Path> files(List<JsonNode> assets) throws IOException {
    Path folder = folder();
    Set<Path> files = new LinkedHashSet<>();
    for (JsonNode asset : assets) {
      Optional<String> name = asset.has(FILE_KEY) ? asset.string(FILE_KEY) : Optional.empty();
      name.flatMap(AssetData::validRelative)
          .map(path -> folder.resolve(path).normalize())
          .filter(path -> path.startsWith(folder) && Files.isRegularFile(path))
          .ifPresent(files::add);
    }
    return files;
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

  /** Returns the SHA-256 of each file that was read, by its name in the scene. */
  Map<String, String> hashes() {
    return Map.copyOf(hashes);
  }

  private static Optional<Content> decoded(JsonNode asset, String key, String text) {
    byte[] letters = withoutLineBreaks(text);
    // The decoder itself takes a text that ends early.
    if (letters.length == 0 || letters.length % 4 != 0) {
      asset.error(Kind.ASSET, key, "expected base64, found a text that ends early");
      return Optional.empty();
    }
    try {
      return Optional.of(new Content(asset, key, Base64.getDecoder().decode(letters)));
    } catch (IllegalArgumentException e) {
      asset.error(Kind.ASSET, key, "expected base64, found characters that are not");
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

  private Optional<Content> file(JsonNode asset, String name) {
    try {
      Optional<Path> path = inFolder(asset, name);
      if (path.isEmpty() || !isFile(asset, name, path.get())) {
        return Optional.empty();
      }
      byte[] bytes = Files.readAllBytes(path.get());
      hash(bytes);
      hashes.put(name, Sha256.of(bytes));
      return Optional.of(new Content(asset, FILE_KEY, bytes));
    } catch (ClosedByInterruptException e) {
      throw new CancellationException(e.toString());
    } catch (IOException e) {
      asset.error(
          Kind.ASSET,
          FILE_KEY,
          "expected a readable file, found "
              + Problems.quoted(name)
              + ": "
              + FileFailure.reason(e));
      return Optional.empty();
    }
  }

  private void hash(byte[] bytes) {
    for (int at = 0; at < bytes.length; at += HASH_BLOCK) {
      Interrupts.check();
      digest.update(bytes, at, Math.min(HASH_BLOCK, bytes.length - at));
    }
  }

  /** Returns whether a path leads to a file of a size that can be read, or adds an error. */
  private static boolean isFile(JsonNode asset, String name, Path path) throws IOException {
    if (!Files.readAttributes(path, BasicFileAttributes.class).isRegularFile()) {
      String found = Files.isDirectory(path) ? "a folder" : "what is none";
      asset.error(
          Kind.ASSET, FILE_KEY, "expected a file, found " + found + " at " + Problems.quoted(name));
      return false;
    }
    if (Files.size(path) > MAX_BYTES) {
      asset.error(
          Kind.LIMIT,
          FILE_KEY,
          "expected at most " + MAX_BYTES + " bytes, found " + Files.size(path));
      return false;
    }
    return true;
  }

  /** Returns the path of a file, or adds an error if it is not inside the scene's folder. */
  private Optional<Path> inFolder(JsonNode asset, String name) throws IOException {
    Path folder = folder();
    Optional<Path> path;
    try {
      path = relative(name).map(folder::resolve).map(Path::normalize);
    } catch (InvalidPathException e) {
      asset.error(
          Kind.ASSET,
          FILE_KEY,
          "expected a readable file, found "
              + Problems.quoted(name)
              + ": "
              + FileFailure.reason(e));
      return Optional.empty();
    }
    if (path.isEmpty() || !path.get().startsWith(folder)) {
      asset.error(
          FILE_KEY,
          "expected a relative path inside the scene's folder, found " + Problems.quoted(name));
      return Optional.empty();
    }
    Path real;
    try {
      real = path.get().toRealPath();
    } catch (NoSuchFileException e) {
      asset.error(Kind.ASSET, FILE_KEY, "expected a file, found none at " + Problems.quoted(name));
      return Optional.empty();
    }
    if (!real.startsWith(folder)) {
      asset.error(
          FILE_KEY,
          "expected a file inside the scene's folder, found the link "
              + Problems.quoted(name)
              + ", which leads out of it; copy the file into the folder");
      return Optional.empty();
    }
    return Optional.of(real);
  }

  /**
   * Returns a path as a scene may state it, or empty if it may not.
   *
   * @throws InvalidPathException if it is none
   */
  private static Optional<Path> relative(String name) {
    boolean isUrl = URL.matcher(name).matches();
    if (name.isEmpty() || isUrl || name.startsWith("\\") || name.indexOf(0) >= 0) {
      return Optional.empty();
    }
    return Optional.of(Path.of(name)).filter(path -> !path.isAbsolute());
  }
}
