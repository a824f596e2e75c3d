package io.github.lumbre.scene.internal;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;

/** Gives each object its own name: the wanted one, followed by a number if it is taken. Mutable. */
public final class Names {
  private static final int LONGEST = 60;

  private final Set<String> taken = new HashSet<>();
  private final Map<String, Integer> next = new HashMap<>();

  /**
   * @param reserved a name that stands for no object
   */
  public Names(String reserved) {
    taken.add(reserved);
  }

  /** Returns a name that no object has yet: the wanted one, or that and a number. */
  public String unused(String wanted) {
    String name = wanted;
    while (!taken.add(name)) {
      name = wanted + " " + next.merge(wanted, 2, (number, two) -> number + 1);
    }
    return name;
  }

  /**
   * Returns a name if it can be one.
   *
   * @throws IllegalArgumentException if it is empty or too long, or has control characters
   */
  public static String require(String what, String name) {
    if (name.isEmpty() || name.length() > LONGEST) {
      throw new IllegalArgumentException(
          what + ": expected 1 to " + LONGEST + " characters, found " + name.length());
    }
    if (name.chars().anyMatch(Character::isISOControl)) {
      throw new IllegalArgumentException(
          what + ": expected no control characters, found one in a name");
    }
    return name;
  }
}
