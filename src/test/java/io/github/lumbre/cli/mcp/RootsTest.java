package io.github.lumbre.cli.mcp;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowable;

import io.github.lumbre.model.ModelFolder;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that paths are confined to the roots before the file system sees them. */
class RootsTest {
  private static final int MOST = 10;

  @TempDir private Path temporary;
  private Path folder;
  private Path model;

  @BeforeEach
  void files() throws IOException {
    folder = Files.createDirectory(temporary.toRealPath().resolve("parts"));
    model = Files.write(folder.resolve("a.stl"), new byte[1]);
  }

  /** The message would otherwise tell which files exist outside, and how large they are. */
  @ParameterizedTest
  @ValueSource(strings = {"../secret.bin", "x/../../secret.bin", "ABSOLUTE"})
  void sizesOfFilesOutsideAreNotRevealed(String name) throws IOException {
    Path secret = folder.resolveSibling("secret.bin");
    String used = name.replace("ABSOLUTE", secret.toString());
    ModelFolder files = Roots.folderOf(model, MOST);
    Throwable missing = catchThrowable(() -> files.read(used, "here"));
    Files.write(secret, new byte[2 * MOST]);
    assertThatThrownBy(() -> files.read(used, "here"))
        .hasMessage(missing.getMessage())
        .hasMessageContaining("expected a file inside the model's folder");
  }

  @Test
  void largeFilesInsideAreRefused() throws Exception {
    Files.write(folder.resolve("large.bin"), new byte[MOST + 1]);
    Files.write(folder.resolve("small.bin"), new byte[MOST]);
    ModelFolder files = Roots.folderOf(model, MOST);
    assertThat(files.read("small.bin", "here")).hasSize(MOST);
    assertThatThrownBy(() -> files.read("large.bin", "here"))
        .hasMessageContaining("expected at most 10 bytes, found more");
  }

  /** A link outside leads back to the file, which shows whether it was followed. */
  @Test
  @DisabledOnOs(OS.WINDOWS)
  void linksOutsideAreNotFollowed() throws Exception {
    Path link = Files.createSymbolicLink(folder.resolveSibling("link"), folder);
    Roots roots = new Roots(List.of(folder));
    assertThat(roots.file("a.stl")).isEqualTo(model);
    assertThat(roots.file(model.toString())).isEqualTo(model);
    assertThat(roots.file("x/../a.stl")).isEqualTo(model);
    for (String name : List.of("../link/a.stl", link.resolve("a.stl").toString())) {
      assertThatThrownBy(() -> roots.file(name)).hasMessageContaining("expected a file in ");
    }
  }

  @Test
  @DisabledOnOs(OS.WINDOWS)
  void rootsMayBeNamedByLinks() throws Exception {
    Path link = Files.createSymbolicLink(folder.resolveSibling("link"), folder);
    Roots roots = new Roots(List.of(link));
    for (Path name : List.of(model, link.resolve("a.stl"), Path.of("a.stl"))) {
      assertThat(roots.file(name.toString())).isEqualTo(model);
    }
  }
}
