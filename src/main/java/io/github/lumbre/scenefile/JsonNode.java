package io.github.lumbre.scenefile;

import io.github.lumbre.base.json.JsonException;
import io.github.lumbre.base.json.JsonTree;
import io.github.lumbre.base.json.JsonValue;
import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.base.text.Spelling;
import io.github.lumbre.image.Rgb;
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
    return problems.origin(path(), name.map(PrintableText::shortened).orElse(""));
  }

  private String path(String childKey) {
    return path() + "." + childKey;
  }

  /** Returns the place of this value. */
  ProblemPlace problemPlace() {
    return new ProblemPlace(problems, this::path);
  }

  /** Returns the place of the value of a key. */
  ProblemPlace problemPlace(String childKey) {
    return new ProblemPlace(problems, () -> path(childKey));
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
    return find(childKey).map(JsonNode::array).orElse(List.of()).stream()
        .flatMap(n -> n.asObject().stream())
        .toList();
  }

  /** Returns the strings of this array; adds an error for everything else. */
  List<String> strings() {
    return array().stream().flatMap(n -> n.string().stream()).toList();
  }

  private List<JsonNode> array() {
    if (!isArray()) {
      unexpected("an array");
      return List.of();
    }
    return elements();
  }

  /** Returns the value if it is a number in a range; otherwise empty, with an error added. */
  Optional<Double> number(Range range) {
    if (!isNumber()) {
      unexpected(range.ifLow());
      return Optional.empty();
    }
    // Overflow was already reported when the text was read.
    if (value.isInfinite()) {
      return Optional.empty();
    }
    if (!range.contains(value.number())) {
      unexpected(range.expectedFor(value.number()));
      return Optional.empty();
    }
    return Optional.of(value.number());
  }

  /** Returns the value if it is an integer in a range; otherwise empty, with an error added. */
  Optional<Long> integer(long low, long high) {
    if (value.isInfinite()) {
      return Optional.empty();
    }
    Optional<Long> found = value.exactLong().filter(n -> n >= low && n <= high);
    if (found.isEmpty()) {
      unexpected(expectedInteger(low, high));
    }
    return found;
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

  /** Returns an id; empty, without adding an error, if the key is missing or wrong. */
  Optional<Integer> idSilently(String childKey) {
    return find(childKey)
        .flatMap(node -> node.value.exactLong())
        .filter(n -> n == n.intValue())
        .map(Long::intValue);
  }

  /** Returns the value if it is true or false; otherwise empty, with an error added. */
  Optional<Boolean> flag() {
    if (value.isFlag()) {
      return Optional.of(value.flag());
    }
    unexpected("true or false");
    return Optional.empty();
  }

  /** Returns the value if it is a string; otherwise empty, without adding an error. */
  Optional<String> text() {
    return value.isString() ? Optional.of(value.text()) : Optional.empty();
  }

  /** Returns the value if it is a string; otherwise empty, with an error added. */
  Optional<String> string() {
    if (!value.isString()) {
      unexpected("a string");
    }
    return text();
  }

  /** Returns whether the value is a string equal to {@code text}. */
  boolean isText(String text) {
    return text().equals(Optional.of(text));
  }

  /** Returns the choice that the value names; otherwise empty, with an error added. */
  <T> Optional<T> choice(Map<String, T> choices) {
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
  Optional<double[]> numbers(List<Integer> lengths) {
    if (!isArray()) {
      unexpected("an array of numbers");
      return Optional.empty();
    }
    List<JsonNode> elements = elements();
    if (!lengths.contains(elements.size())) {
      String expected = lengths.stream().map(String::valueOf).collect(Collectors.joining(" or "));
      error("expected " + expected + " numbers, found " + elements.size());
      return Optional.empty();
    }
    return Optional.of(
        elements.stream().mapToDouble(node -> node.number(Range.ANY).orElse(0.)).toArray());
  }

  /** Returns the vector {x, y, z}; the default replaces missing components. */
  Optional<Vec3> vec3(Vec3 components) {
    return members(VECTOR_KEYS, List.of("x", "y", "z"))
        .map(
            node ->
                new Vec3(
                    node.component("x", components.x(), Range.ANY),
                    node.component("y", components.y(), Range.ANY),
                    node.component("z", components.z(), Range.ANY)));
  }

  private double component(String childKey, double otherwise, Range range) {
    return find(childKey).flatMap(node -> node.number(range)).orElse(otherwise);
  }

  /**
   * Returns this object if its members are numbers. If it is something else, the error has an
   * example, with the numbers of an array.
   */
  private Optional<JsonNode> members(Set<String> known, List<String> shown) {
    if (isObject()) {
      warnUnknown(known);
      return Optional.of(this);
    }
    List<JsonNode> given = isArray() ? elements() : List.of();
    List<String> members = new ArrayList<>();
    for (String each : shown) {
      int i = members.size();
      boolean isNumber = i < given.size() && given.get(i).isNumber();
      members.add('"' + each + "\": " + (isNumber ? given.get(i).found() : "1"));
    }
    unexpected("an object such as {" + String.join(", ", members) + "}");
    return Optional.empty();
  }

  /** Returns the color {r, g, b}; missing components are 1, and alpha is checked and ignored. */
  Optional<Rgb> rgb() {
    return members(COLOR_KEYS, List.of("r", "g", "b"))
        .map(
            node -> {
              node.component("a", 1, Range.ANY);
              return new Rgb(
                  node.component("r", 1, Range.NOT_NEGATIVE),
                  node.component("g", 1, Range.NOT_NEGATIVE),
                  node.component("b", 1, Range.NOT_NEGATIVE));
            });
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
