package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.testing.Folders;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.lang.ref.WeakReference;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests {@code render} of several scenes. */
class BatchTest {
  private static final String SMALL = " --size 16x12 -s 2";

  @TempDir private Path directory;

  @BeforeEach
  void writeScenes() throws IOException {
    ModelSample.write(directory);
    Files.writeString(directory.resolve("tiny.json"), TinyScene.JSON);
    Files.writeString(directory.resolve("broken.glb"), "glTF and no more");
  }

  /** Returns the words of a command line in which T stands for the directory of the test. */
  private String[] words(String line) {
    return Outcome.words(directory, line);
  }

  private Outcome run(String line) {
    Outcome outcome = Outcome.of(words(line));
    return new Outcome(
        outcome.exitCode(), outcome.out(), outcome.err().replace(directory.toString(), "T"));
  }

  private void copy(String from, String to) throws IOException {
    Path target = directory.resolve(to);
    Files.createDirectories(target.getParent());
    Files.copy(directory.resolve(from), target);
  }

  /** Writes an OBJ model that names a texture. */
  private void writeTextured(String name, String texture) throws IOException {
    Files.writeString(
        directory.resolve(name + ".obj"),
        "mtllib %s.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n"
            .formatted(name));
    Files.writeString(directory.resolve(name + ".mtl"), "newmtl m\nmap_Kd %s\n".formatted(texture));
  }

  @Test
  void picturesHaveTheBitsOfSingleRendersAndTheNamesOfTheirScenes() {
    Outcome batch = run("render T/sample.glb T/tiny.json -o T/a/b --format pfm" + SMALL).done();
    for (String scene : List.of("sample.glb", "tiny.json")) {
      String name = scene.replaceFirst("[.].*", ".pfm");
      assertThat(run("render T/" + scene + " -o T/" + name + SMALL).exitCode()).isZero();
      assertThat(directory.resolve("a/b").resolve(name))
          .hasSameBinaryContentAs(directory.resolve(name));
    }
    assertThat(batch.err().lines().toList().get(0)).startsWith("T/a/b/sample.pfm: 16x12 pixels");
    assertThat(batch.err()).containsPattern("\n2 of 2 pictures written; [0-9]+[.][0-9]{2} s\n$");
  }

  @Test
  void progressOfSeveralScenesIsJsonThatNamesThem() {
    Outcome batch =
        run("render T/sample.glb T/tiny.json -o T/out --quiet --progress json" + SMALL).done();
    List<JsonObject> lines =
        batch.err().lines().map(line -> JsonParser.parseString(line).getAsJsonObject()).toList();
    assertThat(lines.stream().map(line -> line.get("scene").getAsString()).distinct())
        .containsExactly("T/sample.glb", "T/tiny.json");
    assertThat(lines.stream().map(line -> line.get("frame").getAsInt()).distinct())
        .containsExactly(1, 2);
    assertThat(lines).allMatch(line -> line.get("frames").getAsInt() == 2 && line.has("done"));
  }

  @Test
  void oneSceneIsRenderedIntoAFolderToo() throws IOException {
    Files.createDirectory(directory.resolve("made.before"));
    for (String folder : List.of("made.before", "new")) {
      assertThat(run("render T/tiny.json --quiet -o T/" + folder).exitCode()).isZero();
      assertThat(directory.resolve(folder).resolve("tiny.png")).exists();
    }
  }

  @Test
  void aBadSceneDoesNotStopTheOthers() throws IOException {
    Outcome batch = run("render T/broken.glb T/no.json T/tiny.json T/b.gif -o T/out" + SMALL);
    assertThat(batch.exitCode()).isEqualTo(ExitCodes.ASSET);
    List<String> lines = batch.err().lines().toList();
    assertThat(lines.get(0)).startsWith("broken.glb: ");
    assertThat(lines.get(1)).startsWith("no.json: expected a scene file, found none");
    assertThat(lines.get(2)).startsWith("T/out/tiny.png: 16x12 pixels");
    assertThat(lines.get(3)).contains("b.gif");
    assertThat(lines.get(4))
        .startsWith("1 of 4 pictures written, 3 failed: T/broken.glb, T/no.json, T/b.gif; ");
    assertThat(lines).hasSize(5);
    assertThat(Folders.files(directory.resolve("out")))
        .containsExactly(directory.resolve("out/tiny.png"));
  }

