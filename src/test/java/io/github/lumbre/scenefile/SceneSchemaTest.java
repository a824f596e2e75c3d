package io.github.lumbre.scenefile;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import com.networknt.schema.InputFormat;
import com.networknt.schema.JsonSchema;
import com.networknt.schema.JsonSchemaFactory;
import com.networknt.schema.SpecVersion.VersionFlag;
import io.github.lumbre.testing.Effort;
import io.github.lumbre.testing.Folders;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The JSON schema, which editors use, is made of the declarations and agrees with the parser. To
 * write it anew: {@code ./mvnw test -Dtest=SceneSchemaTest -Dlumbre.write=true}.
 */
class SceneSchemaTest {
  private static final Path PAGE = Path.of("docs", "scene.schema.json");
  private static final String SCHEMA = SceneSchema.text();
  private static final JsonSchema VALIDATOR =
      JsonSchemaFactory.getInstance(VersionFlag.V202012).getSchema(SCHEMA);

  /** The placeholder of a tested value; no scene contains it. */
  private static final String HOLE = "@hole@";

  private static final List<String> PROBES =
      """
      null | true | "" | "None" | "auto" | "transparent" | "ray" | {} | [] | [1] | {"x": "1"}
      {"x": 1, "w": 1} | {"r": -1} | {"r": 1, "x": 1} | -2147483649 | -1e308 | -2 | -1
      -0.0 | 0 | 1e-320 | 0.5 | 1 | 1.0 | 2.5 | 16 | 17 | 89 | 180 | 360 | 361 | 1024 | 1025
      16384 | 16385 | 65535 | 65536 | 1000000 | 1000001 | 1073741824 | 1073741825 | 2147483647
      2147483648 | 9223372036854775807 | 9223372036854775808 | 1e150 | 1.1e150 | 1e308
      """
          .lines()
          .flatMap(line -> Stream.of(line.split(" [|] ")))
          .toList();

  /** Errors that a schema cannot express: references, files, and products of numbers. */
  private static final Pattern BEYOND_SCHEMAS =
      Pattern.compile(
          ": expected the id of a \\w+, found -?\\d|each id once|main camera's id once"
              + "|: expected base64, |: expected a file|relative path|: PNG |: expected a PNG"
              + "|: line \\d|: singular|within 1e150|infinite one|a mask with|width x height"
              + "|lookAt: expected a point other|the inverse of the matrix"
              + "|penumbra: expected a number from 0 to [-0-9.e]+, found \\d");

  @TempDir private Path folder;

