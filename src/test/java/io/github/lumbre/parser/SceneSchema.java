package io.github.lumbre.parser;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonNull;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import com.google.gson.JsonPrimitive;
import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.internal.CssColor;
import io.github.lumbre.math.internal.Range;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scene.internal.SettingTypes.ChoiceType;
import io.github.lumbre.scene.internal.SettingTypes.FlagType;
import io.github.lumbre.scene.internal.SettingTypes.IntegerType;
import io.github.lumbre.scene.internal.SettingTypes.LongType;
import io.github.lumbre.scene.internal.SettingTypes.NumberType;
import io.github.lumbre.scene.internal.SettingTypes.PowerType;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;

/** The JSON schema of scene files, made of the declarations of their keys. */
final class SceneSchema {
  private static final int WIDTH = 100;

  private static final String HEAD =
      """
      {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "Lumbre scene",
        "description": "What docs/scene-format.md says, as far as a schema can say it.",
        "type": "object",
        "properties": {
          "renderOptions": {"$ref": "#/$defs/renderOptions"},
          "assets": {"type": ["array", "null"], "items": {"$ref": "#/$defs/asset"}},
          "objects": {"type": ["array", "null"], "items": {"$ref": "#/$defs/object"}}
        },
        "required": ["mainCameraId"],
        "additionalProperties": false,
        "$defs": {
          "id": {"type": ["integer", "null"], "minimum": -2147483648, "maximum": 2147483647},
          "color": {
            "type": ["object", "null"],
            "description": "Linear; a component is 1 if missing.",
            "properties": {
              "r": {"type": ["number", "null"], "minimum": 0, "default": 1},
              "g": {"type": ["number", "null"], "minimum": 0, "default": 1},
              "b": {"type": ["number", "null"], "minimum": 0, "default": 1},
              "a": {"type": ["number", "null"], "description": "Read and ignored."}
            },
            "additionalProperties": false
          },
          "vector": {
            "type": ["object", "null"],
            "properties": {
              "x": {"type": ["number", "null"]},
              "y": {"type": ["number", "null"]},
              "z": {"type": ["number", "null"]}
            },
            "additionalProperties": false
          },
          "screenColor": {
            "description": "A color of CSS, which is opaque.",
            "anyOf": [
              {"type": "string", "pattern": "^#([0-9a-fA-F]{3}|[0-9a-fA-F]{6})$"},
              {"type": "string", "pattern": "^color\\\\( *srgb-linear( *[0-9.]+([eE]-?[0-9]+)?){3} *\\\\)$"}
            ]
          }
        }
      }
      """;

  /** The options of models. */
  private static final String MODEL =
      """
      {
        "up": {"enum": ["y", "z", null],
          "description": "The axis of the file that points up (as its format states; y in \
      OBJ, PLY, STL and OFF)."},
        "unit": {"type": ["number", "null"], "exclusiveMinimum": 0,
          "description": "Scene units in a unit of the file (as the file states in meters; 1 \
      for OBJ, PLY, STL and OFF)."},
        "section": {"type": ["array", "null"], "items": {"type": "string"},
          "description": "Planes that cut the model, such as x=0.5, y=50%, -z=2 or \
      0,0,1/1,1,0: a point and a normal."},
        "pointRadius": {"type": ["number", "null"], "exclusiveMinimum": 0,
          "description": "Radius of points in units of the file; half the median distance \
      between them if missing."},
        "pose": {"type": ["string", "null"],
          "description": "Name or index of an animation of a glTF file."},
        "seconds": {"type": ["number", "null"], "minimum": 0, "default": 0,
          "description": "Time in the animation."},
        "variant": {"type": ["string", "null"],
          "description": "Name of a material variant of a glTF file."},
        "hide": {"type": ["array", "null"], "items": {"type": "string"},
          "description": "Names of parts to leave out; * stands for any text."},
        "highlight": {"type": ["array", "null"], "items": {"type": "string"},
          "description": "Names of parts beside which all others are pale; * stands for any \
      text."},
        "look": {"enum": ["clay", "white", null],
          "description": "A material that replaces all: matte gray, or white without light."}
      }
      """;

  private final JsonObject root = JsonParser.parseString(HEAD).getAsJsonObject();
  private final JsonObject definitions = root.getAsJsonObject("$defs");

  private SceneSchema() {}

  static String text() {
    SceneSchema schema = new SceneSchema();
    schema.define();
    return printed(schema.root, "") + "\n";
  }

