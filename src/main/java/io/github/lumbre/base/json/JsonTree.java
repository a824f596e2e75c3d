package io.github.lumbre.base.json;

import com.google.gson.Strictness;
import com.google.gson.stream.JsonReader;
import com.google.gson.stream.JsonToken;
import com.google.gson.stream.MalformedJsonException;
import io.github.lumbre.base.limit.internal.Interrupts;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.CodingErrorAction;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Reads a whole JSON text into {@link JsonValue}s, strictly by RFC 8259 and without recursion. Not
 * reusable.
 */
public final class JsonTree {
  private static final long MAX_TOKENS = 100_000_000;

  /** Heap bytes per token: 90 to 130 measured, plus headroom for the garbage collector. */
  public static final long BYTES_PER_TOKEN = 160;

  /** The largest number of flaws that are reported. */
  private static final int MAX_FLAWS = 20;

  /** Two values of the same key. */
  private record Duplicate(JsonValue first, JsonValue second) {}

  /**
   * A value that JSON allows and readers do not: a number that overflows, or one of a repeated key.
   *
   * @param message what was expected and found
   */
  public record Flaw(JsonValue value, String message) {}

  /**
   * What was read.
   *
   * @param flaws at most 20 of each kind. Of two values of one key, the first counts
   * @param tokens number of tokens of the text
   */
  public record Result(JsonValue root, List<Flaw> flaws, long tokens) {}

  private final ByteBuffer text;
  private final int maxLevels;
  private final long maxTokens;
  private final List<Duplicate> duplicates = new ArrayList<>();
  private final List<Flaw> flaws = new ArrayList<>();
  private Optional<JsonValue> root = Optional.empty();
  private final Deque<JsonValue> open = new ArrayDeque<>();
  private String key = "";
  private int names;
  private long tokens;

  private JsonTree(ByteBuffer text, int maxLevels, long maxTokens) {
    this.text = text;
    this.maxLevels = maxLevels;
    this.maxTokens = maxTokens;
  }

  /**
   * Returns the outermost value.
   *
   * @param text in UTF-8, with or without a byte order mark, in an array-backed buffer
   * @param maxLevels the largest nesting depth of arrays and objects
   * @throws JsonException if the text is not JSON, nested too deeply, or has too many tokens
   */
  public static Result read(ByteBuffer text, int maxLevels, long maxTokens) throws JsonException {
    return new JsonTree(text, maxLevels, maxTokens).read();
  }

  /** Returns the number of tokens that fit into a heap of this size; at most 10^8. */
  public static long maxTokens(long maxHeapBytes) {
    return Math.min(MAX_TOKENS, maxHeapBytes / BYTES_PER_TOKEN);
  }

