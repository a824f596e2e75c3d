package io.github.lumbre.stage.internal;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.internal.CssColor;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.internal.ModelReach;
import io.github.lumbre.model.internal.OptionTypes;
import io.github.lumbre.model.internal.OptionTypes.TextsType;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scene.SettingType;
import io.github.lumbre.scene.internal.SettingTypes.NumberType;
import io.github.lumbre.scenefile.internal.DrawingSheet.Paper;
import io.github.lumbre.stage.Stage.Sky;
import io.github.lumbre.stage.Stage.View;
import io.github.lumbre.texture.internal.ClearSky;
import java.time.Instant;
import java.time.OffsetDateTime;
import java.time.format.DateTimeFormatter;
import java.time.format.DateTimeFormatterBuilder;
import java.time.format.DateTimeParseException;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The types of the options of a stage, besides those of models and settings. */
public final class StageTypes {
  /** Factors of a sky's radiance: the light of all its directions is finite. */
  public static final NumberType INTENSITY = new NumberType(0, EnvironmentLight.MAX_RADIANCE);

  /** Angles about an axis, in degrees. */
  public static final NumberType ROTATION = new NumberType(-Double.MAX_VALUE, Double.MAX_VALUE);

  /** Places of the sun. */
  public static final SettingType<View> SUN = new SunType();

  /** Labels, separated by commas. */
  public static final TextsType LABELS =
      new TextsType(
          "all, or some of " + String.join(", ", ShownLabels.KINDS),
          ",",
          name -> name.equals("all") || ShownLabels.KINDS.contains(name));

  private StageTypes() {}

  /** Views as {@link View#of} reads them. */
  public record ViewType() implements SettingType<View> {
    @Override
    public View parse(String text) {
      return View.of(text);
    }

    @Override
    public String expected() {
      return String.join(", ", View.standard().keySet()) + " or AZIMUTH,ELEVATION";
    }

    @Override
    public String format(View value) {
      return value.isParallel() ? value.name().orElse(text(value)) : text(value);
    }
  }

  /** Points in the axes and the unit of a file. */
  public record PointType() implements SettingType<Vec3> {
    private static final NumberType COORDINATE =
        new NumberType(-ModelReach.LARGEST, ModelReach.LARGEST);

    @Override
    public Vec3 parse(String text) {
      String[] parts = text.split(",", -1);
      if (parts.length != 3) {
        throw new IllegalArgumentException("expected " + expected() + ", found " + text);
      }
      double[] xyz = new double[3];
      for (int i = 0; i < 3; i++) {
        try {
          xyz[i] = Double.parseDouble(parts[i]);
        } catch (NumberFormatException e) {
          throw new IllegalArgumentException("expected " + expected() + ", found " + text, e);
        }
      }
      Vec3 point = new Vec3(xyz[0], xyz[1], xyz[2]);
      if (!accepts(point)) {
        throw new IllegalArgumentException("expected " + expected() + ", found " + text);
      }
      return point;
    }

    @Override
    public boolean accepts(Vec3 value) {
      return Stream.of(value.x(), value.y(), value.z()).allMatch(COORDINATE::accepts);
    }

    @Override
    public String expected() {
      return "X,Y,Z, each " + COORDINATE.expected();
    }

    @Override
    public String format(Vec3 value) {
      return Stream.of(value.x(), value.y(), value.z())
          .map(PrintableText::number)
          .collect(Collectors.joining(","));
    }
  }

  private static String text(View view) {
    return PrintableText.number(view.azimuth()) + "," + PrintableText.number(view.elevation());
  }

  /** Places of the sun: those of a view, or a latitude, a longitude and a time. */
  private record SunType() implements SettingType<View> {
    private static final NumberType ELEVATION = new NumberType(ClearSky.LOWEST, 90);

    /** Made when a time is first read: Java's formats take a while to load. */
    private static final class Time {
      /** A time with a zone in the forms of ISO 8601: Z, +02:00, +0200 and +02. */
      static final DateTimeFormatter FORMAT =
          new DateTimeFormatterBuilder()
              .parseCaseInsensitive()
              .append(DateTimeFormatter.ISO_LOCAL_DATE_TIME)
              .appendPattern("[XXX][X]")
              .toFormatter(Locale.ROOT);
    }

    @Override
    public View parse(String text) {
      int at = text.indexOf('@');
      View place = at < 0 ? direction(text) : at(text, at);
      if (!accepts(place)) {
        throw new IllegalArgumentException(
            at < 0
                ? refusal(place)
                : String.format(
                    Locale.ROOT,
                    "expected a time when the sun is up, found an elevation of %.2f degrees",
                    place.elevation()));
      }
      return place;
    }

    private static View direction(String text) {
      View view = View.of(text);
      return new View(view.azimuth(), view.elevation());
    }

    private static View at(String text, int at) {
      String[] place = text.substring(0, at).split(",", -1);
      if (place.length != 2) {
        throw new IllegalArgumentException("expected LATITUDE,LONGITUDE@TIME, found " + text);
      }
      double latitude = OptionTypes.finite(place[0]);
      double longitude = OptionTypes.finite(place[1]);
      return Sky.sunAt(latitude, longitude, time(text.substring(at + 1)));
    }

    private static Instant time(String text) {
      try {
        return OffsetDateTime.parse(text, Time.FORMAT).toInstant();
      } catch (DateTimeParseException e) {
        throw new IllegalArgumentException(
            "expected a time such as 2026-06-21T12:00Z, found " + text, e);
      }
    }

