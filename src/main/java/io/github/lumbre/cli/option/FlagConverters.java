package io.github.lumbre.cli.option;

import io.github.lumbre.cli.output.PixelPlace;
import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.image.internal.ImageFormat;
import io.github.lumbre.lab.perf.PerfComparison.Clock;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.scene.RenderSettings.Mode;
import io.github.lumbre.scene.RenderSettings.Size;
import io.github.lumbre.scene.SettingType.ChoiceType;
import java.math.BigDecimal;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Converters of flag values from text; errors state what was expected and what was found. */
public final class FlagConverters {
  private FlagConverters() {}

  /** Registers converters of numbers whose errors state what was expected. */
  public static void registerNumbers(CommandLine command) {
    String integer = "an integer up to ";
    ITypeConverter<Integer> ofInt =
        text -> number(Integer::valueOf, integer + Integer.MAX_VALUE, text);
    ITypeConverter<Long> ofLong = text -> number(Long::valueOf, integer + Long.MAX_VALUE, text);
    command.registerConverter(int.class, ofInt).registerConverter(Integer.class, ofInt);
    command.registerConverter(Long.class, ofLong);
    command.registerConverter(Double.class, text -> number(Double::valueOf, "a number", text));
    command.registerConverter(BigDecimal.class, text -> number(BigDecimal::new, "a number", text));
  }

  private static <N> N number(Function<String, N> parser, String expected, String text) {
    try {
      return parser.apply(text);
    } catch (NumberFormatException e) {
      throw unexpected(expected, text);
    }
  }

  /** {@code 640x480}. */
  public static final class OfSize implements ITypeConverter<Size> {
    @Override
    public Size convert(String text) {
      try {
        return Size.of(text);
      } catch (IllegalArgumentException e) {
        throw new TypeConversionException(e.getMessage());
      }
    }
  }

  /** {@code 100,50}. */
  public static final class OfPixel implements ITypeConverter<PixelPlace> {
    private static final Pattern FORM = Pattern.compile("(\\d{1,9}),(\\d{1,9})");

    @Override
    public PixelPlace convert(String text) {
      Matcher found = FORM.matcher(text);
      if (!found.matches()) {
        throw unexpected("x,y in pixels, such as 100,50", text);
      }
      return new PixelPlace(Integer.parseInt(found.group(1)), Integer.parseInt(found.group(2)));
    }
  }

  /** {@code 100,50,64,48}. */
  static final class OfCrop implements ITypeConverter<Crop> {
    private static final Pattern FORM =
        Pattern.compile("(\\d{1,9}),(\\d{1,9}),(\\d{1,9}),(\\d{1,9})");

    @Override
    public Crop convert(String text) {
      Matcher found = FORM.matcher(text);
      if (!found.matches()) {
        throw unexpected("x,y,w,h in pixels, such as 100,50,64,48", text);
      }
      try {
        return new Crop(number(found, 1), number(found, 2), number(found, 3), number(found, 4));
      } catch (IllegalArgumentException e) {
        throw new TypeConversionException(e.getMessage());
      }
    }

    private static int number(Matcher found, int group) {
      return Integer.parseInt(found.group(group));
    }
  }

  /** {@code 90s}, {@code 5m}, {@code 2h} or {@code 1.5h}; always longer than 0. */
  public static final class OfDuration implements ITypeConverter<Duration> {
    private static final Pattern FORM = Pattern.compile("(\\d{1,9}(?:\\.\\d{1,9})?)([smh])");
    private static final Map<String, Double> SECONDS = Map.of("s", 1., "m", 60., "h", 3600.);

    @Override
    public Duration convert(String text) {
      Matcher found = FORM.matcher(text);
      double seconds =
          found.matches() ? Double.parseDouble(found.group(1)) * SECONDS.get(found.group(2)) : 0;
      Duration duration = Duration.ofNanos((long) Math.min(seconds * 1e9, Long.MAX_VALUE / 2));
      if (duration.isZero()) {
        throw unexpected("a duration above 0, such as 90s, 5m or 2h", text);
      }
      return duration;
    }
  }

  /** {@code builtin} or {@code oidn}. */
  static final class OfDenoiser extends OfChoice<DenoiserFlags.Engine> {
    OfDenoiser() {
      super(DenoiserFlags.Engine.class);
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

  /** {@code ray} or {@code path}. */
  public static final class OfMode extends OfChoice<Mode> {
    public OfMode() {
      super(Mode.class);
    }
  }

  /** {@code cpu} or {@code wall}. */
  public static final class OfClock extends OfChoice<Clock> {
    public OfClock() {
      super(Clock.class);
    }
  }

  /** {@code draft}, {@code preview}, {@code final} or {@code reference}. */
  static final class OfQuality extends OfChoice<Quality> {
    OfQuality() {
      super(Quality.class);
    }
  }

  /** {@code auto}, {@code vector} or {@code scalar}. */
  static final class OfKernel extends OfChoice<Kernel> {
    OfKernel() {
      super(Kernel.class);
    }
  }

  /** {@code png}, {@code exr}, {@code pfm} or {@code jpg}. */
  public static final class OfImageFormat extends OfChoice<ImageFormat> {
    public OfImageFormat() {
      super(ImageFormat.class);
    }
  }

  /** How a render shows its progress. */
  enum ProgressStyle {
    BAR,
    JSON,
    NONE
  }

  /** {@code bar}, {@code json} or {@code none}. */
  static final class OfProgressStyle extends OfChoice<ProgressStyle> {
    OfProgressStyle() {
      super(ProgressStyle.class);
    }
  }

  /** The constants of an enum, written as in scene files. */
  private abstract static class OfChoice<E extends Enum<E>> implements ITypeConverter<E>, Choices {
    private final ChoiceType<E> type;

    OfChoice(Class<E> type) {
      this.type = new ChoiceType<>(type);
    }

    @Override
    public E convert(String text) {
      try {
        return type.parse(text);
      } catch (IllegalArgumentException e) {
        throw new TypeConversionException(e.getMessage());
      }
    }

    @Override
    public List<String> choices() {
      return type.names();
    }
  }

  private static TypeConversionException unexpected(String expected, String found) {
    return new TypeConversionException("expected " + expected + ", found '" + found + "'");
  }
}
