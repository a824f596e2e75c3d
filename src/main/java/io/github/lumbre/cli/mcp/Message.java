package io.github.lumbre.cli.mcp;

import io.github.lumbre.base.json.JsonException;
import io.github.lumbre.base.json.JsonTree;
import io.github.lumbre.base.json.JsonValue;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A message of JSON-RPC 2.0 from a client. A member that is null counts as absent.
 *
 * @param id a string or a long; empty for a notification
 * @param params its members; empty without parameters
 */
record Message(Optional<Object> id, String method, Map<String, JsonValue> params) {
  /** The longest line that is read. */
  static final int MAX_BYTES = 1 << 20;

  /** The most messages of a batch. */
  static final int MAX_BATCH = 64;

  private static final int MAX_LEVELS = 32;
  private static final long MAX_TOKENS = 100_000;

  /**
   * Returns the JSON value of a line.
   *
   * @throws RpcException if it is not JSON in UTF-8
   */
  static JsonValue parse(byte[] line) throws RpcException {
    try {
      JsonTree.Result read = JsonTree.read(ByteBuffer.wrap(line), MAX_LEVELS, MAX_TOKENS);
      if (!read.flaws().isEmpty()) {
        JsonTree.Flaw flaw = read.flaws().get(0);
        throw new RpcException(
            RpcException.PARSE_ERROR, flaw.value().path() + ": " + flaw.message());
      }
      return read.root();
    } catch (JsonException e) {
      throw new RpcException(RpcException.PARSE_ERROR, e.path() + ": " + e.getMessage());
    }
  }

  /**
   * Returns the messages of a batch.
   *
   * @throws RpcException if it is empty or too long
   */
  static List<JsonValue> batch(JsonValue value) throws RpcException {
    List<JsonValue> messages = new ArrayList<>(value.elements());
    if (messages.isEmpty() || messages.size() > MAX_BATCH) {
      throw new RpcException(
          RpcException.INVALID_REQUEST,
          "expected 1 to " + MAX_BATCH + " messages in a batch, found " + messages.size());
    }
    return messages;
  }

  /** Returns the identity of a request, as far as it can be read. */
  static Optional<Object> id(JsonValue value) {
    return value.isObject()
        ? Optional.ofNullable(value.members().get("id")).flatMap(Message::idOf)
        : Optional.empty();
  }

  /**
   * Returns a message.
   *
   * @return empty for a response, which no client of this server needs to send
   * @throws RpcException if it is none of JSON-RPC 2.0
   */
  static Optional<Message> of(JsonValue value) throws RpcException {
    require(value.isObject(), "expected an object, found " + value.found());
    Map<String, JsonValue> members = value.members();
    JsonValue version = members.get("jsonrpc");
    require(
        version != null && version.isString() && version.text().equals("2.0"),
        "jsonrpc: expected \"2.0\"");
    if (!members.containsKey("method")
        && (members.containsKey("result") || members.containsKey("error"))) {
      return Optional.empty();
    }
    JsonValue method = members.get("method");
    require(method != null && method.isString(), "method: expected a string");
    Optional<Object> id = id(value);
    require(id.isPresent() || !members.containsKey("id"), "id: expected a string or an integer");
    Optional<JsonValue> params = Optional.ofNullable(present(value).get("params"));
    require(params.isEmpty() || params.get().isObject(), "params: expected an object");
    return Optional.of(
        new Message(id, method.text(), params.map(Message::present).orElse(Map.of())));
  }

  /** Returns the members of an object that are not null. */
  static Map<String, JsonValue> present(JsonValue object) {
    Map<String, JsonValue> members = new LinkedHashMap<>(object.members());
    members.values().removeIf(JsonValue::isNull);
    return members;
  }

  /** Returns a string or integer as an identity; empty for other values. */
  static Optional<Object> idOf(JsonValue value) {
    if (value.isString()) {
      return Optional.of(value.text());
    }
    return value.isNumber() ? value.exactLong().map(Object.class::cast) : Optional.empty();
  }

  private static void require(boolean condition, String message) throws RpcException {
    if (!condition) {
      throw new RpcException(RpcException.INVALID_REQUEST, message);
    }
  }

  /** Returns a member of the metadata of a request; empty if it has none. */
  Optional<JsonValue> meta(String key) {
    return Optional.ofNullable(params.get("_meta"))
        .filter(JsonValue::isObject)
        .flatMap(meta -> Optional.ofNullable(present(meta).get(key)));
  }
}