  private void define() {
    JsonObject top = root.getAsJsonObject("properties");
    properties(SceneKeys.ALL).asMap().forEach((key, value) -> top.asMap().putIfAbsent(key, value));
    require(root, SceneKeys.MAIN_CAMERA);
    JsonArray names = new JsonArray();
    CssColor.known().forEach(names::add);
    definitions.getAsJsonObject("screenColor").getAsJsonArray("anyOf").add(object("enum", names));
    definitions.add("renderOptions", options());
    add("material", MaterialKinds.FAMILY);
    add("texture", TextureKinds.FAMILY);
    JsonObject mesh = closed(ObjectKeys.OF_ASSETS, ObjectKeys.OF_MESHES);
    definitions.add("mesh", content(mesh, ObjectKeys.BASE64_MESH));
    JsonObject asset = object("type", new JsonPrimitive("object"));
    asset.add("properties", properties(ObjectKeys.OF_ASSETS));
    require(asset, ObjectKeys.ID);
    require(asset, ObjectKeys.ASSET_TYPE);
    asset.add("allOf", choices(ObjectKeys.ASSET_TYPE, List.of("Material", "Texture", "Mesh")));
    definitions.add("asset", asset);
    add("camera", CameraKinds.FAMILY);
    add("shape", ShapeKinds.FAMILY);
    add("light", LightKinds.FAMILY);
    JsonObject model = closed(ObjectKeys.OF_EMITTERS, ObjectKeys.OF_MODELS);
    JsonObject ofModel = JsonParser.parseString(MODEL).getAsJsonObject();
    ofModel.asMap().forEach(model.getAsJsonObject("properties")::add);
    require(model, ObjectKeys.FILE);
    JsonObject materials = model.getAsJsonObject("properties").getAsJsonObject("materials");
    materials.add("type", array("object", "null"));
    materials.add("additionalProperties", object("$ref", new JsonPrimitive("#/$defs/id")));
    definitions.add("model", model);
    definitions.add("none", closed(ObjectKeys.ALL, List.of()));
    JsonObject object = object("type", new JsonPrimitive("object"));
    object.add("properties", properties(ObjectKeys.OF_EMITTERS));
    object.getAsJsonObject("properties").add("children", top.get("objects"));
    object.add(
        "allOf",
        choices(ObjectKeys.TYPE, List.of("None", "Camera", "Shape", "Light", "Model")));
    definitions.add("object", object);
  }

  private static void require(JsonObject schema, Key<?> key) {
    JsonObject of = schema.getAsJsonObject("properties").getAsJsonObject(key.name());
    if (of.has("$ref")) {
      of.remove("$ref");
      integer(of, Integer.MIN_VALUE, Integer.MAX_VALUE);
    }
    if (of.has("type")) {
      of.add("type", of.getAsJsonArray("type").get(0));
    } else {
      of.getAsJsonArray("enum").remove(JsonNull.INSTANCE);
    }
    JsonArray required = schema.has("required") ? schema.getAsJsonArray("required") : array();
    if (!required.contains(new JsonPrimitive(key.name()))) {
      required.add(key.name());
    }
    schema.add("required", required);
  }

  /** Adds the definition of a family: its keys, and those of each kind with their values. */
  private void add(String name, Family<?> family) {
    Key<String> typeKey = family.typeKey();
    List<Key<?>> all = new ArrayList<>();
    family.kinds().forEach(kind -> all.addAll(kind.keys()));
    JsonObject schema = closed(family.common(), List.of());
    JsonObject known = schema.getAsJsonObject("properties");
    JsonObject types = object("enum", array(family.names().toArray(String[]::new)));
    known.add(typeKey.name(), types);
    if (typeKey.missing().isEmpty()) {
      schema.add("required", array(typeKey.name()));
    } else {
      types.getAsJsonArray("enum").add(JsonNull.INSTANCE);
      types.addProperty("default", typeKey.missing().get());
    }
    all.forEach(key -> known.add(key.name(), new JsonPrimitive(true)));
    JsonArray kinds = new JsonArray();
    for (String kind : family.names()) {
      JsonObject then = new JsonObject();
      family.kinds().stream()
          .filter(each -> each.name().equals(kind))
          .forEach(each -> describe(each, then));
      boolean isMissing = typeKey.missing().equals(Optional.of(kind));
      kinds.add(when(typeKey.name(), new JsonPrimitive(kind), isMissing, then));
    }
    schema.add("allOf", kinds);
    definitions.add(name, schema);
  }

  private static void describe(Kind<?, ?> kind, JsonObject out) {
    JsonObject described = object("properties", properties(kind.keys()));
    if (kind.condition().isPresent()) {
      JsonPrimitive isTrue = new JsonPrimitive(true);
      out.add("allOf", new JsonArray());
      out.getAsJsonArray("allOf")
          .add(when(kind.condition().get().name(), isTrue, false, described));
    } else if (kind.keys().contains(TextureKinds.BASE64)) {
      content(described, TextureKinds.BASE64).asMap().forEach(out::add);
    } else if (out.has("properties")) {
      properties(kind.keys()).asMap().forEach(out.getAsJsonObject("properties")::add);
    } else if (!kind.keys().isEmpty()) {
      described.asMap().forEach(out::add);
    }
  }

