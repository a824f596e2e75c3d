package io.github.lumbre.model.internal;

import io.github.lumbre.model.ModelOptions.Pose;
import io.github.lumbre.scene.SettingType;
import io.github.lumbre.scene.internal.SettingTypes.NumberType;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Predicate;

/** The types of the options of a model, besides those of settings. */
public final class OptionTypes {
  private OptionTypes() {}

  /** Any text, such as a name. */
  public record TextType(String expected) implements SettingType<String> {
    @Override
    public String parse(String text) {
      return text;
    }
  }

  /** Values with names, which may have any case. */
  public record NamedType<T>(Map<String, T> choices) implements SettingType<T> {
    public NamedType {
      choices = Collections.unmodifiableMap(new TreeMap<>(choices));
    }

    @Override
    public T parse(String text) {
      return Optional.ofNullable(choices.get(text.toLowerCase(Locale.ROOT)))
          .orElseThrow(
              () -> new IllegalArgumentException("expected " + expected() + ", found " + text));
    }

    @Override
    public boolean accepts(T value) {
      return choices.containsValue(value);
    }

    @Override
    public String expected() {
      return String.join(" or ", names());
    }

    @Override
    public String format(T value) {
      return names().stream()
          .filter(name -> choices.get(name).equals(value))
          .findFirst()
          .orElse(String.valueOf(value));
    }

    @Override
    public List<String> names() {
      return List.copyOf(choices.keySet());
    }
  }

  /**
   * Lists of texts. A list is accepted if all of its texts are.
   *
   * @param separator of the texts in one text; empty if one text is one element
   */
  public record TextsType(String expected, String separator, Predicate<String> accepted)
      implements SettingType<List<String>> {
    @Override
    public List<String> parse(String text) {
      List<String> texts = separator.isEmpty() ? List.of(text) : List.of(text.split(separator, -1));
      if (!accepts(texts)) {
        throw new IllegalArgumentException("expected " + expected + ", found " + text);
      }
      return texts;
    }

    @Override
    public boolean accepts(List<String> value) {
      return value.stream().allMatch(accepted);
    }

    @Override
    public String format(List<String> value) {
      return String.join(separator, value);
    }

    @Override
    public String found(List<String> value) {
      return value.stream().filter(accepted.negate()).findFirst().orElseThrow();
    }
  }

  /** Lists of folders. */
  public record FoldersType() implements SettingType<List<Path>> {
    @Override
    public List<Path> parse(String text) {
      return List.of(Path.of(text));
    }

    @Override
    public String expected() {
      return "folders";
    }
  }

  /** Poses of animations at a time, such as {@code walk@0.5}. */
  public record PoseType() implements SettingType<Pose> {
    /** The times of poses in seconds. */
    public static final NumberType SECONDS = new NumberType(0, Double.MAX_VALUE);

    @Override
    public Pose parse(String text) {
      int at = text.lastIndexOf('@');
      if (at < 0) {
        throw new IllegalArgumentException(
            "expected NAME@SECONDS, such as " + text + "@0, found " + text);
      }
      double seconds = finite(text.substring(at + 1));
      if (!SECONDS.accepts(seconds)) {
        throw new IllegalArgumentException(SECONDS.refusal(seconds));
      }
      return new Pose(text.substring(0, at), seconds);
    }

    @Override
    public String expected() {
      return "NAME@SECONDS";
    }

    @Override
    public String format(Pose value) {
      return value.animation() + "@" + value.seconds();
    }
  }

  /**
   * Returns the number in a text.
   *
   * @throws IllegalArgumentException if it is none, or not finite
   */
  public static double finite(String text) {
    double number;
    try {
      number = Double.parseDouble(text);
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException("expected a number, found " + text, e);
    }
    if (!Double.isFinite(number)) {
      throw new IllegalArgumentException("expected a finite number, found " + text);
    }
    return number;
  }
}
