package io.github.lumbre.render.checkpoint;

import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.render.RenderStatistics.RejectedSample;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.scene.Setting;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** Writes and parses a film's header as lines of text, which docs/film-format.md describes. */
final class HeaderText {
  /** The first word of every film file. */
  static final String MAGIC = "LUMBRE-FILM";

  /** The version of films without layers, and of those with layers. */
  static final List<String> VERSIONS = List.of("1", "2");

  private static final String LAYERS = "layers";
  private static final String LIGHT_GROUP = "light-group";
  private static final String OBJECT = "object";
  private static final String MATERIAL = "material";

  private static final String NOTE = "note ";
  private static final String WITH_ALPHA = "samples covered sums first-mean";
  private static final String WITHOUT_ALPHA = "samples sums first-mean";
  private static final Pattern WINDOW = Pattern.compile("(\\d+),(\\d+),(\\d+),(\\d+)");
  private static final Pattern PART =
      Pattern.compile("(\\d+,\\d+,\\d+,\\d+) first (\\d+) fewest (\\d+) most (\\d+)");

  private static final String REJECTED = "rejected";
  private static final String FIRST_REJECTED = "first-rejected";
  private static final String SATURATED = "saturated";
  private static final Pattern SAMPLE = Pattern.compile("(\\d+),(\\d+),(\\d+)");

  private HeaderText() {}

  /** Returns the lines, each with a line feed, and the empty line that ends the header. */
  static String of(FilmHeader header) {
    StringBuilder text = new StringBuilder(MAGIC + " ");
    text.append(VERSIONS.get(header.layers().isEmpty() ? 0 : 1)).append('\n');
    header.identity().forEach((name, value) -> line(text, name, value));
    line(text, "window", header.window().toString());
    for (FilmPart part : header.parts()) {
      line(
          text,
          "part",
          String.format(
              "%s first %d fewest %d most %d",
              part.window(), part.first(), part.fewest(), part.most()));
    }
    line(text, "pixel", header.hasAlpha() ? WITH_ALPHA : WITHOUT_ALPHA);
    layers(text, header.layers());
    faults(text, header.faults());
    header.notes().forEach((name, value) -> line(text, NOTE + name, value));
    return text.append('\n').toString();
  }

  private static void layers(StringBuilder text, RecordedLayers layers) {
    if (layers.isEmpty()) {
      return;
    }
    line(text, LAYERS, Setting.LAYERS.type().format(layers.kinds()));
    layers.lightGroups().forEach(name -> line(text, LIGHT_GROUP, name));
    layers.objects().forEach(name -> line(text, OBJECT, name));
    layers.materials().forEach(name -> line(text, MATERIAL, name));
  }

  private static void faults(StringBuilder text, RenderStatistics faults) {
    if (faults.rejected() != 0) {
      line(text, REJECTED, String.valueOf(faults.rejected()));
      String first =
          faults.firstRejected().stream()
              .map(sample -> sample.x() + "," + sample.y() + "," + sample.sample())
              .collect(Collectors.joining(" "));
      line(text, FIRST_REJECTED, first);
    }
    if (faults.saturated() != 0) {
      line(text, SATURATED, String.valueOf(faults.saturated()));
    }
  }

  private static void line(StringBuilder text, String name, String value) {
    text.append(name).append(": ").append(escaped(value)).append('\n');
  }

  private static String escaped(String value) {
    return value.replace("\\", "\\\\").replace("\n", "\\n");
  }

  private static String unescaped(String value) {
    return Pattern.compile("\\\\(.)")
        .matcher(value)
        .replaceAll(m -> Matcher.quoteReplacement(m.group(1).equals("n") ? "\n" : m.group(1)));
  }

