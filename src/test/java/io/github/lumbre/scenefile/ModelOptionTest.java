package io.github.lumbre.scenefile;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.cli.mcp.Mcp;
import io.github.lumbre.cli.mcp.McpClient;
import io.github.lumbre.cli.option.ModelFlags;
import io.github.lumbre.cli.option.SettingFlags;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Range;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.ModelOptions.Pose;
import io.github.lumbre.model.internal.OptionTypes.FoldersType;
import io.github.lumbre.model.internal.OptionTypes.NamedType;
import io.github.lumbre.model.internal.OptionTypes.PoseType;
import io.github.lumbre.model.internal.OptionTypes.TextsType;
import io.github.lumbre.scene.SettingType;
import io.github.lumbre.scene.internal.SettingTypes.FlagType;
import io.github.lumbre.scene.internal.SettingTypes.NumberType;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.Stage.View;
import io.github.lumbre.stage.StagedModel;
import io.github.lumbre.stage.internal.StageTypes.PointType;
import java.lang.reflect.Modifier;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.ParameterException;

/** Options are the same on the command line, in Java, in scenes and in calls of tools. */
class ModelOptionTest {
  private static final String OBJ = "v 0 0 0\nv 1 0 0\nv 0 1 0\ng a\nf 1 2 3\n";
  private static final int ROUNDS = 300;

  /** What a camera of the file leaves no choice for. */
  private static final Set<ModelOption<?>> FRAMING =
      Set.of(Stage.VIEW, Stage.EYE, Stage.FIT, Stage.PARALLEL, Stage.PERSPECTIVE);

  @TempDir private static Path directory;

  /** A command with the flags of models. */
  @Command(modelTransformer = SettingFlags.Adder.class)
  private static final class Staged {
    @Mixin private ModelFlags model;
  }

  private static Stage stage(List<String> flags) {
    Staged staged = new Staged();
    new CommandLine(staged).parseArgs(flags.toArray(String[]::new));
    return staged.model.stage();
  }

  static List<ModelOption<?>> checkedOptions() {
    return Stage.all().stream().filter(option -> !wrong(option.type()).isEmpty()).toList();
  }

  @Test
  void allConstantsAreListed() {
    assertThat(
            Stream.of(Stage.class, ModelOption.class)
                .flatMap(type -> Arrays.stream(type.getFields()))
                .filter(field -> Modifier.isStatic(field.getModifiers()))
                .filter(field -> field.getType() == ModelOption.class))
        .hasSameSizeAs(Stage.all());
    assertThat(Stage.all().stream().map(ModelOption::flag).filter(flag -> !flag.isEmpty()))
        .doesNotHaveDuplicates();
  }

  /** Flags, the stage, the text of the scene around a model and the options in it agree. */
  @Test
  void randomOptionsSurviveFlagsAndScenes() throws Exception {
    Random random = new Random(6201);
    for (int i = 0; i < ROUNDS; i++) {
      Map<ModelOption<?>, Object> values = new LinkedHashMap<>();
      Stage.all().stream()
          .filter(option -> !option.flag().isEmpty() && random.nextBoolean())
          .forEach(option -> values.put(option, value(option.type(), random)));
      keepSuiting(values);
      Stage expected = Stage.DEFAULT;
      List<String> flags = new ArrayList<>();
      for (ModelOption<?> option : values.keySet()) {
        expected = with(option, values, expected);
        addFlags(option, values, flags);
      }
      Stage stage = stage(flags);
      assertThat(stage).as("%s", flags).isEqualTo(expected).hasSameHashCodeAs(expected);
      JsonObject object = new JsonObject();
      ModelKeys.write(stage.options(), object);
      ModelOptions kept = stage.options().with(ModelOption.ASSETS, List.of());
      assertThat(read(object)).as("%s", object).isEqualTo(kept);
    }
  }

  private static ModelOptions read(JsonObject object) throws SceneFormatException {
    byte[] text = object.toString().getBytes(StandardCharsets.UTF_8);
    Problems problems = new Problems("a.json");
    ModelOptions options = ModelKeys.read(JsonNode.read(text, problems, Limits.NONE));
    problems.throwIfAny();
    return options;
  }

