package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import io.github.lumbre.cli.output.ExitCodes;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Tests the server as clients start it: a process, its streams and its end. */
@Timeout(120)
class McpIT {
  private static final String META =
      "'_meta':{'io.modelcontextprotocol/protocolVersion':'2026-07-28',"
          + "'io.modelcontextprotocol/clientCapabilities':{}}";

  @TempDir private Path directory;
  private Process server;
  private OutputStream messages;
  private BufferedReader answers;

  @BeforeEach
  void start() throws IOException {
    ModelSample.write(directory);
    server =
        new ProcessBuilder(Program.lumbre("mcp", "--root", "" + directory))
            .redirectError(directory.resolve("err.txt").toFile())
            .start();
    messages = server.getOutputStream();
    answers =
        new BufferedReader(new InputStreamReader(server.getInputStream(), StandardCharsets.UTF_8));
  }

  @AfterEach
  void kill() {
    server.destroyForcibly();
  }

  /** Sends a line; single quotes stand for double ones. */
  private void send(String line) throws IOException {
    messages.write((line + "\n").replace('\'', '"').getBytes(StandardCharsets.UTF_8));
    messages.flush();
  }

  private void request(int id, String method, String params) throws IOException {
    send("{'jsonrpc':'2.0','id':%d,'method':'%s','params':{%s}}".formatted(id, method, params));
  }

  private static String views(String more) {
    return more + "'name':'views','arguments':{'model':'sample.glb','width':16,'height':16}";
  }

  private JsonObject next() throws IOException {
    JsonObject answer = JsonParser.parseString(answers.readLine()).getAsJsonObject();
    assertThat(answer.get("jsonrpc").getAsString()).isEqualTo("2.0");
    return answer;
  }

  private JsonObject result(int id) throws IOException {
    JsonObject answer = next();
    assertThat(answer.get("id").getAsInt()).as(answer.toString()).isEqualTo(id);
    return answer.getAsJsonObject("result");
  }

  private void assertEnds() throws IOException, InterruptedException {
    assertThat(server.waitFor(30, TimeUnit.SECONDS)).isTrue();
    assertThat(server.exitValue()).isEqualTo(ExitCodes.OK);
    assertThat(Files.readString(directory.resolve("err.txt"))).isEmpty();
  }

  @Test
  void aClientWithAHandshakeCancelsACall() throws IOException, InterruptedException {
    request(0, "initialize", "'protocolVersion':'2025-06-18','capabilities':{},'clientInfo':{}");
    assertThat(result(0).get("protocolVersion").getAsString()).isEqualTo("2025-06-18");
    send("{'jsonrpc':'2.0','method':'notifications/initialized'}");
    request(1, "tools/list", "");
    assertThat(result(1).getAsJsonArray("tools")).hasSize(7);
    request(2, "tools/call", views(""));
    assertThat(result(2).getAsJsonArray("content").toString()).contains("image/png");
    request(
        3,
        "tools/call",
        "'_meta':{'progressToken':'p'},'name':'render','arguments':"
            + "{'model':'sample.glb','width':1024,'height':1024,'samples':64}");
    assertThat(next().get("method").getAsString()).isEqualTo("notifications/progress");
    send("{'jsonrpc':'2.0','method':'notifications/cancelled','params':{'requestId':3}}");
    request(4, "ping", "");
    JsonObject answer = next();
    while (answer.has("method")) {
      answer = next();
    }
    assertThat(answer.get("id").getAsInt()).isEqualTo(4);
    messages.close();
    assertThat(answers.readLine()).isNull();
    assertEnds();
  }

  @Test
  void aClientWithoutAHandshakeEndsItsInputWhileACallRuns()
      throws IOException, InterruptedException {
    request(1, "server/discover", META);
    assertThat(result(1).get("supportedVersions")).hasToString("[\"2026-07-28\"]");
    request(2, "tools/list", META);
    assertThat(result(2).getAsJsonArray("tools")).hasSize(7);
    request(3, "tools/call", views(META + ","));
    messages.close();
    assertThat(result(3).getAsJsonArray("content").toString()).contains("image/png");
    assertThat(answers.readLine()).isNull();
    assertEnds();
  }

  /** More answers than pipes hold: the server waits, and nothing is lost. */
  @Test
  void aClientThatReadsLateGetsAllAnswers() throws IOException, InterruptedException {
    List<Integer> sent = new ArrayList<>();
    List<Integer> answered = new ArrayList<>();
    for (int id = 0; id < 250; id++) {
      sent.add(id);
      request(id, "tools/list", META);
    }
    messages.close();
    Thread.sleep(500);
    for (String line = answers.readLine(); line != null; line = answers.readLine()) {
      answered.add(JsonParser.parseString(line).getAsJsonObject().get("id").getAsInt());
    }
    assertThat(answered).isEqualTo(sent);
    assertEnds();
  }

  /** The input does not end. */
  @Test
  @DisabledOnOs(OS.WINDOWS)
  void aClientThatReadsNoMoreEndsTheServer() throws IOException, InterruptedException {
    request(1, "tools/list", META);
    answers.read();
    answers.close();
    request(2, "tools/list", META);
    assertEnds();
  }
}
