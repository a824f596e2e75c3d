package io.github.lumbre.model;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/** Collects the warnings about a glTF file, each once. Mutable. */
final class GltfWarnings {
  private static final int MAX_WARNINGS = 1000;

  private final Set<String> warnings = new LinkedHashSet<>();
  private boolean more;

  /**
   * Adds a warning, or counts it if there are too many.
   *
   * @param location in the file; empty if the whole file is meant
   */
  void add(String location, String message) {
    if (warnings.size() < MAX_WARNINGS) {
      warnings.add(location.isEmpty() ? message : location + ": " + message);
    } else {
      more = true;
    }
  }

  /** Returns the warnings in the order in which they were added. */
  List<String> list() {
    List<String> list = new ArrayList<>(warnings);
    if (more) {
      list.add("more than " + MAX_WARNINGS + " warnings; the others are left out");
    }
    return list;
  }
}
