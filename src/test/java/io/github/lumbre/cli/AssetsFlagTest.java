package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.model.format.gltf.GltfFile;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Models whose pictures and buffers lie beside their own folder. */
class AssetsFlagTest extends CommandFixture {
  private static final String FLAGS =
      " --size 16x16 -s 1 --no-denoise --view front --quiet --overwrite";

  private static final String ASSETS = " --assets T/materials";

  @BeforeEach
  void write() throws IOException {
    Files.createDirectories(directory.resolve("models"));
    Files.createDirectories(directory.resolve("materials/textures"));
    byte[] red = Pixels.of(1, 1, 3, new byte[] {(byte) 255, 0, 0}).toPng();
    Files.write(directory.resolve("materials/textures/x.png"), red);
    String text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl m\nf 1/1 2/2 3/3\n";
    Files.writeString(directory.resolve("models/a.obj"), "mtllib a.mtl\n" + text);
    Files.writeString(
        directory.resolve("models/a.mtl"), "newmtl m\nmap_Kd ../materials/textures/x.png\n");
    Files.writeString(directory.resolve("red.obj"), "mtllib red.mtl\n" + text);
    Files.writeString(directory.resolve("red.mtl"), "newmtl m\nmap_Kd x.png\n");
    Files.write(directory.resolve("x.png"), red);
  }

  private void succeeds(String line) {
    Outcome outcome = run(line).done();
    assertThat(outcome.err()).isEmpty();
  }

  @Test
  void picturesOfNamedFoldersAreShown() throws IOException {
    succeeds("render T/red.obj -o T/expected.pfm" + FLAGS);
    succeeds("render T/models/a.obj -o T/a.pfm" + FLAGS + ASSETS);
    assertSame("expected.pfm", "a.pfm");
    assertThat(run("check T/models/a.obj" + ASSETS).out()).contains("textures   1\n");
    succeeds("check T/models/a.obj --strict --assets T/models --assets T/materials/textures");
    assertThat(run("check T/models/a.obj").err()).contains("inside the model's folder");
    assertThat(run("diff T/models/a.obj T/models/a.obj" + ASSETS).err()).isEmpty();
  }

  @Test
  void buffersOfNamedFoldersAreRead() throws IOException {
    GltfFile file = GltfFile.ofTriangle();
    Files.write(directory.resolve("models/b.gltf"), file.gltf("../materials/b.bin"));
    Files.write(directory.resolve("materials/b.bin"), file.buffer());
    succeeds("check T/models/b.gltf --strict" + ASSETS);
    run("check T/models/b.gltf").assertFailed(ExitCodes.ASSET, "inside the model's folder");
  }

  /** The picture of a sky widens the folder of the scene, but not that of the model. */
  @Test
  void aSkyNamesNoFolderOfTheModel() {
    succeeds("render T/red.obj -o T/materials/sky.pfm" + FLAGS);
    assertThat(run("check T/models/a.obj --sky T/materials/sky.pfm").err())
        .contains("inside the model's folder");
    succeeds("check T/models/a.obj --strict --sky T/materials/sky.pfm" + ASSETS);
  }

  @Test
  void aFilmIsResumedWithTheSameFolders() throws IOException {
    String film = " --checkpoint T/a.film";
    succeeds("render T/models/a.obj -o T/a.pfm" + film + FLAGS + ASSETS);
    run("resume T/a.film -s 2 --quiet").assertFailed(ExitCodes.SCENE, "x.png", "--assets");
    succeeds("resume T/a.film -s 2 --quiet" + ASSETS);
    succeeds("render T/models/a.obj -o T/b.pfm" + FLAGS.replace("-s 1", "-s 2") + ASSETS);
    assertSame("a.pfm", "b.pfm");
  }

  @Test
  void filesOfNamedFoldersAreNotReplaced() throws IOException {
    run("render T/models/a.obj -o T/materials/textures/x.png" + FLAGS + ASSETS)
        .assertFailed(ExitCodes.OUTPUT, "x.png");
    Path texture = directory.resolve("materials/textures/red.png");
    Files.copy(directory.resolve("x.png"), texture);
    Files.writeString(
        directory.resolve("models/a.mtl"), "newmtl m\nmap_Kd ../materials/textures/red.png\n");
    run("render T/red.obj T/models/a.obj -o T/materials/textures" + FLAGS + ASSETS)
        .assertFailed(ExitCodes.OUTPUT, "red.png");
    assertThat(texture).hasSameBinaryContentAs(directory.resolve("x.png"));
  }

  @Test
  void foldersAreChecked() throws IOException {
    run("check T/models/a.obj --assets T/no").assertFailed(2, "--assets: expected a folder, found");
    run("check T/models/a.obj --assets T/x.png").assertFailed(2, "found a file");
    run("resume T/a.film --assets T/no").assertFailed(2, "--assets: expected a folder, found none");
    run("import T/models/a.obj -o T/a.json" + ASSETS).assertFailed(2, "--assets: cannot be used");
    Files.writeString(directory.resolve("s.json"), "{}");
    run("check T/s.json" + ASSETS).assertFailed(2, "--assets: requires a model file");
  }
}
