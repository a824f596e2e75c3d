package io.github.lumbre.scene;

import io.github.lumbre.base.text.PrintableText;
import java.util.List;
import java.util.Locale;
import java.util.Objects;

/**
 * The allowed values of a {@link Setting}, and their text form in scene files, on the command line,
 * in checkpoint files and in picture metadata. Immutable.
 *
 * @param <T> the type of the values
 */
public interface SettingType<T> {
  /** The text form of a value that the program chooses. */
  String AUTO = "auto";

  /**
   * Returns the value of a text.
   *
   * @throws IllegalArgumentException if the text is invalid; the message names what was expected
   *     and what was found
   */
  T parse(String text);

  /** Returns whether a value is in range. */
  default boolean accepts(T value) {
    return true;
  }

  /** Returns a description of the allowed values, such as {@code 1 to 256}. */
  String expected();

  /** Returns the text form of a value, which {@link #parse} accepts. */
  default String format(T value) {
    return String.valueOf(value);
  }

  /** Returns the form of a value in help texts. */
  default String shown(T value) {
    return value instanceof Double number ? PrintableText.number(number) : format(value);
  }

  /** Returns what messages show of a value that is refused. */
  default String found(T value) {
    return format(value);
  }

  /**
   * Returns the value if it is in range.
   *
   * @throws IllegalArgumentException if it is not; the message has the name, the expected values
   *     and the value
   */
  default T require(String name, T value) {
    if (!accepts(Objects.requireNonNull(value, name))) {
      throw new IllegalArgumentException(name + ": " + refusal(value));
    }
    return value;
  }

  /** Returns the message about a value that is refused: what was expected, and what was found. */
  default String refusal(T value) {
    return "expected " + expected() + ", found " + found(value);
  }

  /** Returns the texts of the values that have names, such as {@code auto}. */
  default List<String> names() {
    return List.of();
  }

  /**
   * Returns the text form of an enum constant in scene files and on the command line: lower case
   * with hyphens.
   */
  static String nameOf(Enum<?> value) {
    return value.name().toLowerCase(Locale.ROOT).replace('_', '-');
  }
}