    @Override
    public boolean accepts(View value) {
      return ELEVATION.accepts(value.elevation());
    }

    @Override
    public String expected() {
      return ELEVATION.expected().replace("a number", "an elevation");
    }

    @Override
    public String format(View value) {
      return text(value);
    }

    @Override
    public String found(View value) {
      return String.valueOf(value.elevation());
    }
  }

  /** Texts in a form that is checked. */
  private interface Form extends SettingType<String> {
    @Override
    default boolean accepts(String value) {
      try {
        parse(value);
        return true;
      } catch (IllegalArgumentException e) {
        return false;
      }
    }
  }

  /** What is behind a model: {@code sky}, {@code transparent} or a color of CSS. */
  public record BackgroundType() implements Form {
    /** The light of the sky. */
    public static final String SKY = "sky";

    /** Nothing. */
    public static final String TRANSPARENT = "transparent";

    /** A color without the sign before it, which a shell may take for a comment. */
    private static final String HEXADECIMAL = "[0-9a-fA-F]{6}";

    @Override
    public String parse(String text) {
      String word = text.toLowerCase(Locale.ROOT);
      return word.equals(SKY) || word.equals(TRANSPARENT)
          ? word
          : CssColor.text(color(text).orElseThrow());
    }

    /** Returns the color in a text; empty if it is not a color. */
    public static Optional<Rgb> color(String text) {
      if (text.equalsIgnoreCase(SKY) || text.equalsIgnoreCase(TRANSPARENT)) {
        return Optional.empty();
      }
      try {
        return Setting.BACKPLATE.type().parse(text.matches(HEXADECIMAL) ? "#" + text : text);
      } catch (IllegalArgumentException e) {
        throw new IllegalArgumentException(
            e.getMessage().replace("expected ", "expected sky, transparent, "), e);
      }
    }

    @Override
    public String expected() {
      return "sky, transparent, " + Setting.BACKPLATE.type().expected();
    }
  }

  /** The texts of {@link Look}s. */
  public record LookType() implements Form {
    @Override
    public String parse(String text) {
      Look.of(text);
      return text;
    }

    @Override
    public String expected() {
      return "clay, lines or clay,lines";
    }
  }

  /** Scales such as {@code 1:2}: a length on paper, and how long it is in truth. */
  public record ScaleType() implements Form {
    private static final NumberType PART = new NumberType(1e-9, 1e9);

    @Override
    public String parse(String text) {
      factor(text);
      return text;
    }

    @Override
    public String expected() {
      return "two numbers such as 1:2, each " + PART.expected();
    }

    /** Returns the length on paper of a length of 1. */
    public static double factor(String text) {
      String[] parts = text.split(":", -1);
      try {
        double paper = Double.parseDouble(parts[0]);
        double truth = Double.parseDouble(parts[parts.length - 1]);
        if (parts.length == 2 && PART.accepts(paper) && PART.accepts(truth)) {
          return paper / truth;
        }
      } catch (NumberFormatException e) {
        throw new IllegalArgumentException(refused(text), e);
      }
      throw new IllegalArgumentException(refused(text));
    }

    private static String refused(String text) {
      return "expected " + new ScaleType().expected() + ", found " + text;
    }
  }

  /** Sheets of paper: names of ISO 216 and the letter of the United States, or millimeters. */
  public record PageType() implements Form {
    private static final String LANDSCAPE = "-landscape";

    /** Width and height in millimeters. */
    private static final Map<String, double[]> SHEETS =
        Map.of(
            "a0", new double[] {841, 1189},
            "a1", new double[] {594, 841},
            "a2", new double[] {420, 594},
            "a3", new double[] {297, 420},
            "a4", new double[] {210, 297},
            "a5", new double[] {148, 210},
            "letter", new double[] {215.9, 279.4});

    private static final NumberType SIDE = new NumberType(1, 4000);

    @Override
    public String parse(String text) {
      paper(text);
      return text.toLowerCase(Locale.ROOT);
    }

    @Override
    public String expected() {
      return "a0 to a5 or letter, perhaps with -landscape, or two lengths in millimeters such as"
          + " 200x100, each "
          + SIDE.expected();
    }

    /** Returns the sheet in a text. */
    public static Paper paper(String text) {
      String name = text.toLowerCase(Locale.ROOT);
      boolean isTurned = name.endsWith(LANDSCAPE);
      double[] sides = SHEETS.get(name.replace(LANDSCAPE, ""));
      if (sides != null) {
        return isTurned ? new Paper(sides[1], sides[0]) : new Paper(sides[0], sides[1]);
      }
      String[] lengths = name.split("x", -1);
      try {
        double width = Double.parseDouble(lengths[0]);
        double height = Double.parseDouble(lengths[lengths.length - 1]);
        if (lengths.length == 2 && SIDE.accepts(width) && SIDE.accepts(height)) {
          return new Paper(width, height);
        }
      } catch (NumberFormatException e) {
        throw new IllegalArgumentException(refused(text), e);
      }
      throw new IllegalArgumentException(refused(text));
    }

    private static String refused(String text) {
      return "expected " + new PageType().expected() + ", found " + text;
    }
  }

  /** Returns the names of labels; {@code all} stands for all of them. */
  public static List<String> labels(List<String> named) {
    return named.contains("all") ? ShownLabels.KINDS : named;
  }
}
