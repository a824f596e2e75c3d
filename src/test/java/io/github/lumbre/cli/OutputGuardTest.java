package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.testing.Folders;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.OptionSpec;

/** No command overwrites its input or a file of a different type. */
@DisabledOnOs(OS.WINDOWS)
class OutputGuardTest extends CommandFixture {
  /** Paths that commands only read, or in which they only create files with new names. */
  private static final Set<String> INPUTS =
      Set.of(
          "render SCENE",
          "render --fallback-dir",
          "resume --fallback-dir",
          "resume --scene",
          "merge FILM",
          "develop FILM",
          "check SCENE",
          "audit SCENE",
          "import MODEL",
          "pixel SCENE",
          "benchmark --scenes",
          "perf SCENE",
          "coverage SCENE",
          "compare PICTURE",
          "compare REFERENCE",
          "diff OLD",
          "diff NEW",
          "mcp --root",
          "layers FILE",
          "denoise FILE",
          "render --oidn",
          "render --ffmpeg",
          "develop --oidn",
          "merge --oidn",
          "denoise --oidn",
          "view SCENE",
          "view --compare",
          "views MODEL",
          "views --oidn",
          "trade SCENE",
          "render --assets",
          "view --assets",
          "resume --assets",
          "views --assets",
          "import --assets",
          "check --assets",
          "coverage --assets",
          "audit --assets",
          "pixel --assets",
          "diff --assets",
          "trade --assets");

  /** A command line for each path that commands write; OUT is the output. */
  private static final Map<String, String> OUTPUTS =
      Map.ofEntries(
          Map.entry("render --output", "render T/wood.json -o OUT.png"),
          Map.entry("render --sheet", "render T/wood.json T/mesh.obj --sheet OUT.png"),
          Map.entry("render --checkpoint", "render T/wood.json -o T/b.png --checkpoint OUT"),
          Map.entry("resume FILM", "resume OUT"),
          Map.entry("resume --output", "resume T/a.film -o OUT.png"),
          Map.entry("merge --output", "merge T/a.film -o OUT.png"),
          Map.entry("import --output", "import T/mesh.obj -o OUT"),
          Map.entry("develop --output", "develop T/a.film -o OUT.png"),
          Map.entry("benchmark --csv", "benchmark --scenes T --rows 3 --csv OUT"),
          Map.entry("perf --json", "perf T/wood.json --json OUT"),
          Map.entry("compare --error-map", "compare T/a.png T/a.png --error-map OUT.png"),
          Map.entry("diff --output", "diff T/mesh.obj T/mesh.obj -o OUT.html"),
          Map.entry("denoise --output", "denoise T/a.film -o OUT.png"),
          Map.entry("layers --png", "layers T/a.film --png OUT"),
          Map.entry("trade --output", "trade T/wood.json -o OUT.html"),
          Map.entry("views --output", "views T/mesh.obj -o OUT"));

