package io.github.lumbre.scenefile;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import com.google.gson.JsonPrimitive;
import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.image.internal.CssColor;
import io.github.lumbre.scene.Setting;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collector;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The JSON schema of scene files, made of the declarations of their keys. In texts, ' is ". */
final class SceneSchema {
  private static final int WIDTH = 100;

  private static final String START =
      """
      {'$schema': 'https://json-schema.org/draft/2020-12/schema', 'title': 'Lumbre scene',
      'description': 'What docs/scene-format.md says, as far as a schema can say it.',
      'type': 'object',
      """;

  private static final String DEFINITIONS =
      """
      'id': {'type': ['integer', 'null'], 'minimum': -2147483648, 'maximum': 2147483647},
      'statedId': {'type': 'integer', 'minimum': -2147483648, 'maximum': 2147483647},
      'color': {'type': ['object', 'null'], 'description': 'Linear; a component is 1 if missing.',
        'properties': {
          'r': {'type': ['number', 'null'], 'minimum': 0, 'default': 1},
          'g': {'type': ['number', 'null'], 'minimum': 0, 'default': 1},
          'b': {'type': ['number', 'null'], 'minimum': 0, 'default': 1},
          'a': {'type': ['number', 'null'], 'description': 'Read and ignored.'}},
        'additionalProperties': false},
      'vector': {'type': ['object', 'null'],
        'properties': {
          'x': {'type': ['number', 'null']},
          'y': {'type': ['number', 'null']},
          'z': {'type': ['number', 'null']}},
        'additionalProperties': false},
      'screenColor': {'description': 'A color of CSS, which is opaque.',
        'anyOf': [
          {'type': 'string', 'pattern': '^#([0-9a-fA-F]{3}|[0-9a-fA-F]{6})$'},
          {'type': 'string',
            'pattern': '^color\\\\( *srgb-linear( *[0-9.]+([eE]-?[0-9]+)?){3} *\\\\)$'},
          {'enum': [@COLORS]}]}
      """;

  /** The options of models. */
  private SceneSchema() {}

  static String text() {
    List<Key<?>> settings =
        Setting.all().stream()
            .filter(Setting::isInScenes)
            .map(SettingsReader::key)
            .collect(Collectors.toList());
    settings.addAll(RootKeys.OF_OPTIONS);
    List<Key<?>> assets = ObjectKeys.OF_ASSETS;
    String colors = CssColor.known().stream().map(SceneSchema::quoted).collect(joined());
    String definitions =
        Stream.of(
                DEFINITIONS.replace("@COLORS", colors),
                "'gradient': {'type': 'object', "
                    + closed("", properties(RootKeys.OF_GRADIENTS))
                    + ", 'minProperties': 1}",
                "'renderOptions': {'type': ['object', 'null'], "
                    + closed("", properties(settings))
                    + "}",
                family("material", MaterialKinds.FAMILY),
                family("texture", TextureKinds.FAMILY),
                "'mesh': {"
                    + closed(known(assets), known(ObjectKeys.OF_MESHES))
                    + ", "
                    + content(ObjectKeys.BASE64_MESH)
                    + "}",
                "'asset': {'type': 'object', 'properties': {"
                    + properties(assets, ObjectKeys.ID, ObjectKeys.ASSET_TYPE)
                    + "}, 'required': ['id', 'assetType'], "
                    + choices(ObjectKeys.ASSET_TYPE, "Material", "Texture", "Mesh")
                    + "}",
                family("camera", CameraKinds.FAMILY),
                family("shape", ShapeKinds.FAMILY),
                family("light", LightKinds.FAMILY),
                "'model': {'required': ['file'], "
                    + closed(
                        known(ObjectKeys.OF_EMITTERS),
                        properties(ObjectKeys.OF_MODELS, ObjectKeys.FILE)
                            + ", "
                            + properties(ModelKeys.ALL))
                    + "}",
                "'none': {" + closed(known(ObjectKeys.ALL), "") + "}",
                "'object': {'type': 'object', 'properties': {"
                    + properties(ObjectKeys.OF_EMITTERS)
                    + "}, "
                    + choices(ObjectKeys.TYPE, "None", "Camera", "Shape", "Light", "Model")
                    + "}")
            .collect(joined());
    String properties = properties(RootKeys.ALL, RootKeys.MAIN_CAMERA);
    return printed(
            JsonParser.parseString(
                START
                    + closed("", properties)
                    + ", 'required': ['mainCameraId'], '$defs': {"
                    + definitions
                    + "}}"),
            "")
        + "\n";
  }

  private static Collector<CharSequence, ?, String> joined() {
    return Collectors.joining(", ");
  }

  private static String quoted(String text) {
    return new JsonPrimitive(text).toString();
  }

  /** Returns the definition of a family: its keys, and those of each kind with their values. */
  private static String family(String name, Family<?> family) {
    Key<String> type = family.typeKey();
    List<Key<?>> keys = new ArrayList<>();
    family.kinds().forEach(kind -> keys.addAll(kind.keys()));
    String names = family.names().stream().map(SceneSchema::quoted).collect(joined());
    String values =
        type.defaultValue()
            .map(missing -> "{'enum': [%s, null], 'default': '%s'}".formatted(names, missing))
            .orElse("{'enum': [" + names + "]}");
    String common = known(family.common()) + ", '" + type.name() + "': " + values;
    String required =
        type.defaultValue().isPresent() ? "" : ", 'required': ['" + type.name() + "']";
    String kinds =
        family.names().stream()
            .map(
                kind ->
                    when(
                        type.name(),
                        quoted(kind),
                        type.defaultValue().equals(Optional.of(kind)),
                        kinds(family, kind)))
            .collect(joined());
    return "'%s': {%s%s, 'allOf': [%s]}"
        .formatted(name, closed(common, known(keys)), required, kinds);
  }

