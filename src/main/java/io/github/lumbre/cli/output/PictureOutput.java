package io.github.lumbre.cli.output;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.base.file.Disk;
import io.github.lumbre.base.file.OutputFile;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageLayer;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.internal.ImageFormat;
import io.github.lumbre.image.internal.PictureEncoder;
import io.github.lumbre.image.internal.VectorPicture;
import io.github.lumbre.scene.RenderSettings;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.text.Normalizer;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.UnaryOperator;

/**
 * The picture file: reserved before the render starts, or with others whose names are reserved
 * together, and written when it ends. Mutable.
 */
public final class PictureOutput implements AutoCloseable {
  /** The path that denotes standard input or output. */
  public static final Path STANDARD = Path.of("-");

  /** The name of a scene from standard input: its assets are relative to the working directory. */
  public static final Path STDIN = Path.of("stdin");

  private final Path target;

  /** The path that is written: the target, or a temporary file for standard output. */
  private final Path path;

  private final Fallback fallback;

  /** Whether the picture is one of several in the file, which another output writes. */
  private final boolean isPart;

  private Optional<OutputFile> file;

  private PictureOutput(Path target, Path path, Optional<OutputFile> file, Fallback fallback) {
    this(target, path, file, fallback, false);
  }

  private PictureOutput(
      Path target, Path path, Optional<OutputFile> file, Fallback fallback, boolean isPart) {
    this.target = target;
    this.path = path;
    this.file = file;
    this.fallback = fallback;
    this.isPart = isPart;
  }

  /**
   * Returns the default name of a scene's picture: the scene's name with the ending of the format,
   * such as {@code .png}; {@code stdin.png} for a scene from standard input.
   */
  public static Path defaultFor(Path scene, ImageFormat format) {
    Path name = scene.equals(STANDARD) ? STDIN : scene.getFileName();
    String text = name == null ? "" : name.toString();
    int dot = text.lastIndexOf('.');
    String base = dot > 0 ? text.substring(0, dot) : text;
    return Path.of((base.isEmpty() ? "picture" : base) + format.ending());
  }

  /** Returns whether pictures go into a folder, which need not exist if its name has no ending. */
  public static boolean isFolder(Path output) {
    boolean hasEnding = String.valueOf(output.getFileName()).indexOf('.') > 0;
    return !output.equals(STANDARD) && (Files.isDirectory(output) || !hasEnding);
  }

  /**
   * Returns a message about two scenes that have the same picture, also if only the case of letters
   * differs, which many file systems ignore; empty if there are none.
   *
   * @param pictures returns the picture of a scene
   */
  public static Optional<String> clash(List<Path> scenes, UnaryOperator<Path> pictures) {
    Map<String, Path> named = new HashMap<>();
    for (Path scene : scenes) {
      Path picture = pictures.apply(scene);
      String name = Normalizer.normalize(picture.toString(), Normalizer.Form.NFC);
      Path other = named.putIfAbsent(name.toLowerCase(Locale.ROOT), scene);
      if (other != null) {
        return Optional.of(
            "%s and %s: both pictures would be %s; rename one, or render them into two folders"
                .formatted(other, scene, picture));
      }
    }
    return Optional.empty();
  }

  /**
   * Returns what two paths have in common if they denote the same file: the path without symbolic
   * links, and the key of an existing file where the file system has one.
   */
  static List<Object> identities(Path path) {
    List<Object> identities = new ArrayList<>(List.of(real(path)));
    try {
      Object key = Files.readAttributes(path, BasicFileAttributes.class).fileKey();
      Optional.ofNullable(key).ifPresent(identities::add);
    } catch (IOException e) {
      // The file does not exist.
      return identities;
    }
    return identities;
  }

  /** Returns a path with symbolic links resolved; the file itself need not exist. */
  static Path real(Path path) {
    Path absolute = path.toAbsolutePath();
    Path parent = absolute.getParent();
    try {
      return Files.exists(absolute) || parent == null
          ? absolute.toRealPath()
          : parent.toRealPath().resolve(absolute.getFileName());
    } catch (IOException e) {
      return absolute.normalize();
    }
  }

  /**
   * Reserves a file for a picture.
   *
   * @throws TaskException if the file cannot be written
   */
  public static PictureOutput reserve(Path target) throws TaskException {
    return reserve(target, Fallback.TEMPORARY);
  }

  /**
   * Reserves a file for a picture.
   *
   * @param fallback directory for the picture if the file cannot be written later
   * @throws TaskException if the file cannot be written now
   */
  public static PictureOutput reserve(Path target, Fallback fallback) throws TaskException {
    OutputFile file = Failures.written(() -> OutputFile.open(target));
    return new PictureOutput(target, target, Optional.of(file), fallback);
  }

  /**
   * Returns the output of a picture whose name is reserved by {@link OutputFile#reserve(List)}. The
   * file is opened when the picture is written.
   *
   * @param fallback directory for the picture if the file cannot be written then
   */
  public static PictureOutput of(Path target, Fallback fallback) {
    return new PictureOutput(target, target, Optional.empty(), fallback);
  }

