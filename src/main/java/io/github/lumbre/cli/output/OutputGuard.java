package io.github.lumbre.cli.output;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.base.file.OutputFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * The files that a command reads and writes. {@link #check} rejects a command before it starts if
 * it would overwrite an input, write one file twice, or replace a file of a different kind.
 * Symbolic links and hard links are followed. Mutable.
 */
public final class OutputGuard {
  private final boolean overwrite;
  private final List<Input> inputs = new ArrayList<>();
  private final List<Assets> assets = new ArrayList<>();
  private final List<Output> outputs = new ArrayList<>();

  /** The outputs by the identities of the files that writing them replaces or deletes. */
  private final Map<Object, Output> replaced = new HashMap<>();

  /** Lists the files that a scene's assets name. */
  @FunctionalInterface
  public interface AssetList {
    Set<Path> files() throws SceneFormatException, IOException;
  }

  /**
   * @param others folders besides the scene's from which files may come
   */
  private record Assets(Path scene, List<Path> others, AssetList list) {
    /** Returns whether a file in a folder may be one of the files. */
    boolean mayBeIn(Path folder) {
      return folder.startsWith(PictureOutput.real(scene).getParent())
          || others.stream().map(PictureOutput::real).anyMatch(folder::startsWith);
    }

    /** Returns the files; none if the scene cannot be read, which the command itself reports. */
    Set<Path> files() {
      try {
        return list.files();
      } catch (SceneFormatException | IOException e) {
        return Set.of();
      }
    }
  }

  private record Input(Path path, String role) {}

  /**
   * @param flag flag that sets the path
   * @param isOwn whether the command itself checks the file's current content
   */
  private record Output(String flag, Path path, OutputContent content, boolean isOwn) {}

  /**
   * @param overwrite whether outputs may replace files of a different kind
   */
  public OutputGuard(boolean overwrite) {
    this.overwrite = overwrite;
  }

  /**
   * Adds a file that the command reads.
   *
   * @param role of the file in messages, such as "the scene"
   */
  public OutputGuard reads(Path path, String role) {
    inputs.add(new Input(path, role));
    return this;
  }

  /** Adds a checkpoint file that the command reads, and its previous version. */
  public OutputGuard readsFilm(Path film) {
    return reads(film, "a checkpoint file")
        .reads(OutputFile.previous(film), "the previous version of a checkpoint file");
  }

  /** Adds a scene and its asset files. */
  public OutputGuard readsScene(Path scene) {
    return reads(scene, "the scene").readsAssets(scene, () -> SceneParser.files(scene));
  }

  /** Adds the files that a scene's assets name. */
  public OutputGuard readsAssets(Path scene, AssetList list) {
    return readsAssets(scene, List.of(), list);
  }

  /**
   * Adds the files that a scene's assets name.
   *
   * @param others folders besides the scene's from which they may come
   */
  public OutputGuard readsAssets(Path scene, List<Path> others, AssetList list) {
    assets.add(new Assets(scene, others, list));
    return this;
  }

  /**
   * Adds a file that the command writes.
   *
   * @param flag flag that sets the path, for messages
   */
  public OutputGuard writes(String flag, Path path, OutputContent content) {
    outputs.add(new Output(flag, path, content, false));
    return this;
  }

  /** Adds a file that the command reads first and then replaces, or whose content is checked. */
  public OutputGuard updates(String flag, Path path, OutputContent content) {
    outputs.add(new Output(flag, path, content, true));
    return this;
  }

  /** Adds a checkpoint file that the command replaces, and its previous version. */
  public OutputGuard updatesFilm(String flag, Path film) {
    return updates(flag, film, OutputContent.FILM)
        .updates(flag, OutputFile.previous(film), OutputContent.FILM);
  }

  /**
   * Checks all outputs.
   *
   * @throws TaskException with {@link ExitCode#OUTPUT} for the first output that must not be
   *     written
   */
  public void check() throws TaskException {
    for (Output output : outputs) {
      for (Path path : written(output.path)) {
        for (Object identity : PictureOutput.identities(path)) {
          replaced.putIfAbsent(identity, output);
        }
      }
    }
    for (Input input : inputs) {
      requireDifferent(input);
    }
    Map<Object, Output> written = new HashMap<>();
    for (Output output : outputs) {
      for (Object identity : PictureOutput.identities(output.path)) {
        requireFirst(output, Optional.ofNullable(written.putIfAbsent(identity, output)));
      }
    }
    checkAssets();
    for (Output output : outputs) {
      requireReplaceable(output);
    }
  }

  /**
   * Checks that no output is a file of a model that was read after {@link #check}.
   *
   * @param assets the files that the model names
   * @throws TaskException with {@link ExitCode#OUTPUT} for the first output that is
   */
  public void checkAssets(Path model, Set<Path> assets) throws TaskException {
    for (Path asset : assets) {
      requireDifferent(new Input(asset, "a file of the scene " + model));
    }
  }

  /**
   * Reads the asset list of a scene only if an output exists in a folder of its files or below:
   * only then can it be an asset.
   */
  private void checkAssets() throws TaskException {
    Set<Path> folders = new HashSet<>();
    for (Output output : outputs) {
      for (Path path : written(output.path)) {
        if (Files.exists(path)) {
          folders.add(PictureOutput.real(path).getParent());
        }
      }
    }
    for (Assets ofScene : assets) {
      if (folders.stream().anyMatch(ofScene::mayBeIn)) {
        checkAssets(ofScene.scene, ofScene.files());
      }
    }
  }

  /** Returns the files that writing an output replaces or deletes. */
  private static List<Path> written(Path output) {
    Path name = output.getFileName();
    return name == null ? List.of(output) : List.of(output, OutputFile.temporary(output));
  }

  private void requireDifferent(Input input) throws TaskException {
    for (Object identity : PictureOutput.identities(input.path)) {
      Output output = replaced.get(identity);
      if (output != null) {
        throw refused(
            output.path
                + ": is "
                + input.role
                + (output.path.equals(input.path) ? "" : " (" + input.path + ")")
                + ", which is read and must not be overwritten; "
                + advice(output.flag));
      }
    }
  }

  /**
   * @param other output that leads to the same file
   */
  private static void requireFirst(Output output, Optional<Output> other) throws TaskException {
    if (other.isPresent() && other.get() != output) {
      throw refused(
          "%s: is written twice, by %s (%s) and by %s; %s"
              .formatted(
                  output.path,
                  other.get().flag,
                  other.get().path,
                  output.flag,
                  advice(output.flag)));
    }
  }

  private void requireReplaceable(Output output) throws TaskException {
    if (overwrite || output.isOwn || !Files.isRegularFile(output.path)) {
      return;
    }
    String found;
    try {
      if (output.content.mayReplace(output.path)) {
        return;
      }
      found = "is not " + output.content.description();
    } catch (IOException e) {
      found = "cannot be read";
    }
    throw refused(
        "%s: exists and %s; %s, or replace the file with --overwrite"
            .formatted(output.path, found, advice(output.flag)));
  }

  private static String advice(String flag) {
    return "choose another path with " + flag;
  }

  private static TaskException refused(String message) {
    return ExitCode.OUTPUT.failure(message);
  }
}
