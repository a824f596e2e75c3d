package io.github.lumbre.scenefile;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import com.google.gson.JsonObject;
import io.github.lumbre.camera.Camera;
import io.github.lumbre.camera.Lens;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.light.Light;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.NormalMapped;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.StagedModel;
import io.github.lumbre.testing.Folders;
import io.github.lumbre.texture.Texture;
import io.github.lumbre.texture.internal.BilinearTexture;
import io.github.lumbre.texture.internal.ClearSky;
import io.github.lumbre.texture.internal.Constant;
import io.github.lumbre.texture.internal.LinearTexture;
import io.github.lumbre.texture.internal.MappedTexture;
import io.github.lumbre.texture.internal.SampledTexture;
import io.github.lumbre.texture.internal.StudioSky;
import io.github.lumbre.texture.internal.SunDisk;
import io.github.lumbre.texture.internal.TintedTexture;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Each kind of scene object and each of its keys is declared once. */
class KindsTest {
  private static final Path SOURCES = Path.of("src", "main", "java", "io", "github", "lumbre");

  private static final List<Family<?>> FAMILIES =
      List.of(
          CameraKinds.FAMILY,
          ShapeKinds.FAMILY,
          LightKinds.FAMILY,
          MaterialKinds.FAMILY,
          TextureKinds.FAMILY);

  /** Parts of what kinds write, and textures that only readers make, of keys of lights. */
  private static final Set<Class<?>> PARTS =
      Set.of(
          NormalMapped.class,
          BilinearTexture.class,
          ClearSky.class,
          Constant.class,
          LinearTexture.class,
          MappedTexture.class,
          SampledTexture.class,
          StudioSky.class,
          SunDisk.class,
          TintedTexture.class);

  /** Literals that are equal to a key of kinds and are none: a word, and the name of a light. */
  private static final Set<String> NO_KEYS =
      Set.of("Problem.java file", "WrittenSurroundings.java sky");

  @TempDir private Path folder;

  private static Stream<Class<?>> permitted(Class<?> type) {
    return type.isSealed()
        ? Arrays.stream(type.getPermittedSubclasses()).flatMap(KindsTest::permitted)
        : Stream.of(type);
  }

  /** Returns the classes of a package, those inside others included. */
  private static Stream<Class<?>> classes(String name) throws IOException {
    List<Class<?>> classes = new ArrayList<>();
    for (Path file :
        Folders.files(Path.of("target", "classes", "io/github/lumbre", name), ".class")) {
      String simple = file.getFileName().toString().replace(".class", "");
      try {
        classes.add(Class.forName("io.github.lumbre." + name.replace('/', '.') + "." + simple));
      } catch (ClassNotFoundException e) {
        throw new AssertionError(e);
      }
    }
    return classes.stream().filter(c -> !c.isInterface() && !c.isAnonymousClass());
  }

  private static void assertDeclared(Family<?> family, Stream<Class<?>> types) {
    List<Class<?>> declared =
        family.kinds().stream().<Class<?>>map(Kind::type).collect(Collectors.toList());
    assertThat(types)
        .isNotEmpty()
        .allSatisfy(
            type ->
                assertThat(
                        declared.contains(type)
                            || PARTS.contains(type)
                            || family.refused().contains(type.getSimpleName()))
                    .as("%s has a kind or is refused by name", type)
                    .isTrue());
  }

  @Test
  void everyTypeHasAKindOrIsRefusedByName() throws IOException {
    assertDeclared(CameraKinds.FAMILY, permitted(Lens.class));
    assertDeclared(ShapeKinds.FAMILY, permitted(Shape.class));
    assertDeclared(LightKinds.FAMILY, permitted(Light.class));
    assertDeclared(
        MaterialKinds.FAMILY, classes("material").filter(Material.class::isAssignableFrom));
    assertDeclared(
        TextureKinds.FAMILY, classes("texture/internal").filter(Texture.class::isAssignableFrom));
    Set<String> cameras =
        permitted(Lens.class).map(c -> c.getSimpleName() + "Camera").collect(Collectors.toSet());
    assertThat(permitted(Camera.class).map(Class::getSimpleName)).hasSameElementsAs(cameras);
  }

  /** Classes of programs can be rendered, and are named where they cannot be written. */
  @Test
  void classesWithoutAKindAreRefusedByName() {
    record Velvet() {}
    for (Family<?> family : FAMILIES) {
      assertThatIllegalArgumentException()
          .isThrownBy(() -> family.write(new Velvet(), new JsonObject(), null))
          .withMessageMatching("expected a \\w+ of the format, found Velvet");
    }
  }

  private static Set<String> keys() {
    Set<String> keys = new TreeSet<>();
    FAMILIES.forEach(family -> keys.addAll(family.keys()));
    for (List<Key<?>> each :
        List.of(
            RootKeys.ALL,
            RootKeys.OF_OPTIONS,
            RootKeys.OF_GRADIENTS,
            ObjectKeys.OF_EMITTERS,
            ObjectKeys.OF_MESHES,
            ObjectKeys.OF_MODELS)) {
      keys.addAll(Key.names(each));
    }
    return keys;
  }

  @Test
  void noOtherClassHoldsAKey() throws IOException {
    List<Path> files =
        Stream.concat(
                Folders.files(SOURCES.resolve("scenefile")).stream(),
                Stream.of(SOURCES.resolve("cli/view/CameraJson.java")))
            .filter(file -> file.toString().matches(".*(?<!Kinds|Keys)[.]java"))
            .toList();
    Set<String> found = new TreeSet<>();
    for (Path file : files) {
      String source = Files.readString(file);
      for (String key : keys()) {
        if (source.contains('"' + key + '"')) {
          found.add(file.getFileName() + " " + key);
        }
      }
    }
    assertThat(found).isEqualTo(new TreeSet<>(NO_KEYS));
  }

  /** Each pair of kind and key is declared once. */
  @Test
  void kindsHaveEachKeyOnce() {
    for (Family<?> family : FAMILIES) {
      for (Kind<?, ?> kind : family.kinds()) {
        assertThat(kind.keys().stream().map(Key::name)).as(kind.name()).doesNotHaveDuplicates();
        assertThat(Key.names(kind.keys())).doesNotContainAnyElementsOf(Key.names(family.common()));
      }
    }
  }

  /** What the test of the writer reads and renders has all kinds and keys that are written. */
  @Test
  void randomScenesHaveEveryKind() throws Exception {
    StringBuilder written = new StringBuilder();
    RenderSettings settings = RenderSettings.builder().set(Setting.SEED, 1L).build();
    for (int seed = 0; seed < 16; seed++) {
      Path path = folder.resolve(seed + ".json");
      SceneWriter.write(RandomScene.of(seed).build(), settings, path);
      written.append(Files.readString(path));
    }
    Set<String> missing = new LinkedHashSet<>();
    for (Family<?> family : FAMILIES) {
      family.kinds().stream()
          .filter(kind -> kind.type() != Void.class)
          .map(kind -> "\"" + family.typeKey().name() + "\":\"" + kind.name() + '"')
          .filter(text -> written.indexOf(text) < 0)
          .forEach(missing::add);
    }
    assertThat(missing).containsOnly("\"textureType\":\"Image\"");
  }
}
