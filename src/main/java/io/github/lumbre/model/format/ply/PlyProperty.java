package io.github.lumbre.model.format.ply;

import java.util.Optional;

/**
 * A property in the header of a PLY file.
 *
 * @param type of the number, or of the items of a list
 * @param countType of the length of a list, an integer type; empty if the property is one number
 */
record PlyProperty(String name, PlyType type, Optional<PlyType> countType) {

  boolean isList() {
    return countType.isPresent();
  }

  /** Returns the least number of bytes in a binary file. */
  int minBytes() {
    return countType.orElse(type).bytes();
  }
}
