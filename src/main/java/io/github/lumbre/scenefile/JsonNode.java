package io.github.lumbre.scenefile;

import io.github.lumbre.base.json.JsonException;
import io.github.lumbre.base.json.JsonTree;
import io.github.lumbre.base.json.JsonValue;
import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.base.text.Spelling;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Range;
import io.github.lumbre.scenefile.SceneFormatException.Kind;
import io.github.lumbre.scenefile.internal.Origin;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import java.util.stream.Collectors;

/**
 * A value of a scene file.
 *
 * <p>The queries check the type and range of a key's value. If a value is wrong, they add an error
 * to the {@link Problems} and return the default, so that one run finds many errors. A key whose
 * value is {@code null} counts as missing.
 *
 * @param problems the collection that this node's methods add to
 */
record JsonNode(JsonValue value, Problems problems) {
  /** The largest nesting depth of arrays and objects. */
  static final int MAX_LEVELS = 4096;

  private static final Set<String> VECTOR_KEYS = Set.of("x", "y", "z");
  private static final Set<String> COLOR_KEYS = Set.of("r", "g", "b", "a");

  /**
   * Returns the outermost value of a text. Repeated keys and numbers that overflow are added to the
   * problems.
   *
   * @param limits whose memory the values fit into
   * @throws SceneFormatException if the text is not JSON, nested too deeply, or too large
   */
  static JsonNode read(byte[] text, Problems problems, Limits limits) throws SceneFormatException {
    return read(text, problems, JsonTree.maxTokens(limits.heap()));
  }

  static JsonNode read(byte[] text, Problems problems, long maxTokens) throws SceneFormatException {
    try {
      JsonTree.Result read = JsonTree.read(ByteBuffer.wrap(text), MAX_LEVELS, maxTokens);
      for (JsonTree.Flaw flaw : read.flaws()) {
        new JsonNode(flaw.value(), problems).error(flaw.message());
      }
      return new JsonNode(read.root(), problems);
    } catch (JsonException e) {
      problems.error(e.isTooLarge() ? Kind.LIMIT : Kind.INVALID, e::path, e.getMessage());
      throw problems.exception();
    }
  }

  boolean isObject() {
    return value.isObject();
  }

  boolean isArray() {
    return value.isArray();
  }

  boolean isNumber() {
    return value.isNumber();
  }

  private Map<String, JsonValue> members() {
    return value.members();
  }

  private List<JsonNode> elements() {
    return value.elements().stream().map(this::at).toList();
  }

  private JsonNode at(JsonValue child) {
    return new JsonNode(child, problems);
  }

  /** Returns the path, such as {@code $.objects[3].radius}. */
  String path() {
    return value.path();
  }

  /** Returns the place of the object or asset that this node describes. */
  Origin origin() {
    Optional<String> name = ObjectKeys.NAME.find(this).flatMap(JsonNode::text);
    return new Origin(PrintableText.path(path()), name.map(PrintableText::shortened).orElse(""));
  }

  private String path(String childKey) {
    return path() + "." + childKey;
  }

  /** Returns the place of this value. */
  Spot spot() {
    return new Spot(problems, this::path);
  }

  /** Returns the place of the value of a key. */
  Spot spot(String childKey) {
    return new Spot(problems, () -> path(childKey));
  }

  void error(String message) {
    problems.error(Kind.INVALID, this::path, message);
  }

  void error(Kind kind, String message) {
    problems.error(kind, this::path, message);
  }

  /** Adds an error at the value of a key, or where it is missing. */
  void error(String childKey, String message) {
    error(Kind.INVALID, childKey, message);
  }

  /** Adds an error of the given kind at the value of a key, or where it is missing. */
  void error(Kind kind, String childKey, String message) {
    problems.error(kind, () -> path(childKey), message);
  }

  void warn(String childKey, String message) {
    warn(childKey, () -> message);
  }

  /** Adds a warning at the value of a key; computes the message only if it is kept. */
  void warn(String childKey, Supplier<String> message) {
    problems.warn(() -> path(childKey), message);
  }

  /** Returns the value as text for an error message. */
  String found() {
    return value.found();
  }

  private void unexpected(String expected) {
    error("expected " + expected + ", found " + found());
  }

