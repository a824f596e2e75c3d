package io.github.lumbre.model.internal;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Collects the warnings about a model: what a file has, and the picture lacks. Each is listed once,
 * and at most 20 of a kind, with a count of the others. Mutable.
 */
public final class Warnings {
  private static final int MAX_OF_KIND = 20;
  private static final int MAX_KINDS = 1000;

  private final Set<String> texts = new LinkedHashSet<>();
  private final Map<String, Integer> kinds = new LinkedHashMap<>();
  private final Set<String> keys = new HashSet<>();
  private int others;

  /** Adds a warning whose message states its kind. */
  public void add(String location, String message) {
    add(message, location, message);
  }

  /**
   * Adds a warning.
   *
   * @param kind what all warnings of this kind have in common, for the line that counts the others
   * @param location in the file; empty if the whole file is meant
   */
  public void add(String kind, String location, String message) {
    String text = location.isEmpty() ? message : location + ": " + message;
    if (texts.contains(text)) {
      return;
    }
    if (kinds.size() >= MAX_KINDS && !kinds.containsKey(kind)) {
      others++;
    } else if (kinds.merge(kind, 1, Integer::sum) <= MAX_OF_KIND) {
      texts.add(text);
    }
  }

  /** Adds a warning unless there is one with this key. */
  public void once(String key, String location, String message) {
    if (keys.size() < MAX_KINDS && keys.add(key)) {
      add(location, message);
    }
  }

  /** Returns the warnings in the order in which they were added, then the counts of the others. */
  public List<String> all() {
    List<String> all = new ArrayList<>(texts);
    kinds.forEach(
        (kind, count) -> {
          if (count > MAX_OF_KIND) {
            all.add("and " + (count - MAX_OF_KIND) + " more: " + kind);
          }
        });
    if (others > 0) {
      all.add("and " + others + " more warnings");
    }
    return all;
  }
}