  /** Adds that a file is named, or else that the content is stated; returns the schema. */
  private static JsonObject content(JsonObject schema, Key<String> base64) {
    JsonObject properties = schema.getAsJsonObject("properties");
    properties.add(base64.name(), new JsonPrimitive(true));
    properties.add(ObjectKeys.FILE.name(), new JsonPrimitive(true));
    JsonObject file = object("properties", properties(List.of(ObjectKeys.FILE)));
    JsonObject text = object("properties", properties(List.of(base64, ObjectKeys.FILE)));
    require(file, ObjectKeys.FILE);
    require(text, base64);
    text.getAsJsonObject("properties")
        .add(ObjectKeys.FILE.name(), object("type", new JsonPrimitive("null")));
    JsonArray either = new JsonArray();
    either.add(file);
    either.add(text);
    schema.add("anyOf", either);
    return schema;
  }

  /** Returns the rule that a value of a key, or its lack, demands a schema. */
  private static JsonObject when(
      String key, JsonPrimitive value, boolean isMissing, JsonObject then) {
    JsonArray values = new JsonArray();
    values.add(value);
    if (isMissing) {
      values.add(JsonNull.INSTANCE);
    }
    JsonObject condition = object("properties", object(key, object("enum", values)));
    if (!isMissing) {
      condition.add("required", array(key));
    }
    JsonObject rule = object("if", condition);
    rule.add("then", then);
    return rule;
  }

  private static JsonArray choices(Key<?> key, List<String> names) {
    JsonArray all = new JsonArray();
    for (String name : names) {
      String definition = "#/$defs/" + name.toLowerCase(Locale.ROOT);
      boolean isMissing = name.equals("None");
      JsonObject then = object("$ref", new JsonPrimitive(definition));
      all.add(when(key.name(), new JsonPrimitive(name), isMissing, then));
    }
    return all;
  }

  /** Returns an object that has no other keys; those of all kinds may have any value here. */
  private static JsonObject closed(List<Key<?>> common, List<Key<?>> own) {
    JsonObject properties = new JsonObject();
    common.forEach(key -> properties.add(key.name(), new JsonPrimitive(true)));
    properties(own).asMap().forEach(properties::add);
    JsonObject schema = object("properties", properties);
    schema.addProperty("additionalProperties", false);
    return schema;
  }

  private static JsonObject properties(Collection<? extends Key<?>> keys) {
    JsonObject all = new JsonObject();
    keys.forEach(key -> all.add(key.name(), described(key)));
    return all;
  }

  private static <T> JsonElement described(Key<T> key) {
    JsonObject schema = described(key.type());
    if (schema.isEmpty() && key.meaning().isEmpty()) {
      return new JsonPrimitive(true);
    }
    boolean isShown = !schema.has("$ref") && !schema.has("items");
    key.missing()
        .filter(value -> isShown && !value.equals("") && !value.equals(Double.POSITIVE_INFINITY))
        .ifPresent(value -> schema.add("default", simple(key.type().write(value))));
    if (!key.meaning().isEmpty()) {
      schema.addProperty("description", key.meaning());
    }
    return schema;
  }

  private static JsonObject described(Value<?> type) {
    JsonObject schema = new JsonObject();
    if (type instanceof Value.Numbers numbers) {
      number(schema, numbers.range());
    } else if (type instanceof Value.Integers integers) {
      integer(schema, integers.low(), integers.high());
    } else if (type instanceof Value.Longs) {
      integer(schema, Long.MIN_VALUE, Long.MAX_VALUE);
    } else if (type instanceof Value.Ids) {
      schema.addProperty("$ref", "#/$defs/id");
    } else if (type instanceof Value.Flags) {
      schema.add("type", array("boolean", "null"));
    } else if (type instanceof Value.Choices<?> choices) {
      schema.add("enum", orNull(choices.choices().keySet()));
    } else if (type instanceof Value.Texts texts) {
      schema.add("type", array("string", "null"));
      if (!texts.pattern().isEmpty()) {
        schema.addProperty("pattern", texts.pattern());
      }
    } else if (type instanceof Value.Colors) {
      schema.addProperty("$ref", "#/$defs/color");
    } else if (type instanceof Value.Vectors || type instanceof Value.Points) {
      schema.addProperty("$ref", "#/$defs/vector");
    } else if (type instanceof Value.Lists lists) {
      schema.add("type", array("array", "null"));
      schema.add("items", object("type", new JsonPrimitive("number")));
      JsonArray lengths = new JsonArray();
      lists.lengths().forEach(length -> lengths.add(ofLength(length)));
      schema.add("anyOf", lengths);
    }
    return schema;
  }

