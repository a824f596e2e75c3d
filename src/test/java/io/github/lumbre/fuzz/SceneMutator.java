package io.github.lumbre.fuzz;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonNull;
import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.Random;

/**
 * Changes a scene in a few places; the result is usually still JSON. Mutable; confined to one
 * thread.
 */
final class SceneMutator {
  /** Numbers at the limits of machine types and of the format. */
  private static final String[] NUMBERS = {
    "0",
    "-0",
    "1",
    "-1",
    "2",
    "3",
    "0.5",
    "1e-9",
    "1e-320",
    "4.9e-324",
    "2.2250738585072014e-308",
    "1e-160",
    "1e-150",
    "1e30",
    "1e100",
    "1e149",
    "1e150",
    "1.0000000000000002e150",
    "1e154",
    "1e155",
    "1e300",
    "1e308",
    "1.7976931348623157e308",
    "1e400",
    "-1e400",
    "1e-400",
    "-1e-320",
    "-1e150",
    "-1e308",
    "89.99999999999999",
    "90",
    "179.99999999999997",
    "180",
    "360",
    "-90",
    "16777217",
    "2147483647",
    "2147483648",
    "-2147483648",
    "9007199254740993",
    "9223372036854775807",
    "9223372036854775808",
    "99999999999999999999",
    "0.9999999999999999",
    "1.0000000000000002",
    "2.5",
    "1e1",
    "8.0",
    "65535",
    "65536",
    "16384",
    "1024",
    "1000000"
  };

  private static final String[] VALUES = {
    "null",
    "true",
    "false",
    "{}",
    "[]",
    "\"\"",
    "\"1\"",
    "[{}]",
    "[[]]",
    "[null]",
    "{\"x\":0}",
    "{\"r\":1e300}",
    "{\"x\":1e308,\"y\":-1e308}",
    "{\"x\":0,\"y\":0,\"z\":0}",
    "NaN",
    "Infinity",
    "01",
    ".5",
    "\"\\u0000\"",
    "\"\\ud800\"",
    "\"\\u001b[2J\""
  };

  private static final String[] FILES = {
    HostileScenes.INSIDE_PICTURE,
    HostileScenes.INSIDE_MESH,
    "../outside.png",
    "../outside.obj",
    "./../outside.png",
    "sub/../../outside.png",
    "link.png",
    "linked/outside.obj",
    "/etc/passwd",
    "/dev/zero",
    "/dev/stdin",
    "file:///etc/passwd",
    "http://localhost:1/a.png",
    "\\\\host\\a",
    "C:\\a.png",
    "a\u0000b",
    "",
    ".",
    "..",
    "inside.png/",
    "inside.png/..",
    "~/a",
    "%2e%2e/a",
    "inside.png\n",
    "con",
    "scene.json"
  };

  private static final String[] TOKENS = {
    "{",
    "}",
    "[",
    "]",
    ",",
    ":",
    "\"",
    "\\",
    "//",
    "/*",
    "\u0000",
    "\ufeff",
    "\ud83d\ude00",
    "1",
    "null",
    "\"id\":1,",
    "\"type\":\"Light\","
  };

  /** Marks a string whose text is printed verbatim. */
  private static final String RAW = "\u0000raw:";

  /** The place of a value: an array and an index, or an object and a key. */
  private record Place(JsonElement parent, String key, int index) {
    JsonElement value() {
      return parent instanceof JsonArray array ? array.get(index) : object().get(key);
    }

    void set(JsonElement value) {
      if (parent instanceof JsonArray array) {
        array.set(index, value);
      } else {
        object().add(key, value);
      }
    }

    private JsonObject object() {
      return parent.getAsJsonObject();
    }
  }

  private final List<JsonObject> seeds;
  private final List<String> keys;
  private final List<String> texts;
  private final Random random;

  /**
   * @param seeds valid scenes
   * @param vocabulary the vocabulary of all these scenes
   * @param random the only source of randomness
   */
  SceneMutator(List<JsonObject> seeds, Vocabulary vocabulary, Random random) {
    this.seeds = seeds;
    this.random = random;
    keys = vocabulary.keys();
    texts = vocabulary.texts();
  }

