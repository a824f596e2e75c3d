package io.github.lumbre.scenefile;

import static io.github.lumbre.material.MaterialParameter.ATTENUATION_DISTANCE;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import io.github.lumbre.camera.Lens;
import io.github.lumbre.geometry.Mesh;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.Emission;
import io.github.lumbre.light.Light;
import io.github.lumbre.light.PointLight;
import io.github.lumbre.light.internal.LightProfile;
import io.github.lumbre.material.Matte;
import io.github.lumbre.material.MetallicRoughness;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.PassResult;
import io.github.lumbre.render.PixelReplay;
import io.github.lumbre.render.Progress;
import io.github.lumbre.render.checkpoint.CheckpointFile;
import io.github.lumbre.render.checkpoint.FilmFile;
import io.github.lumbre.render.checkpoint.FilmHeader;
import io.github.lumbre.render.checkpoint.RecordedLayers;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.SceneBuilder;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scenefile.audit.SceneAudit;
import io.github.lumbre.testing.Effort;
import io.github.lumbre.testing.Folders;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class SceneWriterTest {
  private static final RenderSettings SETTINGS =
      new RenderSettings.Builder().size(16, 11).samples(2).threads(1).seed(5).build();

  @TempDir private Path folder;

  static IntStream seeds() {
    return IntStream.range(0, Effort.isExhaustive() ? 2000 : 84);
  }

  private static RenderSettings settings(int seed) {
    RenderSettings.Builder builder = SETTINGS.toBuilder();
    if (seed % 2 == 1) {
      builder.set(
          Setting.LAYERS,
          Layer.setOf(Layer.OBJECT, Layer.MATERIAL, Layer.NORMAL, Layer.LIGHTS, Layer.UV));
    }
    if (seed % 11 == 3) {
      builder.mode(RenderSettings.Mode.RAY).samples(4);
    }
    return builder.transparent(seed % 4 == 1).build();
  }

  /** Returns the bytes of a checkpoint file, which has all sums, layers and the identity. */
  private byte[] film(SceneFile file, RenderSettings settings) throws Exception {
    FilmRenderer renderer = new FilmRenderer(settings, file.scene());
    Film film = renderer.newFilm();
    PassResult pass = renderer.addSamples(film, settings.samples(), Progress.NONE);
    Map<String, String> identity = FilmHeader.identity(file.hash(), settings);
    Path path = folder.resolve("film");
    Files.deleteIfExists(path);
    RecordedLayers layers = RecordedLayers.of(settings, file.scene());
    try (CheckpointFile checkpoint = CheckpointFile.reserve(path)) {
      checkpoint.save(FilmFile.of(identity, film, layers, Map.of(), pass.statistics()));
    }
    return Files.readAllBytes(path);
  }

  /** What is written is read back to the same film, identity included, bit for bit. */
  @ParameterizedTest
  @MethodSource("seeds")
  void writtenScenesHaveTheSameFilm(int seed) throws Exception {
    Scene scene = RandomScene.of(seed).build();
    RenderSettings settings = settings(seed);
    Path path = folder.resolve("scene.json");
    SceneFile written = SceneWriter.write(scene, settings, path);
    SceneFile read =
        new SceneParser()
            .overriding(
                inFile ->
                    inFile.toBuilder().set(Setting.LAYERS, settings.get(Setting.LAYERS)).build())
            .parse(path);
    assertThat(read.hash()).isEqualTo(written.hash());
    assertThat(read.settings().toBuilder().threads(1).build()).isEqualTo(settings);
    assertThat(film(read, settings)).isEqualTo(film(written, settings));
    assertThat(new FilmRenderer(settings, scene).newFilm().window()).isEqualTo(settings.window());
  }

  private static SceneBuilder simple() {
    return Scene.builder()
        .lookingAt(new Vec3(0, 1, -5), Vec3.ZERO, Lens.pinhole(40))
        .add("ball", Sphere.of(Vec3.ZERO, 1), Matte.of(.8, .2, .2))
        .addBackground(Rgb.WHITE);
  }

  @Test
  void codeScenesHaveHashesPlacesAndAudits() {
    SceneFile file = SceneWriter.file(simple().build(), SETTINGS);
    assertThat(file.hash()).hasSize(64);
    assertThat(file.parsed().origins().primitives().get(0).toString())
        .isEqualTo("$.objects[0] \"ball\"");
    assertThat(file.parsed().contents().shapes()).isEqualTo(1);
    assertThat(SceneAudit.of(file)).isNotNull();
    assertThat(new PixelReplay(file.scene(), SETTINGS).pixel(8, 5, 1).brightest()).isNotEmpty();
    Scene other = simple().add("second", Sphere.of(Vec3.Y, 1), Matte.GRAY).build();
    assertThat(SceneWriter.file(other, SETTINGS).hash()).isNotEqualTo(file.hash());
    assertThat(SceneWriter.file(simple().build(), SETTINGS).hash()).isEqualTo(file.hash());
  }

  /** The format has moving models, but no scenes whose parts code moves. */
  @Test
  void scenesInMotionAreRefusedAndOthersHaveThePosesOfTheSettings() {
    Scene still = simple().build();
    RenderSettings moving =
        SETTINGS.toBuilder().set(Setting.SHUTTER, .1).set(Setting.POSES, 4).build();
    assertThat(SceneWriter.file(still, moving).scene().poses()).hasSize(moving.poses());
    assertThat(SceneWriter.file(still, SETTINGS).scene().poses()).hasSize(1);
    Scene other = simple().add("second", Sphere.of(Vec3.Y, 1), Matte.GRAY).build();
    Scene inMotion = Scene.inMotion(List.of(still, other));
    assertThatIllegalArgumentException()
        .isThrownBy(() -> SceneWriter.file(inMotion, SETTINGS))
        .withMessage("expected a scene that stands still, found one in motion");
  }

  @Test
  void existingFilesAreKept() throws Exception {
    Path path = folder.resolve("scene.json");
    SceneWriter.write(simple().build(), SETTINGS, path);
    SceneWriter.write(simple().build(), SETTINGS, path); // the same content
    Scene other = simple().addAmbient(Rgb.WHITE).build();
    byte[] before = Files.readAllBytes(path);
    assertThatExceptionOfType(FileAlreadyExistsException.class)
        .isThrownBy(() -> SceneWriter.write(other, SETTINGS, path))
        .withMessage(path.toString());
    assertThat(Files.readAllBytes(path)).isEqualTo(before);
    SceneWriter.replace(other, SETTINGS, path);
    assertThat(new SceneParser().parse(path).scene().ambient()).isEqualTo(Rgb.WHITE);
    assertThat(Folders.names(folder)).containsExactly("scene.json");
  }

  @Test
  void whatTheFormatLacksIsNamed() {
    Matte computed = new Matte((u, v) -> Rgb.gray(u));
    TriangleMesh mesh =
        TriangleMesh.of(
            new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0},
            new double[0],
            new double[0],
            new int[] {0, 1, 2});
    List<Scene> scenes =
        List.of(
            simple().add("odd", Sphere.of(Vec3.Y, 1), computed).build(),
            simple().add("odd", Mesh.baked(mesh, Transform.IDENTITY), Matte.GRAY).build(),
            simple()
                .add(
                    "odd",
                    Sphere.of(Vec3.Y, 1),
                    MetallicRoughness.builder()
                        .set(ATTENUATION_DISTANCE, Double.POSITIVE_INFINITY)
                        .build())
                .build());
    for (Scene scene : scenes) {
      assertThatIllegalArgumentException()
          .isThrownBy(() -> SceneWriter.file(scene, SETTINGS))
          .withMessageMatching("\"odd\": (\\w+: )?expected .*, found .*");
    }
    Scene glowing = simple().add(Sphere.of(Vec3.Y, 1), Matte.GRAY, Emission.of(Rgb.WHITE)).build();
    assertThatIllegalArgumentException()
        .isThrownBy(() -> SceneWriter.file(glowing, SETTINGS))
        .withMessageMatching("\"object \\d+\": expected .*, found .*");
    LightProfile lamp =
        new LightProfile(
            new double[] {0, 90}, new double[] {0, 360}, new int[2], new double[] {1, 1});
    Light profiled = lamp.light(PointLight.of(Vec3.ZERO, Rgb.WHITE), Transform.IDENTITY);
    Scene lit = simple().add(profiled).build();
    assertThatIllegalArgumentException()
        .isThrownBy(() -> SceneWriter.file(lit, SETTINGS))
        .withMessageEndingWith("expected a light without a profile, found the profile of a lamp");
    Scene fixed =
        Scene.builder().seenBy(Lens.pinhole(50).camera(Vec3.ZERO, Frame.WORLD, 1)).build();
    assertThatIllegalArgumentException()
        .isThrownBy(() -> SceneWriter.file(fixed, SETTINGS))
        .withMessage("expected a scene with lookingAt, found one with seenBy");
  }
}
