package io.github.lumbre.scenefile;

/** Thrown for a part of a scene that the scene format does not have. */
final class Unwritable extends IllegalArgumentException {
  private static final long serialVersionUID = 1;

  Unwritable(String expected, String found) {
    super("expected " + expected + ", found " + found);
  }

  private Unwritable(String message, Unwritable cause) {
    super(message, cause);
  }

  /** Returns the name of the class of a thing that the format does not have. */
  static String name(Object thing) {
    String name = thing.getClass().getSimpleName();
    return name.isEmpty() || thing.getClass().isSynthetic() ? "one that code computes" : name;
  }

  /** Returns this problem with the place where it is. */
  Unwritable at(String place) {
    return new Unwritable(place + ": " + getMessage(), this);
  }
}
