package io.github.lumbre.model.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.ModelOptions;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class AllowedFoldersTest {
  @TempDir private Path folder;

  @BeforeEach
  void write() throws IOException {
    folder = folder.toRealPath();
    Files.createDirectories(folder.resolve("models/maps"));
    Files.createDirectories(folder.resolve("materials/textures"));
    Files.writeString(folder.resolve("models/maps/own.png"), "own");
    Files.writeString(folder.resolve("materials/textures/x.png"), "x");
    Files.writeString(folder.resolve("secret.png"), "secret");
  }

  private AllowedFolders allowed(String... others) {
    return new AllowedFolders(
        folder.resolve("models"), List.of(others).stream().map(folder::resolve).toList());
  }

  private void assertFound(AllowedFolders allowed, String name, String file) throws IOException {
    assertThat(allowed.find(name)).contains(folder.resolve(file));
  }

  @Test
  void filesOfTheModelsFolderAndOfNamedOnesAreFound() throws IOException {
    String name = "../materials/textures/x.png";
    assertFound(allowed(), "maps/own.png", "models/maps/own.png");
    assertThat(allowed().find(name)).isEmpty();
    for (String other : List.of("materials", "materials/textures", "models/../materials", "")) {
      assertFound(allowed("nothing", other), name, "materials/textures/x.png");
    }
    String absolute = folder.resolve("materials/textures/x.png").toString();
    assertFound(allowed("materials"), absolute, "materials/textures/x.png");
    assertThat(allowed().find(absolute)).isEmpty();
  }

  /** Whether a file exists outside is not told: nothing there is touched. */
  @ParameterizedTest
  @ValueSource(
      strings = {"../secret.png", "../nothing.png", "../materials/../secret.png", "..", "../../x"})
  void whatIsOutsideIsNotTouched(String name) throws IOException {
    assertThat(allowed("materials").find(name)).isEmpty();
    assertThat(allowed("materials").find(folder.resolve("models").resolve(name).toString()))
        .isEmpty();
  }

  @Test
  void missingFilesInsideAreTold() {
    assertThatThrownBy(() -> allowed("materials").find("../materials/no.png"))
        .isInstanceOf(NoSuchFileException.class);
  }

  @Test
  void linksAreResolvedFirst() throws IOException {
    Files.createSymbolicLink(folder.resolve("models/out.png"), folder.resolve("secret.png"));
    Files.createSymbolicLink(folder.resolve("materials/out.png"), folder.resolve("secret.png"));
    Files.createSymbolicLink(folder.resolve("models/linked"), folder.resolve("materials"));
    Files.createSymbolicLink(folder.resolve("named"), folder.resolve("materials"));
    assertThat(allowed("materials").find("out.png")).isEmpty();
    assertThat(allowed("materials").find("../materials/out.png")).isEmpty();
    assertThat(allowed().find("linked/textures/x.png")).isEmpty();
    assertFound(allowed("materials"), "linked/textures/x.png", "materials/textures/x.png");
    assertFound(allowed("named"), "../named/textures/x.png", "materials/textures/x.png");
    assertFound(allowed("named"), "../materials/textures/x.png", "materials/textures/x.png");
  }

  @Test
  void theFolderOfTheModelMayBeALink() throws IOException {
    Files.createDirectory(folder.resolve("elsewhere"));
    Files.createSymbolicLink(folder.resolve("elsewhere/link"), folder.resolve("models"));
    AllowedFolders linked =
        new AllowedFolders(
            folder.resolve("elsewhere/link"), List.of(folder.resolve("materials")));
    assertFound(linked, "maps/own.png", "models/maps/own.png");
    assertFound(linked, "../materials/textures/x.png", "materials/textures/x.png");
  }

  /** The names of files that are missing, with a path of another computer. */
  @Test
  void filesAreSearchedInTheOwnFolderFirst() throws IOException {
    AllowedFolders allowed = allowed("materials");
    assertThat(allowed.similar("C:\\maps\\OWN.png")).containsExactly("maps/own.png");
    List<String> found = allowed.similar("D:/a/x.png");
    assertThat(found).hasSize(1);
    assertFound(allowed, found.get(0), "materials/textures/x.png");
    assertThat(allowed().similar("D:/a/x.png")).isEmpty();
  }

  @Test
  void uploadsGetNoFurtherFolder() throws IOException {
    ModelOptions options =
        ModelOptions.DEFAULT.with(ModelOption.ASSETS, List.of(folder.resolve("materials")));
    String name = "../materials/textures/x.png";
    Path own = folder.resolve("models");
    assertThat(AllowedFolders.of(own, options).find(name)).isPresent();
    assertThat(AllowedFolders.of(own, options.limitedTo(Limits.UPLOADS)).find(name))
        .isEqualTo(Optional.empty());
  }

  @Test
  void aFolderOfAProgramHasThem() throws Exception {
    String name = "../materials/textures/x.png";
    Path own = folder.resolve("models");
    ModelFolder files = ModelFolder.of(own, List.of(folder.resolve("materials")));
    assertThat(files.read(name, "here")).asString().isEqualTo("x");
    assertThatThrownBy(() -> files.read("../secret.png", "here"))
        .isInstanceOf(ModelFormatException.class)
        .hasMessage(
            "here: expected a file inside the model's folder or a further one that is allowed,"
                + " found \"../secret.png\"");
    assertThatThrownBy(() -> ModelFolder.of(own).read(name, "here"))
        .hasMessage("here: expected a file inside the model's folder, found \"" + name + "\"");
  }
}
