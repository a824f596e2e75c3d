package io.github.lumbre.model;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.model.internal.AllowedFolders;
import io.github.lumbre.model.internal.FileFolder;
import io.github.lumbre.model.internal.NamedFiles;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;

/** Reads the files that a model names: those in the folders that it may use, and below. */
@FunctionalInterface
public interface ModelFolder {
  /** A folder without files. */
  ModelFolder NONE =
      (name, location) -> {
        throw ModelFormatException.Kind.ASSET.at(
            location,
            "expected a model in one file, found a reference to " + PrintableText.quoted(name));
      };

  /** Returns access to the files in a folder and below. */
  static ModelFolder of(Path folder) {
    return of(folder, List.of());
  }

  /**
   * Returns access to the files in a folder and below, and in further folders and below. Links are
   * resolved first; what then lies in none of them is refused.
   *
   * @param folder of the model, in which names start
   * @param assets further folders, in which files that are missing are searched, too
   */
  static ModelFolder of(Path folder, List<Path> assets) {
    return new FileFolder(new AllowedFolders(folder.toAbsolutePath().normalize(), assets));
  }

  /**
   * Returns access to files in memory, such as those of an upload.
   *
   * @param files bytes by names, with / between the names of folders; neither is copied
   */
  static ModelFolder of(Map<String, byte[]> files) {
    return new NamedFiles("", (path, location) -> Optional.ofNullable(files.get(path)));
  }

  /**
   * Returns access to the resources in a folder of the class path and below.
   *
   * @param folder without a slash at its beginning and end, such as {@code com/example/models}
   */
  static ModelFolder of(ClassLoader loader, String folder) {
    return new NamedFiles(
        "",
        (path, location) -> {
          try (InputStream in = loader.getResourceAsStream(folder + "/" + path)) {
            return in == null ? Optional.empty() : Optional.of(in.readAllBytes());
          }
        });
  }

  /**
   * Returns the bytes of a file.
   *
   * @param name relative path with / between names, percent-decoded
   * @param location of the reference in the model, for messages
   * @throws ModelFormatException if the name leaves the folder, or the file is missing or too large
   * @throws IOException if the file cannot be read
   * @throws java.util.concurrent.CancellationException if the thread is interrupted
   */
  byte[] read(String name, String location) throws ModelFormatException, IOException;

  /**
   * Returns files that may be meant by a name that cannot be read: files with its last name,
   * without regard to case, in the folder or below. By default there are none.
   *
   * @param name of a file, as in {@link #read}
   */
  default List<String> similar(String name) {
    return List.of();
  }

  /** Returns this folder with another {@link #similar}. */
  default ModelFolder searchedBy(Function<String, List<String>> search) {
    ModelFolder files = this;
    return new ModelFolder() {
      @Override
      public byte[] read(String name, String location) throws ModelFormatException, IOException {
        return files.read(name, location);
      }

      @Override
      public List<String> similar(String name) {
        return search.apply(name);
      }
    };
  }
}
