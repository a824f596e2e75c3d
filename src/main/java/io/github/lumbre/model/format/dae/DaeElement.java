package io.github.lumbre.model.format.dae;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** An element of the file, with what the reader uses of it. Mutable while the file is parsed. */
final class DaeElement {
  private static final double[] NONE = {};

  private final String name;
  private final Map<String, String> attributes;
  private final String location;
  private final List<DaeElement> children = new ArrayList<>(2);
  private String text = "";
  private double[] numbers = NONE;
  private Optional<DaeIndices> indices = Optional.empty();

  DaeElement(String name, Map<String, String> attributes, String location) {
    this.name = name;
    this.attributes = attributes;
    this.location = location;
  }

  void add(DaeElement child) {
    children.add(child);
  }

  void setText(String stated) {
    text = stated;
  }

  void setNumbers(double... stated) {
    numbers = stated;
  }

  void setIndices(DaeIndices stated) {
    indices = Optional.of(stated);
  }

  /** Returns the name without its prefix. */
  String name() {
    return name;
  }

  boolean is(String wanted) {
    return name.equals(wanted);
  }

  /** Returns the place in the file, for messages. */
  String location() {
    return location;
  }

  /** Returns the value of an attribute; empty if there is none. */
  String attribute(String key) {
    return attributes.getOrDefault(key, "");
  }

  /** Returns the name that users see: that of the element, or its id; empty without both. */
  String title() {
    String stated = attribute("name");
    return stated.isBlank() ? attribute("id") : stated;
  }

  /** Returns an attribute as an integer from 0 on; otherwise if it is none. */
  int integer(String key, int otherwise) {
    String value = attribute(key).strip();
    boolean isInteger = value.matches("[0-9]{1,9}");
    return isInteger ? Integer.parseInt(value) : otherwise;
  }

  List<DaeElement> children() {
    return children;
  }

  /** Returns the children of a name. */
  List<DaeElement> children(String wanted) {
    return children.stream().filter(child -> child.is(wanted)).toList();
  }

  /** Returns the first element on a path of names. */
  Optional<DaeElement> find(String... path) {
    Optional<DaeElement> found = Optional.of(this);
    for (String step : path) {
      found = found.flatMap(e -> e.children.stream().filter(c -> c.is(step)).findFirst());
    }
    return found;
  }

  /** Returns the first element of a name below this one, of any depth, in the order of the file. */
  Optional<DaeElement> below(String wanted) {
    for (DaeElement child : children) {
      Optional<DaeElement> found =
          child.is(wanted) ? Optional.of(child) : child.below(wanted);
      if (found.isPresent()) {
        return found;
      }
    }
    return Optional.empty();
  }

  /** Returns the text before the first child, without space around it. */
  String text() {
    return text;
  }

  /** Returns the numbers of an array; empty for other elements. */
  double[] numbers() {
    return numbers;
  }

  /** Returns the indices of triangles and polygons; empty for other elements. */
  Optional<DaeIndices> indices() {
    return indices;
  }
}
