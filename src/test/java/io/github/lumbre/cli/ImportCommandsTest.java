package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.output.ExitCodes;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests {@code --import-with}, with a script that notes each conversion. */
@DisabledOnOs(OS.WINDOWS)
class ImportCommandsTest extends CommandFixture {
  private static final String SMALL = " --size 16x12 -s 1 --no-denoise";
  private static final String COPY = "cp \"$(dirname \"$1\")/sample.glb\" \"$2\"\n";

  /** A conversion with other bytes. */
  private static final String OTHER = COPY + "printf '\\0\\0\\0\\0' >> \"$2\"\n";

  @BeforeEach
  void writeModel() throws IOException {
    ModelSample.write(directory);
    Files.writeString(directory.resolve("a.fbx"), "a model");
    tool(COPY);
  }

  private void tool(String script) throws IOException {
    Path file = directory.resolve("tool");
    Files.writeString(file, "#!/bin/sh\necho \"$1\" >> \"$(dirname \"$1\")/calls\"\n" + script);
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rwxr-xr-x"));
  }

  private Outcome imports(String line) {
    Stream<String> words = Stream.of(Outcome.words(directory, line));
    Stream<String> flag = Stream.of("--import-with", path("tool") + " {in} {out}");
    return Outcome.of(Stream.concat(words, flag).toArray(String[]::new));
  }

  private void assertImports(String line) {
    Outcome outcome = imports(line);
    assertThat(outcome.exitCode()).as(outcome.err()).isZero();
  }

  private List<String> calls() throws IOException {
    Path calls = directory.resolve("calls");
    return Files.exists(calls) ? Files.readAllLines(calls) : List.of();
  }

  @Test
  void aConvertedModelHasThePictureOfTheGlb() throws IOException {
    assertImports("render T/a.fbx -o T/a.png" + SMALL);
    runs("render T/sample.glb -o T/b.png" + SMALL);
    assertThat(pixels("a.png")).isEqualTo(pixels("b.png"));
    assertThat(texts("a.png").get("Scene")).isEqualTo("a.fbx");
    assertThat(calls()).containsExactly(directory.toRealPath().resolve("a.fbx").toString());
  }

  @Test
  void eachCommandConvertsOnce() throws IOException {
    assertImports("render T/a.fbx -o T/a.gif --turntable 3" + SMALL);
    assertThat(calls()).hasSize(1);
    assertImports("views T/a.fbx -o T/views" + SMALL);
    assertThat(calls()).hasSize(2);
    assertImports("render T/a.fbx -o T/b.gif --animation lift --fps 2" + SMALL);
    assertThat(calls()).hasSize(3);
    assertThat(imports("check T/a.fbx").out()).contains("animations");
    assertThat(calls()).hasSize(4);
    Files.writeString(directory.resolve("b.fbx"), "another model");
    Files.createDirectory(directory.resolve("both"));
    assertImports("render T/a.fbx T/b.fbx -o T/both" + SMALL);
    assertThat(calls()).hasSize(6);
  }

  /** Another conversion of the same file may have other bytes. */
  @ParameterizedTest
  @ValueSource(strings = {"", " --look lines"})
  void framesAreContinuedByTheSameConversion(String look) throws IOException {
    String line = "render T/a.fbx -o T/a.png --turntable 2 --continue" + SMALL + look;
    assertImports(line);
    assertThat(imports(line).err()).contains("2 were complete");
    tool("printf '\\n' > /dev/null\n" + COPY);
    assertThat(imports(line).err()).contains("2 were complete").doesNotContain("warning");
    byte[] first = Files.readAllBytes(directory.resolve("a-000.png"));
    tool(OTHER);
    imports(line)
        .assertFailed(
            ExitCodes.USAGE,
            path("a-000.png")
                + ": cannot be continued: the program of --import-with has converted the model to"
                + " other bytes than now");
    assertThat(directory.resolve("a-000.png")).hasBinaryContent(first);
    Files.writeString(directory.resolve("a.fbx"), "another model");
    imports(line).assertFailed(ExitCodes.USAGE, "its scene is another one");
  }

  /** What a program reads beside the model shows in what it writes. */
  @Test
  void aChangedFileBesideTheModelIsNoticed() throws IOException {
    Path texture = Files.writeString(directory.resolve("a.tex"), "\0\0\0\0");
    tool(COPY + "cat \"$(dirname \"$1\")/a.tex\" >> \"$2\"\n");
    String line = "render T/a.fbx -o T/a.png --turntable 2 --continue" + SMALL;
    assertImports(line);
    assertImports(line);
    Files.writeString(texture, "\0\0\0\0\0\0\0\0");
    imports(line).assertFailed(ExitCodes.USAGE, "or a file that it reads beside the model");
  }

  /** Jobs of an array convert on machines of their own. */
  @Test
  void partsThatConvertDifferentlyAreNotJoined() throws IOException {
    String line = "render T/a.fbx -o T/a.gif --turntable 4" + SMALL;
    assertImports(line + " --frames 0/2");
    tool(OTHER);
    assertImports(line + " --frames 1/2");
    for (String tool : List.of(OTHER, COPY)) {
      tool(tool);
      imports(line + " --continue")
          .assertFailed(ExitCodes.USAGE, "has converted the model to other bytes than now");
    }
    assertThat(directory.resolve("a.gif")).doesNotExist();
  }