  @SuppressWarnings("unchecked") // The value was drawn for the option.
  private static <T> Stage with(
      ModelOption<T> option, Map<ModelOption<?>, Object> values, Stage stage) {
    return stage.with(option, (T) values.get(option));
  }

  /** Leaves out what flags refuse beside others. */
  private static void keepSuiting(Map<ModelOption<?>, Object> values) {
    if (values.containsKey(Stage.CAMERA)) {
      values.keySet().removeAll(FRAMING);
    }
    if (values.containsKey(Stage.EYE)) {
      values.remove(Stage.VIEW);
    } else {
      values.remove(Stage.TARGET);
    }
    if (values.containsKey(Stage.PARALLEL)) {
      values.keySet().removeAll(List.of(Stage.PERSPECTIVE, Stage.FOV));
    }
    if (values.containsKey(Stage.SUN)) {
      values.put(Stage.SKY, "sun");
    }
    String look = (String) values.getOrDefault(Stage.LOOK, "");
    if (!look.contains("lines")) {
      values.keySet().removeAll(List.of(Stage.LINE_WIDTH, Stage.CREASE, Stage.HIDDEN));
    }
    if (values.containsKey(Stage.SCALE)) {
      values.remove(Stage.ZOOM);
    }
    if (look.equals("lines")) {
      values.remove(Stage.GROUND);
    }
  }

  @SuppressWarnings("unchecked") // The value was drawn for the option.
  private static <T> void addFlags(
      ModelOption<T> option, Map<ModelOption<?>, Object> values, List<String> flags) {
    T value = (T) values.get(option);
    boolean isRepeated =
        option.type() instanceof FoldersType
            || option.type() instanceof TextsType texts && texts.separator().isEmpty();
    if (value.equals(List.of())) {
      return;
    }
    if (isRepeated) {
      ((List<?>) value)
          .forEach(each -> flags.addAll(List.of(option.flag(), String.valueOf(each))));
    } else if (option.label().isEmpty()) {
      flags.add(option.flag());
    } else {
      flags.add(option.flag() + "=" + option.type().format(value));
    }
  }

  private static Object value(SettingType<?> type, Random random) {
    if (type instanceof NumberType numbers) {
      Range range = numbers.range();
      double number = random.nextInt(1000) / 8.;
      return range.contains(number) ? number : Math.max(range.low(), range.high() / 2);
    }
    if (type instanceof FlagType) {
      return true;
    }
    if (type instanceof NamedType<?> named) {
      return any(List.copyOf(named.choices().values()), random);
    }
    if (type instanceof PointType) {
      return new Vec3(random.nextGaussian(), random.nextInt(9), -1e20 * random.nextDouble());
    }
    if (type instanceof FoldersType) {
      return List.of(directory, directory.resolve(".").normalize());
    }
    if (type instanceof PoseType) {
      return new Pose(any(List.of("walk", "a@b", "0"), random), random.nextDouble());
    }
    if (type instanceof TextsType texts) {
      List<String> known =
          List.of("x=0.5", "-z=2%", "1,2,3/0,1,0", "axes", "scale", "all", "a, b", "piece 1", "*");
      return known.stream()
          .filter(text -> random.nextBoolean() && texts.accepts(List.of(text)))
          .toList();
    }
    String[] texts = {"front", "-40.25,15", "0,90", "transparent", "#123456", "lines", "1:2", "a4", "é b"};
    List<Object> fitting = new ArrayList<>();
    for (String text : texts) {
      parsed(type, text).ifPresent(fitting::add);
    }
    return any(fitting, random);
  }

  private static <T> T any(List<T> values, Random random) {
    return values.get(random.nextInt(values.size()));
  }

  private static Optional<Object> parsed(SettingType<?> type, String text) {
    try {
      return Optional.of(type.parse(text));
    } catch (IllegalArgumentException e) {
      return Optional.empty();
    }
  }

