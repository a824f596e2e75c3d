package io.github.lumbre.model.internal;

import io.github.lumbre.text.PrintableText;
import java.util.Collection;
import java.util.List;
import java.util.stream.Collectors;

/** Writes texts and numbers of a glTF file into messages. */
public final class GltfText {
  private static final int MAX_CHOICES = 20;

  private GltfText() {}

  /** Returns a number without a fraction if it is whole. */
  public static String number(double value) {
    return value == Math.rint(value) && Math.abs(value) < 1e15
        ? Long.toString((long) value)
        : Double.toString(value);
  }

  /** Returns names to choose from, such as {@code "a", "b" or "c"}. */
  public static String choice(Collection<String> names) {
    List<String> shown =
        names.stream().limit(MAX_CHOICES).map(PrintableText::quoted).collect(Collectors.toList());
    if (names.size() > MAX_CHOICES) {
      shown.add("another name");
    }
    int last = shown.size() - 1;
    return last == 0
        ? shown.get(0)
        : String.join(", ", shown.subList(0, last)) + " or " + shown.get(last);
  }
}
