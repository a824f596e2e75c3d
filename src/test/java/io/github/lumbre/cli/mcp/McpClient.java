package io.github.lumbre.cli.mcp;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.PipedInputStream;
import java.io.PipedOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;

/** A client of a server in a thread of this process: its messages are sent one after the other. */
public final class McpClient implements AutoCloseable {
  /** What each message states of its client, with single quotes instead of double ones. */
  public static final String META =
      "'_meta':{'io.modelcontextprotocol/protocolVersion':'2026-07-28',"
          + "'io.modelcontextprotocol/clientCapabilities':{}},";

  private final PipedOutputStream messages = new PipedOutputStream();
  private final LinkedBlockingQueue<String> answers = new LinkedBlockingQueue<>();
  private final Thread server;

  /** Serves one client. */
  public interface Server {
    void serve(InputStream in, OutputStream out) throws IOException;
  }

  /** Starts the server. */
  public McpClient(Server serve) throws IOException {
    PipedInputStream in = new PipedInputStream(messages, 1 << 16);
    OutputStream out =
        new OutputStream() {
          @Override
          public void write(int value) {
            throw new UnsupportedOperationException();
          }

          @Override
          public void write(byte[] bytes) {
            answers.add(new String(bytes, StandardCharsets.UTF_8));
          }
        };
    server =
        new Thread(
            () -> {
              try {
                serve.serve(in, out);
              } catch (IOException e) {
                answers.add(e.toString());
              }
            });
    server.start();
  }

  /** Sends a line. */
  public void send(String message) throws IOException {
    send(message.getBytes(StandardCharsets.UTF_8));
  }

  void send(byte[] message) throws IOException {
    messages.write(message);
    messages.flush();
  }

  /** Returns a call; single quotes stand for double ones. */
  public static String line(int id, String tool, String arguments) {
    return ("{'jsonrpc':'2.0','id':%d,'method':'tools/call','params':{%s'name':'%s',"
            + "'arguments':{%s}}}\n")
        .formatted(id, META, tool, arguments)
        .replace('\'', '"');
  }

  void send(int id, String tool, String arguments) throws IOException {
    send(line(id, tool, arguments));
  }

  JsonObject result(String tool, String arguments) throws IOException, InterruptedException {
    send(1, tool, arguments);
    JsonObject answer = next();
    assertThat(answer.has("result")).as(answer.toString()).isTrue();
    return answer.getAsJsonObject("result");
  }

  JsonObject numbers(String tool, String arguments) throws IOException, InterruptedException {
    JsonObject result = result(tool, arguments);
    assertThat(result.has("isError")).as(result.toString()).isFalse();
    return result.getAsJsonObject("structuredContent");
  }

  String failure(String tool, String arguments) throws IOException, InterruptedException {
    JsonObject result = result(tool, arguments);
    assertThat(result.has("isError")).as(result.toString()).isTrue();
    return result.getAsJsonArray("content").get(0).getAsJsonObject().get("text").getAsString();
  }

  /** Waits for the next answer. */
  public JsonObject next() throws InterruptedException {
    String answer = answers.poll(30, TimeUnit.SECONDS);
    assertThat(answer).as("an answer within 30 s").isNotNull();
    return JsonParser.parseString(answer).getAsJsonObject();
  }

  @Override
  public void close() throws IOException {
    messages.close();
    try {
      server.join(30_000);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    assertThat(server.isAlive()).isFalse();
  }
}
