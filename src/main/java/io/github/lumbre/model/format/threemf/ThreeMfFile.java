package io.github.lumbre.model.format.threemf;

import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.format.FormatFile;
import io.github.lumbre.model.format.ZipParts;

/** What the readers of all parts of one 3MF file share. Mutable. */
final class ThreeMfFile extends FormatFile {
  private final ZipParts parts;

  ThreeMfFile(ZipParts parts, ModelOptions options) {
    super(parts, options);
    this.parts = parts;
  }

  ZipParts parts() {
    return parts;
  }
}
