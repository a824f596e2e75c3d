package io.github.lumbre.model.format.ply;

import java.util.List;

/**
 * An element in the header of a PLY file.
 *
 * @param count the number of items
 */
record PlyElement(String name, int count, List<PlyProperty> properties) {

  boolean isVertex() {
    return name.equals("vertex");
  }

  /** Returns the least number of bytes of an item in a binary file. */
  long minBinaryBytes() {
    return properties.stream().mapToLong(PlyProperty::minBytes).sum();
  }

  /** Returns the least number of bytes of an item in a text: digits with separators. */
  long minTextBytes() {
    return 2L * properties.size();
  }
}
