package io.github.lumbre.cli.mcp;

import io.github.lumbre.math.internal.Sha256;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelFormatException;
import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Access to files that notes which of them were read, and what was in them. Thread-safe. */
final class SeenFiles implements ModelFolder {
  private static final String NONE = "";

  private final ModelFolder files;
  private final Map<String, String> hashes = new LinkedHashMap<>();

  SeenFiles(ModelFolder files) {
    this.files = files;
  }

  @Override
  public byte[] read(String name, String location) throws ModelFormatException, IOException {
    try {
      byte[] content = files.read(name, location);
      note(name, Sha256.of(content));
      return content;
    } catch (ModelFormatException e) {
      note(name, NONE);
      throw e;
    }
  }

  private synchronized void note(String name, String hash) {
    hashes.put(name, hash);
  }

  @Override
  public List<String> similar(String name) {
    return files.similar(name);
  }

  /**
   * Returns whether the files have the same content as when they were read.
   *
   * @param now access to the same files
   */
  synchronized boolean areSame(ModelFolder now) throws IOException {
    for (Map.Entry<String, String> file : hashes.entrySet()) {
      if (!hash(file.getKey(), now).equals(file.getValue())) {
        return false;
      }
    }
    return true;
  }

  private static String hash(String name, ModelFolder now) throws IOException {
    try {
      return Sha256.of(now.read(name, NONE));
    } catch (ModelFormatException e) {
      return NONE;
    }
  }
}
