package io.github.lumbre.scenefile;

/** Values of scene files that are written. */
final class Written {
  private Written() {}

  /** Returns the name of the class of a thing that the format does not have. */
  static String name(Object thing) {
    String name = thing.getClass().getSimpleName();
    return name.isEmpty() || thing.getClass().isSynthetic() ? "one that code computes" : name;
  }
}
