package io.github.lumbre.scenefile;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import io.github.lumbre.base.json.JsonTree;
import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.math.internal.Range;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the parsing of JSON and its limits. */
class JsonTreeTest {
  private final Problems problems = new Problems("s.json");

  private JsonNode read(String text) throws SceneFormatException {
    return JsonNode.read(text.getBytes(StandardCharsets.UTF_8), problems, Limits.NONE);
  }

  private SceneFormatException refusal(String text) {
    return catchThrowableOfType(SceneFormatException.class, () -> read(text));
  }

  @Test
  void valuesKnowTheirPaths() throws SceneFormatException {
    JsonNode root = read("{\"objects\": [{}, {\"radius\": {\"x\": 1}}]}");
    JsonNode second = root.objects("objects").get(1);
    assertThat(root.path()).isEqualTo("$");
    assertThat(second.path()).isEqualTo("$.objects[1]");
    assertThat(second.object("radius").orElseThrow().path()).isEqualTo("$.objects[1].radius");
  }

  @Test
  void byteOrderMarkIsTolerated() throws SceneFormatException {
    JsonNode node = read("\ufeff{\"a\": 2.5}");
    assertThat(Key.number("a", Range.ANY, 0, "").in(node)).isEqualTo(2.5);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "{\"a\": 1,}",
        "{\"a\": [1, 2,]}",
        "{\"a\": NaN}",
        "{\"a\": -Infinity}",
        "{\"a\": 01}",
        "{\"a\": +1}",
        "{\"a\": .5}",
        "{\"a\": 1.}",
        "{\"a\": 0x10}",
        "{\"a\": 'b'}",
        "{a: 1}",
        "{\"a\": b}",
        "{\"a\" = 1}",
        "{\"a\": 1; \"b\": 2}",
        "{\"a\": True}",
        "{\"a\": NULL}",
        "{\"a\": 1} // comment",
        "{/* comment */}",
        "# comment\n{}",
        "{\"a\": \"\\'\"}",
        "{\"a\": \"\\u12g4\"}",
        "{\"a\": \"line\nbreak\"}",
        "{} {}",
        "{}]",
        ")]}'\n{}"
      })
  void whatIsNotJsonIsRefused(String text) {
    assertThat(refusal(text).kind()).isEqualTo(SceneFormatException.Kind.INVALID);
    assertThat(refusal(text)).hasMessageContaining("expected JSON (RFC 8259), found ");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "{'a': 1,}|a comma after the last element at line 1, column 10",
        "{'a': [1, 2, ]}|a comma after the last element at line 1, column 15",
        "`{'ä': 1,\n\n }`|a comma after the last element at line 3, column 3",
        "`// x\n{}`|a comment, which JSON does not have, at line 1, column 2",
        "{/* x */}|a comment, which JSON does not have, at line 1, column 3",
        "`{\n# x\n}`|a comment, which JSON does not have, at line 2, column 2",
        "{'a': Infinity}|Infinity without double quotes at line 1, column 7",
        "{'a': -Infinity}|-Infinity without double quotes at line 1, column 7",
        "{'a': True}|True without double quotes at line 1, column 7",
        "{a: 1}|a without double quotes at line 1, column 3",
        "{'a' 1}|no colon after a key at line 1, column 7",
        "{'a': 1 'b': 2}|no comma between two elements at line 1, column 10",
        "[1 2]|no comma between two elements at line 1, column 5",
        "{'a': 01}|a syntax error at line 1, column 7",
        "{'a': =}|a syntax error at line 1, column 7"
      })
  void frequentMistakesAreNamed(String text, String found) {
    assertThat(refusal(text.replace('\'', '"')))
        .hasMessageEndingWith("expected JSON (RFC 8259), found " + found);
  }

  @Test
  void openStringIsNamed() {
    assertThat(refusal("{\"a\": \"b"))
        .hasMessageContaining("s.json: $.a: expected JSON (RFC 8259), found a string without its");
  }

  @Test
  void singleQuotesAreNamed() {
    for (String text : new String[] {"{'a': 1}", "{\"a\": 'b'}"}) {
      assertThat(refusal(text)).hasMessageContaining("single quotes instead of double quotes");
    }
  }

  @Test
  void syntaxErrorsSayWhere() {
    assertThat(refusal("{\n \"a\": 1,\n \"b\": NaN\n}"))
        .hasMessage(
            "s.json: $.b: expected JSON (RFC 8259), found NaN without double quotes at line 3,"
                + " column 7");
    assertThat(refusal("{\"camera\": {"))
        .hasMessageContaining("s.json: $.camera: expected more JSON, found the end of the file");
  }

  @ParameterizedTest
  @ValueSource(strings = {"{\"a\": [1, ", "{\"a\"", "[", "{"})
  void textsThatEndEarlyAreRefused(String text) {
    assertThat(refusal(text)).hasMessageContaining("found the end of the file");
  }

  @ParameterizedTest
  @ValueSource(strings = {"", " \n\t ", "\ufeff"})
  void emptyFilesAreNamed(String text) {
    assertThat(refusal(text)).hasMessage("s.json: expected an object, found an empty file");
  }

  @Test
  void bytesThatAreNotUtf8AreRefused() {
    byte[] bytes = "{\"a\": \"?\"}".getBytes(StandardCharsets.UTF_8);
    bytes[7] = (byte) 0xff;
    assertThat(
            catchThrowableOfType(
                SceneFormatException.class, () -> JsonNode.read(bytes, problems, Limits.NONE)))
        .hasMessage("s.json: expected UTF-8, found invalid bytes");
  }

  @Test
  void duplicateKeysNameBothLines() throws SceneFormatException {
    JsonNode root = read("{\"o\": {\n\"a\": 1,\n\"b\": {\"a\": 2},\n\n\"a\": 3}}");
    assertThat(problems.exception())
        .hasMessage("s.json: $.o.a: expected each key once, found it on line 2 and on line 5");
    JsonNode object = root.object("o").orElseThrow();
    assertThat(Key.number("a", Range.ANY, 0, "").in(object)).isEqualTo(1);
  }

  @Test
  void numbersThatOverflowAreErrorsWhereverTheyStand() throws SceneFormatException {
    read("{\"whatever\": [0, -1e400]}");
    assertThat(problems.exception())
        .hasMessage("s.json: $.whatever[1]: expected a finite number, found -1e400");
  }

  @Test
  void manyLevelsAreFineAndTooManyAreRefusedAtOnce() throws SceneFormatException {
    int most = JsonNode.MAX_LEVELS;
    read("[".repeat(most) + "]".repeat(most));
    assertThat(problems.hasErrors()).isFalse();
    SceneFormatException refusal = refusal("[".repeat(1_000_000));
    assertThat(refusal.kind()).isEqualTo(SceneFormatException.Kind.LIMIT);
    assertThat(refusal)
        .hasMessageEndingWith("expected at most 4096 nested JSON values, found more");
    assertThat(refusal.getMessage()).hasSizeLessThan(1000);
  }

  @Test
  void moreTokensThanFitIntoTheHeapAreRefused() throws SceneFormatException {
    byte[] nineTokens = "{\"a\": [1, 2], \"b\": 3}".getBytes(StandardCharsets.UTF_8);
    assertThat(JsonNode.read(nineTokens, problems, 9).isObject()).isTrue();
    SceneFormatException refusal =
        catchThrowableOfType(
            SceneFormatException.class, () -> JsonNode.read(nineTokens, problems, 8));
    assertThat(refusal.kind()).isEqualTo(SceneFormatException.Kind.LIMIT);
    assertThat(refusal.problems())
        .map(Object::toString)
        .containsExactly("s.json: expected at most 8 JSON tokens in this heap, found more");
    assertThat(JsonTree.maxTokens(160_000)).isEqualTo(1000);
    assertThat(JsonTree.maxTokens(Long.MAX_VALUE)).isEqualTo(100_000_000);
  }

  @Test
  void longStringsAreRead() throws SceneFormatException {
    String text = "A".repeat(25_000_000);
    JsonNode node = read("{\"a\": \"" + text + "\"}");
    assertThat(node.find("a").flatMap(JsonNode::string).orElseThrow()).hasSameSizeAs(text);
  }
}
