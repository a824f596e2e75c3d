package io.github.lumbre.model.format.threemf;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.format.ObjTextures;
import io.github.lumbre.model.format.ZipParts;
import io.github.lumbre.model.internal.ModelFiles;
import io.github.lumbre.model.internal.ModelLimits;
import io.github.lumbre.model.internal.Tally;
import io.github.lumbre.model.internal.Warnings;

/** What the readers of all parts of one 3MF file share. Mutable. */
final class ThreeMfFile {
  private final ZipParts parts;
  private final ModelOptions options;
  private final Warnings warnings = new Warnings();
  private final Tally tally = new Tally();
  private final ObjTextures pictures;
  private long bytes;

  ThreeMfFile(ZipParts parts, ModelOptions options) {
    this.parts = parts;
    this.options = options;
    pictures = new ObjTextures(new ModelFiles(parts, options.limits(), warnings), options.limits());
  }

  ZipParts parts() {
    return parts;
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