  /** The camera, light, floor and background of the scene's text are those of the stage. */
  @Test
  void randomStagesSurviveTheTextOfTheirScene() throws Exception {
    Random random = new Random(6202);
    for (int i = 0; i < 60; i++) {
      Stage stage = Stage.DEFAULT;
      Map<ModelOption<?>, Object> values = new LinkedHashMap<>();
      for (ModelOption<?> option :
          List.of(
              Stage.VIEW,
              Stage.PARALLEL,
              Stage.PERSPECTIVE,
              Stage.FOV,
              Stage.SUN,
              Stage.SKY_INTENSITY,
              Stage.SKY_ROTATION,
              Stage.GROUND,
              Stage.BACKGROUND,
              Stage.LOOK,
              Stage.LINE_WIDTH,
              Stage.CREASE)) {
        values.put(option, value(option.type(), random));
      }
      values.put(Stage.GROUND, random.nextBoolean());
      if (random.nextBoolean()) {
        values.remove(Stage.PARALLEL);
      }
      if (random.nextBoolean()) {
        values.keySet().removeAll(List.of(Stage.PERSPECTIVE, Stage.FOV));
      }
      values.put(Stage.SKY, any(List.of("studio", "white", "sun"), random));
      keepSuiting(values);
      for (ModelOption<?> option : values.keySet()) {
        stage = with(option, values, stage);
      }
      Stage shown = stageOf(text(stage));
      View view = stage.get(Stage.VIEW);
      assertThat(shown.get(Stage.VIEW))
          .isEqualTo(new View(view.azimuth(), view.elevation(), false, stage.isParallel()));
      if (!stage.isParallel()) {
        assertThat(shown.get(Stage.FOV)).isEqualTo(stage.find(Stage.FOV).orElse(35.));
      }
      assertThat(shown.sky()).isEqualTo(stage.sky());
      assertThat(shown.get(Stage.GROUND)).isEqualTo(stage.get(Stage.GROUND));
      assertThat(shown.background()).isEqualTo(stage.background());
      assertThat(shown.transparent()).isEqualTo(stage.transparent());
      assertThat(shown.lineWidth()).isEqualTo(stage.lineWidth());
      assertThat(shown.get(Stage.CREASE)).isEqualTo(stage.get(Stage.CREASE));
      assertThat(shown.options()).isEqualTo(stage.options());
    }
  }

  private static JsonObject text(Stage stage) throws Exception {
    byte[] model = OBJ.getBytes(StandardCharsets.US_ASCII);
    SceneParser parser =
        new SceneParser().overriding(settings -> settings.toBuilder().size(8, 8).build());
    SceneFile file =
        StagedModel.read("a.obj", model, ModelFolder.NONE, stage, parser).scene();
    byte[] text = file.text().orElseThrow().json();
    return JsonParser.parseString(new String(text, StandardCharsets.UTF_8)).getAsJsonObject();
  }

  /** Returns the stage that the text of a scene describes. */
  private static Stage stageOf(JsonObject scene) throws SceneFormatException {
    Stage stage = Stage.DEFAULT;
    JsonObject settings = scene.getAsJsonObject("renderOptions");
    if (settings.has("background") || settings.has("backplate")) {
      String key = settings.has("background") ? "background" : "backplate";
      stage = stage.with(Stage.BACKGROUND, settings.get(key).getAsString());
    }
    if (settings.has("lineWidth")) {
      stage = stage.with(Stage.LINE_WIDTH, settings.get("lineWidth").getAsDouble());
    }
    if (settings.has("creaseAngle")) {
      stage = stage.with(Stage.CREASE, settings.get("creaseAngle").getAsDouble());
    }
    for (JsonElement element : scene.getAsJsonArray("objects")) {
      JsonObject object = element.getAsJsonObject();
      switch (object.get("type").getAsString()) {
        case "Camera" -> {
          JsonObject turned = object.getAsJsonObject("localRotation");
          boolean isParallel = object.get("cameraType").getAsString().equals("Orthographic");
          View view = new View(0 - number(turned, "y"), number(turned, "x"), false, isParallel);
          stage = stage.seenFrom(view);
          stage = isParallel ? stage : stage.with(Stage.FOV, number(object, "fieldOfView"));
        }
        case "Light" -> stage = stage.under(sky(object));
        case "Shape" -> stage = stage.with(Stage.GROUND, true);
        default -> stage = stage.reading(read(object(object)));
      }
    }
    return stage;
  }

  private static JsonObject object(JsonObject model) {
    JsonObject options = model.deepCopy();
    options.keySet().retainAll(Key.names(ModelKeys.ALL));
    return options;
  }