  /** Returns the output of one of several pictures in a file, which another output writes. */
  public static PictureOutput partOf(Path target) {
    return new PictureOutput(target, target, Optional.empty(), Fallback.TEMPORARY, true);
  }

  /**
   * Returns an output that writes to standard output. The picture is first written to a temporary
   * file, which is kept if standard output cannot be written.
   *
   * @param fallback directory of the temporary file
   * @throws TaskException if the temporary file cannot be created
   */
  public static PictureOutput toStandardOutput(ImageFormat format, Fallback fallback)
      throws TaskException {
    Path directory = fallback.directory();
    try {
      Path collected = fallback.newFile(Path.of("picture" + format.ending()));
      Optional<OutputFile> file = Optional.of(OutputFile.open(collected));
      return new PictureOutput(STANDARD, collected, file, fallback);
    } catch (IOException e) {
      throw ExitCode.OUTPUT.failure(directory + ": cannot be written: " + e.getMessage(), e);
    }
  }

  /** Returns the path of the picture, or {@link #STANDARD}. */
  public Path target() {
    return target;
  }

  /** Returns whether the picture's format is for the screen (PNG or JPEG). */
  public boolean isForScreen() {
    return ImageFormat.of(path).filter(ImageFormat::isForScreen).isPresent();
  }

  /**
   * Checks that the format can hold a picture.
   *
   * @throws TaskException if the picture is too large for it
   */
  public void requireFits(RenderSettings settings) throws TaskException {
    int side =
        settings
            .crop()
            .map(crop -> Math.max(crop.width(), crop.height()))
            .orElse(Math.max(settings.width(), settings.height()));
    boolean isJpeg = ImageFormat.of(path).equals(Optional.of(ImageFormat.JPG));
    if (isJpeg && side > ImageWriter.MAX_JPEG_SIDE) {
      throw ExitCode.LIMIT.failure(
          "%s: a JPEG has at most %s pixels on a side, found %s; choose another format"
              .formatted(target, ImageWriter.MAX_JPEG_SIDE, side));
    }
  }

  private boolean isStandardOutput() {
    return target.equals(STANDARD);
  }

  /** Returns whether the picture's format has layers. */
  public boolean hasLayers() {
    return ImageFormat.of(path).equals(Optional.of(ImageFormat.EXR));
  }

  /** Writes a picture without layers; see {@link #write(Image, List, ImageWriter.Options)}. */
  public void write(Image image, ImageWriter.Options options) throws TaskException {
    write(image, List.of(), options);
  }

  /** Returns whether the picture's format has lines and areas instead of pixels. */
  public boolean isVector() {
    return ImageFormat.of(path).filter(ImageFormat::isVector).isPresent();
  }

  /**
   * Writes a drawing; if that fails, writes it to the fallback directory instead.
   *
   * @throws TaskException if that failed; it names the path of the rescued drawing
   */
  public void write(VectorPicture picture) throws TaskException {
    write(output -> PictureEncoder.write(picture, output));
  }

  /**
   * Writes the picture with layers; if that fails, writes it to the fallback directory instead. A
   * picture that is a part of a file is not written.
   *
   * @throws TaskException if that failed; it names the path of the rescued picture
   */
  public void write(Image image, List<ImageLayer> layers, ImageWriter.Options options)
      throws TaskException {
    if (isPart) {
      return;
    }
    write(output -> PictureEncoder.write(image, layers, output, options));
  }

  /** Writes a picture to an open file. */
  private interface Encoding {
    void write(OutputFile output) throws IOException;
  }

  private void write(Encoding encoding) throws TaskException {
    try {
      encoding.write(opened());
    } catch (IOException e) {
      String failure = path + ": cannot be written: " + e.getMessage();
      String rescue = isStandardOutput() ? "" : "; " + rescue(encoding);
      throw ExitCode.OUTPUT.failure(failure + rescue, e);
    }
    if (isStandardOutput()) {
      print(path);
    }
  }

  private OutputFile opened() throws IOException {
    if (file.isEmpty()) {
      file = Optional.of(OutputFile.open(path, Disk.REAL));
    }
    return file.get();
  }

  private static void print(Path collected) throws TaskException {
    try (OutputStream out = StandardOutput.open()) {
      Files.copy(collected, out);
      Files.delete(collected);
    } catch (IOException e) {
      throw ExitCode.OUTPUT.failure(
          "standard output cannot be written: %s; the picture is saved as %s instead"
              .formatted(e.getMessage(), collected),
          e);
    }
  }

  private String rescue(Encoding encoding) {
    try {
      Path other = fallback.newFile(target());
      try (OutputFile output = OutputFile.open(other)) {
        encoding.write(output);
      } finally {
        Fallback.deleteIfEmpty(other);
      }
      return "saved as " + other + " instead";
    } catch (IOException e) {
      return "nor could it be saved in " + fallback.directory() + ": " + e.getMessage();
    }
  }

  /** Releases the reserved file if nothing was written. */
  @Override
  public void close() {
    try {
      if (file.isPresent()) {
        file.get().close();
      }
      if (isStandardOutput()) {
        Fallback.deleteIfEmpty(path);
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
