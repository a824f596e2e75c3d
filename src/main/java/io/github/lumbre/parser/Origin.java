package io.github.lumbre.parser;

import java.util.Objects;

/**
 * Where in a scene file something stands. Nothing in it can control a terminal.
 *
 * @param path as {@code $.objects[3].children[0]}; a very long one lacks its middle
 * @param name that the file gives it; empty if none
 */
public record Origin(String path, String name) {
  /** Of what no part of the file stands for, such as the material of an object without one. */
  public static final Origin NONE = new Origin("", "");

  public Origin {
    Objects.requireNonNull(path, "path");
    Objects.requireNonNull(name, "name");
  }

  static Origin of(JsonNode node) {
    String name = node.find("name").flatMap(JsonNode::text).map(Problems::shortened).orElse("");
    return new Origin(Problems.shownPath(node.path()), name);
  }

  /** Returns the path, and the name if there is one, for people. */
  @Override
  public String toString() {
    return name.isEmpty() ? path : path + " \"" + name + '"';
  }
}