  private static Stage.Sky sky(JsonObject light) {
    String name = light.has("sky") ? light.get("sky").getAsString() : "white";
    boolean hasSun = light.has("sunAzimuth");
    return new Stage.Sky(
        hasSun ? "sun" : name,
        number(light, "intensity"),
        number(light.getAsJsonObject("localRotation"), "y"),
        hasSun
            ? new View(number(light, "sunAzimuth"), number(light, "sunElevation"))
            : new Stage.Sky(name).sun());
  }

  private static double number(JsonObject object, String key) {
    return object.get(key).getAsDouble();
  }

  /** Returns JSON values that a type refuses; none if it accepts all of them. */
  private static List<String> wrong(SettingType<?> type) {
    if (type instanceof NumberType numbers) {
      Range range = numbers.range();
      List<String> wrong = new ArrayList<>();
      Stream.of(range.low(), range.high())
          .flatMap(bound -> Stream.of(bound - 1, bound, bound + 1, 2 * bound))
          .filter(number -> Double.isFinite(number) && !range.contains(number))
          .forEach(number -> wrong.add(String.valueOf(number)));
      return wrong;
    }
    if (type instanceof FlagType) {
      return List.of();
    }
    if (type instanceof PoseType) {
      return List.of("\"walk@-1\"");
    }
    if (type == Stage.SUN.type()) {
      return List.of("\"0,-5\"");
    }
    return parsed(type, "nonsense").isPresent() ? List.of() : List.of("\"nonsense\"");
  }

  @ParameterizedTest
  @MethodSource("checkedOptions")
  void allWaysRefuseTheSameValues(ModelOption<?> option) throws Exception {
    for (String wrong : wrong(option.type())) {
      String text = wrong.replace("\"", "");
      String expected = "expected " + range(option.type());
      if (!option.flag().isEmpty()) {
        assertThatThrownBy(() -> stage(List.of(option.flag() + "=" + text)))
            .isInstanceOf(ParameterException.class)
            .hasMessageStartingWith(option.flag() + ": " + expected);
      }
      if (option.type() instanceof NumberType || option.type() instanceof TextsType) {
        assertThatThrownBy(() -> refused(option, text))
            .isInstanceOf(IllegalArgumentException.class)
            .hasMessageStartingWith(option.name() + ": " + expected);
      }
      if (option.isInScenes()) {
        assertThatThrownBy(() -> read(scene(option, wrong))).hasMessageContaining(inScenes(option));
      }
      if (!option.tool().isEmpty() && option.toolValue().isEmpty()) {
        assertThat(answer(option, wrong)).contains(option.tool() + ": " + expected);
      }
    }
  }

  private static String range(SettingType<?> type) {
    return type instanceof PoseType ? PoseType.SECONDS.expected() : type.expected();
  }

  private static String inScenes(ModelOption<?> option) {
    return option.type() instanceof NamedType<?> named
        ? "expected one of " + String.join(", ", named.names())
        : "expected " + range(option.type());
  }

  @SuppressWarnings("unchecked") // The value has the type of the option.
  private static <T> void refused(ModelOption<T> option, String text) {
    Object value = option.type() instanceof NumberType ? Double.valueOf(text) : List.of(text);
    Stage.DEFAULT.with(option, (T) value);
  }

  private static JsonObject scene(ModelOption<?> option, String value) {
    boolean isList = option.type() instanceof TextsType;
    JsonObject object = new JsonObject();
    if (option.type() instanceof PoseType) {
      object.addProperty("seconds", -1);
    }
    JsonElement element = JsonParser.parseString(isList ? "[" + value + "]" : value);
    object.add(option.name(), element);
    return object;
  }

  private static String answer(ModelOption<?> option, String value) throws Exception {
    Files.writeString(directory.resolve("a.obj"), OBJ);
    boolean isList = option.type() instanceof TextsType;
    String tool = option == ModelOption.SECTION ? "section" : "render";
    String arguments =
        "'model':'a.obj','%s':%s".formatted(option.tool(), isList ? "[" + value + "]" : value);
    try (McpClient client = new McpClient((in, to) -> Mcp.serve(List.of(directory), in, to))) {
      client.send(McpClient.line(1, tool, arguments));
      return client.next().toString();
    }
  }
}
