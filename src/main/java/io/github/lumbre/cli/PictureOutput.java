package io.github.lumbre.cli;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageFormat;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.OutputFile;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Where the picture goes: reserved before the work begins, filled when it has ended. Mutable. */
final class PictureOutput implements AutoCloseable {
  private final OutputFile file;
  private final Fallback fallback;

  private PictureOutput(OutputFile file, Fallback fallback) {
    this.file = file;
    this.fallback = fallback;
  }

  /**
   * Returns where a scene's picture goes by default: its name with another ending, in the working
   * directory.
   */
  static Path defaultFor(Path scene) {
    Path name = scene.getFileName();
    String text = name == null ? "" : name.toString();
    int dot = text.lastIndexOf('.');
    String base = dot > 0 ? text.substring(0, dot) : text;
    return Path.of((base.isEmpty() ? "picture" : base) + ImageFormat.PNG.ending());
  }

  /** Returns whether two paths lead to the same file, which need not exist. */
  static boolean isSame(Path one, Path other) {
    try {
      return Files.isSameFile(one, other);
    } catch (IOException e) {
      return real(one).equals(real(other));
    }
  }

  /** Returns a path whose symbolic links are resolved; the file itself need not exist. */
  private static Path real(Path path) {
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
   * Reserves a place for a picture.
   *
   * @throws CommandException if it cannot be written there
   */
  static PictureOutput reserve(Path target) throws CommandException {
    return reserve(target, Fallback.TEMPORARY);
  }

  /**
   * Reserves a place for a picture.
   *
   * @param fallback where the picture goes if it turns out that it cannot be written there
   * @throws CommandException if that is known already
   */
  static PictureOutput reserve(Path target, Fallback fallback) throws CommandException {
    try {
      return new PictureOutput(OutputFile.open(target), fallback);
    } catch (IOException e) {
      throw new CommandException(ExitCodes.OUTPUT, e.getMessage(), e);
    }
  }

  Path target() {
    return file.target();
  }

  /**
   * Writes the picture; if that fails, into the other directory, lest it be lost.
   *
   * @throws CommandException if that failed, naming the path where the picture is instead
   */
  void write(Image image, ImageWriter.Options options) throws CommandException {
    try {
      ImageWriter.write(image, file, options);
    } catch (IOException e) {
      String failure = target() + ": cannot be written: " + e.getMessage();
      throw new CommandException(ExitCodes.OUTPUT, failure + "; " + rescue(image, options), e);
    }
  }

  private String rescue(Image image, ImageWriter.Options options) {
    try {
      Path other = fallback.newFile(target());
      ImageWriter.write(image, other, options);
      return "saved as " + other + " instead";
    } catch (IOException e) {
      return "nor could " + fallback.directory() + ": " + e.getMessage();
    }
  }

  /** Releases the place if nothing was written. */
  @Override
  public void close() {
    try {
      file.close();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
