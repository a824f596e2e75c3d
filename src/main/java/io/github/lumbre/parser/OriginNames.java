package io.github.lumbre.parser;

import io.github.lumbre.parser.internal.Origin;
import io.github.lumbre.scene.internal.Names;
import java.util.HashMap;
import java.util.Map;

/**
 * Gives each place in a scene file its own name: the name in the file, followed by a number if
 * another place has the same; without a name, the path. Mutable.
 */
final class OriginNames {
  /** The names by path and name in the file, between them a NUL, which is in neither. */
  private final Map<String, String> names = new HashMap<>();

  private final Names given;
  private final String missing;

  /**
   * @param missing name of {@link Origin#NONE}
   */
  OriginNames(String missing) {
    this.missing = missing;
    given = new Names(missing);
  }

  String of(Origin origin) {
    String key = origin.path() + '\0' + origin.name();
    return key.length() == 1 ? missing : names.computeIfAbsent(key, k -> unused(origin));
  }

  private String unused(Origin origin) {
    return given.unused(origin.name().isEmpty() ? origin.path() : origin.name());
  }
}
