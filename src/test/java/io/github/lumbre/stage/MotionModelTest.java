package io.github.lumbre.stage;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.geometry.MeshInstance;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.ModelOptions.Pose;
import io.github.lumbre.model.Models;
import io.github.lumbre.model.format.gltf.GltfFile;
import io.github.lumbre.render.PictureRenderer;
import io.github.lumbre.render.PixelReplay;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.Primitive;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.scenefile.SceneText;
import io.github.lumbre.scenefile.internal.ParsedScene;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Pictures of animated models during the time of a shutter. */
class MotionModelTest {
  private static final int WIDTH = 12;
  private static final int HEIGHT = 9;
  private static final int POSES = 8;
  private static final double SHUTTER = .5;

  /** Of a picture in motion: the same on every machine, and with every version of Java. */
  private static final int HASH = 1688788924;

  /** The light of the sky behind the lamp. */
  private static final double SKY = .25;

  @TempDir private Path directory;

  private final GltfFile file = new GltfFile();
  private final List<String> channels = new ArrayList<>();
  private final List<String> samplers = new ArrayList<>();

  private void animate(int node, String path, String type, String interpolation, double... values) {
    int times = file.floats("SCALAR", 0, 1);
    channels.add(
        "{'sampler': %d, 'target': {'node': %d, 'path': '%s'}}"
            .formatted(samplers.size(), node, path));
    samplers.add(
        "{'input': %d, 'output': %d, 'interpolation': '%s'}"
            .formatted(times, file.floats(type, values), interpolation));
  }

  /** A still panel, one that moves, one that changes its shape, and a light that moves. */
  private void addParts() {
    file.set("extensionsUsed", "['KHR_lights_punctual']");
    file.set(
        "extensions", "{'KHR_lights_punctual': {'lights': [{'type': 'point', 'intensity': 30}]}}");
    int panel = file.triangle("");
    file.add("nodes", "{'mesh': %d, 'scale': [3, 3, 3]}".formatted(panel));
    file.add("nodes", "{'mesh': %d, 'translation': [0, 0, 1]}".formatted(file.triangle("")));
    int moves = file.floats("VEC3", 0, 0, 0, 1, 1, 0, 0, 0, 0);
    int morphed = file.triangle(", 'targets': [{'POSITION': " + moves + "}]");
    file.add("nodes", "{'mesh': %d, 'translation': [1, 1, 0.5]}".formatted(morphed));
    file.add("nodes", "{'extensions': {'KHR_lights_punctual': {'light': 0}}}");
    animate(1, "translation", "VEC3", "LINEAR", 0, 0, 1, 2, 0, 1);
    animate(2, "weights", "SCALAR", "LINEAR", 0, 1);
    animate(3, "translation", "VEC3", "LINEAR", 0, 0, 2, 2, 0, 2);
  }

