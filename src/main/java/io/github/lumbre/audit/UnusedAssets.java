package io.github.lumbre.audit;

import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.parser.SceneOrigins;
import java.util.List;

/** Assets of the file that nothing of the scene uses. */
final class UnusedAssets implements Check {
  @Override
  public List<Finding> of(SceneFile file, Pilot pilot) {
    return file.origins().unused().stream().map(UnusedAssets::finding).toList();
  }

  private static Finding finding(SceneOrigins.Unused unused) {
    return Finding.note(
        "unused",
        unused.origin(),
        "the " + unused.type() + " is used by nothing that is rendered",
        "it is not decoded, so that errors in it go unnoticed",
        "remove it, or look for a reference with another id");
  }
}
