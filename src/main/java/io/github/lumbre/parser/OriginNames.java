package io.github.lumbre.parser;

import io.github.lumbre.parser.internal.Origin;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;

/**
 * Gives each place in a scene file its own name: the name in the file, followed by a number if
 * another place has the same; without a name, the path. Mutable.
 */
final class OriginNames {
  /** The names by path and name in the file, between them a NUL, which is in neither. */
  private final Map<String, String> names = new HashMap<>();

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
    String key = origin.path() + '\0' + origin.name();
    return key.length() == 1 ? missing : names.computeIfAbsent(key, k -> unused(origin));
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
