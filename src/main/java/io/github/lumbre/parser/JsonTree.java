package io.github.lumbre.parser;

import com.google.gson.Strictness;
import com.google.gson.stream.JsonReader;
import com.google.gson.stream.JsonToken;
import com.google.gson.stream.MalformedJsonException;
import io.github.lumbre.limit.Limits;
import io.github.lumbre.text.JsonMistake;
import io.github.lumbre.text.JsonPlace;
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
 * Reads a whole JSON text into {@link JsonNode}s, strictly by RFC 8259 and without recursion. Not
 * reusable.
 */
final class JsonTree {
  /** The largest nesting depth of arrays and objects. */
  static final int MAX_LEVELS = 4096;

  private static final long MAX_TOKENS = 100_000_000;

  /** Heap bytes per token: 90 to 130 measured, plus headroom for the garbage collector. */
  private static final long BYTES_PER_TOKEN = 160;

  /** Two values of the same key. */
  private record Duplicate(JsonNode first, JsonNode second) {}

  private final byte[] text;
  private final Problems problems;
  private final long maxTokens;
  private final List<Duplicate> duplicates = new ArrayList<>();
  private Optional<JsonNode> root = Optional.empty();
  private final Deque<JsonNode> open = new ArrayDeque<>();
  private String key = "";
  private int names;

  private JsonTree(byte[] text, Problems problems, long maxTokens) {
    this.text = text;
    this.problems = problems;
    this.maxTokens = maxTokens;
  }

  /**
   * Returns the outermost value.
   *
   * <p>Duplicate keys and numbers that overflow are added to the problems. Of two values of one
   * key, the first counts.
   *
   * @param text in UTF-8, with or without a byte order mark
   * @throws SceneFormatException if the text is not JSON, nested too deeply, or has more tokens
   *     than fit into the heap
   */
  static JsonNode read(byte[] text, Problems problems) throws SceneFormatException {
    return read(text, problems, maxTokens(Limits.NONE.heap()));
  }

  /** Returns the outermost value, whose nodes fit into the memory that limits allow. */
  static JsonNode read(byte[] text, Problems problems, Limits limits) throws SceneFormatException {
    return read(text, problems, maxTokens(limits.heap()));
  }

  static JsonNode read(byte[] text, Problems problems, long maxTokens) throws SceneFormatException {
    return new JsonTree(text, problems, maxTokens).read();
  }

  /** Returns the number of tokens that fit into a heap of this size; at most 10^8. */
  static long maxTokens(long maxHeapBytes) {
    return Math.min(MAX_TOKENS, maxHeapBytes / BYTES_PER_TOKEN);
  }

  private JsonNode read() throws SceneFormatException {
    JsonReader in = reader();
    try {
      readAll(in);
    } catch (CharacterCodingException e) {
      throw broken("$", "expected UTF-8, found invalid bytes");
    } catch (MalformedJsonException e) {
      throw broken(
          in.getPath(),
          "expected JSON (RFC 8259), found "
              + JsonMistake.of(ByteBuffer.wrap(text), place(in), String.valueOf(e.getMessage())));
    } catch (EOFException e) {
      throw root.isEmpty()
          ? broken("$", "expected an object, found an empty file")
          : broken(in.getPath(), "expected more JSON, found the end of the file " + place(in));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    reportDuplicates();
    return root.orElseThrow();
  }

  private JsonReader reader() {
    JsonReader in =
        new JsonReader(
            new InputStreamReader(
                Interrupts.over(text),
                StandardCharsets.UTF_8
                    .newDecoder()
                    .onMalformedInput(CodingErrorAction.REPORT)
                    .onUnmappableCharacter(CodingErrorAction.REPORT)));
    in.setStrictness(Strictness.STRICT);
    in.setNestingLimit(MAX_LEVELS + 1);
    return in;
  }

  private SceneFormatException broken(String path, String message) {
    // Where a name is expected, the path ends with a dot.
    String place = path.replaceFirst("[.]$", "");
    problems.error(SceneFormatException.Kind.INVALID, () -> place, message);
    return problems.exception();
  }

  private SceneFormatException tooLarge(String path, String message) {
    problems.error(SceneFormatException.Kind.LIMIT, () -> path, message);
    return problems.exception();
  }

  private static JsonPlace place(JsonReader in) {
    return JsonPlace.of(in.toString());
  }

  private void readAll(JsonReader in) throws IOException, SceneFormatException {
    long tokens = 0;
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

  private void readToken(JsonReader in, JsonToken token) throws IOException, SceneFormatException {
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

  private JsonNode value(JsonReader in, JsonToken token) throws IOException {
    JsonNode.Place place =
        open.isEmpty() ? JsonNode.Place.outermost(problems) : open.peek().placeFor(key, names);
    return switch (token) {
      case BEGIN_OBJECT -> {
        in.beginObject();
        yield JsonNode.object(place);
      }
      case BEGIN_ARRAY -> {
        in.beginArray();
        yield JsonNode.array(place);
      }
      case NUMBER -> JsonNode.number(place, in.nextString());
      case BOOLEAN -> JsonNode.flag(place, in.nextBoolean());
      case NULL -> {
        in.nextNull();
        yield JsonNode.nothing(place);
      }
      default -> JsonNode.string(place, in.nextString());
    };
  }

  private void add(JsonNode node) throws SceneFormatException {
    if (open.isEmpty()) {
      root = Optional.of(node);
    } else {
      open.peek().add(node).ifPresent(first -> duplicates.add(new Duplicate(first, node)));
    }
    if (node.isInfinite()) {
      node.error("expected a finite number, found " + node.found());
    }
    if (node.isObject() || node.isArray()) {
      open.push(node);
      if (open.size() > MAX_LEVELS) {
        throw tooLarge(
            node.path(), "expected at most " + MAX_LEVELS + " nested JSON values, found more");
      }
    }
  }

  private void reportDuplicates() {
    if (duplicates.isEmpty()) {
      return;
    }
    List<Duplicate> shown = duplicates.subList(0, Math.min(duplicates.size(), Problems.MAX_ERRORS));
    Map<Integer, Integer> lines = new HashMap<>();
    for (Duplicate duplicate : shown) {
      lines.put(duplicate.first.position(), 0);
      lines.put(duplicate.second.position(), 0);
    }
    findLines(lines);
    for (Duplicate duplicate : shown) {
      duplicate.second.error(
          "expected each key once, found it on line "
              + lines.get(duplicate.first.position())
              + " and on line "
              + lines.get(duplicate.second.position()));
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
