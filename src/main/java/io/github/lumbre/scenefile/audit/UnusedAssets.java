package io.github.lumbre.scenefile.audit;

import io.github.lumbre.scenefile.internal.ParsedScene;
import io.github.lumbre.scenefile.internal.SceneOrigins;
import java.util.List;

/** Reports assets of the file that the rendered scene does not use. */
final class UnusedAssets implements Check {
  @Override
  public List<Finding> of(ParsedScene file, Pilot pilot) {
    return file.origins().unused().stream().map(UnusedAssets::finding).toList();
  }

  private static Finding finding(SceneOrigins.Unused unused) {
    return Finding.note(
        "unused",
        unused.origin(),
        "the " + unused.type() + " is not used by any rendered object",
        "it is not decoded, so its errors stay unreported",
        "remove it, or check for a reference with a wrong id");
  }
}
