package io.github.lumbre.model;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** Collects warnings up to a limit. Mutable. */
final class Warnings {
  private static final int MAX_WARNINGS = 1000;

  private final List<String> texts = new ArrayList<>();
  private final Set<String> keys = new HashSet<>();
  private int dropped;

  /** Adds a warning with its place in the file. */
  void add(String location, String message) {
    add(location + ": " + message);
  }

  /** Adds a warning that begins with its place in the file. */
  void add(String message) {
    if (texts.size() < MAX_WARNINGS) {
      texts.add(message);
    } else {
      dropped++;
    }
  }

  /** Adds a warning unless there is one with this key. */
  void once(String key, String location, String message) {
    if (keys.size() < MAX_WARNINGS && keys.add(key)) {
      add(location, message);
    }
  }

  /** Returns all warnings; beyond the limit, the last one states how many are missing. */
  List<String> all() {
    List<String> all = new ArrayList<>(texts);
    if (dropped > 0) {
      all.add("and " + dropped + " more warnings");
    }
    return all;
  }
}
