package io.github.lumbre.scenefile;

import io.github.lumbre.base.file.FileFailure;
import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.model.internal.ModelFormat;
import io.github.lumbre.scenefile.SceneFormatException.Kind;
import java.io.IOException;
import java.nio.channels.ClosedByInterruptException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** The file of a scene or a model, before it is understood. Stateless. */
final class InputFile {
  private InputFile() {}

  /**
   * Returns the bytes of a file.
   *
   * @param what the file is, for messages
   * @param bytes what is counted, for messages
   */
  static byte[] read(Path file, Problems problems, String what, String bytes, long maxBytes)
      throws SceneFormatException, IOException {
    try {
      long max = Math.min(AssetData.MAX_BYTES, maxBytes);
      long size = Files.size(file);
      Optional<String> excess =
          Limits.excess(bytes, max, size)
              .or(() -> Limits.excess("bytes, the whole heap", Limits.NONE.heap(), size));
      if (excess.isPresent()) {
        problems.error(Kind.LIMIT, () -> "$", excess.get());
        throw problems.exception();
      }
      return Files.readAllBytes(file);
    } catch (ClosedByInterruptException e) {
      throw Interrupts.cancelled(e);
    } catch (NoSuchFileException e) {
      String place = Problems.at(file);
      problems.error(Kind.INVALID, () -> "$", "expected a " + what + " file, found none" + place);
      throw problems.exception();
    } catch (IOException e) {
      throw FileFailure.named(file, e);
    }
  }

  /** Refuses a content that is neither a scene nor a model, and names its kind. */
  static void requireScene(byte[] text, Path file, Problems problems) throws SceneFormatException {
    boolean isNamed = text.length == 0 || file.toString().endsWith(".json");
    String found = ModelFormat.describe(text).orElse(isNamed ? "JSON" : "another kind of file");
    if (text.length > 0 && !found.equals("JSON")) {
      problems.error(
          Kind.INVALID,
          () -> "",
          "expected a scene (.json) or a model (%s), found %s"
              .formatted(ModelFormat.ENDINGS, found));
      throw problems.exception();
    }
  }

  /** Returns the existing files that a scene's assets name; see {@link SceneParser#files(Path)}. */
  static Set<Path> namedBy(byte[] content, Path file) throws SceneFormatException, IOException {
    Problems problems = new Problems(String.valueOf(file.getFileName()));
    JsonNode root = JsonNode.read(content, problems, Limits.NONE);
    if (root.asObject().isEmpty()) {
      throw problems.exception();
    }
    AssetData data =
        new AssetData(
            file,
            new ContentHash(),
            Allowance.unlimited(),
            Map.of(),
            List.of(),
            Optional.empty());
    Set<Path> files =
        new LinkedHashSet<>(
            data.files(root.objects(RootKeys.ASSETS.name()), ObjectKeys.FILE));
    ObjectTree tree = ObjectTree.of(root);
    files.addAll(data.modelFiles(tree.nodes(ObjectTree.Type.MODEL)));
    files.addAll(data.files(tree.nodes(ObjectTree.Type.LIGHT), LightKinds.PROFILE));
    return files;
  }
}
