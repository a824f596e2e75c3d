package io.github.lumbre.parser;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;

/**
 * Gives each place in a scene file its own name: the name in the file, followed by a number if
 * another place has the same; without a name, the path. Mutable.
 */
final class OriginNames {
  private final Map<Origin, String> names = new HashMap<>();
  private final Set<String> taken = new HashSet<>();

  /** The next number for each name that has been given. */
  private final Map<String, Integer> next = new HashMap<>();

  private final String missing;

  /**
   * @param missing name of {@link Origin#NONE}
   */
  OriginNames(String missing) {
    this.missing = missing;
    taken.add(missing);
  }

  String of(Origin origin) {
    return origin.equals(Origin.NONE) ? missing : names.computeIfAbsent(origin, this::unused);
  }

  private String unused(Origin origin) {
    String wanted = origin.name().isEmpty() ? origin.path() : origin.name();
    String name = wanted;
    while (!taken.add(name)) {
      name = wanted + " " + next.merge(wanted, 2, (number, two) -> number + 1);
    }
    return name;
  }
}
