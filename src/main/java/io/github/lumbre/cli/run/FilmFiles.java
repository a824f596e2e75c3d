package io.github.lumbre.cli.run;

import io.github.lumbre.scenefile.internal.FileHashes;
import io.github.lumbre.scenefile.internal.LateHash;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * The hashes of a scene's files, as stored in a film's header. Each line has the hash, a space and
 * the file's name in the scene. The scene file itself comes first and has no name.
 */
final class FilmFiles {
  /** The maximum length of the text; a film's header is limited to one megabyte. */
  private static final int MAX_LENGTH = 1 << 18;

  private FilmFiles() {}

  /** Returns the text for the header; empty if it is too long. */
  static Optional<String> text(FileHashes files) {
    StringBuilder text = new StringBuilder(files.scene().value()).append(' ');
    files.assets().forEach((name, hash) -> text.append('\n').append(hash.value() + " " + name));
    return text.length() > MAX_LENGTH ? Optional.empty() : Optional.of(text.toString());
  }

  /**
   * Returns the names of changed and of missing files.
   *
   * @param then text of the film's header
   * @param sceneName name of the scene file in the result
   */
  static List<String> changed(String then, FileHashes now, String sceneName) {
    Map<String, String> before = new TreeMap<>();
    for (String line : then.split("\n")) {
      int space = line.indexOf(' ');
      if (space > 0) {
        before.put(line.substring(space + 1), line.substring(0, space));
      }
    }
    List<String> changed = new ArrayList<>();
    if (!now.scene().value().equals(before.get(""))) {
      changed.add(sceneName);
    }
    before.remove("");
    before.forEach(
        (name, hash) -> {
          LateHash present = now.assets().get(name);
          if (present == null || !hash.equals(present.value())) {
            changed.add(name);
          }
        });
    return changed;
  }
}
