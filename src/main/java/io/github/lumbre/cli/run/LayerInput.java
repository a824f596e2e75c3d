package io.github.lumbre.cli.run;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.base.file.FileFailure;
import io.github.lumbre.base.text.Spelling;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageLayer;
import io.github.lumbre.image.LayeredImage;
import io.github.lumbre.image.internal.Backdrop;
import io.github.lumbre.render.checkpoint.FilmFile;
import io.github.lumbre.render.checkpoint.internal.FilmPicture;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Reads the layers of OpenEXR files and checkpoint files for commands. */
public final class LayerInput {
  private static final int START_BYTES = 16;

  private LayerInput() {}

  /**
   * Reads all layers of an OpenEXR file, or develops the layers of a checkpoint file.
   *
   * @param messages receives a warning if a checkpoint file is damaged
   * @throws TaskException if the file cannot be read
   */
  public static LayeredImage read(Path file, Messages messages) throws TaskException {
    try {
      if (isFilm(file)) {
        return developed(FilmInput.read(file, messages));
      }
      return LayeredImage.read(file);
    } catch (IOException e) {
      throw failure(file, e);
    }
  }

  /** Returns the failure of a command that cannot read a picture. */
  public static TaskException failure(Path file, IOException e) {
    if (e instanceof ImageFormatException invalid) {
      boolean isTooLarge = invalid.kind() == ImageFormatException.Kind.TOO_LARGE;
      ExitCode code = isTooLarge ? ExitCode.LIMIT : ExitCode.ASSET;
      return code.failure(file + ": " + e.getMessage(), e);
    }
    boolean isThere = !(e instanceof NoSuchFileException);
    String problem = isThere ? "cannot be read: " + FileFailure.reason(e) : "does not exist";
    return ExitCode.USAGE.failure(file + ": " + problem, e);
  }

  /** Returns whether a file is a checkpoint file; false if it cannot be read. */
  public static boolean isFilm(Path file) {
    try (InputStream in = Files.newInputStream(file)) {
      return FilmFile.startsIn(in.readNBytes(START_BYTES));
    } catch (IOException e) {
      return false;
    }
  }

  /** Returns the layers that an OpenEXR file of the film would have. */
  private static LayeredImage developed(FilmFile file) {
    FilmPicture picture = FilmPicture.of(file.film(), file.header().layers());
    Image image = Backdrop.asLight(picture.image(), file.header().background());
    List<ImageLayer> layers = new ArrayList<>();
    layers.add(ImageLayer.of(image));
    layers.addAll(picture.layers());
    return new LayeredImage(image.width(), image.height(), layers, picture.metadata());
  }

  /**
   * Returns a layer of a file.
   *
   * @param path of the file, for messages
   * @throws TaskException if it has no such layer
   */
  public static ImageLayer layer(LayeredImage file, String name, Path path) throws TaskException {
    return layer(
        file,
        name,
        path,
        file.layers().stream().map(ImageLayer::name).filter(n -> !n.isEmpty()).toList());
  }

  /**
   * Returns a layer of a file.
   *
   * @param names what to choose from, for messages
   */
  public static ImageLayer layer(LayeredImage file, String name, Path path, List<String> names)
      throws TaskException {
    return file.layer(name)
        .orElseThrow(
            () ->
                ExitCode.USAGE.failure(
                    "%s: has no layer '%s', only %s%s"
                        .formatted(
                            path,
                            name,
                            names.isEmpty() ? "the picture" : String.join(", ", names),
                            Spelling.suggestion(name, names))));
  }
}