  @BeforeEach
  void writeFiles() throws IOException {
    ImageIO.write(new BufferedImage(1, 1, 1), "png", directory.resolve("wood.png").toFile());
    Files.writeString(directory.resolve("mesh.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    String texture = "{\"id\": 8, \"assetType\": \"Texture\", \"file\": \"wood.png\"},";
    String mesh = "{\"id\": 9, \"assetType\": \"Mesh\", \"file\": \"mesh.obj\"}";
    Files.writeString(directory.resolve("wood.json"), TinyScene.withAsset(texture + mesh));
    Files.writeString(directory.resolve("notes"), "# What somebody has written\n");
    TinyTable.write(directory);
    run("render T/wood.json -o T/a.png --checkpoint T/a.film");
  }

  private Map<String, String> files() throws IOException {
    Map<String, String> files = new TreeMap<>();
    for (Path file : Folders.below(directory, "")) {
      String content = Base64.getEncoder().encodeToString(Files.readAllBytes(file));
      files.put(directory.relativize(file).toString(), content);
    }
    return files;
  }

  private void assertRefused(String line, String... parts) throws IOException {
    Map<String, String> before = files();
    run(line).assertFailed(ExitCodes.OUTPUT, parts);
    assertThat(files()).isEqualTo(before);
  }

  @Test
  void everyPathOnTheCommandLineIsKnownAsInputOrOutput() {
    Set<String> found = new TreeSet<>();
    addPaths("", Lumbre.commandLine(), found);
    Set<String> known = new TreeSet<>(INPUTS);
    known.addAll(OUTPUTS.keySet());
    assertThat(found).isEqualTo(known);
  }

  private static void addPaths(String prefix, CommandLine parent, Set<String> found) {
    parent
        .getSubcommands()
        .forEach(
            (name, command) -> {
              command.getCommandSpec().args().stream()
                  .filter(OutputGuardTest::isPath)
                  .forEach(arg -> found.add(prefix + name + " " + label(arg)));
              addPaths(prefix + name + " ", command, found);
            });
  }

  private static boolean isPath(ArgSpec arg) {
    return arg.type() == Path.class || Stream.of(arg.auxiliaryTypes()).anyMatch(Path.class::equals);
  }

  private static String label(ArgSpec arg) {
    return arg instanceof OptionSpec option ? option.longestName() : arg.paramLabel();
  }

  static Stream<String> commands() {
    Set<String> folders = Set.of("layers --png", "views --output");
    return OUTPUTS.keySet().stream().filter(name -> !folders.contains(name)).sorted();
  }

  /** The output is a link to a foreign file, which must not be replaced silently. */
  @ParameterizedTest
  @MethodSource("commands")
  void aFileOfAnotherKindIsRefused(String output) throws IOException {
    String line = OUTPUTS.get(output);
    for (String ending : new String[] {"", ".png", ".html"}) {
      Files.copy(directory.resolve("notes"), directory.resolve("own" + ending));
    }
    Map<String, String> before = files();
    Outcome outcome = run(line.replace("OUT", "T/own"));
    assertThat(outcome.err()).contains("/own").hasLineCount(1);
    boolean isReadFirst = output.equals("resume FILM");
    assertThat(outcome.exitCode()).isEqualTo(isReadFirst ? ExitCodes.SCENE : ExitCodes.OUTPUT);
    boolean isNeverReplaced = output.equals("render --checkpoint") || isReadFirst;
    assertThat(outcome.err().contains("--overwrite")).isEqualTo(!isNeverReplaced);
    assertThat(files()).isEqualTo(before);
  }

  @ParameterizedTest
  @CsvSource({
    "render T/wood.json -o T/wood.png, a file of the scene",
    "render T/wood.json -o T/x.png --checkpoint T/wood.json, is the scene",
    "render T/wood.json -o T/x.png --checkpoint T/mesh.obj, a file of the scene",
    "render T/wood.json -o T/x.png --checkpoint T/x.png, is written twice",
    "resume T/a.film -o T/wood.png, a file of the scene",
    "merge T/a.film -o T/a.film, is a checkpoint file",
    "compare T/a.png T/wood.png --error-map T/wood.png, is the reference",
    "trade T/wood.json -o T/wood.html, is the scene",
    "benchmark --scenes T --rows 3 --csv T/table.csv, is the table",
    "benchmark --scenes T --rows 3 --csv T/tiny.json, is the scene",
    "benchmark --scenes T --rows 3 --csv T/table-hashes.csv, is the file of hashes",
    "benchmark --scenes T --rows 3 --store --csv T/table-hashes.csv, is written twice",
    "perf T/wood.json --json T/wood.json, is the scene",
    "perf T/wood.json --json T/mesh.obj, a file of the scene"
  })
  void inputsAreNeverOverwritten(String line, String reason) throws IOException {
    Files.writeString(directory.resolve("x-noise.svg"), "");
    assertRefused(line, reason, "choose another path with");
    assertRefused(line + " --overwrite", reason, "choose another path with");
  }

  @Test
  void viewsReplaceNoTextureOfTheModel() throws IOException {
    Files.copy(directory.resolve("wood.png"), directory.resolve("front.png"));
    Files.writeString(directory.resolve("own.mtl"), "newmtl a\nmap_Kd front.png\n");
    Files.writeString(
        directory.resolve("own.obj"),
        "mtllib own.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl a\nf 1/1 2/1 3/1\n");
    assertRefused("views T/own.obj -o T", "front.png", "choose another path with -o");
    assertRefused("views T/own.obj -o T --overwrite", "front.png");
  }

  @ParameterizedTest
  @CsvSource({
    "wood.png, render T/wood.json -o LINK.png",
    "wood.json, render T/wood.json -o LINK.png",
    "mesh.obj, render T/wood.json -o LINK.png",
    "wood.png, resume T/a.film -o LINK.png",
    "a.film, resume T/a.film -o LINK.png",
    "a.film, merge T/a.film -o LINK.png",
    "a.film, merge T/a.film -o LINK.film",
    "a.film, develop T/a.film -o LINK.png",
    "a.png, compare T/wood.png T/a.png --error-map LINK.png",
    "wood.json, trade T/wood.json -o LINK.html",
    "wood.json, perf T/wood.json --json LINK.json",
    "table.csv, benchmark --scenes T --rows 3 --csv LINK.csv"
  })
  void linksToInputsAreFollowed(String victim, String line) throws IOException {
    Path links = Files.createDirectories(directory.resolve("links"));
    Path input = directory.resolve(victim);
    for (String ending : new String[] {"png", "html", "csv", "json", "film"}) {
      Path link = links.resolve("wood." + ending);
      Files.createSymbolicLink(link, input);
    }
    String real = line.replace("LINK", "T/links/wood");
    assertRefused(real, "links/wood", victim, "choose another path");
    for (String ending : new String[] {"png", "html", "csv", "json", "film"}) {
      Path link = links.resolve("wood." + ending);
      Files.delete(link);
      Files.createLink(link, input);
    }
    assertRefused(real, "links/wood", victim, "choose another path");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "render T/wood.json -o T/new/folder/x.png",
        "render T/wood.json -o T/y.png --checkpoint T/new/folder/x.film",
        "develop T/a.film -o T/new/folder/x.png",
        "merge T/a.film -o T/new/folder/x.film",
        "compare T/a.png T/a.png --error-map T/new/folder/x.png"
      })
  void missingFoldersOfOutputsAreMade(String line) throws IOException {
    assertThat(run(line).exitCode()).isZero();
    assertThat(directory.resolve("new/folder")).isNotEmptyDirectory();
    assertRefused(
        line.replace("new/folder", "notes/folder"),
        "notes/folder/x.",
        "/notes/folder cannot be created: ");
  }

  @Test
  void oneNewFileThroughALinkedFolderIsOneFile() throws IOException {
    Files.createSymbolicLink(directory.resolve("other"), directory);
    assertRefused("render T/wood.json -o T/x.png --checkpoint T/other/x.png", "is written twice");
  }

  @Test
  void theHiddenFileOfAnOutputIsAnOutputToo() throws IOException {
    Files.copy(directory.resolve("wood.png"), directory.resolve(".x.png.tmp"));
    Path scene = directory.resolve("wood.json");
    Files.writeString(scene, Files.readString(scene).replace("wood.png", ".x.png.tmp"));
    assertRefused("render T/wood.json -o T/x.png", ".x.png.tmp");
  }

  @ParameterizedTest
  @CsvSource({
    "render T/wood.json -o T/own",
    "resume T/a.film -s 3 -o T/own",
    "merge T/a.film -o T/own",
    "develop T/a.film -o T/own",
    "compare T/a.png T/a.png --error-map T/own"
  })
  void picturesReplacePicturesAndWithTheFlagAnything(String line) throws IOException {
    Path own = directory.resolve("own.png");
    String command = line.replace("T/own", "T/own.png");
    Files.copy(directory.resolve("notes"), own);
    assertThat(run(command + " --overwrite").exitCode()).isZero();
    assertThat(ImageIO.read(own.toFile()).getWidth()).isPositive();
    assertThat(run(command).exitCode()).isZero();
    Files.write(own, new byte[0]);
    assertThat(run(command).exitCode()).isZero();
  }

  @Test
  void animationsReplaceAnimationsAndPictures() throws IOException {
    String line = "render T/wood.json T/wood.json -s 1 --size 8x6 -o T/own.apng";
    Path own = directory.resolve("own.apng");
    Files.copy(directory.resolve("notes"), own);
    assertRefused(line, "own.apng: exists and is not a GIF, PNG, MP4 or WebM file");
    Files.copy(directory.resolve("wood.png"), own, StandardCopyOption.REPLACE_EXISTING);
    for (String start : List.of("GIF89a", "....ftypmp42", "\u001aE\u00df\u00a3")) {
      assertThat(run(line).exitCode()).isZero();
      Files.writeString(own, start, StandardCharsets.ISO_8859_1);
    }
    assertThat(run(line).exitCode()).isZero();
  }

  @Test
  void commandsReplaceWhatTheyHaveWritten() throws IOException {
    Stream.of(
            "merge T/a.film -o T/b.film",
            "perf T/wood.json -s 1 --size 8x8 --warmup 0 --repeat 1 --pairs 1 --threads 1"
                + " --json T/bench.json",
            "benchmark --scenes T --rows 3 --warmup 0 --scale 0.1 --store --csv T/new.csv",
            "trade T/wood.json -s 1 --seeds 3 --size 8x8 --knobs sampler -o T/study.html")
        .forEach(
            line -> {
              Outcome first = run(line).done();
              Outcome second = run(line).done();
            });
    assertThat(files().keySet()).noneMatch(name -> name.endsWith(".tmp"));
  }
}