  private static String text(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  static Stream<Path> scenes() throws IOException {
    return Folders.scenes().stream();
  }

  private static boolean isValid(String scene) {
    return VALIDATOR.validate(scene, InputFormat.JSON).isEmpty();
  }

  /** The parser's verdict on a scene, as far as a schema can express it. */
  private enum Verdict {
    SOUND,
    WRONG,
    /** Errors beyond schemas have prevented the parser from reporting others. */
    UNKNOWN
  }

  private Verdict verdict(String scene, String name) {
    try {
      SceneFile file = new SceneParser().parse(Files.writeString(folder.resolve(name), scene));
      boolean known = file.warnings().stream().noneMatch(w -> w.message().contains("unknown key"));
      return known ? Verdict.SOUND : Verdict.WRONG;
    } catch (SceneFormatException e) {
      boolean beyond =
          e.problems().stream().allMatch(p -> BEYOND_SCHEMAS.matcher(p.toString()).find());
      return beyond ? Verdict.UNKNOWN : Verdict.WRONG;
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  @ParameterizedTest
  @MethodSource("scenes")
  void scenesOfTheProjectAreValid(Path scene) {
    assertThat(VALIDATOR.validate(text(scene), InputFormat.JSON)).isEmpty();
  }

  /** The page is what the declarations of the keys say. */
  @Test
  void schemaIsGenerated() throws IOException {
    String expected = SceneSchema.text();
    if (Boolean.getBoolean("lumbre.write")) {
      Files.writeString(PAGE, expected);
    }
    assertThat(Files.readString(PAGE)).isEqualTo(expected);
  }

  /** Replaces values of scenes that cover all features by others: random ones in a quick build. */
  @Test
  void schemaAndParserAgreeOnRandomValues() throws IOException {
    Files.writeString(folder.resolve("inside.obj"), SceneFixture.TRIANGLE);
    Files.write(folder.resolve("inside.png"), SceneFixture.png(0xffffff));
    List<String> places = new ArrayList<>();
    Set<String> seen = new HashSet<>();
    for (String name : List.of("thin-lens", "pinhole", "fish-eye", "cylindrical", "orthographic")) {
      String scene = sound(name);
      assertThat(isValid(scene)).as(name).isTrue();
      assertThat(verdict(scene, "s.json")).as(name).isEqualTo(Verdict.SOUND);
      JsonObject tree = JsonParser.parseString(scene).getAsJsonObject();
      collect(tree, tree, "", seen, places);
    }
    List<String> disagreements = new ArrayList<>();
    int pairs = places.size() * PROBES.size();
    IntStream tries =
        Effort.isExhaustive() ? IntStream.range(0, pairs) : new Random(1).ints(500, 0, pairs);
    tries.forEach(
        i ->
            compare(
                places.get(i / PROBES.size()),
                PROBES.get(i % PROBES.size()),
                "s.json",
                disagreements));
    assertThat(disagreements).isEmpty();
  }

  private String sound(String name) throws IOException {
    String resource = "/io/github/lumbre/fuzz/" + name + ".json";
    try (InputStream in = getClass().getResourceAsStream(resource)) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  private void compare(String withHole, String probe, String file, List<String> disagreements) {
    String changed = withHole.replace('"' + HOLE + '"', probe);
    boolean valid = isValid(changed);
    if (verdict(changed, file) == (valid ? Verdict.WRONG : Verdict.SOUND)) {
      int at = withHole.indexOf(HOLE);
      disagreements.add(
          withHole.substring(Math.max(0, at - 60), at) + probe + (valid ? ": valid" : ": invalid"));
    }
  }

  private static void collect(
      JsonObject scene, JsonElement element, String path, Set<String> seen, List<String> all) {
    if (element instanceof JsonArray array) {
      for (int i = 0; i < array.size(); i++) {
        JsonElement old = array.get(i);
        if (seen.add(path + "[]")) {
          array.set(i, JsonParser.parseString('"' + HOLE + '"'));
          all.add(scene.toString());
          array.set(i, old);
        }
        collect(scene, old, path, seen, all);
      }
    } else if (element instanceof JsonObject object) {
      String type = path + kind(object);
      for (String key : List.copyOf(object.keySet())) {
        JsonElement old = object.get(key);
        if (seen.add(type + "." + key)) {
          object.addProperty(key, HOLE);
          all.add(scene.toString());
          object.add(key, old);
        }
        collect(scene, old, key.equals("children") ? "/objects" : type + "/" + key, seen, all);
      }
    }
  }

  private static String kind(JsonObject object) {
    return object.entrySet().stream()
        .filter(member -> member.getKey().matches("type|\\w+Type|finite"))
        .map(Map.Entry::getValue)
        .map(JsonElement::toString)
        .collect(Collectors.joining(","));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "{}",
        "[]",
        "{\"mainCameraId\": 1, \"objects\": [{\"type\": \"Camera\", \"id\": 1, \"fieldOfVeiw\":"
            + " 50}]}",
        "{\"mainCameraId\": 1, \"objects\": [{\"type\": \"Camera\", \"id\": 1, \"radius\": 5}]}",
        "{\"mainCameraId\": 1, \"objects\": [{\"type\": \"Camera\", \"id\": 1}], \"assets\": [{}]}",
        "{\"mainCameraId\": 1, \"objects\": [{\"type\": \"Camera\", \"id\": 1, \"children\":"
            + " [3]}]}",
        "{\"mainCameraId\": 1, \"objects\": [{\"type\": \"Camera\", \"id\": 1}, {\"intensity\":"
            + " 1}]}"
      })
  void whatTheParserComplainsOfIsNotValid(String scene) {
    assertThat(verdict(scene, "s.json")).isEqualTo(Verdict.WRONG);
    assertThat(isValid(scene)).isFalse();
  }

  @Test
  void scenesMayNameTheirSchema() {
    String scene =
        "{\"$schema\": \"scene.schema.json\", \"mainCameraId\": 1, \"objects\": [{\"type\":"
            + " \"Camera\", \"id\": 1}]}";
    assertThat(verdict(scene, "s.json")).isEqualTo(Verdict.SOUND);
    assertThat(isValid(scene)).isTrue();
  }
}
