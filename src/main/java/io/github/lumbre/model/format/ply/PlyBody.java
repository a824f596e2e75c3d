package io.github.lumbre.model.format.ply;

import io.github.lumbre.model.ModelFormatException;

/** Reads the numbers after the header of a PLY file in their order. Mutable. */
interface PlyBody {
  /** Returns the number of bytes that are left. */
  long remainingBytes();

  /** Returns the least number of bytes of an item. */
  long minBytes(PlyElement element);

  /**
   * Moves to an item of an element.
   *
   * @param number of the item, from 0
   */
  void beginItem(PlyElement element, int number) throws ModelFormatException;

  /** Returns a number of any type; of floats, infinities and NaN are possible. */
  double number(PlyProperty property) throws ModelFormatException;

  /** Returns a number of an integer type. */
  long integer(PlyProperty property) throws ModelFormatException;

  /** Returns the length of a list; at least 0, and at most as many items as bytes can hold. */
  int listLength(PlyProperty property) throws ModelFormatException;

  /** Ends an item, all of whose properties have been read. */
  void endItem();

  /** Returns the place of the item, for messages. */
  String location();

  /** Returns an exception that names the place. */
  ModelFormatException error(String message);
}
