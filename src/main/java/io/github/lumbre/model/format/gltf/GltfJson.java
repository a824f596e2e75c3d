package io.github.lumbre.model.format.gltf;

import io.github.lumbre.base.json.JsonException;
import io.github.lumbre.base.json.JsonTree;
import io.github.lumbre.base.json.JsonValue;
import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.internal.ModelNames;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Predicate;
import java.util.regex.Pattern;

/**
 * A value in the JSON of a glTF file. Its queries throw an exception that names its place in the
 * file if a value is not as glTF has it.
 */
record GltfJson(JsonValue value) {
  /** The largest nesting depth of arrays and objects; glTF itself needs about ten. */
  private static final int MAX_LEVELS = 256;

  /** Where a wrong number is replaced instead of refused. */
  private static final Pattern REPLACED =
      Pattern.compile(
          "[$][.](?:(?:materials|cameras|samplers)\\[|extensions[.]KHR_lights_punctual[.])");

  /**
   * Returns the outermost object of a text.
   *
   * @param text in UTF-8, in an array-backed buffer
   * @throws ModelFormatException if the text is not JSON, not an object, or beyond the limits
   */
  static GltfJson read(ByteBuffer text, GltfBudget budget) throws ModelFormatException {
    JsonTree.Result read;
    try {
      read = JsonTree.read(text, MAX_LEVELS, budget.tokens());
    } catch (JsonException e) {
      throw new ModelFormatException(
          e.isTooLarge() ? Kind.TOO_LARGE : Kind.MALFORMED, shown(e.path()), e.getMessage());
    }
    budget.allocate("", JsonTree.BYTES_PER_TOKEN * read.tokens());
    for (JsonTree.Flaw flaw : read.flaws()) {
      if (!isReplaceable(flaw.value())) {
        throw new GltfJson(flaw.value()).malformed(flaw.message());
      }
    }
    if (!read.root().isObject()) {
      throw new GltfJson(read.root())
          .malformed("expected a JSON object, found " + read.root().found());
    }
    return new GltfJson(read.root());
  }

  /** Returns whether a flaw is a number that {@link GltfValues} replaces. */
  private static boolean isReplaceable(JsonValue value) {
    return value.isInfinite() && REPLACED.matcher(value.path()).lookingAt();
  }

  /** Returns whether a value is a finite number. */
  static boolean isFinite(JsonValue value) {
    return value.isNumber() && !value.isInfinite();
  }

  /** Returns the place in the file, such as {@code nodes[3].mesh}; empty for the root. */
  String location() {
    return shown(value.path());
  }

  /** Returns the place of a member. */
  String location(String member) {
    return shown(value.path() + '.' + member);
  }

  private static String shown(String path) {
    return PrintableText.path(path.replaceFirst("^[$][.]?", ""));
  }

  /** Returns whether this object has a member. */
  boolean has(String member) {
    return members().containsKey(member);
  }

  /** Returns the keys of this object. */
  List<String> keys() {
    return new ArrayList<>(members().keySet());
  }

  private Map<String, JsonValue> members() {
    return value.members();
  }

  /** Returns a member of any type; empty if it is missing. */
  Optional<JsonValue> find(String member) {
    return Optional.ofNullable(members().get(member));
  }

  /** Returns a member that is an object. */
  Optional<GltfJson> object(String member) throws ModelFormatException {
    return checked(member, JsonValue::isObject, "an object").map(GltfJson::new);
  }

  /** Returns a member of a type; empty if it is missing. */
  private Optional<JsonValue> checked(String member, Predicate<JsonValue> type, String expected)
      throws ModelFormatException {
    Optional<JsonValue> found = find(member);
    if (found.isPresent() && !type.test(found.get())) {
      throw expected(member, expected);
    }
    return found;
  }

  /** Returns a member that is an object, and must exist. */
  GltfJson requireObject(String member) throws ModelFormatException {
    return object(member).orElseThrow(() -> expected(member, "an object"));
  }

  /** Returns an extension of this object. */
  Optional<GltfJson> extension(String name) throws ModelFormatException {
    Optional<GltfJson> extensions = object("extensions");
    return extensions.isPresent() ? extensions.get().object(name) : Optional.empty();
  }

  /** Returns the objects in a member that is an array; empty if it is missing. */
  List<GltfJson> objects(String member) throws ModelFormatException {
    return items(member, JsonValue::isObject, "an object").stream().map(GltfJson::new).toList();
  }

  /** Returns the texts in a member that is an array; empty if it is missing. */
  List<String> texts(String member) throws ModelFormatException {
    return items(member, JsonValue::isString, "a text").stream().map(JsonValue::text).toList();
  }

