package io.github.lumbre.model.format;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.ModelLimits;
import java.util.ArrayList;
import java.util.List;

/** The prefixes that the open elements of an XML text declare (Namespaces in XML 1.0). Mutable. */
final class XmlNamespaces {
  private static final int MAX_COUNT = 1000;

  /** A prefix that means a namespace within an element. */
  private record Declaration(String prefix, String uri, int depth) {}

  private final List<Declaration> declarations = new ArrayList<>();

  /**
   * Declares a prefix.
   *
   * @param prefix empty for elements without one
   * @param depth of the element that declares it
   * @param location of the element, for messages
   */
  void declare(String prefix, String uri, int depth, String location) throws ModelFormatException {
    declarations.add(new Declaration(prefix, uri, depth));
    ModelLimits.require(location, "namespaces", MAX_COUNT, declarations.size());
  }

  /** Forgets what elements deeper than a depth have declared. */
  void leave(int depth) {
    for (int i = declarations.size() - 1; i >= 0 && declarations.get(i).depth > depth; i--) {
      declarations.remove(i);
    }
  }

  /** Returns the namespace of a prefix; empty if it has none. */
  String of(String prefix) {
    for (int i = declarations.size() - 1; i >= 0; i--) {
      if (declarations.get(i).prefix.equals(prefix)) {
        return declarations.get(i).uri;
      }
    }
    return "";
  }
}
