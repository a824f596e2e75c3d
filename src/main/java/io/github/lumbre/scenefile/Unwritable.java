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

  /** Returns this problem with the place where it is. */
  Unwritable at(String place) {
    return new Unwritable(place + ": " + getMessage(), this);
  }
}
