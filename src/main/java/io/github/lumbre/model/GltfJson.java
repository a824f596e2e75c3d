package io.github.lumbre.model;

import io.github.lumbre.model.ModelFormatException.Kind;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;

/** A value in the JSON of a glTF file, and its place in the file. Immutable. */
final class GltfJson {
  /** The value of a JSON null. */
  static final Object NULL = new Object();

  private final GltfJson parent;
  private final String key;
  private final int index;
  private final Object value;

  private GltfJson(GltfJson parent, String key, int index, Object value) {
    this.parent = parent == null ? this : parent;
    this.key = key;
    this.index = index;
    this.value = value;
  }

  /**
   * Returns the outermost object.
   *
   * @throws ModelFormatException if the value is not a map
   */
  static GltfJson root(Object value) throws ModelFormatException {
    if (!(value instanceof Map)) {
      throw new ModelFormatException(
          Kind.MALFORMED, "", "expected a JSON object, found " + found(value));
    }
    return new GltfJson(null, "", -1, value);
  }

  /** Returns the place in the file, such as {@code nodes[3].mesh}; empty for the root. */
  String location() {
    return GltfText.path(place());
  }

  /** Returns the place of a member. */
  String location(String member) {
    return GltfText.path(place(member));
  }

  private String place() {
    if (parent == this) {
      return "";
    }
    return index >= 0 ? parent.place() + '[' + index + ']' : parent.place(key);
  }

  private String place(String member) {
    String place = place();
    return place.isEmpty() ? member : place + '.' + member;
  }

  /** Returns whether this object has a member. */
  boolean has(String member) {
    return members().containsKey(member);
  }

  /** Returns the keys of this object. */
  List<String> keys() {
    return new ArrayList<>(members().keySet());
  }

  @SuppressWarnings("unchecked") // GltfJsonReader makes these maps.
  private Map<String, Object> members() {
    return (Map<String, Object>) value;
  }

  /** Returns a member that is an object. */
  Optional<GltfJson> object(String member) throws ModelFormatException {
    Object found = members().get(member);
    if (found != null && !(found instanceof Map)) {
      throw expected(member, "an object");
    }
    return found == null ? Optional.empty() : Optional.of(new GltfJson(this, member, -1, found));
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
    List<?> items = items(member);
    GltfJson array = new GltfJson(this, member, -1, items);
    List<GltfJson> objects = new ArrayList<>(items.size());
    for (int i = 0; i < items.size(); i++) {
      GltfJson item = new GltfJson(array, "", i, items.get(i));
      if (!(item.value instanceof Map)) {
        throw new ModelFormatException(
            Kind.MALFORMED, item.location(), "expected an object, found " + found(item.value));
      }
      objects.add(item);
    }
    return objects;
  }

  /** Returns the texts in a member that is an array; empty if it is missing. */
  List<String> texts(String member) throws ModelFormatException {
    List<String> texts = new ArrayList<>();
    for (Object item : items(member)) {
      if (!(item instanceof String text)) {
        throw malformed(item(member, texts.size()), "expected a text, found " + found(item));
      }
      texts.add(text);
    }
    return texts;
  }

  /** Returns the numbers in a member that is an array; empty if it is missing. */
  double[] numbers(String member) throws ModelFormatException {
    List<?> items = items(member);
    double[] numbers = new double[items.size()];
    for (int i = 0; i < numbers.length; i++) {
      if (!(items.get(i) instanceof Double number)) {
        throw malformed(item(member, i), "expected a number, found " + found(items.get(i)));
      }
      numbers[i] = number;
    }
    return numbers;
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
    List<?> items = items(member);
    int[] indices = new int[items.size()];
    for (int i = 0; i < indices.length; i++) {
      indices[i] = index(item(member, i), items.get(i), size);
    }
    return indices;
  }

  private List<?> items(String member) throws ModelFormatException {
    Object found = members().get(member);
    if (found == null) {
      return List.of();
    }
    if (!(found instanceof List<?> items)) {
      throw expected(member, "an array");
    }
    return items;
  }