  /** Returns the text of a scene that differs from a valid one. */
  byte[] next() {
    JsonObject scene = any(seeds).deepCopy();
    for (int changes = 1 + random.nextInt(3); changes > 0; changes--) {
      List<Place> places = new ArrayList<>();
      collect(scene, places);
      if (!places.isEmpty()) {
        change(place(places), places);
      }
    }
    if (random.nextInt(50) == 0) {
      enlarge(scene);
    }
    StringBuilder text = new StringBuilder();
    print(scene, text);
    byte[] bytes = text.toString().getBytes(StandardCharsets.UTF_8);
    return random.nextInt(12) == 0 ? broken(bytes) : bytes;
  }

  private <T> T any(List<T> list) {
    return list.get(random.nextInt(list.size()));
  }

  private String any(String... list) {
    return list[random.nextInt(list.length)];
  }

  /** Returns a random place; files and settings, which are rare, are more probable. */
  private Place place(List<Place> places) {
    int kind = random.nextInt(8);
    List<Place> wanted =
        places.stream()
            .filter(p -> kind < 2 ? isFile(p) : kind == 2 && p.parent == settings(places))
            .toList();
    return any(wanted.isEmpty() ? places : wanted);
  }

  private static boolean isFile(Place place) {
    return place.key.startsWith("base64") || place.key.equals("file");
  }

  private static JsonElement settings(List<Place> places) {
    return places.stream()
        .filter(place -> place.key.equals("renderOptions"))
        .map(Place::value)
        .findFirst()
        .orElse(JsonNull.INSTANCE);
  }

  /** Requests more memory than is available. */
  private void enlarge(JsonObject scene) {
    if (scene.get("renderOptions") instanceof JsonObject options && random.nextBoolean()) {
      options.addProperty("width", 65535);
      options.addProperty("height", 4097 + random.nextInt(60000));
      return;
    }
    int depth = 1900 + random.nextInt(200) + 2100 * random.nextInt(2);
    String nested = "{\"type\":\"None\",\"children\":[".repeat(depth) + "]}".repeat(depth);
    scene.add("objects", raw("[" + nested + "]"));
  }

  private static void collect(JsonElement element, List<Place> places) {
    if (element instanceof JsonArray array) {
      for (int i = 0; i < array.size(); i++) {
        places.add(new Place(array, "", i));
        collect(array.get(i), places);
      }
    } else if (element instanceof JsonObject object) {
      for (Map.Entry<String, JsonElement> member : object.entrySet()) {
        places.add(new Place(object, member.getKey(), 0));
        collect(member.getValue(), places);
      }
    }
  }

  private void change(Place place, List<Place> places) {
    if (place.key.startsWith("base64") && random.nextInt(4) != 0) {
      place.set(new JsonPrimitive(changedFile(place)));
    } else if (place.key.equals("file") && random.nextInt(4) != 0) {
      place.set(new JsonPrimitive(any(FILES)));
    } else if (isNumber(place.value()) && random.nextInt(3) != 0) {
      place.set(raw(number(place.value().getAsString())));
    } else {
      changeStructure(place, places);
    }
  }

  private void changeStructure(Place place, List<Place> places) {
    switch (random.nextInt(10)) {
      case 0 -> place.set(raw(any(VALUES)));
      case 1 -> place.set(raw(any(NUMBERS)));
      case 2 -> place.set(any(places).value().deepCopy());
      case 3 -> place.set(new JsonPrimitive(any(texts)));
      case 4 -> remove(place);
      case 5 -> rename(place);
      case 6 -> repeat(place);
      case 7 -> nest(place);
      case 8 -> swap(place, any(places));
      default -> add(place);
    }
  }

  private static boolean isNumber(JsonElement value) {
    return value instanceof JsonPrimitive primitive && primitive.isNumber();
  }

  private String number(String old) {
    switch (random.nextInt(6)) {
      case 0:
        return Double.toString(Double.parseDouble(old) * (random.nextDouble() * 4 - 2));
      case 1:
        return Integer.toString(random.nextInt(12) - 2);
      case 2:
        return (random.nextBoolean() ? "-" : "") + random.nextInt(1000) + "e" + exponent();
      default:
        return any(NUMBERS);
    }
  }

  private int exponent() {
    return random.nextInt(random.nextBoolean() ? 20 : 660) - (random.nextBoolean() ? 10 : 330);
  }

