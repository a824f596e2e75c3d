package io.github.lumbre.cli.mcp;

import io.github.lumbre.base.Release;
import io.github.lumbre.base.json.JsonValue;
import io.github.lumbre.base.limit.internal.TimeLimit;
import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.cli.output.JsonText;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;

/**
 * The requests of the Model Context Protocol and their results. Confined to the thread that reads
 * messages.
 *
 * <p>Source: <a href="https://modelcontextprotocol.io/specification/2026-07-28">the revision
 * 2026-07-28</a>, and the life cycle and tools of the revisions before it.
 */
final class Protocol {
  /** The revision without a handshake. */
  static final String STATELESS = "2026-07-28";

  /** The revisions that begin with {@code initialize}, the newest first. */
  static final List<String> WITH_HANDSHAKE =
      List.of("2025-11-25", "2025-06-18", "2025-03-26", "2024-11-05");

  private static final String META = "io.modelcontextprotocol/";
  private static final long MILLIS_PER_HOUR = 3_600_000;

  private static final String INSTRUCTIONS =
      "Lumbre renders 3D models (glTF, OBJ, PLY, STL, OFF, 3MF, COLLADA, ZIP) and its scenes in JSON"
          + " from files: pictures as PNG, numbers as JSON. 'views' shows a part from all sides at"
          + " once; 'describe' lists its size and parts without rendering; 'render' shows one view;"
          + " 'diff' says what changed between two models.";

  private final List<Tool> tools;
  private boolean hasBegun;

  Protocol(List<Tool> tools) {
    this.tools = List.copyOf(tools);
  }

  /** How results are written. */
  enum Era {
    /** With the revisions that begin with a handshake. */
    HANDSHAKE,

    /** With {@link Protocol#STATELESS}. */
    STATELESS;

    /** Returns a result with what this era adds. */
    Map<String, Object> result(Map<String, Object> result) {
      if (this == HANDSHAKE) {
        return result;
      }
      Map<String, Object> complete = new LinkedHashMap<>();
      complete.put("resultType", "complete");
      complete.putAll(result);
      complete.put("_meta", Map.of(META + "serverInfo", program()));
      return complete;
    }
  }

  /** A call of a tool whose name is known. */
  record Call(Tool tool, Map<String, JsonValue> arguments) {
    /**
     * Does the work; its failures are results, too, so that language models see them.
     *
     * @param most time that the work may take
     */
    Map<String, Object> result(CallProgress progress, Duration most) throws InterruptedException {
      try (TimeLimit time = TimeLimit.start(most)) {
        try {
          return done(tool.call(new Arguments(tool.inputs(), arguments), progress));
        } catch (ToolException e) {
          return failed(e.getMessage());
        } catch (InterruptedException | CancellationException e) {
          if (time.hasPassed()) {
            return failed(
                "stopped after %d s; ask for fewer pixels or samples, or hide parts of the model"
                    .formatted(most.toSeconds()));
          }
          throw e;
        } catch (OutOfMemoryError e) {
          return failed("the server's memory is exhausted; wait for other calls, and try again");
        }
      }
    }

    private static Map<String, Object> done(Tool.Outcome outcome) {
      List<Object> content = new ArrayList<>();
      for (byte[] picture : outcome.pictures()) {
        Map<String, Object> image = new LinkedHashMap<>();
        image.put("type", "image");
        image.put("data", Base64.getEncoder().encodeToString(picture));
        image.put("mimeType", "image/png");
        content.add(image);
      }
      content.add(text(outcome.text().orElseGet(() -> JsonText.line(outcome.values()))));
      Map<String, Object> result = new LinkedHashMap<>();
      result.put("content", content);
      result.put("structuredContent", outcome.values());
      return result;
    }

    private static Map<String, Object> failed(String message) {
      Map<String, Object> result = new LinkedHashMap<>();
      result.put("content", List.of(text(message)));
      result.put("isError", true);
      return result;
    }

    private static Map<String, Object> text(String text) {
      Map<String, Object> content = new LinkedHashMap<>();
      content.put("type", "text");
      content.put("text", text);
      return content;
    }
  }

  private static Map<String, Object> program() {
    Map<String, Object> program = new LinkedHashMap<>();
    program.put("name", "lumbre");
    program.put("title", "Lumbre");
    program.put("version", Release.number());
    return program;
  }

