package io.github.lumbre.model;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.model.internal.AllowedFolders;
import io.github.lumbre.model.internal.FileFolder;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelFormat;
import io.github.lumbre.model.internal.ModelLimits;
import io.github.lumbre.model.internal.ModelReader;
import io.github.lumbre.scene.Scene;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;

/** Reads model files for scenes that are built in code. Stateless. */
public final class Models {
  /** The endings of the names of model files, for messages. */
  public static final String NAMES = ModelFormat.ENDINGS;

  private Models() {}

  /** Returns whether a name has the ending of a model file. */
  public static boolean isModelName(String name) {
    return ModelReader.isModelName(name);
  }

  /**
   * Returns whether a file is a model, by the ending of its name. If the ending is of neither a
   * model nor .json, the content of the file decides.
   */
  public static boolean isModel(Path file) {
    return ModelReader.isModel(file);
  }

  /**
   * Reads a glTF, OBJ, PLY, STL, OFF, 3MF or COLLADA file, or a ZIP archive of one, and the files
   * that it names.
   *
   * @throws ModelFormatException if the file is damaged, unsupported or too large
   * @throws IOException if the file cannot be read
   * @throws java.util.concurrent.CancellationException if the thread is interrupted
   */
  public static ModelFile read(Path file) throws ModelFormatException, IOException {
    return read(file, ModelOptions.DEFAULT);
  }

  /** Reads a model file with options; see {@link #read(Path)}. */
  public static ModelFile read(Path file, ModelOptions options)
      throws ModelFormatException, IOException {
    Path parent = file.toAbsolutePath().normalize().getParent();
    long most = options.limits().bytes();
    ModelFolder folder = new FileFolder(AllowedFolders.of(parent, options), most);
    byte[] content = ModelReader.bytes(file, options.limits());
    return read(file.getFileName().toString(), content, folder, options);
  }

  /**
   * Reads a model from the bytes of a file that names no other files, such as GLB, PLY, STL, OFF,
   * 3MF and ZIP.
   *
   * @param name of the file; its ending chooses the format
   * @throws ModelFormatException if the file is damaged, unsupported or too large, or names another
   * @throws IOException never
   * @throws java.util.concurrent.CancellationException if the thread is interrupted
   */
  public static ModelFile read(String name, byte[] content)
      throws ModelFormatException, IOException {
    return read(name, content, ModelFolder.NONE, ModelOptions.DEFAULT);
  }

  /**
   * Reads a model from a stream; see {@link #read(String, byte[], ModelFolder, ModelOptions)}.
   *
   * @param content is read to its end, or to one byte more than the options' {@link Limits#bytes};
   *     not closed
   * @throws IOException if the stream or the folder fails
   * @throws java.util.concurrent.CancellationException if the thread is interrupted
   */
  public static ModelFile read(
      String name, InputStream content, ModelFolder folder, ModelOptions options)
      throws ModelFormatException, IOException {
    return read(name, options.limits().bytesOf(content), folder, options);
  }

  /**
   * Reads a model from the bytes of a file.
   *
   * @param name of the file; its ending chooses the format
   * @param folder reads other files that the model names
   * @throws ModelFormatException if the file is damaged, unsupported or too large
   * @throws IOException if the folder fails
   * @throws java.util.concurrent.CancellationException if the thread is interrupted
   * @throws IllegalArgumentException if the pose is in motion: a scene that code builds has a model
   *     for each pose of {@link Scene#inMotion}
   */
  public static ModelFile read(
      String name, byte[] content, ModelFolder folder, ModelOptions options)
      throws ModelFormatException, IOException {
    if (options.find(ModelOption.POSE).filter(pose -> pose.poses() > 1).isPresent()) {
      throw new IllegalArgumentException("pose: expected one that stands still, found motion");
    }
    ModelLimits.require("", "bytes", options.limits().bytes(), content.length);
    Map<String, byte[]> files = new LinkedHashMap<>();
    ModelFolder recording =
        (other, location) -> {
          byte[] bytes = folder.read(other, location);
          files.put(other, bytes);
          return bytes;
        };
    Model model = ModelReader.read(name, content, recording.searchedBy(folder::similar), options);
    return new ModelFile(name, content.clone(), files, options, model);
  }
}