  private String changedFile(Place place) {
    boolean picture = place.key.equals("base64PNG");
    byte[] old;
    try {
      old = Base64.getDecoder().decode(place.value().getAsString());
    } catch (IllegalArgumentException | IllegalStateException | UnsupportedOperationException e) {
      old = new byte[0];
    }
    byte[] changed =
        picture ? new PictureMutator(random).next() : new MeshMutator(random).changed(old);
    String text = Base64.getEncoder().encodeToString(changed);
    if (random.nextInt(12) != 0 || text.isEmpty()) {
      return text;
    }
    int at = random.nextInt(text.length());
    return text.substring(0, at) + any("", "=", "\n", "!", " ", "\u00e4") + text.substring(at + 1);
  }

  private static void remove(Place place) {
    if (place.parent instanceof JsonArray array) {
      array.remove(place.index);
    } else {
      place.object().remove(place.key);
    }
  }

  private void rename(Place place) {
    if (place.parent instanceof JsonObject object) {
      JsonElement value = object.remove(place.key);
      object.add(random.nextInt(8) == 0 ? place.key + "x" : any(keys), value);
    }
  }

  private void repeat(Place place) {
    if (place.parent instanceof JsonArray array) {
      for (int times = 1 + random.nextInt(3); times > 0; times--) {
        array.add(place.value().deepCopy());
      }
    }
  }

  /** Nests an object in itself, or a value in many arrays and objects. */
  private void nest(Place place) {
    if (place.value() instanceof JsonObject object && object.has("type")) {
      JsonArray children = new JsonArray();
      children.add(object.deepCopy());
      object.add("children", children);
      return;
    }
    int depth = 1 << random.nextInt(13);
    place.set(raw("[".repeat(depth) + "]".repeat(depth)));
  }

  private static void swap(Place one, Place other) {
    JsonElement first = one.value().deepCopy();
    JsonElement second = other.value().deepCopy();
    one.set(second);
    other.set(first);
  }

  /** Adds a key of another scene to an object. */
  private void add(Place place) {
    if (place.value() instanceof JsonObject object) {
      JsonElement value = random.nextBoolean() ? raw(any(NUMBERS)) : new JsonPrimitive(any(texts));
      object.add(any(keys), value);
    }
  }

  private static JsonPrimitive raw(String text) {
    return new JsonPrimitive(RAW + text);
  }

  private byte[] broken(byte[] text) {
    byte[] result = text.clone();
    int at = random.nextInt(text.length);
    switch (random.nextInt(4)) {
      case 0:
        result[at] = (byte) random.nextInt(256);
        return result;
      case 1:
        return Arrays.copyOf(text, at);
      case 2:
        int end = Math.min(text.length, at + random.nextInt(40));
        return joined(text, at, new byte[0], end);
      default:
        return joined(text, at, any(TOKENS).getBytes(StandardCharsets.UTF_8), at);
    }
  }

  private static byte[] joined(byte[] text, int at, byte[] middle, int from) {
    byte[] result = new byte[at + middle.length + text.length - from];
    System.arraycopy(text, 0, result, 0, at);
    System.arraycopy(middle, 0, result, at, middle.length);
    System.arraycopy(text, from, result, at + middle.length, text.length - from);
    return result;
  }

  private static void print(JsonElement element, StringBuilder out) {
    if (element instanceof JsonObject object) {
      String before = "{";
      for (Map.Entry<String, JsonElement> member : object.entrySet()) {
        out.append(before).append(new JsonPrimitive(member.getKey())).append(':');
        print(member.getValue(), out);
        before = ",";
      }
      out.append(object.size() == 0 ? "{}" : "}");
    } else if (element instanceof JsonArray array) {
      out.append('[');
      for (int i = 0; i < array.size(); i++) {
        out.append(i == 0 ? "" : ",");
        print(array.get(i), out);
      }
      out.append(']');
    } else if (element instanceof JsonNull) {
      out.append("null");
    } else if (isRaw(element)) {
      out.append(element.getAsString().substring(RAW.length()));
    } else {
      out.append(element);
    }
  }

  private static boolean isRaw(JsonElement element) {
    return element.getAsJsonPrimitive().isString() && element.getAsString().startsWith(RAW);
  }
}
