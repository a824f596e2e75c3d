package io.github.lumbre.model.internal;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import java.io.IOException;
import java.util.List;

/**
 * Reads the files that a model names. In place of a file that is missing, or outside the model's
 * folder, the only one of its last name in the folder is used, with a warning; see {@link
 * ModelFolder#similar}. Models whose bytes are limited are uploads, and get no other file.
 */
public final class ModelFiles {
  private final ModelFolder folder;
  private final boolean searches;
  private final Warnings warnings;

  public ModelFiles(ModelFolder folder, Limits limits, Warnings warnings) {
    this.folder = folder;
    searches = !limits.hasLimitedBytes();
    this.warnings = warnings;
  }

  /** Returns the bytes of a file; see {@link ModelFolder#read}. */
  public byte[] read(String name, String location) throws ModelFormatException, IOException {
    try {
      return folder.read(name, location);
    } catch (ModelFormatException e) {
      if (e.kind() != Kind.ASSET || !searches) {
        throw e;
      }
      String found = onlySimilar(name, e);
      byte[] bytes = folder.read(found, location);
      warnings.add(
          "another file is used",
          location,
          e.detail() + "; " + PrintableText.quoted(found) + " is used");
      return bytes;
    }
  }

  private String onlySimilar(String name, ModelFormatException missing)
      throws ModelFormatException {
    List<String> similar = folder.similar(name);
    if (similar.isEmpty()) {
      throw missing;
    }
    if (similar.size() > 1) {
      throw Kind.ASSET.at(
          missing.location(),
          missing.detail() + "; there are several of that name: " + ModelNames.choice(similar));
    }
    return similar.get(0);
  }
}