  /**
   * Parses the lines of a header, without the empty line at its end.
   *
   * @throws FilmFormatException if the text is not a header
   */
  static FilmHeader parse(String text) throws FilmFormatException {
    Map<String, String> identity = new LinkedHashMap<>();
    Map<String, String> notes = new LinkedHashMap<>();
    List<FilmPart> parts = new ArrayList<>();
    Map<String, List<String>> names =
        Map.of(
            LIGHT_GROUP, new ArrayList<>(), OBJECT, new ArrayList<>(), MATERIAL, new ArrayList<>());
    String[] lines = text.split("\n");
    for (String line : List.of(lines).subList(1, lines.length)) {
      int colon = line.indexOf(": ");
      if (colon < 0) {
        throw new FilmFormatException("expected 'name: value' in its header, found '" + line + "'");
      }
      String name = line.substring(0, colon);
      String value = unescaped(line.substring(colon + 2));
      if (name.startsWith(NOTE)) {
        notes.put(name.substring(NOTE.length()), value);
      } else if (name.equals("part")) {
        parts.add(valid(name, value, HeaderText::part));
      } else if (names.containsKey(name)) {
        names.get(name).add(value);
      } else {
        identity.put(name, value);
      }
    }
    String pixel = String.valueOf(identity.remove("pixel"));
    if (!pixel.equals(WITH_ALPHA) && !pixel.equals(WITHOUT_ALPHA)) {
      throw new FilmFormatException("pixel: unknown layout '" + pixel + "'");
    }
    Crop window = valid("window", String.valueOf(identity.remove("window")), HeaderText::window);
    RenderStatistics faults = faults(identity);
    RecordedLayers layers = layers(Optional.ofNullable(identity.remove(LAYERS)), names);
    return new FilmHeader(identity, pixel.equals(WITH_ALPHA), window, layers, parts, faults, notes);
  }

  private static RecordedLayers layers(Optional<String> kinds, Map<String, List<String>> names)
      throws FilmFormatException {
    try {
      RecordedLayers layers =
          new RecordedLayers(
              Setting.LAYERS.type().parse(kinds.orElse("")),
              names.get(LIGHT_GROUP),
              names.get(OBJECT),
              names.get(MATERIAL));
      if (layers.kinds().isEmpty() != kinds.isEmpty()) {
        throw new IllegalArgumentException("expected some, found none");
      }
      return layers;
    } catch (IllegalArgumentException e) {
      throw new FilmFormatException(LAYERS + ": " + e.getMessage());
    }
  }

  /** Removes the faults from the values and returns them; missing ones are 0. */
  private static RenderStatistics faults(Map<String, String> values) throws FilmFormatException {
    long rejected = count(REJECTED, values.remove(REJECTED));
    String first = values.remove(FIRST_REJECTED);
    long saturated = count(SATURATED, values.remove(SATURATED));
    List<RejectedSample> samples = new ArrayList<>();
    for (String sample : first == null || first.isEmpty() ? new String[0] : first.split(" ")) {
      samples.add(valid(FIRST_REJECTED, sample, HeaderText::sample));
    }
    return RenderStatistics.ofFaults(rejected, samples, saturated);
  }

  private static long count(String name, String text) throws FilmFormatException {
    return text == null ? 0 : valid(name, text, HeaderText::count);
  }

  private static long count(String text) {
    long count = Long.parseLong(text);
    if (count < 0) {
      throw new IllegalArgumentException(text);
    }
    return count;
  }

  private static RejectedSample sample(String text) {
    Matcher found = matched(SAMPLE, text);
    return new RejectedSample(number(found, 1), number(found, 2), number(found, 3));
  }

  private static <T> T valid(String name, String value, Function<String, T> reader)
      throws FilmFormatException {
    try {
      return reader.apply(value);
    } catch (IllegalArgumentException e) {
      throw new FilmFormatException(name + ": invalid value '" + value + "'");
    }
  }

  private static FilmPart part(String text) {
    Matcher found = matched(PART, text);
    return new FilmPart(
        window(found.group(1)), number(found, 2), number(found, 3), number(found, 4));
  }

  private static Crop window(String text) {
    Matcher found = matched(WINDOW, text);
    return new Crop(number(found, 1), number(found, 2), number(found, 3), number(found, 4));
  }

  private static Matcher matched(Pattern pattern, String text) {
    Matcher found = pattern.matcher(text);
    if (!found.matches()) {
      throw new IllegalArgumentException(text);
    }
    return found;
  }

  private static int number(Matcher found, int group) {
    return Integer.parseInt(found.group(group));
  }
}