  /** Returns this node; empty, with an error added, if it is not an object. */
  Optional<JsonNode> asObject() {
    if (isObject()) {
      return Optional.of(this);
    }
    unexpected("an object");
    return Optional.empty();
  }

  /** Returns the value of a key, or empty if it is missing or {@code null}. */
  Optional<JsonNode> find(String childKey) {
    return Optional.ofNullable(members().get(childKey)).filter(v -> !v.isNull()).map(this::at);
  }

  boolean has(String childKey) {
    return find(childKey).isPresent();
  }

  Optional<JsonNode> object(String childKey) {
    return find(childKey).flatMap(JsonNode::asObject);
  }

  /** Returns the objects of an array; an empty list if the key is missing. */
  List<JsonNode> objects(String childKey) {
    return array(childKey).stream().flatMap(n -> n.asObject().stream()).toList();
  }

  /** Returns the strings of an array; an empty list if the key is missing. */
  List<String> strings(String childKey) {
    return array(childKey).stream().flatMap(n -> n.asString().stream()).toList();
  }

  private List<JsonNode> array(String childKey) {
    Optional<JsonNode> array = find(childKey);
    if (array.isEmpty()) {
      return List.of();
    }
    if (!array.get().isArray()) {
      array.get().unexpected("an array");
      return List.of();
    }
    return array.get().elements();
  }

  double number(String childKey, double missing, Range range) {
    return find(childKey).map(node -> node.number(missing, range)).orElse(missing);
  }

  private double number(double instead, Range range) {
    if (!isNumber()) {
      unexpected(range.ifLow());
      return instead;
    }
    // Overflow was already reported when the text was read.
    if (value.isInfinite()) {
      return instead;
    }
    if (!range.contains(value.number())) {
      unexpected(range.expectedFor(value.number()));
      return instead;
    }
    return value.number();
  }

  int integer(String childKey, int missing, int low, int high) {
    return (int) integer(childKey, (long) missing, low, high);
  }

  long integer(String childKey, long missing, long low, long high) {
    return find(childKey).map(node -> node.integer(missing, low, high)).orElse(missing);
  }

  private long integer(long instead, long low, long high) {
    if (value.isInfinite()) {
      return instead;
    }
    Optional<Long> found = value.exactLong().filter(n -> n >= low && n <= high);
    if (found.isPresent()) {
      return found.get();
    }
    unexpected(expectedInteger(low, high));
    return instead;
  }

  /** Returns the expected range as text; the full range only for an integer outside it. */
  private String expectedInteger(long low, long high) {
    boolean isWhole = isNumber() && value.number() == Math.rint(value.number());
    boolean isTooLarge = isNumber() && value.number() > high;
    if (!isWhole && low <= Integer.MIN_VALUE && high >= Integer.MAX_VALUE) {
      return "an integer";
    }
    if (low > Integer.MIN_VALUE && high == Integer.MAX_VALUE && !isTooLarge) {
      return "an integer >= " + low;
    }
    return "an integer from " + low + " to " + high;
  }

  /** Returns an id, or empty if the key is missing or wrong. */
  Optional<Integer> id(String childKey) {
    long none = Long.MAX_VALUE;
    long found = integer(childKey, none, Integer.MIN_VALUE, Integer.MAX_VALUE);
    return found == none ? Optional.empty() : Optional.of((int) found);
  }

  /** Returns the same as {@link #id}, without adding an error. */
  Optional<Integer> idSilently(String childKey) {
    return find(childKey)
        .flatMap(node -> node.value.exactLong())
        .filter(n -> n == n.intValue())
        .map(Long::intValue);
  }

  boolean flag(String childKey, boolean missing) {
    return find(childKey).map(node -> node.flag(missing)).orElse(missing);
  }

  private boolean flag(boolean instead) {
    if (value.isFlag()) {
      return value.flag();
    }
    unexpected("true or false");
    return instead;
  }

  Optional<String> string(String childKey) {
    return find(childKey).flatMap(JsonNode::asString);
  }

  /** Returns the value if it is a string; otherwise empty, without adding an error. */
  Optional<String> text() {
    return value.isString() ? Optional.of(value.text()) : Optional.empty();
  }

  private Optional<String> asString() {
    if (!value.isString()) {
      unexpected("a string");
    }
    return text();
  }