  private Result read() throws JsonException {
    JsonReader in = reader();
    try {
      readAll(in);
    } catch (CharacterCodingException e) {
      throw broken("$", "expected UTF-8, found invalid bytes");
    } catch (MalformedJsonException e) {
      throw broken(
          in.getPath(),
          "expected JSON (RFC 8259), found "
              + JsonMistake.of(text, place(in), String.valueOf(e.getMessage())));
    } catch (EOFException e) {
      throw root.isEmpty()
          ? broken("$", "expected an object, found an empty file")
          : broken(in.getPath(), "expected more JSON, found the end of the file " + place(in));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    reportDuplicates();
    return new Result(root.orElseThrow(), flaws, tokens);
  }

  private JsonReader reader() {
    JsonReader in =
        new JsonReader(
            new InputStreamReader(
                Interrupts.over(
                    text.array(), text.arrayOffset() + text.position(), text.remaining()),
                StandardCharsets.UTF_8
                    .newDecoder()
                    .onMalformedInput(CodingErrorAction.REPORT)
                    .onUnmappableCharacter(CodingErrorAction.REPORT)));
    in.setStrictness(Strictness.STRICT);
    in.setNestingLimit(maxLevels + 1);
    return in;
  }

  private static JsonException broken(String path, String message) {
    // Where a name is expected, the path ends with a dot.
    return new JsonException(path.replaceFirst("[.]$", ""), false, message);
  }

  private static JsonException tooLarge(String path, String message) {
    return new JsonException(path, true, message);
  }

  private static JsonPlace place(JsonReader in) {
    return JsonPlace.of(in.toString());
  }

  private void readAll(JsonReader in) throws IOException, JsonException {
    do {
      readToken(in, in.peek());
      if (++tokens > maxTokens) {
        throw tooLarge(
            "$", "expected at most " + maxTokens + " JSON tokens in this heap, found more");
      }
    } while (!open.isEmpty());
    // The reader itself rejects a second value.
    in.peek();
  }

  private void readToken(JsonReader in, JsonToken token) throws IOException, JsonException {
    switch (token) {
      case NAME -> {
        key = in.nextName();
        names++;
      }
      case END_OBJECT -> {
        in.endObject();
        open.pop();
      }
      case END_ARRAY -> {
        in.endArray();
        open.pop();
      }
      default -> add(value(in, token));
    }
  }

  private JsonValue value(JsonReader in, JsonToken token) throws IOException {
    JsonValue.Maker maker = new JsonValue.Maker(Optional.ofNullable(open.peek()), key, names);
    return switch (token) {
      case BEGIN_OBJECT -> {
        in.beginObject();
        yield maker.object();
      }
      case BEGIN_ARRAY -> {
        in.beginArray();
        yield maker.array();
      }
      case NUMBER -> maker.number(in.nextString());
      case BOOLEAN -> maker.flag(in.nextBoolean());
      case NULL -> {
        in.nextNull();
        yield maker.nothing();
      }
      default -> maker.string(in.nextString());
    };
  }

  private void add(JsonValue value) throws JsonException {
    if (open.isEmpty()) {
      root = Optional.of(value);
    } else {
      open.peek().add(value).ifPresent(first -> duplicates.add(new Duplicate(first, value)));
    }
    if (value.isInfinite() && flaws.size() < MAX_FLAWS) {
      flaws.add(new Flaw(value, "expected a finite number, found " + value.found()));
    }
    if (value.isObject() || value.isArray()) {
      open.push(value);
      if (open.size() > maxLevels) {
        throw tooLarge(
            value.path(), "expected at most " + maxLevels + " nested JSON values, found more");
      }
    }
  }

  private void reportDuplicates() {
    List<Duplicate> shown = duplicates.subList(0, Math.min(duplicates.size(), MAX_FLAWS));
    if (shown.isEmpty()) {
      return;
    }
    Map<Integer, Integer> lines = new HashMap<>();
    for (Duplicate duplicate : shown) {
      lines.put(duplicate.first.position(), 0);
      lines.put(duplicate.second.position(), 0);
    }
    findLines(lines);
    for (Duplicate duplicate : shown) {
      String message =
          "expected each key once, found it on line "
              + lines.get(duplicate.first.position())
              + " and on line "
              + lines.get(duplicate.second.position());
      flaws.add(new Flaw(duplicate.second, message));
    }
  }

  /** Reads the text a second time and records the lines of some keys. The text is valid JSON. */
  private void findLines(Map<Integer, Integer> lineOfName) {
    JsonReader in = reader();
    int count = 0;
    try {
      for (JsonToken token = in.peek(); token != JsonToken.END_DOCUMENT; token = in.peek()) {
        switch (token) {
          case BEGIN_OBJECT -> in.beginObject();
          case END_OBJECT -> in.endObject();
          case BEGIN_ARRAY -> in.beginArray();
          case END_ARRAY -> in.endArray();
          case NAME -> {
            in.nextName();
            lineOfName.computeIfPresent(++count, (name, line) -> place(in).line());
          }
          default -> in.skipValue();
        }
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
