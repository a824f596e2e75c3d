package io.github.lumbre.base.text;

import java.util.Collection;
import java.util.Comparator;
import java.util.Locale;
import java.util.Optional;
import java.util.function.BinaryOperator;

/** Suggests corrections for misspelled words. */
public final class Spelling {
  /** The shortest part of a word that suggests it. */
  private static final int SHORTEST = 4;

  /** Keeps one suggestion; of several, none is right. */
  private static final BinaryOperator<String> ONLY = (one, other) -> "";

  private Spelling() {}

  /** Returns {@code "; did you mean …?"}, or an empty text if no known word is similar. */
  public static String suggestion(String word, Collection<String> known) {
    return similar(word, known).map(found -> "; did you mean " + found + "?").orElse("");
  }

  /** Returns the known word that is most similar to a word; empty if none is. */
  public static Optional<String> similar(String word, Collection<String> known) {
    // Suggestions for very long words are not worth the search.
    if (word.length() > 40) {
      return Optional.empty();
    }
    int near = Math.max(1, word.length() / 3);
    return known.stream()
        .filter(candidate -> distance(word, candidate) <= near)
        .min(
            Comparator.comparingInt((String candidate) -> distance(word, candidate))
                .thenComparing(Comparator.naturalOrder()))
        .or(() -> known.stream().filter(candidate -> isShort(word, candidate)).reduce(ONLY))
        .filter(candidate -> !candidate.isEmpty());
  }

  /**
   * Returns whether a word is short for another one: its initials, as fov of fieldOfView, or its
   * beginning or end, as position of localPosition.
   */
  private static boolean isShort(String word, String whole) {
    String initials = whole.isEmpty() ? "" : whole.charAt(0) + whole.replaceAll("[^A-Z]", "");
    String small = word.toLowerCase(Locale.ROOT);
    String all = whole.toLowerCase(Locale.ROOT);
    return initials.length() > 1 && initials.equalsIgnoreCase(word)
        || word.length() >= SHORTEST && (all.startsWith(small) || all.endsWith(small));
  }

  /**
   * Returns the edit distance of two words, ignoring case: the number of letters to insert, remove,
   * replace, or swap with a neighbor (Damerau 1964).
   */
  static int distance(String one, String other) {
    String a = one.toLowerCase(Locale.ROOT);
    String b = other.toLowerCase(Locale.ROOT);
    int[][] edits = new int[a.length() + 1][b.length() + 1];
    for (int i = 0; i <= a.length(); i++) {
      for (int j = 0; j <= b.length(); j++) {
        edits[i][j] = i == 0 || j == 0 ? i + j : fewest(a, b, i, j, edits);
      }
    }
    return edits[a.length()][b.length()];
  }

  private static int fewest(String a, String b, int i, int j, int[][] edits) {
    int replaced = edits[i - 1][j - 1] + (a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1);
    int fewest = Math.min(replaced, 1 + Math.min(edits[i - 1][j], edits[i][j - 1]));
    boolean swapped =
        i > 1 && j > 1 && a.charAt(i - 1) == b.charAt(j - 2) && a.charAt(i - 2) == b.charAt(j - 1);
    return swapped ? Math.min(fewest, edits[i - 2][j - 2] + 1) : fewest;
  }
}