  /** Returns the numbers in a member that is an array; empty if it is missing. */
  double[] numbers(String member) throws ModelFormatException {
    return items(member, GltfJson::isFinite, "a number").stream()
        .mapToDouble(JsonValue::number)
        .toArray();
  }

  private List<JsonValue> items(String member, Predicate<JsonValue> type, String expected)
      throws ModelFormatException {
    Optional<JsonValue> array = checked(member, JsonValue::isArray, "an array");
    List<JsonValue> items = array.map(JsonValue::elements).orElse(List.of());
    for (JsonValue item : items) {
      if (!type.test(item)) {
        throw new GltfJson(item).malformed("expected " + expected + ", found " + item.found());
      }
    }
    return items;
  }

  /** Returns a member that is an array of as many numbers as there are in its default. */
  double[] numbers(String member, double... fallback) throws ModelFormatException {
    if (!has(member)) {
      return fallback;
    }
    double[] numbers = numbers(member);
    if (numbers.length != fallback.length) {
      throw malformed(member, "expected " + fallback.length + " numbers, found " + numbers.length);
    }
    return numbers;
  }

  /** Returns the indices in a member that is an array; empty if it is missing. */
  int[] indices(String member, int size) throws ModelFormatException {
    List<JsonValue> items = items(member, item -> true, "");
    int[] indices = new int[items.size()];
    for (int i = 0; i < indices.length; i++) {
      indices[i] = new GltfJson(items.get(i)).index(size);
    }
    return indices;
  }

  /** Returns a member that is an index into a list; empty if it is missing. */
  OptionalInt index(String member, int size) throws ModelFormatException {
    Optional<JsonValue> found = find(member);
    return found.isEmpty()
        ? OptionalInt.empty()
        : OptionalInt.of(new GltfJson(found.get()).index(size));
  }

  /** Returns a member that is an index into a list, and must exist. */
  int requireIndex(String member, int size) throws ModelFormatException {
    OptionalInt index = index(member, size);
    if (index.isEmpty()) {
      throw expected(member, "an index");
    }
    return index.getAsInt();
  }

  private int index(int size) throws ModelFormatException {
    if (size == 0) {
      throw malformed("expected no index into an empty list, found " + value.found());
    }
    return (int) whole(0, size - 1L);
  }

  /** Returns a member that is a whole number. */
  long whole(String member, long fallback, long min, long max) throws ModelFormatException {
    Optional<JsonValue> found = find(member);
    return found.isEmpty() ? fallback : new GltfJson(found.get()).whole(min, max);
  }

  /** Returns a member that is a whole number, and must exist. */
  long requireWhole(String member, long min, long max) throws ModelFormatException {
    if (!has(member)) {
      throw expected(member, "a whole number");
    }
    return whole(member, 0, min, max);
  }

  private long whole(long min, long max) throws ModelFormatException {
    if (!value.isNumber()) {
      throw malformed("expected a whole number, found " + value.found());
    }
    double number = value.number();
    if (number != Math.rint(number) || number < min || number > max) {
      throw malformed(
          (max == Long.MAX_VALUE ? "expected at least " + min : "expected " + min + " to " + max)
              + ", found "
              + value.found());
    }
    return (long) number;
  }

  /** Returns a member that is a finite number. */
  double number(String member, double fallback) throws ModelFormatException {
    return checked(member, GltfJson::isFinite, "a number").map(JsonValue::number).orElse(fallback);
  }

  /** Returns a member that is a text. */
  String text(String member, String fallback) throws ModelFormatException {
    return checked(member, JsonValue::isString, "a text").map(JsonValue::text).orElse(fallback);
  }

  /** Returns a member that is one of some texts. */
  String choice(String member, String fallback, List<String> choices) throws ModelFormatException {
    String text = text(member, fallback);
    if (!choices.contains(text)) {
      throw expected(member, ModelNames.choice(choices));
    }
    return text;
  }

  /** Returns a member that is true or false. */
  boolean flag(String member, boolean fallback) throws ModelFormatException {
    return checked(member, JsonValue::isFlag, "true or false")
        .map(JsonValue::flag)
        .orElse(fallback);
  }

  /** Returns an error about a member that does not have the expected value. */
  ModelFormatException expected(String member, String what) {
    String found = find(member).map(JsonValue::found).orElse("nothing");
    return malformed(member, "expected " + what + ", found " + found);
  }

  /** Returns an error about a member. */
  ModelFormatException malformed(String member, String message) {
    return Kind.MALFORMED.at(location(member), message);
  }

  private ModelFormatException malformed(String message) {
    return Kind.MALFORMED.at(location(), message);
  }
}
