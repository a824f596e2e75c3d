package io.github.lumbre.scene.internal;

import io.github.lumbre.base.text.Spelling;
import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.internal.CssColor;
import io.github.lumbre.math.internal.Range;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.SettingType;
import java.util.Arrays;
import java.util.Collections;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The types of settings. */
public final class SettingTypes {
  private SettingTypes() {}

  /** Integers in a range, with both ends included. */
  public record IntegerType(int low, int high) implements SettingType<Integer> {
    @Override
    public Integer parse(String text) {
      return number(text, Integer::valueOf, "an integer up to " + Integer.MAX_VALUE);
    }

    @Override
    public boolean accepts(Integer value) {
      return value >= low && value <= high;
    }

    @Override
    public String expected() {
      return low + " to " + high;
    }
  }

  /** Powers of two from 1 to the highest one. */
  public record PowerType(int high) implements SettingType<Integer> {
    @Override
    public Integer parse(String text) {
      return number(text, Integer::valueOf, expected());
    }

    @Override
    public boolean accepts(Integer value) {
      return value >= 1 && value <= high && Integer.bitCount(value) == 1;
    }

    @Override
    public String expected() {
      return "a power of two from 1 to " + high;
    }
  }

  /** All 64-bit integers. */
  public record LongType() implements SettingType<Long> {
    @Override
    public Long parse(String text) {
      return number(text, Long::valueOf, expected());
    }

    @Override
    public String expected() {
      return "an integer up to " + Long.MAX_VALUE;
    }
  }

  /** Positive numbers, infinity included: a limit that may be absent. */
  public record LimitType() implements SettingType<Double> {
    @Override
    public Double parse(String text) {
      return number(text, Double::valueOf, "a number");
    }

    @Override
    public boolean accepts(Double value) {
      return value > 0;
    }

    @Override
    public String expected() {
      return "more than 0";
    }
  }

  /** Numbers in a range. */
  public record NumberType(Range range) implements SettingType<Double> {
    /** Creates a range with both ends included. */
    public NumberType(double low, double high) {
      this(Range.closed(low, high));
    }

    @Override
    public Double parse(String text) {
      return number(text, Double::valueOf, expected());
    }

    @Override
    public boolean accepts(Double value) {
      return range.contains(value);
    }

    @Override
    public String expected() {
      return range.ifLow();
    }
  }

  /** The values {@code true} and {@code false}. */
  public record FlagType() implements SettingType<Boolean> {
    @Override
    public Boolean parse(String text) {
      if (!text.equals("true") && !text.equals("false")) {
        throw unexpected(expected(), text);
      }
      return Boolean.valueOf(text);
    }

    @Override
    public String expected() {
      return "true or false";
    }

    @Override
    public List<String> names() {
      return List.of("true", "false");
    }
  }

  /** The constants of an enum, written in lower case with hyphens. */
  public record ChoiceType<E extends Enum<E>>(Class<E> type) implements SettingType<E> {
    @Override
    public E parse(String text) {
      return Arrays.stream(type.getEnumConstants())
          .filter(value -> format(value).equals(text))
          .findFirst()
          .orElseThrow(() -> unexpected(expected(), text));
    }

    @Override
    public String expected() {
      return "one of " + String.join(", ", names());
    }

    @Override
    public List<String> names() {
      return List.copyOf(choices().keySet());
    }

    @Override
    public String format(E value) {
      return SettingType.nameOf(value);
    }

    /** Returns the constants by their text form, in the order of their declaration. */
    public Map<String, E> choices() {
      return Arrays.stream(type.getEnumConstants())
          .collect(
              Collectors.toMap(this::format, Function.identity(), (a, b) -> a, LinkedHashMap::new));
    }
  }

  /** A number of stops, or {@code auto}. */
  public record ExposureType() implements SettingType<Exposure> {
    @Override
    public Exposure parse(String text) {
      if (text.equals(SettingType.AUTO)) {
        return Exposure.AUTO;
      }
      try {
        return Exposure.of(Double.parseDouble(text));
      } catch (IllegalArgumentException e) {
        throw unexpected(expected(), text);
      }
    }

    @Override
    public String expected() {
      return "auto or a finite number of stops";
    }

    @Override
    public List<String> names() {
      return List.of(SettingType.AUTO);
    }

    @Override
    public String format(Exposure value) {
      return value.stops().isPresent()
          ? String.valueOf(value.stops().getAsDouble())
          : SettingType.AUTO;
    }
  }

  /** A color of the screen as a linear color, in a form of CSS; empty for none. */
  public record ScreenColorType() implements SettingType<Optional<Rgb>> {
    @Override
    public Optional<Rgb> parse(String text) {
      if (text.isEmpty()) {
        return Optional.empty();
      }
      Optional<Rgb> color = CssColor.of(text);
      if (color.isEmpty()) {
        String message = unexpected(expected(), text).getMessage();
        throw new IllegalArgumentException(
            message + Spelling.suggestion(text, CssColor.known()));
      }
      return color;
    }

    @Override
    public boolean accepts(Optional<Rgb> value) {
      return value.map(CssColor::isOnScreen).orElse(true);
    }

    @Override
    public String expected() {
      return "a color such as #ff8800, or a name of a CSS color such as white";
    }

    @Override
    public String format(Optional<Rgb> value) {
      return value.map(CssColor::text).orElse("");
    }
  }

  /** Layers, separated by commas: their names, {@code all} or {@code denoise}. */
  public record LayersType() implements SettingType<Set<Layer>> {
    @Override
    public Set<Layer> parse(String text) {
      EnumSet<Layer> layers = EnumSet.noneOf(Layer.class);
      if (!text.isEmpty()) {
        for (String name : text.split(",", -1)) {
          layers.addAll(named(name.strip()));
        }
      }
      return Collections.unmodifiableSet(layers);
    }

    private Set<Layer> named(String name) {
      return switch (name) {
        case Layer.ALL -> EnumSet.allOf(Layer.class);
        case Layer.DENOISE -> Layer.FOR_DENOISING;
        default -> Set.of(Layer.named(name).orElseThrow(() -> unknown(name)));
      };
    }

    private IllegalArgumentException unknown(String name) {
      List<String> known = Arrays.stream(Layer.values()).map(Layer::text).toList();
      String message = unexpected(expected(), name).getMessage();
      return new IllegalArgumentException(message + Spelling.suggestion(name, known));
    }

    @Override
    public String expected() {
      return Arrays.stream(Layer.values())
          .map(Layer::text)
          .collect(Collectors.joining(", ", "all, denoise, or some of ", ""));
    }

    @Override
    public List<String> names() {
      Stream<String> groups = Stream.of(Layer.ALL, Layer.DENOISE);
      return Stream.concat(groups, Arrays.stream(Layer.values()).map(Layer::text)).toList();
    }

    @Override
    public String format(Set<Layer> value) {
      return value.stream().map(Layer::text).collect(Collectors.joining(","));
    }
  }

  private static <N> N number(String text, Function<String, N> parser, String expected) {
    try {
      return parser.apply(text);
    } catch (NumberFormatException e) {
      throw unexpected(expected, text);
    }
  }

  private static IllegalArgumentException unexpected(String expected, String found) {
    return new IllegalArgumentException("expected " + expected + ", found '" + found + "'");
  }
}
