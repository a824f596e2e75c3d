package io.github.lumbre.cli.mcp;

import io.github.lumbre.base.json.JsonValue;
import java.io.IOException;
import java.io.InputStream;
import java.time.Duration;
import java.util.List;
import java.util.Optional;

/**
 * Answers the messages of one client of the Model Context Protocol: a line each, JSON-RPC 2.0 in
 * UTF-8. Clients of the revision 2026-07-28 state the revision with each request; clients of
 * earlier revisions begin with {@code initialize}. Confined to the thread that serves; calls of
 * tools run in others.
 */
final class McpServer {
  private final Lines lines;
  private final Answers answers;
  private final Calls calls;
  private final Protocol protocol;
  private Runnable beforeCalls = () -> {};
  private final Duration most;

  /**
   * @param most time that a call may take
   */
  McpServer(InputStream in, Answers answers, List<Tool> tools, Duration most) {
    this.most = most;
    this.lines = new Lines(in, Message.MAX_BYTES);
    this.answers = answers;
    this.calls = new Calls(answers);
    this.protocol = new Protocol(tools);
  }

  /** Returns this server, which runs an action whenever a call comes. */
  McpServer beforeCalls(Runnable action) {
    beforeCalls = action;
    return this;
  }

  /**
   * Answers messages until the input ends or the client stops listening, and then waits for the
   * calls that run.
   *
   * @throws IOException if the input cannot be read
   */
  void serve() throws IOException {
    try (calls) {
      boolean hasMore = true;
      while (hasMore && !answers.isBroken()) {
        Optional<Lines.Line> line = lines.next();
        hasMore = line.isPresent();
        line.filter(read -> !read.isBlank()).ifPresent(this::answer);
      }
    }
  }

  private void answer(Lines.Line line) {
    try {
      if (!line.isWhole()) {
        throw new RpcException(
            RpcException.INVALID_REQUEST,
            "expected at most " + Message.MAX_BYTES + " bytes in a line, found more");
      }
      JsonValue value = Message.parse(line.bytes());
      if (value.isArray()) {
        Batch batch = new Batch(answers);
        Message.batch(value).forEach(message -> answer(message, batch.next()));
        batch.end();
      } else {
        answer(value, answers::write);
      }
    } catch (RpcException e) {
      answers.write(Answers.error(LineIdentity.of(line.bytes()), e));
    }
  }

  private void answer(JsonValue value, Receiver to) {
    try {
      Optional<Message> message = Message.of(value);
      if (message.isPresent() && message.get().id().isPresent()) {
        request(message.get(), to);
      } else {
        message.ifPresent(this::notified);
        to.cancelled();
      }
    } catch (RpcException e) {
      to.answered(Answers.error(Message.id(value), e));
    }
  }

  private void notified(Message message) {
    if (message.method().equals("notifications/cancelled")) {
      Optional.ofNullable(message.params().get("requestId"))
          .flatMap(Message::idOf)
          .ifPresent(calls::cancel);
    }
  }

  private void request(Message message, Receiver to) throws RpcException {
    Object id = message.id().orElseThrow();
    Protocol.Era era = protocol.era(message);
    if (message.method().equals("tools/call")) {
      Protocol.Call call = protocol.call(message);
      beforeCalls.run();
      calls.start(
          id,
          message.meta("progressToken").flatMap(Message::idOf),
          progress -> era.result(call.result(progress, most)),
          to);
    } else {
      to.answered(Answers.result(id, protocol.result(message, era)));
    }
  }
}
