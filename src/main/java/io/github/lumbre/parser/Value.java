package io.github.lumbre.parser;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Range;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The type of a key's values. Stateless.
 *
 * @param <T> the type in memory
 */
sealed interface Value<T> {
  /** Returns the value of a key; {@code otherwise} if it is missing, or wrong: an error. */
  T read(JsonNode from, String key, T otherwise);

  JsonElement write(T value);

  /** Returns what is expected instead of a value that scenes may not state; empty if they may. */
  default Optional<String> excess(T value) {
    return Optional.empty();
  }

  /** Numbers in a range. */
  record Numbers(Range range) implements Value<Double> {
    @Override
    public Double read(JsonNode from, String key, Double otherwise) {
      return from.number(key, otherwise, range);
    }

    @Override
    public JsonElement write(Double value) {
      return new JsonPrimitive(value);
    }

    @Override
    public Optional<String> excess(Double value) {
      return range.contains(value) ? Optional.empty() : Optional.of(range.expectedFor(value));
    }
  }

  /** Integers from low to high. */
  record Integers(int low, int high) implements Value<Integer> {
    @Override
    public Integer read(JsonNode from, String key, Integer otherwise) {
      return from.integer(key, otherwise, low, high);
    }

    @Override
    public JsonElement write(Integer value) {
      return new JsonPrimitive(value);
    }
  }

  /** Integers of 64 bits. */
  record Longs() implements Value<Long> {
    @Override
    public Long read(JsonNode from, String key, Long otherwise) {
      return from.integer(key, otherwise, Long.MIN_VALUE, Long.MAX_VALUE);
    }

    @Override
    public JsonElement write(Long value) {
      return new JsonPrimitive(value);
    }
  }

  /** The id of an object, or of an asset of a type. */
  record Ids(Optional<AssetTable.Type> asset) implements Value<Integer> {
    @Override
    public Integer read(JsonNode from, String key, Integer otherwise) {
      return from.id(key).orElse(otherwise);
    }

    @Override
    public JsonElement write(Integer value) {
      return new JsonPrimitive(value);
    }
  }

  /** True or false. */
  record Flags() implements Value<Boolean> {
    @Override
    public Boolean read(JsonNode from, String key, Boolean otherwise) {
      return from.flag(key, otherwise);
    }

    @Override
    public JsonElement write(Boolean value) {
      return new JsonPrimitive(value);
    }
  }

  /** Named values. */
  record Choices<T>(Map<String, T> choices) implements Value<T> {
    @Override
    public T read(JsonNode from, String key, T otherwise) {
      return from.choice(key, choices, otherwise);
    }

    @Override
    public JsonElement write(T value) {
      return choices.entrySet().stream()
          .filter(choice -> choice.getValue().equals(value))
          .map(choice -> new JsonPrimitive(choice.getKey()))
          .findFirst()
          .orElseThrow();
    }
  }

  /** Texts that a regular expression matches. */
  record Texts(String pattern) implements Value<String> {
    @Override
    public String read(JsonNode from, String key, String otherwise) {
      return from.string(key).orElse(otherwise);
    }

    @Override
    public JsonElement write(String value) {
      return new JsonPrimitive(value);
    }
  }

  /** Linear colors. */
  record Colors() implements Value<Rgb> {
    @Override
    public Rgb read(JsonNode from, String key, Rgb otherwise) {
      return from.has(key) ? from.rgb(key) : otherwise;
    }

    @Override
    public JsonElement write(Rgb value) {
      return object("r", value.r(), "g", value.g(), "b", value.b());
    }
  }

  /** Vectors of three numbers. */
  record Vectors() implements Value<Vec3> {
    @Override
    public Vec3 read(JsonNode from, String key, Vec3 otherwise) {
      return from.vec3(key, otherwise);
    }

    @Override
    public JsonElement write(Vec3 value) {
      return object("x", value.x(), "y", value.y(), "z", value.z());
    }
  }

  /** Vectors of two numbers; a third one is ignored. */
  record Points() implements Value<Point2> {
    @Override
    public Point2 read(JsonNode from, String key, Point2 otherwise) {
      return from.vec2(key, otherwise);
    }

    @Override
    public JsonElement write(Point2 value) {
      return object("x", value.x(), "y", value.y());
    }
  }

  /** Arrays of numbers, of one of some lengths. */
  record Lists(List<Integer> lengths) implements Value<double[]> {
    @Override
    public double[] read(JsonNode from, String key, double[] otherwise) {
      return from.numbers(key, lengths);
    }

    @Override
    public JsonElement write(double[] value) {
      JsonArray numbers = new JsonArray();
      Arrays.stream(value).forEach(numbers::add);
      return numbers;
    }
  }

  /** Values with a structure of their own, which has its own reader and writer. */
  record Others() implements Value<JsonNode> {
    @Override
    public JsonNode read(JsonNode from, String key, JsonNode otherwise) {
      return from.find(key).orElse(otherwise);
    }

    @Override
    public JsonElement write(JsonNode value) {
      throw new UnsupportedOperationException();
    }
  }

  private static JsonObject object(Object... keysAndNumbers) {
    JsonObject object = new JsonObject();
    for (int i = 0; i < keysAndNumbers.length; i += 2) {
      object.addProperty((String) keysAndNumbers[i], (Double) keysAndNumbers[i + 1]);
    }
    return object;
  }
}
