package io.github.lumbre.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.material.MaterialParameter;
import io.github.lumbre.model.format.gltf.GltfFile;
import io.github.lumbre.model.internal.FileSearch;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.testing.Pictures;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A file that a model names with another case or path is found if it is the only one. */
class FileSearchTest {
  private static final String QUAD = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl m\nf 1/1 2/1 3/1\n";

  @TempDir private Path directory;
  private final byte[] picture = Pictures.png(1, 1, 0);
  private Path folder;

  @BeforeEach
  void makeFolder() throws IOException {
    folder = Files.createDirectories(directory.resolve("model"));
  }

  private void put(String name) throws IOException {
    Path file = directory.resolve(name);
    Files.createDirectories(file.getParent());
    Files.write(file, picture);
  }

  private Model obj(String texture, Limits limits) throws ModelFormatException, IOException {
    Files.writeString(folder.resolve("a.mtl"), "newmtl m\nmap_Kd " + texture + "\n");
    Path file = Files.writeString(folder.resolve("a.obj"), "mtllib a.mtl\n" + QUAD);
    return Models.read(file, ModelOptions.DEFAULT.limitedTo(limits)).model();
  }

  private static boolean isTextured(Model model) {
    return model
        .parts()
        .get(0)
        .material()
        .input(MaterialParameter.BASE_COLOR)
        .texture()
        .isPresent();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "WOOD.PNG",
        "C:\\textures\\wood.png",
        "\"wood.png\"",
        "\"C:\\My Work\\Wood.png\"",
        "../textures/wood.png",
        "/home/someone/wood.png",
        "-s 2 2 ../Wood.Png"
      })
  void theOnlyFileOfTheNameIsUsed(String name) throws Exception {
    put("model/maps/deep/down/wood.png");
    put("wood.png");
    put("model/maps/other.png");
    Model model = obj(name, Limits.NONE);
    assertThat(isTextured(model)).isTrue();
    assertThat(model.warnings()).hasSize(1);
    assertThat(model.warnings().get(0))
        .endsWith("; \"maps/deep/down/wood.png\" is used")
        .doesNotContain("\"\"");
    if (name.startsWith("\"")) {
      // The quotes are part of the name that was not found.
      assertThat(model.warnings().get(0)).contains(" at '" + name.replace('\\', '/') + "'; ");
    }
  }

  @Test
  void theExactNameComesFirst() throws Exception {
    put("model/wood.png");
    put("model/maps/wood.png");
    Model model = obj("wood.png", Limits.NONE);
    assertThat(isTextured(model)).isTrue();
    assertThat(model.warnings()).isEmpty();
  }

  @Test
  void noneOrSeveralAreLeftOut() throws Exception {
    put("wood.png");
    put("model/1/2/3/4/wood.png");
    assertThat(isTextured(obj("WOOD.png", Limits.NONE))).isFalse();
    put("model/1/wood.png");
    put("model/2/Wood.png");
    Model model = obj("WOOD.png", Limits.NONE);
    assertThat(isTextured(model)).isFalse();
    assertThat(model.warnings())
        .containsExactly(
            "a.mtl line 2: expected a file, found none at \"WOOD.png\"; there are several of that"
                + " name: \"1/wood.png\" or \"2/Wood.png\"; the picture is left out");
  }

  @Test
  void uploadsGetNoOtherFile() throws Exception {
    put("model/wood.png");
    Model model = obj("WOOD.png", Limits.UPLOADS);
    assertThat(isTextured(model)).isFalse();
    assertThat(model.warnings().toString()).contains("found none").doesNotContain("wood.png");
    assertThat(isTextured(obj("wood.png", Limits.UPLOADS))).isTrue();
  }

  @Test
  void linksOutOfTheFolderAreNotFollowed() throws Exception {
    put("outside/wood.png");
    Files.createSymbolicLink(folder.resolve("link"), directory.resolve("outside"));
    assertThat(isTextured(obj("WOOD.png", Limits.NONE))).isFalse();
    Files.createSymbolicLink(folder.resolve("wood.png"), directory.resolve("outside/wood.png"));
    assertThat(isTextured(obj("WOOD.png", Limits.NONE))).isFalse();
  }

  @Test
  void librariesAndFilesOfGltfAreFound() throws Exception {
    put("model/maps/wood.png");
    Files.writeString(folder.resolve("maps/Library.MTL"), "newmtl m\nKd 0 1 0\n");
    Path obj = Files.writeString(folder.resolve("b.obj"), "mtllib D:\\library.mtl\n" + QUAD);
    Model model = Models.read(obj).model();
    assertThat(model.parts().get(0).material().input(MaterialParameter.BASE_COLOR).factor().r())
        .isZero();
    GltfFile file = new GltfFile();
    file.triangle(", 'material': 0");
    file.add("nodes", "{'mesh': 0}");
    file.add("materials", "{'emissiveTexture': {'index': 0}}");
    file.add("textures", "{'source': 0}");
    file.add("images", "{'uri': '../Maps/WOOD.png'}");
    Path gltf = Files.write(folder.resolve("c.gltf"), file.gltf("C.BIN"));
    assertThatThrownBy(() -> Models.read(gltf)).hasMessageContaining("found none at \"C.BIN\"");
    Files.write(folder.resolve("c.bin"), file.buffer());
    model = Models.read(gltf).model();
    assertThat(model.parts().get(0).material().emission().texture()).isPresent();
    assertThat(model.warnings())
        .anySatisfy(w -> assertThat(w).contains("\"maps/wood.png\" is used"))
        .anySatisfy(w -> assertThat(w).contains("\"c.bin\" is used"));
  }

  @Test
  void largeFoldersAreNotSearched() throws Exception {
    put("model/1/wood.png");
    put("model/2/x.png");
    assertThat(new FileSearch(folder, 4).of("WOOD.PNG")).isEqualTo(List.of("1/wood.png"));
    assertThat(new FileSearch(folder, 3).of("WOOD.PNG")).isEmpty();
    assertThat(new FileSearch(folder.resolve("missing")).of("wood.png")).isEmpty();
    assertThat(new FileSearch(folder).of("..")).isEmpty();
  }
}