  @Test
  void aFolderInWhichNothingIsWrittenVanishes() {
    Outcome batch = run("render T/broken.glb T/no.json -o T/new/out" + SMALL);
    assertThat(batch.exitCode()).isEqualTo(ExitCodes.ASSET);
    assertThat(directory.resolve("new")).doesNotExist();
  }

  @ParameterizedTest
  @CsvSource({
    "tiny.json, sub/tiny.json",
    "tiny.json, sub/TINY.glb",
    "tiny.json, tiny.json",
    "sub/caf\u00e9.json, sub/cafe\u0301.glb"
  })
  void equalNamesAreRefusedBeforeWork(String one, String other) {
    Outcome batch = run("render T/sample.glb T/%s T/%s -o T/out".formatted(one, other));
    batch.assertFailed(ExitCodes.OUTPUT, "T/%s and T/%s: both pictures".formatted(one, other));
    assertThat(directory.resolve("out")).doesNotExist();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "-o T/out --checkpoint T/x.film | --checkpoint: requires one scene, found 2",
        "-o T/out --turntable 3         | --turntable: requires one scene, found 2",
        "-o T/out --dry-run             | --dry-run: requires one scene, found 2",
        "-o T/out.png                   | -o: expected a folder",
        "-o -                           | -o: expected a folder",
        "--quiet                        | T/tiny.json: several scenes require a folder",
        "- -o T/out                     | -: standard input cannot be",
        "-o T/out --view iso            | T/tiny.json: --view: requires a model file",
        "-o T/out --sky-intensity -1    | --sky-intensity: expected",
        "-o T/out --depth -1            | --depth: expected",
        "-o T/out --bogus               | unknown option '--bogus'"
      })
  void flagsThatDoNotSuitAreRefusedBeforeWork(String flags, String message) {
    run("render T/sample.glb T/tiny.json " + flags).assertFailed(ExitCodes.USAGE, message);
    assertThat(directory.resolve("out")).doesNotExist();
  }

  @Test
  void flagsThatDoNotSuitTheContentOfOneSceneFailIt() throws IOException {
    Files.writeString(
        directory.resolve("large.json"), TinyScene.with("\"width\": 16", "\"width\": 160"));
    Outcome batch = run("render T/tiny.json T/large.json --crop 20,0,9,9 -s 1 -o T/out");
    assertThat(batch.exitCode()).isEqualTo(ExitCodes.USAGE);
    assertThat(batch.err())
        .startsWith("lumbre: T/tiny.json: --crop: expected a part of 16x12, found 20,0,9,9\n");
    assertThat(directory.resolve("out/large.png")).exists();
  }

  @Test
  void warningsNameTheScene() throws IOException {
    String camera = "\"localPosition\": {\"x\": 0, \"y\": 1, \"z\": -4}";
    String away = TinyScene.with(camera, "\"localPosition\": {\"x\": 0, \"y\": 1, \"z\": 40}");
    Files.writeString(
        directory.resolve("away.json"), away.replaceAll("(?m)^.*\"(Plane|Cube)\".*\n", ""));
    Outcome batch = run("render T/tiny.json T/away.json -o T/out -s 2 --stats").done();
    assertThat(batch.err())
        .contains("hint: T/away.json: nothing is in view", "T/away.json: samples   ")
        .contains("T/tiny.json: samples   ");
  }

  @Test
  void filesThatAnotherSceneReadsAreNotOverwritten() throws IOException {
    copy("sample.glb", "models/wood.glb");
    assertThat(run("render T/tiny.json -o T/models/wood.png --quiet").exitCode()).isZero();
    Files.move(directory.resolve("models/wood.png"), directory.resolve("wood.png"));
    copy("sample.glb", "wood.glb");
    writeTextured("chair", "wood.png");
    byte[] texture = Files.readAllBytes(directory.resolve("wood.png"));
    Outcome batch = run("render T/wood.glb T/chair.obj -o T" + SMALL);
    batch.assertFailed(
        ExitCodes.OUTPUT, "T/wood.png: is a file of the scene T/chair.obj", "which is read");
    assertThat(directory.resolve("wood.png")).hasBinaryContent(texture);
    assertThat(directory.resolve("chair.png")).doesNotExist();
  }

  @Test
  void scenesAreNotOverwritten() throws IOException {
    copy("sample.glb", "wood.png");
    run("render T/tiny.json T/wood.png -o T" + SMALL)
        .assertFailed(ExitCodes.OUTPUT, "T/wood.png: is the model", "which is read");
    assertThat(directory.resolve("wood.png"))
        .hasSameBinaryContentAs(directory.resolve("sample.glb"));
    assertThat(directory.resolve("tiny.png")).doesNotExist();
  }

  @Test
  void foreignFilesInTheFolderAreFoundFirst() throws IOException {
    Files.createDirectory(directory.resolve("out"));
    Files.writeString(directory.resolve("out/tiny.png"), "a letter");
    run("render T/sample.glb T/tiny.json -o T/out" + SMALL)
        .assertFailed(ExitCodes.OUTPUT, "T/out/tiny.png: exists and is not a PNG");
    assertThat(directory.resolve("out/sample.png")).doesNotExist();
  }

  @Test
  void summariesInJsonAreALineForEachScene() {
    Outcome batch = run("render T/tiny.json T/broken.glb -o T/out --json --quiet" + SMALL);
    assertThat(batch.exitCode()).isEqualTo(ExitCodes.ASSET);
    assertThat(batch.out().lines().map(JsonParser::parseString))
        .extracting(line -> line.getAsJsonObject().get("exit_code").getAsInt())
        .containsExactly(ExitCodes.OK, ExitCodes.ASSET);
  }

  @Test
  void oneTimeoutEndsTheBatchAndCountsWhatIsNotBegun() throws IOException {
    copy("tiny.json", "sub/b.json");
    copy("tiny.json", "sub/c.json");
    Outcome batch =
        run(
            "render T/no.json T/tiny.json T/sub/b.json T/sub/c.json -o T/out -s 100000000"
                + " --timeout 2s");
    assertThat(batch.exitCode()).isEqualTo(ExitCodes.LIMIT);
    assertThat(batch.err())
        .endsWith(
            "lumbre: --timeout: the time ended after 0 of 4 pictures: T/out/tiny.png is partial,"
                + " 2 not rendered: T/out/b.png to T/out/c.png, 1 failed: T/no.json\n");
    assertThat(directory.resolve("out/tiny.png")).exists();
  }

  @Test
  void scenesAreGarbageWhenTheNextOneIsRendered() throws IOException {
    for (String name : List.of("a", "b", "c")) {
      copy("sample.glb", "models/" + name + ".glb");
    }
    List<WeakReference<Scene>> scenes = new ArrayList<>();
    List<Long> alive = new ArrayList<>();
    int exitCode =
        Lumbre.run(
            words(
                "render T/models/a.glb T/models/b.glb T/models/c.glb T/tiny.json -o T/out" + SMALL),
            new PrintWriter(new StringWriter()),
            new PrintWriter(new StringWriter()),
            (path, file, local, isTimed) -> {
              System.gc();
              alive.add(scenes.stream().filter(scene -> scene.get() != null).count());
              scenes.add(new WeakReference<>(file.scene()));
              return local;
            });
    assertThat(exitCode).isZero();
    assertThat(alive).containsExactly(0L, 0L, 0L, 0L);
  }
}