  /** A checkpoint file holds no program: the flag is stated again. */
  @Test
  void filmsAreResumedByTheSameConversion() throws IOException {
    assertImports("render T/a.fbx -o T/a.png -s 4 --size 16x12 --no-denoise");
    assertImports("render T/a.fbx -o T/b.png -s 2 --size 16x12 --checkpoint T/a.film");
    run("resume T/a.film -s 4 -o T/b.png")
        .assertFailed(ExitCodes.USAGE, "--import-with: required as when rendering began");
    assertImports("resume T/a.film -s 4 -o T/b.png");
    assertThat(pixels("b.png")).isEqualTo(pixels("a.png"));
    tool(OTHER);
    imports("resume T/a.film -s 8 -o T/b.png")
        .assertFailed(ExitCodes.SCENE, "converted " + path("a.fbx") + " to other bytes");
    Files.writeString(directory.resolve("a.fbx"), "another model");
    tool(COPY);
    imports("resume T/a.film -s 8 -o T/b.png").assertFailed(ExitCodes.SCENE, "a.fbx has changed");
    runs("render T/sample.glb -o T/c.png -s 2 --size 16x12 --checkpoint T/c.film");
    imports("resume T/c.film -s 4").assertFailed(ExitCodes.USAGE, "--import-with: cannot be used");
  }

  @Test
  void sharesThatConvertDifferentlyAreNotMerged() throws IOException {
    String share = "render T/a.fbx -o T/s.png -s 4 --size 16x12 --no-denoise --checkpoint T/s";
    assertImports("render T/a.fbx -o T/a.png -s 4 --size 16x12 --no-denoise");
    assertImports(share + "0.film --share 0/2");
    assertImports(share + "1.film --share 1/2");
    runs("merge T/s0.film T/s1.film -o T/b.png");
    assertThat(pixels("b.png")).isEqualTo(pixels("a.png"));
    tool(OTHER);
    assertImports(share + "2.film --share 1/2");
    run("merge T/s0.film T/s2.film -o T/b.png --overwrite")
        .assertFailed(ExitCodes.SCENE, "converted-model-hash: ");
  }

  @Test
  void failuresHaveTheirCodeAndCause() throws IOException {
    String line = "render T/a.fbx -o T/a.png" + SMALL;
    tool("echo broken; exit 3\n");
    imports(line)
        .assertFailed(
            ExitCodes.ASSET,
            path("a.fbx")
                + ": cannot be imported: "
                + path("tool")
                + ": failed with code 3: broken");
    tool("exit 0\n");
    imports(line).assertFailed(ExitCodes.ASSET, "left no GLB: no file");
    tool("printf 'glTF is a lie' > \"$2\"\n");
    imports(line).assertFailed(ExitCodes.ASSET, "a.fbx: ");
    tool("sleep 3600\n");
    imports(line + " --timeout 1s").assertFailed(ExitCodes.LIMIT, "--timeout: the time ended");
    imports("render T/none.fbx -o T/a.png")
        .assertFailed(ExitCodes.SCENE, "none.fbx: does not exist");
    assertThat(directory.resolve("a.png")).doesNotExist();
  }

  @Test
  void whatDoesNotSuitIsRefused() throws IOException {
    TinyScene.write(directory, TinyScene.JSON);
    imports("render T/tiny.json -o T/a.png").assertFailed(ExitCodes.USAGE, "--import-with");
    imports("render - -o T/a.png").assertFailed(ExitCodes.USAGE, "--import-with");
    run("render T/a.fbx -o T/a.png --import-with tool")
        .assertFailed(ExitCodes.USAGE, "--import-with: expected one of assimp, blender, step");
    run("render T/a.fbx -o T/a.png --import-with assimp=T/none")
        .assertFailed(ExitCodes.USAGE, "--import-with: ");
    run("render T/a.fbx -o T/a.png --import-with T/tool")
        .assertFailed(ExitCodes.USAGE, "--import-with: expected '/path/program {in} {out}'");
    assertThat(calls()).isEmpty();
  }

  /** Neither a file, nor the environment, nor another command starts a program. */
  @Test
  void onlyTheFlagStartsAProgram() throws IOException {
    run("render T/a.fbx -o T/a.png").assertFailed(ExitCodes.SCENE, "a.fbx: expected a scene");
    for (String command : List.of("view", "audit", "import", "trade", "mcp")) {
      assertThat(imports(command + " T/a.fbx").exitCode()).isEqualTo(ExitCodes.USAGE);
    }
    assertThat(calls()).isEmpty();
  }

  @Test
  void theAxisAndTheUnitAreCorrected() {
    String before = imports("check T/a.fbx").out();
    String after = imports("check T/a.fbx --up z --unit 0.5").out();
    assertThat(before).contains("bounds     (5, 1, -2) to (6, 2, -1)");
    assertThat(after).contains("bounds     (2.5, -1, -1) to (3, -0.5, -0.5)");
  }
}
