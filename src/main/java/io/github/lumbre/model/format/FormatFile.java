package io.github.lumbre.model.format;

import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.ModelFiles;
import io.github.lumbre.model.internal.ModelLimits;
import io.github.lumbre.model.internal.Tally;
import io.github.lumbre.model.internal.Warnings;

/** What all parts of the reader of one file share. Mutable. */
public class FormatFile {
  private final ModelOptions options;
  private final Warnings warnings = new Warnings();
  private final Tally tally = new Tally();
  private final ObjTextures pictures;
  private long bytes;

  public FormatFile(ModelFolder folder, ModelOptions options) {
    this.options = options;
    pictures =
        new ObjTextures(new ModelFiles(folder, options.limits(), warnings), options.limits());
  }

  public ModelOptions options() {
    return options;
  }

  public Warnings warnings() {
    return warnings;
  }

  public Tally tally() {
    return tally;
  }

  public ObjTextures pictures() {
    return pictures;
  }

  /**
   * Counts memory before it is allocated.
   *
   * @throws ModelFormatException if the file needs more than the limits allow
   */
  public void take(String location, long more) throws ModelFormatException {
    bytes += more;
    ModelLimits.requireMemory(location, bytes, options.limits());
  }
}
