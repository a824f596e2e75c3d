package io.github.lumbre.model;

import com.google.gson.Strictness;
import com.google.gson.stream.JsonReader;
import com.google.gson.stream.JsonToken;
import com.google.gson.stream.MalformedJsonException;
import io.github.lumbre.model.ModelFormatException.Kind;
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
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Reads the JSON of a glTF file, strictly by RFC 8259 and without recursion. Objects become maps,
 * arrays become lists, numbers become doubles. Duplicate keys and infinite numbers are refused. Not
 * reusable.
 */
final class GltfJsonReader {
  /** The largest nesting depth of arrays and objects; glTF itself needs about ten. */
  private static final int MAX_LEVELS = 256;

  private final ByteBuffer text;
  private final JsonReader in;
  private final GltfBudget budget;
  private final Deque<Object> open = new ArrayDeque<>();
  private final Map<String, String> knownKeys = new HashMap<>();
  private String key = "";
  private Object root = GltfJson.NULL;

  private GltfJsonReader(ByteBuffer text, GltfBudget budget) {
    this.text = text;
    this.budget = budget;
    in =
        new JsonReader(
            new InputStreamReader(
                GltfInterrupts.over(
                    text.array(), text.arrayOffset() + text.position(), text.remaining()),
                StandardCharsets.UTF_8
                    .newDecoder()
                    .onMalformedInput(CodingErrorAction.REPORT)
                    .onUnmappableCharacter(CodingErrorAction.REPORT)));
    in.setStrictness(Strictness.STRICT);
    in.setNestingLimit(MAX_LEVELS + 1);
  }

  /**
   * Returns the outermost object.
   *
   * @param text in UTF-8, in an array-backed buffer
   * @throws ModelFormatException if the text is not JSON, not an object, or beyond the limits
   */
  static GltfJson read(ByteBuffer text, GltfBudget budget) throws ModelFormatException {
    return GltfJson.root(new GltfJsonReader(text, budget).read());
  }

  private Object read() throws ModelFormatException {
    try {
      readAll();
    } catch (CharacterCodingException e) {
      throw malformed("", "expected UTF-8, found invalid bytes");
    } catch (MalformedJsonException e) {
      String found = JsonMistake.of(text, place(), String.valueOf(e.getMessage()));
      throw malformed(path(), "expected JSON (RFC 8259), found " + found);
    } catch (EOFException e) {
      throw malformed(path(), "expected more JSON, found the end of the text " + place());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return root;
  }

  private void readAll() throws IOException, ModelFormatException {
    do {
      readToken(in.peek());
      budget.addToken();
    } while (!open.isEmpty());
    // The reader itself rejects a second value.
    in.peek();
  }

  private void readToken(JsonToken token) throws IOException, ModelFormatException {
    switch (token) {
      case NAME -> key = knownKeys.computeIfAbsent(in.nextName(), name -> name);
      case END_OBJECT -> {
        in.endObject();
        open.pop();
      }
      case END_ARRAY -> {
        in.endArray();
        open.pop();
      }
      case BEGIN_OBJECT -> {
        Map<String, Object> members = new LinkedHashMap<>();
        add(members);
        in.beginObject();
        open(members);
      }
      case BEGIN_ARRAY -> {
        List<Object> items = new ArrayList<>();
        add(items);
        in.beginArray();
        open(items);
      }
      case NUMBER -> add(number());
      case BOOLEAN -> add(in.nextBoolean());
      case NULL -> {
        in.nextNull();
        add(GltfJson.NULL);
      }
      default -> add(in.nextString());
    }
  }

  private Double number() throws IOException, ModelFormatException {
    String text = in.nextString();
    double number = Double.parseDouble(text);
    if (Double.isInfinite(number)) {
      String place = path(in.getPreviousPath());
      throw malformed(place, "expected a finite number, found " + PrintableText.shortened(text));
    }
    return number;
  }

  private void open(Object container) throws ModelFormatException {
    open.push(container);
    if (open.size() > MAX_LEVELS) {
      throw tooLarge("expected at most " + MAX_LEVELS + " nested JSON values, found more");
    }
  }

  @SuppressWarnings("unchecked") // readToken makes these containers.
  private void add(Object value) throws ModelFormatException {
    if (open.isEmpty()) {
      root = value;
    } else if (open.peek() instanceof List<?> items) {
      ((List<Object>) items).add(value);
    } else {
      if (((Map<String, Object>) open.peek()).put(key, value) != null) {
        throw malformed(path(), "expected each key once, found it again " + place());
      }
    }
  }

  private String path() {
    return path(in.getPath());
  }

  private static String path(String path) {
    // Where a name is expected, the path ends with a dot.
    return path.replaceFirst("[.]$", "").replaceFirst("^[$][.]?", "");
  }

  private JsonPlace place() {
    return JsonPlace.of(in.toString());
  }

  private static ModelFormatException malformed(String path, String message) {
    return new ModelFormatException(Kind.MALFORMED, GltfText.path(path), message);
  }

  private ModelFormatException tooLarge(String message) {
    return new ModelFormatException(Kind.TOO_LARGE, GltfText.path(path()), message);
  }
}
