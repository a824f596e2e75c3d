package io.github.lumbre.scenefile;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Range;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests typed access to JSON values and its error messages. */
class JsonNodeTest {
  private final Problems problems = new Problems("s.json");

  private JsonNode root(String text) {
    try {
      return JsonNode.read(text.getBytes(StandardCharsets.UTF_8), problems, Limits.NONE);
    } catch (SceneFormatException e) {
      throw new AssertionError(e);
    }
  }

  private List<String> errors(String text, Consumer<JsonNode> reading) {
    reading.accept(root(text));
    return problems.exception().problems().stream().map(Object::toString).toList();
  }

  @Test
  void nullMeansMissing() {
    JsonNode node = root("{\"a\": null, \"b\": null}");
    assertThat(Key.number("a", Range.ANY, 7, "").in(node)).isEqualTo(7);
    assertThat(Key.vector("b", Vec3.X, "").in(node)).isEqualTo(Vec3.X);
    assertThat(problems.hasErrors()).isFalse();
  }

  @ParameterizedTest
  @CsvSource(
      quoteCharacter = '`',
      value = {
        "-1, -1",
        "0, 0",
        "-0.0, -0.0",
        "\"2\", \"2\"",
        "true, true",
        "{}, an object",
        "[1], an array",
      })
  void numbersMustBeNumbersInRange(String written, String shown) {
    assertThat(errors("{\"r\": " + written + "}", n -> Key.number("r", Range.SIZE, 1, "").in(n)))
        .containsExactly("s.json: $.r: expected a finite number > 0, found " + shown);
  }

  @Test
  void numbersThatAreTooLargeAreTold() {
    assertThat(errors("{\"r\": 1e151}", n -> Key.number("r", Range.SIZE, 1, "").in(n)))
        .containsExactly("s.json: $.r: expected a number <= 1e150, found 1e151");
  }

  @ParameterizedTest
  @ValueSource(strings = {"8", "8.0", "0.8e1", "80e-1"})
  void integersMayBeWrittenInAnyWay(String written) {
    Key<Integer> key = Key.integer("n", 1, 10, 1, "");
    assertThat(key.in(root("{\"n\": " + written + "}"))).isEqualTo(8);
    assertThat(problems.hasErrors()).isFalse();
  }

  @ParameterizedTest
  @ValueSource(strings = {"8.5", "0", "11", "1e300", "1e-300", "\"8\"", "99999999999999999999"})
  void integersMustBeIntegersInRange(String written) {
    assertThat(errors("{\"n\": " + written + "}", n -> Key.integer("n", 1, 10, 1, "").in(n)))
        .containsExactly("s.json: $.n: expected an integer from 1 to 10, found " + written);
  }

  @Test
  void quotedBooleansAreErrors() {
    assertThat(errors("{\"f\": \"true\"}", n -> Key.flag("f", false, "").in(n)))
        .containsExactly("s.json: $.f: expected true or false, found \"true\"");
  }

  @Test
  void wrongNamesAreAnsweredWithTheRightOnes() {
    assertThat(
            errors(
                "{\"m\": \"Ray\"}",
                n -> n.find("m").orElseThrow().choice(new TreeMap<>(Map.of("ray", 1, "path", 2)))))
        .containsExactly("s.json: $.m: expected one of path, ray, found \"Ray\"");
  }

  @Test
  void missingComponentsHaveDefaults() {
    JsonNode node = root("{\"v\": {\"y\": 2}, \"c\": {\"g\": 0.5, \"a\": 0}}");
    assertThat(Key.vector("v", new Vec3(1, 1, 1), "").in(node)).isEqualTo(new Vec3(1, 2, 1));
    assertThat(Key.color("c", "").in(node)).isEqualTo(new Rgb(1, .5, 1));
    assertThat(Key.color("d", "").in(node)).isEqualTo(Rgb.WHITE);
  }

  @Test
  void colorsAreNotNegative() {
    assertThat(errors("{\"c\": {\"g\": -0.5}}", n -> Key.color("c", "").in(n)))
        .containsExactly("s.json: $.c.g: expected a finite number >= 0, found -0.5");
  }

  @Test
  void elementsOfArraysMustBeObjects() {
    assertThat(
            errors(
                "{\"a\": [{}, 3], \"b\": {}}",
                n -> {
                  assertThat(n.objects("a")).hasSize(1);
                  assertThat(n.objects("b")).isEmpty();
                }))
        .containsExactly(
            "s.json: $.a[1]: expected an object, found 3",
            "s.json: $.b: expected an array, found an object");
  }

  @Test
  void unknownKeysAreWarnedOfWithTheNearestKnown() {
    root("{\"materialId\": 1, \"raduis\": 2, \"zzz\": 3, \"width\": 4}")
        .warnUnknown(Set.of("materialID", "radius", "width"));
    assertThat(problems.warnings())
        .map(Object::toString)
        .containsExactly(
            "s.json: $.materialId: unknown key; did you mean materialID?",
            "s.json: $.raduis: unknown key; did you mean radius?",
            "s.json: $.zzz: unknown key");
  }

  @Test
  void textsFromTheFileCannotControlATerminal() {
    root("{\"\\u001b[2J\\u202e\": 1}").warnUnknown(Set.of());
    assertThat(problems.warnings())
        .map(Object::toString)
        .containsExactly("s.json: $.\\u001b[2J\\u202e: unknown key");
  }

  @Test
  void noMoreThanTwentyErrorsAreTold() {
    String objects = "{\"x\": \"a\"},".repeat(30) + "{}";
    assertThat(
            errors(
                "{\"o\": [" + objects + "]}",
                n -> n.objects("o").forEach(o -> Key.number("x", Range.ANY, 0, "").in(o))))
        .hasSize(20);
  }

  @Test
  void warningsAreLimitedToo() {
    JsonNode node = root("{}");
    for (int i = 0; i < 1500; i++) {
      node.warn("key", "w" + i);
    }
    assertThat(problems.warnings())
        .map(Object::toString)
        .hasSize(1001)
        .endsWith("s.json: and 500 more warnings");
  }
}
