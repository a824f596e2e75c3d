package io.github.lumbre.model.format.zip;

import io.github.lumbre.base.file.FileContent;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.format.ZipParts;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelNames;
import io.github.lumbre.model.internal.ModelReader;
import io.github.lumbre.model.internal.NamedFiles;
import java.io.IOException;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * Reads ZIP archives with one model. The model may name the other files of the archive, such as its
 * material library and pictures, and no files beside the archive. Stateless.
 */
public final class ZipReader {
  private static final String ENDING = ".zip";

  /** The folder in which macOS stores what it knows of the other files. */
  private static final String FORKS = "__MACOSX/";

  private ZipReader() {}

  /** Returns whether a file begins like an archive of no known kind. */
  public static boolean startsIn(byte[] start, long size) {
    return FileContent.describe(start).filter("a ZIP archive"::equals).isPresent();
  }

  private static boolean isModel(String name) {
    String last = name.substring(name.lastIndexOf('/') + 1);
    return ModelReader.isModelName(last)
        && !last.toLowerCase(Locale.ROOT).endsWith(ENDING)
        && !last.startsWith(".")
        && !name.startsWith(FORKS);
  }

  /** Returns the content of the only model in an archive. */
  public static Model read(byte[] bytes, ModelFolder beside, ModelOptions options)
      throws ModelFormatException, IOException {
    ZipParts parts = ZipParts.of(bytes, options.limits());
    List<String> models = parts.names().stream().filter(ZipReader::isModel).sorted().toList();
    if (models.size() != 1) {
      throw Kind.UNSUPPORTED.at(
          "",
          "expected one model in the archive, found "
              + (models.isEmpty() ? "none" : "several: " + ModelNames.choice(models)));
    }
    String name = models.get(0);
    String folder = name.substring(0, name.lastIndexOf('/') + 1);
    ModelFolder files =
        new NamedFiles(
            folder,
            (path, location) ->
                parts.has(path) ? Optional.of(parts.read(path, location)) : Optional.empty());
    return ModelReader.readPose(name, parts.read(name, ""), files, options);
  }
}
