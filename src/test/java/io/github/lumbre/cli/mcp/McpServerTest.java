package io.github.lumbre.cli.mcp;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import io.github.lumbre.testing.Effort;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class McpServerTest {
  private static final String META =
      "\"_meta\":{\"io.modelcontextprotocol/protocolVersion\":\"2026-07-28\","
          + "\"io.modelcontextprotocol/clientCapabilities\":{}}";

  private static final String START =
      "{\"jsonrpc\":\"2.0\",\"id\":0,\"method\":\"initialize\",\"params\":"
          + "{\"protocolVersion\":\"2025-11-25\",\"capabilities\":{},\"clientInfo\":{}}}\n";

  private static final Duration PATIENCE = Duration.ofSeconds(30);

  /** Says its text, fails, or waits until it is interrupted or released. */
  private static final class Echo implements Tool {
    static final Input<String> TEXT = Input.requiredText("text", "What to say.");
    static final Input<Integer> TIMES = Input.integer("times", 1, 3, 1, "How often.");

    final CountDownLatch started = new CountDownLatch(1);
    final CountDownLatch released = new CountDownLatch(1);
    final CountDownLatch interrupted = new CountDownLatch(1);

    @Override
    public String name() {
      return "echo";
    }

    @Override
    public String title() {
      return "Echo";
    }

    @Override
    public String description() {
      return "Says it again.";
    }

    @Override
    public List<Input<?>> inputs() {
      return List.of(TEXT, TIMES);
    }

    @Override
    public List<Output> outputs() {
      return List.of(Output.text("said", "What was said."));
    }

    @Override
    public Outcome call(Arguments arguments, CallProgress progress)
        throws ToolException, InterruptedException {
      String text = arguments.get(TEXT);
      switch (text) {
        case "fail" -> throw new ToolException("cannot be said");
        case "crash" -> throw new IllegalStateException("broken");
        case "fault" -> throw new AssertionError("impossible");
        case "memory" -> throw new OutOfMemoryError();
        case "overflow" -> throw new StackOverflowError();
        case "wait" -> {
          started.countDown();
          try {
            released.await();
          } catch (InterruptedException e) {
            interrupted.countDown();
            throw e;
          }
        }
        default -> progress.expect(1);
      }
      return new Outcome(
          List.of(new byte[] {1, 2, 3}), Map.of("said", text.repeat(arguments.get(TIMES))));
    }
  }

  private static List<JsonElement> answers(String messages) throws IOException {
    return answers(messages.getBytes(StandardCharsets.UTF_8), new Echo());
  }

  private static List<JsonElement> answers(byte[] messages, Echo echo) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    new McpServer(new ByteArrayInputStream(messages), new Answers(out), List.of(echo), PATIENCE)
        .serve();
    return out.toString(StandardCharsets.UTF_8).lines().map(JsonParser::parseString).toList();
  }

  private static JsonObject only(String message) throws IOException {
    List<JsonElement> answers = answers(message);
    assertThat(answers).hasSize(1);
    JsonObject answer = answers.get(0).getAsJsonObject();
    assertThat(answer.get("jsonrpc").getAsString()).isEqualTo("2.0");
    return answer;
  }

  private static String request(Object id, String method, String params) {
    return "{\"jsonrpc\":\"2.0\",\"id\":%s,\"method\":\"%s\",\"params\":{%s}}\n"
        .formatted(id, method, params);
  }

  private static String call(Object id, String arguments) {
    return request(id, "tools/call", META + ",\"name\":\"echo\",\"arguments\":{" + arguments + "}");
  }

  private static int code(JsonObject answer) {
    JsonObject error = answer.getAsJsonObject("error");
    // The order is the same in each process.
    assertThat(error.keySet()).startsWith("code", "message");
    return error.get("code").getAsInt();
  }

  @Test
  void newClientsNeedNoHandshake() throws IOException {
    JsonObject result = only(request(1, "server/discover", META)).getAsJsonObject("result");
    assertThat(result.get("resultType").getAsString()).isEqualTo("complete");
    assertThat(result.get("supportedVersions")).hasToString("[\"2026-07-28\"]");
    assertThat(result.getAsJsonObject("capabilities").has("tools")).isTrue();
    assertThat(result.get("ttlMs").getAsLong()).isPositive();
    assertThat(result.get("cacheScope").getAsString()).isEqualTo("public");
  }

  @ParameterizedTest
  @CsvSource({
    "2025-11-25, 2025-11-25",
    "2025-06-18, 2025-06-18",
    "2025-03-26, 2025-03-26",
    "2024-11-05, 2024-11-05",
    "1999-01-01, 2025-11-25",
    "2026-07-28, 2025-11-25"
  })
  void earlierRevisionsAreNegotiated(String asked, String answered) throws IOException {
    JsonObject result = only(START.replace("2025-11-25", asked)).getAsJsonObject("result");
    assertThat(result.get("protocolVersion").getAsString()).isEqualTo(answered);
    assertThat(result.getAsJsonObject("serverInfo").get("name").getAsString()).isEqualTo("lumbre");
    assertThat(result.has("resultType")).isFalse();
  }

  @Test
  void afterTheHandshakeRequestsNeedNoRevision() throws IOException {
    List<JsonElement> answers =
        answers(
            START
                + "{\"jsonrpc\":\"2.0\",\"method\":\"notifications/initialized\"}\n"
                + request(1, "ping", "")
                + request("\"two\"", "tools/list", ""));
    assertThat(answers).hasSize(3);
    assertThat(answers.get(1)).hasToString("{\"jsonrpc\":\"2.0\",\"id\":1,\"result\":{}}");
    JsonObject listed = answers.get(2).getAsJsonObject();
    assertThat(listed.get("id").getAsString()).isEqualTo("two");
    JsonObject tool =
        listed.getAsJsonObject("result").getAsJsonArray("tools").get(0).getAsJsonObject();
    assertThat(tool.getAsJsonObject("inputSchema"))
        .hasToString(
            "{\"type\":\"object\",\"properties\":{\"text\":{\"type\":\"string\",\"description\":\"What"
                + " to say.\"},\"times\":{\"type\":\"integer\",\"description\":\"How often.\","
                + "\"minimum\":1,\"maximum\":3,\"default\":1}},\"required\":[\"text\"],"
                + "\"additionalProperties\":false}");
    assertThat(tool.getAsJsonObject("outputSchema"))
        .hasToString(
            "{\"type\":\"object\",\"properties\":{\"said\":{\"type\":\"string\","
                + "\"description\":\"What was said.\"}},\"required\":[\"said\"]}");
    assertThat(tool.getAsJsonObject("annotations"))
        .hasToString("{\"readOnlyHint\":true,\"openWorldHint\":false}");
  }

  @Test
  void aCallReturnsPicturesAndNumbers() throws IOException {
    JsonObject result = only(call(1, "\"text\":\"ab\",\"times\":2")).getAsJsonObject("result");
    JsonArray content = result.getAsJsonArray("content");
    assertThat(content.get(0))
        .hasToString("{\"type\":\"image\",\"data\":\"AQID\",\"mimeType\":\"image/png\"}");
    assertThat(content.get(1).getAsJsonObject().get("text").getAsString())
        .isEqualTo("{\"said\":\"abab\"}");
    assertThat(result.get("structuredContent")).hasToString("{\"said\":\"abab\"}");
    assertThat(result.has("isError")).isFalse();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "'\"text\":\"fail\"' | cannot be said",
        "'\"text\":\"memory\"' | 'the server''s memory is exhausted; wait for other calls, and try"
            + " again'",
        "'' | 'text: expected a string of at most 4096 characters, found none'",
        "'\"text\":7' | 'text: expected a string of at most 4096 characters, found 7'",
        "'\"text\":\"a\",\"times\":4' | 'times: expected an integer from 1 to 3, found 4'",
        "'\"text\":\"a\",\"times\":1.5' | 'times: expected an integer from 1 to 3, found 1.5'",
        "'\"text\":\"a\",\"tims\":1' | '\"tims\": expected one of the arguments text, times; did"
            + " you mean times?'"
      })
  void faultsOfACallAreResults(String arguments, String message) throws IOException {
    JsonObject result = only(call(1, arguments)).getAsJsonObject("result");
    assertThat(result.get("isError").getAsBoolean()).isTrue();
    assertThat(result.getAsJsonArray("content").get(0).getAsJsonObject().get("text").getAsString())
        .isEqualTo(message);
  }

  @ParameterizedTest
  @ValueSource(strings = {"crash", "fault", "overflow"})
  void aCrashEndsItsOwnCallOnly(String text) throws IOException {
    List<JsonElement> answers =
        answers(call(1, "\"text\":\"" + text + "\"") + call(2, "\"text\":\"b\""));
    assertThat(answers).hasSize(2);
    for (JsonElement answer : answers) {
      JsonObject each = answer.getAsJsonObject();
      assertThat(each.has("error")).isEqualTo(each.get("id").getAsInt() == 1);
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "-32700 | {\"jsonrpc\":",
        "-32700 | {\"jsonrpc\":\"2.0\",\"jsonrpc\":\"2.0\",\"id\":1,\"method\":\"ping\"}",
        "-32600 | 7",
        "-32600 | []",
        "-32600 | {}",
        "-32600 | {\"jsonrpc\":\"1.0\",\"id\":1,\"method\":\"ping\"}",
        "-32600 | {\"jsonrpc\":\"2.0\",\"id\":null,\"method\":\"ping\"}",
        "-32600 | {\"jsonrpc\":\"2.0\",\"id\":1.5,\"method\":\"ping\"}",
        "-32600 | {\"jsonrpc\":\"2.0\",\"id\":1,\"method\":5}",
        "-32600 | {\"jsonrpc\":\"2.0\",\"id\":1,\"method\":\"ping\",\"params\":[]}",
        "-32602 | {\"jsonrpc\":\"2.0\",\"id\":1,\"method\":\"tools/list\"}",
        "-32602 | {\"jsonrpc\":\"2.0\",\"id\":1,\"method\":\"initialize\"}",
        "-32602 | {\"jsonrpc\":\"2.0\",\"id\":1,\"method\":\"tools/list\",\"params\":{\"_meta\":"
            + "{\"io.modelcontextprotocol/protocolVersion\":\"2026-07-28\"}}}",
        "-32022 | {\"jsonrpc\":\"2.0\",\"id\":1,\"method\":\"tools/list\",\"params\":{\"_meta\":"
            + "{\"io.modelcontextprotocol/protocolVersion\":\"2031-01-01\"}}}",
      })
  void wrongMessagesGetErrors(int code, String message) throws IOException {
    assertThat(code(only(message + "\n"))).isEqualTo(code);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "{\"jsonrpc\":\"2.0\",\"id\":1,\"method\":\"ping\",\"params\":null}",
        "{\"jsonrpc\":\"2.0\",\"id\":1,\"method\":\"tools/list\",\"params\":null}",
        "{\"jsonrpc\":\"2.0\",\"id\":1,\"method\":\"tools/list\","
            + "\"params\":{\"_meta\":null,\"cursor\":null}}",
        "{\"jsonrpc\":\"2.0\",\"id\":1,\"method\":\"tools/call\",\"params\":{\"name\":\"echo\","
            + "\"_meta\":{\"progressToken\":null},\"arguments\":{\"text\":\"a\",\"times\":null}}}"
      })
  void nullIsAbsent(String message) throws IOException {
    List<JsonElement> answers = answers(START + message + "\n");
    assertThat(answers.get(1).getAsJsonObject().has("result")).as(answers.get(1) + "").isTrue();
    assertThat(answers.get(1).toString()).doesNotContain("isError");
  }

  @Test
  void requiredArgumentsAreNotNull() throws IOException {
    for (String arguments : List.of("null", "{\"text\":null}")) {
      String line = call(1, "").replace("\"arguments\":{}", "\"arguments\":" + arguments);
      assertThat(only(line).toString()).contains("isError", "text: expected a string", "found none");
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "7 | {\"jsonrpc\":\"2.0\",\"id\":7,\"method\":\"ping\",}",
        "7 | {\"jsonrpc\":\"2.0\",\"id\":7,\"method\":\"pi",
        "7 | {\"method\":ping, \"params\":{\"id\":8}, \"id\" : 7, \"jsonrpc\":\"2.0\"}",
        "7 | {\"jsonrpc\":\"2.0\",\"id\":7,\"method\":\"ping\",\"params\":{\"a\":1e400}}",
        "7 | {\"jsonrpc\":\"2.0\",\"id\":7,\"id\":7,\"method\":\"ping\"}",
        "7 | {\"jsonrpc\":\"2.0\",\"id\":7,\"method\":\"ping\",\"method\":\"ping\"}",
        "\"a\\\"\\u0062\" | {\"jsonrpc\":\"2.0\",\"id\":\"a\\\"\\u0062\" \"method\":\"ping\"}",
        "null | {\"jsonrpc\":\"2.0\",\"id\":7,\"id\":8,\"method\":\"ping\"}",
        "null | {\"jsonrpc\":\"2.0\",\"id\":7",
        "null | {\"jsonrpc\":\"2.0\",\"id\":\"7",
        "null | {\"jsonrpc\":\"2.0\",\"id\":7.5,}",
        "null | {\"jsonrpc\":\"2.0\",\"params\":{\"id\":7},}",
        "null | {\"jsonrpc\":\"2.0\",\"method\":\"id\",\"a\":[\"id\",7],}",
        "null | [{\"jsonrpc\":\"2.0\",\"id\":7,}]",
        "null | not JSON",
        "null | 7"
      })
  void unreadableLinesGetTheirIdentityBack(String id, String message) throws IOException {
    JsonObject answer = only(message + "\n");
    assertThat(answer.has("error")).isTrue();
    assertThat(answer.has("id")).isTrue();
    assertThat(answer.get("id")).isEqualTo(JsonParser.parseString(id));
  }

  @Test
  void aLongLineGetsItsIdentityBack() throws IOException {
    String line = request(9, "ping", "\"a\":\"" + " ".repeat(Message.MAX_BYTES) + "\"");
    assertThat(only(line).get("id").getAsInt()).isEqualTo(9);
  }

  /** Bytes that are not UTF-8, and halves of characters, which JSON can escape. */
  @Test
  void brokenCharactersHarmNoIdentity() throws IOException {
    byte[] line = request(7, "ping", "\"a\":\"?\"").getBytes(StandardCharsets.UTF_8);
    for (int i = 0; i < line.length; i++) {
      line[i] = line[i] == '?' ? (byte) 0xff : line[i];
    }
    JsonObject answer = answers(line, new Echo()).get(0).getAsJsonObject();
    assertThat(code(answer)).isEqualTo(-32700);
    assertThat(answer.get("id").getAsInt()).isEqualTo(7);
    answer = only(request("\"\\ud83d\"", "ping", ""));
    assertThat(code(answer)).isEqualTo(-32700);
    assertThat(answer.get("id").isJsonNull()).isTrue();
  }

  @ParameterizedTest
  @ValueSource(strings = {"resources/list", "ping", "initialize", "", "tools/lists"})
  void unknownMethodsGetTheirError(String method) throws IOException {
    assertThat(code(only(request(1, method, META)))).isEqualTo(-32601);
  }

  @Test
  void anUnknownToolIsTheFaultOfTheRequest() throws IOException {
    JsonObject answer = only(request(1, "tools/call", META + ",\"name\":\"ech\""));
    assertThat(code(answer)).isEqualTo(-32602);
    assertThat(answer.getAsJsonObject("error").get("message").getAsString())
        .isEqualTo("params.name: expected one of echo, found \"ech\"");
  }

  @Test
  void responsesNotificationsAndBlankLinesGetNoAnswer() throws IOException {
    assertThat(
            answers(
                "{\"jsonrpc\":\"2.0\",\"id\":1,\"result\":{}}\n \r\n\n"
                    + "{\"jsonrpc\":\"2.0\",\"method\":\"notifications/unknown\"}\n"
                    + "{\"jsonrpc\":\"2.0\",\"method\":\"notifications/cancelled\","
                    + "\"params\":{\"requestId\":99}}\n"))
        .isEmpty();
  }

  @Test
  void aBatchIsAnsweredTogether() throws IOException {
    String batch =
        "["
            + call(1, "\"text\":\"a\"").strip()
            + ",{\"jsonrpc\":\"2.0\",\"method\":\"notifications/initialized\"},"
            + request(2, "ping", "").strip()
            + ",5]\n";
    List<JsonElement> answers = answers(batch);
    assertThat(answers).hasSize(1);
    assertThat(answers.get(0).getAsJsonArray()).hasSize(3);
  }

  @Test
  void aLongLineIsSkipped() throws IOException {
    String longLine = "[" + " ".repeat(Message.MAX_BYTES) + "]\n";
    List<JsonElement> answers = answers(longLine + request(1, "ping", ""));
    assertThat(code(answers.get(0).getAsJsonObject())).isEqualTo(-32600);
    assertThat(answers.get(1).getAsJsonObject().get("id").getAsInt()).isEqualTo(1);
  }

  private static McpClient client(Echo echo) throws IOException {
    return client(echo, PATIENCE);
  }

  private static McpClient client(Echo echo, Duration most) throws IOException {
    return new McpClient(
        (in, out) -> new McpServer(in, new Answers(out), List.of(echo), most).serve());
  }

  @Test
  void aCancelledCallStopsAndGetsNoAnswer() throws Exception {
    Echo echo = new Echo();
    try (McpClient client = client(echo)) {
      client.send(call(7, "\"text\":\"wait\""));
      assertThat(echo.started.await(30, TimeUnit.SECONDS)).isTrue();
      client.send(
          "{\"jsonrpc\":\"2.0\",\"method\":\"notifications/cancelled\","
              + "\"params\":{\"requestId\":7,\"reason\":\"late\"}}\n");
      assertThat(echo.interrupted.await(30, TimeUnit.SECONDS)).isTrue();
      client.send(call(7, "\"text\":\"again\""));
      JsonObject answer = client.next();
      assertThat(answer.get("id").getAsInt()).isEqualTo(7);
      assertThat(answer.getAsJsonObject("result").get("structuredContent"))
          .hasToString("{\"said\":\"again\"}");
    }
  }

  @Test
  void aCallEndsInTime() throws Exception {
    Echo echo = new Echo();
    try (McpClient client = client(echo, Duration.ofMillis(1))) {
      client.send(call(1, "\"text\":\"wait\""));
      JsonObject result = client.next().getAsJsonObject("result");
      assertThat(echo.interrupted.getCount()).isZero();
      assertThat(result.get("isError").getAsBoolean()).isTrue();
      assertThat(result.getAsJsonArray("content").toString())
          .contains("stopped after 0 s; ask for fewer pixels or samples");
      client.send(request(2, "ping", ""));
      assertThat(client.next().get("id").getAsInt()).isEqualTo(2);
    }
  }

  /** Nobody is there for the answers, so that calls need not end, and no input comes. */
  @Test
  void aClientThatIsGoneEndsCalls() throws Exception {
    Echo echo = new Echo();
    OutputStream gone =
        new OutputStream() {
          @Override
          public void write(int value) throws IOException {
            throw new IOException("Broken pipe");
          }
        };
    String messages = call(1, "\"text\":\"wait\"") + request(2, "ping", "");
    new McpServer(
            new ByteArrayInputStream(messages.getBytes(StandardCharsets.UTF_8)),
            new Answers(gone),
            List.of(echo),
            PATIENCE)
        .serve();
    assertThat(echo.interrupted.getCount()).isZero();
  }

  @ParameterizedTest
  @ValueSource(strings = {"{}", "null", "1.5", "[1]", "true", "\"\""})
  void progressTokensOfAnyTypeAreHarmless(String token) throws IOException {
    String request =
        call(1, "\"text\":\"a\"")
            .replace("\"_meta\":{", "\"_meta\":{\"progressToken\":" + token + ",");
    assertThat(only(request).has("result")).isTrue();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "{\"jsonrpc\":\"2.0\",\"id\":1e300,\"method\":\"ping\"}",
        "{\"jsonrpc\":\"2.0\",\"id\":99999999999999999999,\"method\":\"ping\"}",
        "{\"jsonrpc\":\"2.0\",\"id\":-1e-999999999,\"method\":\"ping\"}"
      })
  void hugeNumbersAreNoIdentities(String message) throws IOException {
    assertThat(code(only(message + "\n"))).isEqualTo(-32600);
  }

  @Test
  void longIdentitiesComeBack() throws IOException {
    String id = "\"" + "\\u001b".repeat(100_000) + "\"";
    assertThat(only(request(id, "ping", "")).get("id").getAsString()).hasSize(100_000);
  }

  @Test
  void deepJsonIsRefused() throws IOException {
    String deep = "[".repeat(500_000) + "]".repeat(500_000) + "\n";
    assertThat(code(only(deep))).isEqualTo(-32700);
    deep = "{\"a\":".repeat(100_000) + "1" + "}".repeat(100_000) + "\n";
    assertThat(code(only(deep))).isEqualTo(-32700);
  }

  @Test
  void aSlowCallHoldsUpNoOther() throws Exception {
    Echo echo = new Echo();
    try (McpClient client = client(echo)) {
      client.send(call(1, "\"text\":\"wait\""));
      assertThat(echo.started.await(30, TimeUnit.SECONDS)).isTrue();
      client.send(call(1, "\"text\":\"a\""));
      assertThat(code(client.next())).isEqualTo(-32600);
      client.send(call(2, "\"text\":\"b\""));
      assertThat(client.next().get("id").getAsInt()).isEqualTo(2);
      client.send(request(3, "tools/list", META));
      assertThat(client.next().get("id").getAsInt()).isEqualTo(3);
      echo.released.countDown();
      assertThat(client.next().get("id").getAsInt()).isEqualTo(1);
    }
  }

  @Test
  void callsThatWaitAreBounded() throws Exception {
    Echo echo = new Echo();
    try (McpClient client = client(echo)) {
      int most = Calls.RUNNING + Calls.WAITING;
      for (int i = 0; i < most; i++) {
        client.send(call(i, "\"text\":\"wait\""));
      }
      assertThat(echo.started.await(30, TimeUnit.SECONDS)).isTrue();
      client.send(call(most, "\"text\":\"a\""));
      JsonObject refused = client.next();
      assertThat(refused.get("id").getAsInt()).isEqualTo(most);
      assertThat(code(refused)).isEqualTo(-32603);
      echo.released.countDown();
      for (int i = 0; i < most; i++) {
        assertThat(client.next().has("result")).isTrue();
      }
    }
  }

  /** Each line is answered or ignored, and the server is alive afterwards. */
  @Test
  void changedMessagesEndNothing() throws IOException {
    Random random = new Random(Effort.seed(11));
    List<String> seeds =
        List.of(
            START,
            request(1, "server/discover", META),
            call(2, "\"text\":\"a\",\"times\":2"),
            "[" + request(3, "ping", "").strip() + "]\n",
            "{\"jsonrpc\":\"2.0\",\"method\":\"notifications/cancelled\","
                + "\"params\":{\"requestId\":7}}\n");
    ByteArrayOutputStream messages = new ByteArrayOutputStream();
    int count = Effort.count(2000, 100_000);
    for (int i = 0; i < count; i++) {
      byte[] line = seeds.get(random.nextInt(seeds.size())).getBytes(StandardCharsets.UTF_8);
      for (int n = 1 + random.nextInt(4); n > 0; n--) {
        int at = random.nextInt(line.length - 1);
        line[at] = (byte) (random.nextBoolean() ? line[at] ^ 1 << random.nextInt(8) : ' ');
      }
      messages.write(line);
    }
    messages.write("\n".getBytes(StandardCharsets.UTF_8));
    messages.write(request("\"last\"", "ping", "").getBytes(StandardCharsets.UTF_8));
    List<JsonElement> answers = answers(messages.toByteArray(), new Echo());
    assertThat(answers).hasSizeGreaterThan(count / 2);
    assertThat(answers)
        .filteredOn(JsonElement::isJsonObject)
        .anyMatch(answer -> answer.getAsJsonObject().toString().contains("\"id\":\"last\""));
  }
}
