package io.github.lumbre.cli.mcp;

import java.util.LinkedHashMap;
import java.util.Map;

/** A request that the protocol does not allow; it is answered with an error of JSON-RPC 2.0. */
final class RpcException extends Exception {
  static final int PARSE_ERROR = -32700;
  static final int INVALID_REQUEST = -32600;
  static final int METHOD_NOT_FOUND = -32601;
  static final int INVALID_PARAMS = -32602;
  static final int INTERNAL_ERROR = -32603;

  /** The revision of the protocol that a request states is not supported. */
  static final int UNSUPPORTED_VERSION = -32022;

  private static final long serialVersionUID = 1;

  private final int code;
  private final transient Map<String, Object> data;

  /**
   * @param message says what was found and what was expected
   */
  RpcException(int code, String message) {
    this(code, message, Map.of());
  }

  /**
   * @param data for programs; empty for none
   */
  RpcException(int code, String message, Map<String, Object> data) {
    super(message);
    this.code = code;
    this.data = data;
  }

  /** Returns the value of {@code error} in the answer. */
  Map<String, Object> error() {
    Map<String, Object> error = new LinkedHashMap<>();
    error.put("code", code);
    error.put("message", getMessage());
    if (!data.isEmpty()) {
      error.put("data", data);
    }
    return error;
  }
}
