package io.github.lumbre.cli.option;

import java.util.List;

/** A converter that lists the named values of a flag, which shells complete. */
public interface Choices {
  /** Returns the names that the converter accepts. */
  List<String> choices();

  /** Returns whether a value may consist of several names, separated by commas. */
  default boolean isList() {
    return false;
  }
}