  /** A panel whose upper corner follows a joint that turns. */
  private void addSkin() {
    int positions = file.floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0);
    int joints = file.bytes(5121, "VEC4", "", 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0);
    int weights = file.floats("VEC4", 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0);
    int mesh =
        file.mesh(
            "'POSITION': %d, 'JOINTS_0': %d, 'WEIGHTS_0': %d".formatted(positions, joints, weights),
            "");
    int still = file.add("nodes", "{'translation': [0, 0, 1.5]}");
    int turning = file.add("nodes", "{'translation': [0, 0, 1.5]}");
    file.add("nodes", "{'mesh': %d, 'skin': 0}".formatted(mesh));
    file.add("skins", "{'joints': [%d, %d]}".formatted(still, turning));
    animate(turning, "rotation", "VEC4", "LINEAR", 0, 0, 0, 1, 0, 0, -.8, .6);
  }

  private void addCamera() {
    file.add("cameras", "{'type': 'perspective', 'perspective': {'yfov': 0.8, 'znear': 0.1}}");
    animate(file.add("nodes", "{'camera': 0}"), "translation", "VEC3", "LINEAR", 1, 1, 5, 2, 1, 5);
  }

  private byte[] glb() {
    file.add(
        "animations",
        "{'name': 'go', 'channels': [%s], 'samplers': [%s]}"
            .formatted(String.join(",", channels), String.join(",", samplers)));
    return file.glb();
  }

  private static SceneParser parser(double shutter, int poses) {
    return new SceneParser()
        .overriding(
            settings ->
                settings.toBuilder()
                    .size(WIDTH, HEIGHT)
                    .samples(2 * POSES)
                    .threads(1)
                    .maxTraceDepth(2)
                    .set(Setting.SHUTTER, shutter)
                    .set(Setting.POSES, poses)
                    .build());
  }

  private static Stage at(double seconds) {
    return Stage.DEFAULT.with(ModelOption.POSE, new Pose("go", seconds));
  }

  private static SceneFile read(byte[] glb, Stage stage, double shutter) throws Exception {
    return staged(parser(shutter, POSES), glb, stage);
  }

  private static SceneFile staged(SceneParser parser, byte[] glb, Stage stage) throws Exception {
    return StagedModel.read("a.glb", glb, ModelFolder.NONE, stage, parser).scene();
  }

  private static Image render(SceneFile scene) throws InterruptedException {
    return new PictureRenderer(scene.settings()).render(scene.scene());
  }

  private static List<Shape> shapes(Scene scene) {
    return scene.primitives().stream().map(Primitive::shape).toList();
  }

  /**
   * Poses that move share a mesh in its own space, which single pictures have in world space: the
   * rounding of both differs, so that a sample at an edge may differ.
   */
  @Test
  void pictureIsTheMeanOfPicturesAtTheTimesOfItsPoses() throws Exception {
    addParts();
    addSkin();
    addCamera();
    byte[] glb = glb();
    SceneFile moving = read(glb, at(.25), SHUTTER);
    Image picture = render(moving);
    List<PixelReplay> singles = new ArrayList<>();
    for (double time : new Pose("go", .25, SHUTTER, POSES).times()) {
      SceneFile still = read(glb, at(time), 0);
      assertThat(still.scene().poses()).hasSize(1);
      singles.add(new PixelReplay(still.scene(), still.settings()));
    }
    int different = 0;
    for (int y = 0; y < HEIGHT; y++) {
      for (int x = 0; x < WIDTH; x++) {
        Rgb mean = Rgb.BLACK;
        for (int i = 0; i < 2 * POSES; i++) {
          Rgb sample = singles.get(i % POSES).sample(x, y, i).film();
          mean = mean.plus(sample.times(1. / (2 * POSES)));
        }
        Rgb found = picture.pixel(x, y);
        different += Math.abs(found.g() - mean.g()) > 1e-4 * mean.g() ? 1 : 0;
      }
    }
    assertThat(different).isLessThan(3);
    assertThat(picture.rgb()).isNotEqualTo(render(read(glb, at(.5), 0)).rgb());
  }

  @Test
  void partsThatDoNotMoveAreSharedAndMeshesThatMove() throws Exception {
    addParts();
    List<Scene> poses = read(glb(), at(0), SHUTTER).scene().poses();
    assertThat(poses).hasSize(POSES);
    assertThat(poses.stream().map(pose -> shapes(pose).get(0)).distinct()).hasSize(1);
    Set<Object> moved = poses.stream().map(pose -> shapes(pose).get(1)).collect(Collectors.toSet());
    assertThat(moved).hasSize(POSES);
    assertThat(moved.stream().map(shape -> ((MeshInstance) shape).shared()).distinct()).hasSize(1);
    assertThat(poses.stream().map(pose -> shapes(pose).get(2)).distinct()).hasSize(POSES);
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void standingStillChangesNoBit(boolean hasEnded) throws Exception {
    addParts();
    byte[] glb = glb();
    // After its end, the animation stands still.
    Stage stage = hasEnded ? at(2) : Stage.DEFAULT;
    SceneFile moving = read(glb, stage, SHUTTER);
    assertThat(moving.scene().poses()).hasSize(POSES).containsOnly(moving.scene().poses().get(0));
    assertThat(render(moving).rgb()).isEqualTo(render(read(glb, stage, 0)).rgb());
  }

  @Test
  void kernelsFindTheSameHits() throws Exception {
    addParts();
    byte[] glb = glb();
    float[] plain = render(read(glb, at(0), SHUTTER)).rgb();
    assertThat(Arrays.hashCode(plain)).isEqualTo(HASH);
    for (Kernel kernel : List.of(Kernel.SCALAR, Kernel.VECTOR)) {
      if (kernel == Kernel.SCALAR || Kernel.vectorObstacle().isEmpty()) {
        SceneFile scene = staged(parser(SHUTTER, POSES).searchedBy(kernel), glb, at(0));
        assertThat(render(scene).rgb()).isEqualTo(plain);
        Scene other = read(glb, at(0), SHUTTER).scene().searchedBy(kernel);
        assertThat(new PictureRenderer(scene.settings()).render(other).rgb()).isEqualTo(plain);
      }
    }
    SceneFile changing = read(glb, at(0), SHUTTER);
    changing.scene().changeKernel(() -> true);
    assertThat(render(changing).rgb()).isEqualTo(plain);
  }

  /** A film is resumed from the text of its scene, with the settings of its header. */
  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void sceneFilesMoveAsModelsDo(boolean hasCamera) throws Exception {
    addParts();
    if (hasCamera) {
      addCamera();
    }
    byte[] glb = glb();
    Files.write(directory.resolve("a.glb"), glb);
    SceneFile model = read(glb, at(.25), SHUTTER);
    SceneText text = model.text().orElseThrow();
    Path path = directory.resolve(text.path().getFileName());
    SceneFile scene = parser(SHUTTER, POSES).parse(text.json(), path);
    assertThat(scene.scene().poses()).hasSize(POSES);
    assertThat(render(scene).rgb()).isEqualTo(render(model).rgb());
    assertThat(new String(text.json(), StandardCharsets.UTF_8).contains("useCamera"))
        .isEqualTo(hasCamera);
  }

  @Test
  void partsMayAppear() throws Exception {
    addParts();
    file.add("nodes", "{'mesh': 0, 'translation': [1, 0, 2]}");
    animate(4, "scale", "VEC3", "STEP", 0, 0, 0, 1, 1, 1);
    byte[] glb = glb();
    SceneFile appearing = read(glb, at(.75), SHUTTER);
    assertThat(appearing.scene().poses())
        .extracting(pose -> pose.primitives().size())
        .containsExactly(3, 3, 3, 3, 4, 4, 4, 4);
    // What is known of the scene is known of its middle pose.
    ParsedScene parsed = appearing.parsed();
    assertThat(parsed.origins().primitives()).hasSize(4);
    assertThat(parsed.contents().triangles()).isEqualTo(4);
    assertThat(parsed.model().orElseThrow().parts(appearing.scene()).parts()).hasSize(4);
    Image picture = render(appearing);
    assertThat(picture.rgb()).isNotEqualTo(render(read(glb, at(.4), SHUTTER)).rgb());
    SceneParser recording =
        parser(SHUTTER, POSES)
            .overriding(
                s ->
                    s.toBuilder()
                        .set(Setting.SHUTTER, SHUTTER)
                        .set(Setting.LAYERS, Set.of(Layer.OBJECT))
                        .build());
    assertThatThrownBy(() -> staged(recording, glb, at(.75)))
        .isInstanceOf(SceneFormatException.class)
        .hasMessageContaining("expected the same parts and lights in all poses");
  }

  /** A panel, which is a lamp and appears, before a sky of another light group; the rest is cut. */
  private SceneFile lamp(Set<Layer> layers) throws Exception {
    file.set("extensionsUsed", "['KHR_materials_emissive_strength']");
    int material = file.add("materials", "{'emissiveFactor': [1, 1, 1], 'doubleSided': true}");
    file.add("nodes", "{'mesh': %d}".formatted(file.triangle(", 'material': " + material)));
    file.add("nodes", "{'mesh': %d, 'translation': [9, 0, 0]}".formatted(file.triangle("")));
    animate(0, "scale", "VEC3", "STEP", 0, 0, 0, 1, 1, 1);
    Files.write(directory.resolve("a.glb"), glb());
    String scene =
        """
        {"mainCameraId": 1, "renderOptions": {"shutter": 0.5, "poses": 8}, "objects": [
        {"type": "Camera", "id": 1, "localPosition": {"x": -0.3, "y": 0.3, "z": -2}},
        {"type": "Model", "file": "a.glb", "pose": "go", "seconds": 0.75,
         "lightGroup": "lamp", "section": ["x=5"]},
        {"type": "Light", "lightType": "Dome", "intensity": 0.25, "lightGroup": "sky"}]}
        """;
    return parser(SHUTTER, POSES)
        .overriding(
            s ->
                s.toBuilder()
                    .size(WIDTH, HEIGHT)
                    .samples(POSES)
                    .set(Setting.LAYERS, layers)
                    .build())
        .parse(scene.getBytes(StandardCharsets.UTF_8), directory.resolve("scene.json"));
  }

  @Test
  void sceneMayBeEmptyAtFirst() throws Exception {
    SceneFile scene = lamp(Layer.FOR_DENOISING);
    assertThat(scene.scene().poses())
        .extracting(pose -> pose.primitives().size())
        .containsExactly(0, 0, 0, 0, 1, 1, 1, 1);
    float[] rgb = render(scene).rgb();
    double most = IntStream.range(0, rgb.length).mapToDouble(i -> rgb[i]).max().getAsDouble();
    // Half of the time, the lamp hides the sky, and shines and reflects its light.
    assertThat(most).isBetween((1 + SKY) / 2, (1 + SKY) / 2 + SKY);
  }

  @Test
  void lightGroupsWithOtherLightsInSomePosesAreRefused() {
    assertThatThrownBy(() -> lamp(Set.of(Layer.LIGHTS)))
        .isInstanceOf(SceneFormatException.class)
        .hasMessageContaining("expected the same parts and lights in all poses");
  }

  @ParameterizedTest
  @ValueSource(strings = {"x=60%", "y=0.4"})
  void sectionsStandStill(String section) throws Exception {
    addParts();
    Stage cut = at(.25).reading(at(.25).options().with(ModelOption.SECTION, List.of(section)));
    byte[] glb = glb();
    SceneFile moving = read(glb, cut, SHUTTER);
    assertThat(moving.scene().poses()).hasSize(POSES).doesNotHaveDuplicates();
    assertThat(shapes(moving.scene().poses().get(0)).get(0))
        .isSameAs(shapes(moving.scene().poses().get(POSES - 1)).get(0));
    assertThat(render(moving).rgb()).isNotEqualTo(render(read(glb, at(.25), SHUTTER)).rgb());
  }

  /** 2,000 triangles with a new shape in each pose: half a megabyte a pose. */
  @Test
  void memoryOfAllPosesIsEstimatedFirst() throws Exception {
    int positions = manyTriangles();
    String target = ", 'targets': [{'POSITION': " + positions + "}]";
    file.add("nodes", "{'mesh': %d}".formatted(file.mesh("'POSITION': " + positions, target)));
    animate(0, "weights", "SCALAR", "LINEAR", 0, 1);
    requireMemoryForAllPoses();
  }

  /** A lamp of 2,000 triangles that keeps its shape, but is divided into emitters in each pose. */
  @Test
  void memoryOfMovingLampsIsEstimatedFirst() throws Exception {
    int material = file.add("materials", "{'emissiveFactor': [1, 1, 1]}");
    int lamp = file.mesh("'POSITION': " + manyTriangles(), ", 'material': " + material);
    file.add("nodes", "{'mesh': %d}".formatted(lamp));
    animate(0, "translation", "VEC3", "LINEAR", 0, 0, 0, 1, 0, 0);
    requireMemoryForAllPoses();
  }

  private int manyTriangles() {
    return file.floats("VEC3", new Random(0).doubles(9 * 2000).toArray());
  }

  private void requireMemoryForAllPoses() throws Exception {
    byte[] glb = glb();
    Limits limits = Limits.NONE.withMemory(20_000_000);
    SceneFile few = staged(parser(SHUTTER, 2).limitedTo(limits), glb, at(0));
    assertThat(few.scene().poses()).hasSize(2);
    assertThatThrownBy(() -> staged(parser(SHUTTER, 256).limitedTo(limits), glb, at(0)))
        .isInstanceOf(SceneFormatException.class)
        .hasMessageContaining(
            "animations: 256 poses: expected at most 20000000 bytes of memory for the model")
        .extracting(e -> ((SceneFormatException) e).kind())
        .isEqualTo(SceneFormatException.Kind.LIMIT);
  }

  @Test
  void aShutterWithoutMotionIsSaid() throws Exception {
    String scene =
        """
        {"mainCameraId": 1, "renderOptions": {"shutter": 0.5},
         "objects": [{"type": "Camera", "id": 1}]}
        """;
    assertThat(
            new SceneParser()
                .parse(scene.getBytes(StandardCharsets.UTF_8), directory.resolve("a.json"))
                .warnings())
        .anyMatch(warning -> warning.toString().contains("shutter: changes nothing"));
  }

  @Test
  void codeAddsModelsThatStandStill() throws Exception {
    addParts();
    byte[] glb = glb();
    ModelOptions still = ModelOptions.DEFAULT.with(ModelOption.POSE, new Pose("go", .5));
    assertThat(Models.read("a.glb", glb, ModelFolder.NONE, still).options()).isEqualTo(still);
    ModelOptions moving =
        ModelOptions.DEFAULT.with(ModelOption.POSE, new Pose("go", .5, SHUTTER, POSES));
    assertThatThrownBy(() -> Models.read("a.glb", glb, ModelFolder.NONE, moving))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("pose: expected one that stands still, found motion");
  }

  @Test
  void samplesAreRoundedUp() throws Exception {
    addParts();
    byte[] glb = glb();
    SceneFile scene = staged(parser(SHUTTER, 64), glb, at(0));
    assertThat(scene.settings().samples()).isEqualTo(64);
    assertThat(read(glb, at(0), 0).settings().samples()).isEqualTo(2 * POSES);
  }

  @ParameterizedTest
  @ValueSource(doubles = {-1, Double.NaN, 1e9})
  void shuttersHaveLimits(double shutter) {
    assertThatThrownBy(() -> new Pose("go", 0, shutter, 16))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("shutter: expected a number from 0 to 3600, found " + shutter);
    assertThatThrownBy(() -> RenderSettings.builder().set(Setting.SHUTTER, shutter))
        .isInstanceOf(IllegalArgumentException.class);
  }

  @ParameterizedTest
  @ValueSource(ints = {0, -16, 3, 512})
  void posesArePowersOfTwo(int poses) {
    assertThatThrownBy(() -> new Pose("go", 0, .1, poses))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("poses: expected a power of two from 1 to 256, found " + poses);
  }
}
