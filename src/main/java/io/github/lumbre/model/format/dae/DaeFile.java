package io.github.lumbre.model.format.dae;

import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.format.ObjTextures;
import io.github.lumbre.model.internal.ModelFiles;
import io.github.lumbre.model.internal.ModelLimits;
import io.github.lumbre.model.internal.Tally;
import io.github.lumbre.model.internal.Warnings;

/** What all parts of the reader of one COLLADA file share. Mutable. */
final class DaeFile {
  private final ModelOptions options;
  private final Warnings warnings = new Warnings();
  private final Tally tally = new Tally();
  private final ObjTextures pictures;
  private long bytes;

  DaeFile(ModelFolder folder, ModelOptions options) {
    this.options = options;
    pictures =
        new ObjTextures(new ModelFiles(folder, options.limits(), warnings), options.limits());
  }

  ModelOptions options() {
    return options;
  }

  Warnings warnings() {
    return warnings;
  }

  Tally tally() {
    return tally;
  }

  ObjTextures pictures() {
    return pictures;
  }

  /**
   * Counts memory before it is allocated.
   *
   * @throws ModelFormatException if the file needs more than the limits allow
   */
  void take(String location, long more) throws ModelFormatException {
    bytes += more;
    ModelLimits.requireMemory(location, bytes, options.limits());
  }
}
