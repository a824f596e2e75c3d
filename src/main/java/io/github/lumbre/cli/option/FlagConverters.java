package io.github.lumbre.cli.option;

import io.github.lumbre.cli.output.PixelPlace;
import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.image.animation.FrameRate;
import io.github.lumbre.image.internal.ImageFormat;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.scene.RenderSettings.Mode;
import io.github.lumbre.scene.internal.FrameSize;
import io.github.lumbre.scene.internal.SettingTypes.ChoiceType;
import java.math.BigDecimal;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Converters of flag values from text; errors state what was expected and what was found. */
public final class FlagConverters {
  private static final String DIGITS = "(\\d{1,9})";
  private static final Pattern PIXEL = Pattern.compile(DIGITS + "," + DIGITS);
  private static final Pattern CROP =
      Pattern.compile(String.join(",", DIGITS, DIGITS, DIGITS, DIGITS));
  private static final Pattern DURATION = Pattern.compile("(\\d{1,9}(?:\\.\\d{1,9})?)([smh])");

  /** Its nanoseconds are less than half of the largest long. */
  private static final int LONGEST_HOURS = 1_000_000;

  private static final Map<String, Double> SECONDS = Map.of("s", 1., "m", 60., "h", 3600.);

  private static final List<OfChoice<?>> CHOICES =
      List.of(
          new OfChoice<>(Mode.class),
          new OfChoice<>(Quality.class),
          new OfChoice<>(Kernel.class),
          new OfChoice<>(ImageFormat.class),
          new OfChoice<>(DenoiserFlags.Engine.class),
          new OfChoice<>(ProgressStyle.class),
          new OfChoice<>(Shell.class));

  private FlagConverters() {}

  /** Registers the converters of all types of values. */
  public static void register(CommandLine command) {
    String integer = "an integer up to ";
    ITypeConverter<Integer> ofInt =
        text -> number(Integer::valueOf, integer + Integer.MAX_VALUE, text);
    ITypeConverter<Long> ofLong = text -> number(Long::valueOf, integer + Long.MAX_VALUE, text);
    command.registerConverter(int.class, ofInt).registerConverter(Integer.class, ofInt);
    command.registerConverter(Long.class, ofLong);
    command.registerConverter(Double.class, text -> number(Double::valueOf, "a number", text));
    command.registerConverter(BigDecimal.class, text -> number(BigDecimal::new, "a number", text));
    command.registerConverter(Duration.class, FlagConverters::duration);
    command.registerConverter(FrameSize.class, text -> explained(FrameSize::of, text));
    command.registerConverter(FrameRate.class, text -> explained(FrameRate::parse, text));
    command.registerConverter(Crop.class, FlagConverters::crop);
    command.registerConverter(PixelPlace.class, FlagConverters::pixel);
    CHOICES.forEach(choice -> choice.register(command));
  }

  /** Returns the converter that lists the named values of a type; empty without such values. */
  public static Optional<Choices> choices(Class<?> type) {
    return CHOICES.stream()
        .filter(choice -> choice.type == type)
        .map(Choices.class::cast)
        .findFirst();
  }

  private static <N> N number(Function<String, N> parser, String expected, String text) {
    try {
      return parser.apply(text);
    } catch (NumberFormatException e) {
      throw unexpected(expected, text);
    }
  }

  private static PixelPlace pixel(String text) {
    Matcher found = matched(PIXEL, "x,y in pixels, such as 100,50", text);
    return new PixelPlace(number(found, 1), number(found, 2));
  }

  private static Crop crop(String text) {
    Matcher found = matched(CROP, "x,y,w,h in pixels, such as 100,50,64,48", text);
    return explained(
        all -> new Crop(number(found, 1), number(found, 2), number(found, 3), number(found, 4)),
        text);
  }

  private static Matcher matched(Pattern form, String expected, String text) {
    Matcher found = form.matcher(text);
    if (!found.matches()) {
      throw unexpected(expected, text);
    }
    return found;
  }

  private static int number(Matcher found, int group) {
    return Integer.parseInt(found.group(group));
  }

  /** Returns a duration such as {@code 90s}, {@code 5m} or {@code 1.5h}, above 0. */
  private static Duration duration(String text) {
    Matcher found = DURATION.matcher(text);
    double seconds =
        found.matches() ? Double.parseDouble(found.group(1)) * SECONDS.get(found.group(2)) : 0;
    long nanos = (long) (seconds * 1e9);
    if (nanos == 0 || seconds > LONGEST_HOURS * SECONDS.get("h")) {
      throw unexpected(
          "a duration above 0 and up to " + LONGEST_HOURS + "h, such as 90s, 5m or 2h", text);
    }
    return Duration.ofNanos(nanos);
  }

  /** Parses a text with a parser whose errors state what was expected. */
  private static <V> V explained(Function<String, V> parser, String text) {
    try {
      return parser.apply(text);
    } catch (IllegalArgumentException e) {
      throw new TypeConversionException(e.getMessage());
    }
  }

  /** {@code 2%}: a share above 0. */
  public static final class OfShare implements ITypeConverter<Double> {
    private static final Pattern FORM = Pattern.compile("(\\d{1,9}(?:\\.\\d{1,9})?)%");

    @Override
    public Double convert(String text) {
      Matcher found = FORM.matcher(text);
      double percent = found.matches() ? Double.parseDouble(found.group(1)) : 0;
      if (percent == 0) {
        throw unexpected("a percentage above 0, such as 2%", text);
      }
      return percent / 100;
    }
  }

  /** A shell that completes commands. */
  public enum Shell {
    BASH,
    ZSH,
    FISH,
    POWERSHELL
  }

  /** How a render shows its progress. */
  enum ProgressStyle {
    BAR,
    JSON,
    NONE
  }

  /** The constants of an enum, written as in scene files. */
  private static final class OfChoice<E extends Enum<E>> implements ITypeConverter<E>, Choices {
    private final Class<E> type;
    private final ChoiceType<E> names;

    OfChoice(Class<E> type) {
      this.type = type;
      names = new ChoiceType<>(type);
    }

    void register(CommandLine command) {
      command.registerConverter(type, this);
    }

    @Override
    public E convert(String text) {
      return explained(names::parse, text);
    }

    @Override
    public List<String> choices() {
      return names.names();
    }
  }

  private static TypeConversionException unexpected(String expected, String found) {
    return new TypeConversionException("expected " + expected + ", found '" + found + "'");
  }
}