  /** Returns whether the value is a string equal to {@code text}. */
  boolean isText(String text) {
    return text().equals(Optional.of(text));
  }

  /** Returns the choice that a key names, or the default if the key is missing or wrong. */
  <T> T choice(String childKey, Map<String, T> choices, T missing) {
    return choice(childKey, choices).orElse(missing);
  }

  /** Returns the choice that a key names, or empty if the key is missing or wrong. */
  <T> Optional<T> choice(String childKey, Map<String, T> choices) {
    return find(childKey).flatMap(node -> node.choice(choices));
  }

  private <T> Optional<T> choice(Map<String, T> choices) {
    if (value.isString() && choices.containsKey(value.text())) {
      return Optional.of(choices.get(value.text()));
    }
    unexpected("one of " + String.join(", ", choices.keySet()));
    return Optional.empty();
  }

  /**
   * Returns an array of finite numbers; empty, with an error added, if it is none.
   *
   * @param lengths allowed numbers of elements
   */
  double[] numbers(String childKey, List<Integer> lengths) {
    Optional<JsonNode> array = find(childKey);
    if (array.isEmpty() || !array.get().isArray()) {
      array.ifPresent(node -> node.unexpected("an array of numbers"));
      return new double[0];
    }
    List<JsonNode> elements = array.get().elements();
    if (!lengths.contains(elements.size())) {
      String expected = lengths.stream().map(String::valueOf).collect(Collectors.joining(" or "));
      array.get().error("expected " + expected + " numbers, found " + elements.size());
      return new double[0];
    }
    return elements.stream().mapToDouble(node -> node.number(0, Range.ANY)).toArray();
  }

  /** Returns the vector {x, y, z}; the default replaces missing components. */
  Vec3 vec3(String childKey, Vec3 missing) {
    Optional<JsonNode> node = parts(childKey, "x", "y", "z");
    if (node.isEmpty()) {
      return missing;
    }
    node.get().warnUnknown(VECTOR_KEYS);
    return new Vec3(
        node.get().number("x", missing.x(), Range.ANY),
        node.get().number("y", missing.y(), Range.ANY),
        node.get().number("z", missing.z(), Range.ANY));
  }

  /**
   * Returns the object under a key whose members are numbers. If it is something else, the error
   * has an example, with the numbers of an array.
   */
  private Optional<JsonNode> parts(String childKey, String... keys) {
    Optional<JsonNode> child = find(childKey);
    if (child.isEmpty() || child.get().isObject()) {
      return child;
    }
    List<JsonNode> given = child.get().isArray() ? child.get().elements() : List.of();
    List<String> members = new ArrayList<>();
    for (String each : keys) {
      int i = members.size();
      boolean isNumber = i < given.size() && given.get(i).isNumber();
      members.add('"' + each + "\": " + (isNumber ? given.get(i).found() : "1"));
    }
    child.get().unexpected("an object such as {" + String.join(", ", members) + "}");
    return Optional.empty();
  }

  /** Returns the vector {x, y}; the default replaces missing components. */
  Point2 vec2(String childKey, Point2 missing) {
    Vec3 found = vec3(childKey, new Vec3(missing.x(), missing.y(), 0));
    return new Point2(found.x(), found.y());
  }

  /** Returns the color {r, g, b} under a key; missing components, or all of them, are 1. */
  Rgb rgb(String childKey) {
    return parts(childKey, "r", "g", "b").map(JsonNode::rgb).orElse(Rgb.WHITE);
  }

  /** Returns this object as a color; alpha is checked and ignored. */
  Rgb rgb() {
    warnUnknown(COLOR_KEYS);
    number("a", 1, Range.ANY);
    return new Rgb(
        number("r", 1, Range.NOT_NEGATIVE),
        number("g", 1, Range.NOT_NEGATIVE),
        number("b", 1, Range.NOT_NEGATIVE));
  }

  /** Returns the keys of an object, in the order of the file. */
  List<String> keys() {
    return List.copyOf(members().keySet());
  }

  /** Warns of every key that is not in {@code known}, and suggests a similar one. */
  void warnUnknown(Set<String> known) {
    for (JsonValue member : members().values()) {
      if (!known.contains(member.key())) {
        problems.warn(member::path, () -> "unknown key" + Spelling.suggestion(member.key(), known));
      }
    }
  }
}