  private static String item(String member, int i) {
    return member + '[' + i + ']';
  }

  /** Returns a member that is an index into a list; empty if it is missing. */
  OptionalInt index(String member, int size) throws ModelFormatException {
    Object found = members().get(member);
    return found == null ? OptionalInt.empty() : OptionalInt.of(index(member, found, size));
  }

  /** Returns a member that is an index into a list, and must exist. */
  int requireIndex(String member, int size) throws ModelFormatException {
    OptionalInt index = index(member, size);
    if (index.isEmpty()) {
      throw expected(member, "an index");
    }
    return index.getAsInt();
  }

  private int index(String place, Object found, int size) throws ModelFormatException {
    if (size == 0) {
      throw malformed(place, "expected no index into an empty list, found " + found(found));
    }
    return (int) whole(place, found, 0, size - 1L);
  }

  /** Returns a member that is a whole number. */
  long whole(String member, long fallback, long min, long max) throws ModelFormatException {
    Object found = members().get(member);
    return found == null ? fallback : whole(member, found, min, max);
  }

  /** Returns a member that is a whole number, and must exist. */
  long requireWhole(String member, long min, long max) throws ModelFormatException {
    if (!has(member)) {
      throw expected(member, "a whole number");
    }
    return whole(member, 0, min, max);
  }

  private long whole(String place, Object found, long min, long max) throws ModelFormatException {
    if (!(found instanceof Double number)) {
      throw malformed(place, "expected a whole number, found " + found(found));
    }
    if (number != Math.rint(number) || number < min || number > max) {
      throw malformed(
          place,
          (max == Long.MAX_VALUE ? "expected at least " + min : "expected " + min + " to " + max)
              + ", found "
              + found(found));
    }
    return number.longValue();
  }

  /** Returns a member that is a finite number. */
  double number(String member, double fallback) throws ModelFormatException {
    Object found = members().get(member);
    if (found == null) {
      return fallback;
    }
    if (!(found instanceof Double number)) {
      throw expected(member, "a number");
    }
    return number;
  }

  /** Returns a member that is a number above 0, and must exist. */
  double requirePositive(String member) throws ModelFormatException {
    double number = number(member, 0);
    if (!(number > 0)) {
      throw expected(member, "a number > 0");
    }
    return number;
  }

  /** Returns a member that is a text. */
  String text(String member, String fallback) throws ModelFormatException {
    Object found = members().get(member);
    if (found == null) {
      return fallback;
    }
    if (!(found instanceof String text)) {
      throw expected(member, "a text");
    }
    return text;
  }

  /** Returns a member that is one of some texts. */
  String choice(String member, String fallback, List<String> choices) throws ModelFormatException {
    String text = text(member, fallback);
    if (!choices.contains(text)) {
      throw expected(member, GltfText.choice(choices));
    }
    return text;
  }

  /** Returns a member that is true or false. */
  boolean flag(String member, boolean fallback) throws ModelFormatException {
    Object found = members().get(member);
    if (found == null) {
      return fallback;
    }
    if (!(found instanceof Boolean flag)) {
      throw expected(member, "true or false");
    }
    return flag;
  }

  /** Returns an error about a member that does not have the expected value. */
  ModelFormatException expected(String member, String what) {
    Object found = members().get(member);
    return malformed(
        member, "expected " + what + ", found " + (found == null ? "nothing" : found(found)));
  }

  /** Returns an error about a member. */
  ModelFormatException malformed(String member, String message) {
    return new ModelFormatException(Kind.MALFORMED, location(member), message);
  }

  private static String found(Object value) {
    if (value instanceof Double number) {
      return GltfText.number(number);
    }
    if (value instanceof String text) {
      return PrintableText.quoted(text);
    }
    return value instanceof Map
        ? "an object"
        : value instanceof List ? "an array" : value == NULL ? "null" : value.toString();
  }
}
