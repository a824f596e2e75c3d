package io.github.lumbre.model;

import java.io.IOException;

/** Reads the files that a model names: those in the model's own folder and below. */
@FunctionalInterface
public interface ModelFolder {
  /**
   * Returns the bytes of a file.
   *
   * @param name relative path with / between names, percent-decoded
   * @param location of the reference in the model, for messages
   * @throws ModelFormatException if the name leaves the folder, or the file is missing or too large
   * @throws IOException if the thread is interrupted
   */
  byte[] read(String name, String location) throws ModelFormatException, IOException;
}