  /** Returns the schema of the kinds of a name; those with a condition are for it alone. */
  private static String kinds(Family<?> family, String name) {
    return family.kinds().stream()
        .filter(kind -> kind.name().equals(name))
        .map(SceneSchema::kind)
        .collect(Collectors.joining(", ", "{'allOf': [", "]}"));
  }

  private static String kind(Kind<?, ?> kind) {
    if (kind.keys().contains(TextureKinds.BASE64)) {
      List<Key<?>> others = new ArrayList<>(kind.keys());
      others.removeAll(List.of(TextureKinds.BASE64, ObjectKeys.FILE));
      return "{'properties': {%s}, %s}"
          .formatted(properties(others), content(TextureKinds.BASE64));
    }
    String described = "{'properties': {" + properties(kind.keys()) + "}}";
    return kind.condition()
        .map(flag -> when(flag.name(), "true", false, described))
        .orElse(described);
  }

  /** Returns the rule that a file is named, or else that the content is stated. */
  private static String content(Key<String> base64) {
    return "'if': {'properties': {'file': {'type': 'null'}}}, 'then': {'properties': {"
        + properties(List.of(base64), base64)
        + "}, 'required': ['%s']}, 'else': {'properties': {'file': {'type': 'string'}}}"
            .formatted(base64.name());
  }

  /** Returns the rule that a value of a key, or its lack, demands a schema. */
  private static String when(String key, String value, boolean isMissing, String then) {
    return "{'if': {'properties': {'%s': {'enum': [%s]}}%s}, 'then': %s}"
        .formatted(
            key,
            isMissing ? value + ", null" : value,
            isMissing ? "" : ", 'required': ['" + key + "']",
            then);
  }

  private static String choices(Key<?> key, String... names) {
    return Stream.of(names)
        .map(
            name ->
                when(
                    key.name(),
                    quoted(name),
                    name.equals("None"),
                    "{'$ref': '#/$defs/" + name.toLowerCase(Locale.ROOT) + "'}"))
        .collect(Collectors.joining(", ", "'allOf': [", "]"));
  }

  private static String closed(String common, String own) {
    String separator = common.isEmpty() || own.isEmpty() ? "" : ", ";
    return "'properties': {" + common + separator + own + "}, 'additionalProperties': false";
  }

  /** Returns keys that may have any value here. */
  private static String known(Collection<Key<?>> keys) {
    return Key.names(keys).stream().map(name -> "'" + name + "': true").collect(joined());
  }

  private static String properties(Collection<Key<?>> keys, Key<?>... required) {
    return keys.stream()
        .map(key -> "'" + key.name() + "': " + described(key, List.of(required).contains(key)))
        .collect(joined());
  }

  private static <T> String described(Key<T> key, boolean isRequired) {
    String type = key.type().schema();
    if (isRequired) {
      type =
          type.replaceAll("\\['(\\w+)', 'null']", "'$1'")
              .replace(", null]", "]")
              .replace("/id'", "/statedId'");
    }
    JsonObject schema = JsonParser.parseString(type).getAsJsonObject();
    boolean isShown = !schema.has("$ref") && !schema.has("items");
    key.defaultValue()
        .filter(value -> isShown && !List.of("", Double.POSITIVE_INFINITY).contains(value))
        .map(value -> key.type().writer().apply(value))
        .filter(value -> !value.equals(new JsonPrimitive("")))
        .ifPresent(value -> schema.add("default", simple(value)));
    if (!key.meaning().isEmpty()) {
      schema.addProperty("description", key.meaning());
    }
    return schema.isEmpty() ? "true" : schema.toString();
  }

  private static JsonElement simple(JsonElement value) {
    boolean isNumber = value instanceof JsonPrimitive primitive && primitive.isNumber();
    return isNumber ? JsonParser.parseString(PrintableText.number(value.getAsDouble())) : value;
  }

  /** Returns the text of a value: in one line if that is short. */
  private static String printed(JsonElement value, String indent) {
    boolean isObject = value instanceof JsonObject;
    if (!isObject && !(value instanceof JsonArray)) {
      return value.toString();
    }
    List<String> parts = new ArrayList<>();
    if (isObject) {
      value
          .getAsJsonObject()
          .asMap()
          .forEach((key, v) -> parts.add('"' + key + "\": " + printed(v, indent + "  ")));
    } else {
      value.getAsJsonArray().forEach(each -> parts.add(printed(each, indent + "  ")));
    }
    String line = String.join(", ", parts);
    boolean isShort = !line.contains("\n") && indent.length() + line.length() < WIDTH;
    String inner = isShort ? line : "\n" + lines(parts, indent + "  ") + "\n" + indent;
    return isObject ? "{" + inner + "}" : "[" + inner + "]";
  }

  /** Returns parts below each other; short texts share lines. */
  private static String lines(List<String> parts, String indent) {
    StringBuilder lines = new StringBuilder(indent);
    int start = 0;
    for (int i = 0; i < parts.size(); i++) {
      String part = parts.get(i);
      boolean isText = i > 0 && part.startsWith("\"") && !part.contains(": ");
      if (i > 0 && isText && lines.length() - start + part.length() < WIDTH + 38) {
        lines.append(", ");
      } else if (i > 0) {
        lines.append(",\n");
        start = lines.length();
        lines.append(indent);
      }
      lines.append(part);
    }
    return lines.toString();
  }
}