  private static JsonObject ofLength(int length) {
    JsonObject schema = object("minItems", new JsonPrimitive(length));
    schema.addProperty("maxItems", length);
    return schema;
  }

  private static void integer(JsonObject schema, long low, long high) {
    schema.add("type", array("integer", "null"));
    schema.addProperty("minimum", low);
    schema.addProperty("maximum", high);
  }

  /** Adds a range as its function accepts numbers: bounds may be excluded, and 0 may be alone. */
  private static void number(JsonObject schema, Range range) {
    schema.add("type", array("number", "null"));
    JsonObject limits = new JsonObject();
    if (range.low() > -Double.MAX_VALUE) {
      boolean isClosed = range.contains(range.low());
      limits.add(isClosed ? "minimum" : "exclusiveMinimum", number(range.low()));
    }
    if (range.high() < Double.MAX_VALUE) {
      boolean isClosed = range.contains(range.high());
      limits.add(isClosed ? "maximum" : "exclusiveMaximum", number(range.high()));
    }
    JsonObject zero = object("const", new JsonPrimitive(0));
    if (range.contains(0) && range.low() > 0) {
      JsonArray either = new JsonArray();
      either.add(zero);
      either.add(limits);
      schema.add("anyOf", either);
      return;
    }
    limits.asMap().forEach(schema::add);
    if (!range.contains(0) && range.low() < 0 && range.high() > 0) {
      schema.add("not", zero);
    }
  }

  private static JsonObject options() {
    JsonObject schema = closed(List.of(), SceneKeys.OF_OPTIONS);
    JsonObject properties = schema.getAsJsonObject("properties");
    Setting.all().stream()
        .filter(Setting::isInScenes)
        .forEach(setting -> properties.add(setting.name(), described(setting)));
    JsonObject background = properties.getAsJsonObject(SceneKeys.BACKGROUND.name());
    either(background, "color", object("const", new JsonPrimitive(SettingsReader.TRANSPARENT)));
    JsonObject screen = object("$ref", new JsonPrimitive("#/$defs/screenColor"));
    either(properties.getAsJsonObject(Setting.BACKPLATE.name()), "color", screen);
    schema.add("type", array("object", "null"));
    return schema;
  }

  private static void either(JsonObject schema, String definition, JsonObject other) {
    JsonArray both = new JsonArray();
    both.add(object("$ref", new JsonPrimitive("#/$defs/" + definition)));
    both.add(other);
    schema.add("anyOf", both);
  }

  private static <T> JsonObject described(Setting<T> setting) {
    JsonObject schema = new JsonObject();
    T missing = setting.missing();
    if (setting.type() instanceof IntegerType integers) {
      integer(schema, integers.low(), integers.high());
    } else if (setting.type() instanceof LongType) {
      integer(schema, Long.MIN_VALUE, Long.MAX_VALUE);
    } else if (setting.type() instanceof NumberType numbers) {
      number(schema, Range.closed(numbers.low(), numbers.high()));
    } else if (setting.type() instanceof FlagType) {
      schema.add("type", array("boolean", "null"));
    } else if (setting.type() instanceof ChoiceType<?> choices) {
      schema.add("enum", orNull(choices.choices().keySet()));
    } else if (setting.type() instanceof PowerType powers) {
      JsonArray all = new JsonArray();
      for (int power = 1; power <= powers.high(); power *= 2) {
        all.add(power);
      }
      all.add(JsonNull.INSTANCE);
      schema.add("enum", all);
    } else if (missing instanceof Exposure) {
      schema.add("type", array("number", "string", "null"));
      schema.addProperty("pattern", "^auto$");
    }
    if (missing instanceof Number number) {
      schema.add("default", number(number.doubleValue()));
    } else if (!(missing instanceof Optional)) {
      schema.addProperty("default", setting.type().format(missing));
    }
    schema.addProperty("description", setting.meaning());
    return schema;
  }

  private static JsonArray orNull(Set<String> names) {
    JsonArray all = array(names.toArray(String[]::new));
    all.add(JsonNull.INSTANCE);
    return all;
  }

  private static JsonArray array(String... texts) {
    JsonArray array = new JsonArray();
    List.of(texts).forEach(array::add);
    return array;
  }

  private static JsonObject object(String key, JsonElement value) {
    JsonObject object = new JsonObject();
    object.add(key, value);
    return object;
  }

  private static JsonElement simple(JsonElement value) {
    boolean isNumber = value instanceof JsonPrimitive primitive && primitive.isNumber();
    return isNumber ? number(value.getAsDouble()) : value;
  }

  private static JsonPrimitive number(double x) {
    return x == Math.rint(x) && Math.abs(x) < 1e15
        ? new JsonPrimitive((long) x)
        : new JsonPrimitive(x);
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
