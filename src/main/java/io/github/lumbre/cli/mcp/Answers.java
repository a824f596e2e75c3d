package io.github.lumbre.cli.mcp;

import io.github.lumbre.cli.output.JsonText;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/**
 * Writes messages to a client, a line each. If the client stops reading, the callers wait, so that
 * nothing piles up. Thread-safe.
 */
final class Answers {
  private final OutputStream out;
  private volatile boolean isBroken;

  Answers(OutputStream out) {
    this.out = out;
  }

  /** Returns the answer to a request. */
  static Map<String, Object> result(Object id, Map<String, Object> result) {
    Map<String, Object> answer = message();
    answer.put("id", id);
    answer.put("result", result);
    return answer;
  }

  /**
   * Returns the answer to a request that cannot be answered otherwise.
   *
   * @param id of the request; empty if it cannot be read, which is null in the answer
   */
  static Map<String, Object> error(Optional<Object> id, RpcException e) {
    Map<String, Object> answer = message();
    answer.put("id", id.orElse(null));
    answer.put("error", e.error());
    return answer;
  }

  static Map<String, Object> notification(String method, Map<String, Object> params) {
    Map<String, Object> notification = message();
    notification.put("method", method);
    notification.put("params", params);
    return notification;
  }

  private static Map<String, Object> message() {
    Map<String, Object> message = new LinkedHashMap<>();
    message.put("jsonrpc", "2.0");
    return message;
  }

  /** Writes a message, or the messages of a batch. */
  void write(Object message) {
    byte[] line = (JsonText.completeLine(message) + "\n").getBytes(StandardCharsets.UTF_8);
    synchronized (this) {
      if (!isBroken) {
        try {
          out.write(line);
          out.flush();
        } catch (IOException e) {
          isBroken = true;
        }
      }
    }
  }

  /** Returns whether the client cannot be reached any more. */
  boolean isBroken() {
    return isBroken;
  }
}
