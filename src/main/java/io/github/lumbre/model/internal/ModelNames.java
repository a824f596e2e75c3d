package io.github.lumbre.model.internal;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.base.text.Spelling;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import java.util.Collection;
import java.util.List;
import java.util.stream.Collectors;

/** Chooses from the names in a model. Stateless. */
public final class ModelNames {
  private static final int MAX_CHOICES = 20;

  private ModelNames() {}

  /**
   * Returns the index of a name.
   *
   * @param what the kind of the named thing, with an article
   * @throws ModelFormatException that lists the names, if the wanted one is none of them
   */
  public static int index(String location, String what, List<String> names, String wanted)
      throws ModelFormatException {
    int index = names.indexOf(wanted);
    if (index >= 0) {
      return index;
    }
    String quoted = PrintableText.quoted(wanted);
    throw Kind.MALFORMED.at(
        location,
        names.isEmpty()
            ? "expected " + what + " " + quoted + ", found none in the model"
            : "expected "
                + choice(names)
                + ", found "
                + quoted
                + Spelling.suggestion(wanted, names));
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