  /**
   * Returns the era of a request.
   *
   * @throws RpcException if it states another revision, or lacks what the revision requires
   */
  Era era(Message message) throws RpcException {
    Optional<JsonValue> revision = message.meta(META + "protocolVersion");
    if (revision.isEmpty()) {
      boolean isStart = message.method().equals("initialize") || message.method().equals("ping");
      if (isStart || hasBegun) {
        return Era.HANDSHAKE;
      }
      throw new RpcException(
          RpcException.INVALID_PARAMS,
          "params._meta: expected " + META + "protocolVersion, or initialize first");
    }
    if (!revision.get().isString() || !revision.get().text().equals(STATELESS)) {
      Map<String, Object> data = new LinkedHashMap<>();
      data.put("supported", List.of(STATELESS));
      data.put("requested", shown(revision.get()));
      throw new RpcException(
          RpcException.UNSUPPORTED_VERSION, "Unsupported protocol version", data);
    }
    if (message.meta(META + "clientCapabilities").filter(JsonValue::isObject).isEmpty()) {
      throw new RpcException(
          RpcException.INVALID_PARAMS,
          "params._meta: expected an object " + META + "clientCapabilities");
    }
    return Era.STATELESS;
  }

  private static String shown(JsonValue value) {
    return value.isString() ? PrintableText.shortened(value.text()) : value.found();
  }

  /**
   * Returns the result of a request that is no call.
   *
   * @throws RpcException if there is no such method
   */
  Map<String, Object> result(Message message, Era era) throws RpcException {
    boolean isStateless = era == Era.STATELESS;
    String method = message.method();
    if (method.equals("tools/list")) {
      return era.result(listed(isStateless));
    }
    if (method.equals("server/discover") && isStateless) {
      Map<String, Object> result = described();
      result.put("supportedVersions", List.of(STATELESS));
      keep(result);
      return era.result(result);
    }
    if (method.equals("initialize") && !isStateless) {
      return initialized(message);
    }
    if (method.equals("ping") && !isStateless) {
      return Map.of();
    }
    throw new RpcException(
        RpcException.METHOD_NOT_FOUND, "Method not found: " + PrintableText.shortened(method));
  }

  private Map<String, Object> initialized(Message message) throws RpcException {
    JsonValue asked = message.params().get("protocolVersion");
    if (asked == null || !asked.isString()) {
      throw new RpcException(
          RpcException.INVALID_PARAMS, "params.protocolVersion: expected a string");
    }
    hasBegun = true;
    Map<String, Object> result = new LinkedHashMap<>();
    boolean isKnown = WITH_HANDSHAKE.contains(asked.text());
    result.put("protocolVersion", isKnown ? asked.text() : WITH_HANDSHAKE.get(0));
    result.putAll(described());
    return result;
  }

  private static Map<String, Object> described() {
    Map<String, Object> result = new LinkedHashMap<>();
    result.put("capabilities", Map.of("tools", Map.of()));
    result.put("serverInfo", program());
    result.put("instructions", INSTRUCTIONS);
    return result;
  }

  private Map<String, Object> listed(boolean isKept) {
    Map<String, Object> result = new LinkedHashMap<>();
    result.put("tools", tools.stream().map(Protocol::listed).toList());
    if (isKept) {
      keep(result);
    }
    return result;
  }

  /** States that a result does not change. */
  private static void keep(Map<String, Object> result) {
    result.put("ttlMs", MILLIS_PER_HOUR);
    result.put("cacheScope", "public");
  }

  private static Map<String, Object> listed(Tool tool) {
    Map<String, Object> properties = new LinkedHashMap<>();
    tool.inputs().forEach(input -> properties.put(input.name(), input.schema()));
    Map<String, Object> schema = new LinkedHashMap<>();
    schema.put("type", "object");
    schema.put("properties", properties);
    schema.put(
        "required", tool.inputs().stream().filter(Input::isRequired).map(Input::name).toList());
    schema.put("additionalProperties", false);
    Map<String, Object> listed = new LinkedHashMap<>();
    listed.put("name", tool.name());
    listed.put("title", tool.title());
    listed.put("description", tool.description());
    listed.put("inputSchema", schema);
    listed.put("outputSchema", Output.object(tool.outputs()));
    Map<String, Object> annotations = new LinkedHashMap<>();
    annotations.put("readOnlyHint", true);
    annotations.put("openWorldHint", false);
    listed.put("annotations", annotations);
    return listed;
  }

  /**
   * Returns the call that a request asks for.
   *
   * @throws RpcException if there is no such tool
   */
  Call call(Message message) throws RpcException {
    JsonValue name = message.params().get("name");
    Optional<Tool> tool =
        name == null || !name.isString()
            ? Optional.empty()
            : tools.stream().filter(t -> t.name().equals(name.text())).findFirst();
    if (tool.isEmpty()) {
      throw new RpcException(
          RpcException.INVALID_PARAMS,
          "params.name: expected one of "
              + String.join(", ", tools.stream().map(Tool::name).toList())
              + ", found "
              + (name == null ? "none" : name.found()));
    }
    JsonValue arguments = message.params().get("arguments");
    if (arguments != null && !arguments.isObject()) {
      throw new RpcException(
          RpcException.INVALID_PARAMS,
          "params.arguments: expected an object, found " + arguments.found());
    }
    return new Call(tool.get(), arguments == null ? Map.of() : Message.present(arguments));
  }
}
