package io.github.lumbre.spark;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.image.LayeredImage;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Pictures from Spark in this process are bit-identical to those of the command line. */
class RenderOnSparkTest {
  private static final String SCENES = Path.of("..", "scenes").toString() + "/";

  @TempDir private Path directory;

  /** The exit code and the texts of a command. */
  record Outcome(int exitCode, String out, String err) {}

  @BeforeEach
  void useTwoCores() {
    System.setProperty("spark.master", "local[2]");
    System.setProperty("spark.ui.enabled", "false");
    System.setProperty("spark.driver.host", "localhost");
  }

  @AfterEach
  void forget() {
    List.of("spark.master", "spark.ui.enabled", "spark.driver.host").forEach(System::clearProperty);
  }

  private String path(String name) {
    return directory.resolve(name).toString();
  }

  private byte[] bytes(String name) throws IOException {
    return Files.readAllBytes(directory.resolve(name));
  }

  private static Outcome onSpark(String... args) {
    return onSpark(Arrays.asList(args));
  }

  private static Outcome onSpark(List<String> args) {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    int code = RenderOnSpark.run(args, new PrintWriter(out, true), new PrintWriter(err, true));
    return new Outcome(code, out.toString(), err.toString());
  }

  private static Outcome here(String... args) {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    int code =
        io.github.lumbre.cli.Lumbre.run(
            args,
            new PrintWriter(out, true),
            new PrintWriter(err, true),
            io.github.lumbre.cli.run.Engine.LOCAL);
    return new Outcome(code, out.toString(), err.toString());
  }

  private static void assertDone(Outcome outcome) {
    assertThat(outcome.exitCode()).as(outcome.err()).isZero();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "cornell-box.json -s 11 --size 70x50",
        "cornell-box.json -s 5 --size 70x50 --mode ray",
        "camera-fisheye.json -s 9 --size 64x48",
        "camera-fisheye.json -s 5 --size 64x48 --mode ray",
        "glass-and-mirror.json -s 7 --size 60x40 --split 3 --filter gaussian",
        "glass-and-mirror.json -s 4 --size 60x40 --mode ray",
        "torus-knot.json -s 12 --size 80x45 --crop 11,7,50,30",
        "torus-knot.json -s 4 --size 80x45 --mode ray --seed 9",
        "table-12-wood.json -s 3 --size 48x48 --depth 3",
        "table-12-wood.json -s 3 --size 48x48 --mode ray"
      })
  void picturesAreBitIdentical(String line) throws IOException {
    List<String> args = new ArrayList<>(List.of(line.split(" ")));
    args.set(0, SCENES + args.get(0));
    List<String> here = new ArrayList<>(args);
    here.add(0, "render");
    here.addAll(List.of("-o", path("here.pfm")));
    assertDone(here(here.toArray(String[]::new)));
    args.addAll(List.of("-o", path("spark.pfm"), "--unit", "0.1s"));
    assertDone(onSpark(args));
    assertThat(bytes("spark.pfm")).isEqualTo(bytes("here.pfm"));
  }

  @Test
  void targetErrorStopsAtTheSamplesOfOneMachine() throws IOException {
    String[] args = {SCENES + "table-15-frog.json", "--size", "64x64", "--target-error", "4%"};
    List<String> here = new ArrayList<>(List.of("render"));
    here.addAll(List.of(args));
    here.addAll(List.of("-o", path("here.pfm")));
    Outcome local = here(here.toArray(String[]::new));
    List<String> spark = new ArrayList<>(List.of(args));
    spark.addAll(List.of("-o", path("spark.pfm"), "--unit", "0.1s"));
    Outcome outcome = onSpark(spark);
    assertDone(outcome);
    assertThat(bytes("spark.pfm")).isEqualTo(bytes("here.pfm"));
    assertThat(noise(outcome.err())).isNotEmpty().isEqualTo(noise(local.err()));
  }

  private static String noise(String text) {
    return text.replaceAll("(?s).*, (\\d+ samples per pixel, noise about [^,]*),.*", "$1");
  }

  @Test
  void checkpointsAreResumedHereAndThere() throws IOException {
    String scene = SCENES + "cornell-box.json";
    String[] size = {"--size", "40x40"};
    assertDone(here("render", scene, "-s", "24", size[0], size[1], "-o", path("whole.pfm")));
    assertDone(
        onSpark(
            scene, "-s", "6", size[0], size[1], "-o", path("a.pfm"), "--checkpoint", path("a")));
    assertDone(here("resume", path("a"), "-s", "13"));
    assertDone(onSpark("resume", path("a"), "-s", "24", "--unit", "0.1s"));
    assertThat(bytes("a.pfm")).isEqualTo(bytes("whole.pfm"));
  }

  @Test
  void checkpointsMayBeOnAHadoopFileSystem() throws IOException {
    String scene = SCENES + "cornell-box.json";
    String film = directory.resolve("remote.film").toUri().toString();
    String[] size = {"--size", "40x40"};
    assertDone(here("render", scene, "-s", "12", size[0], size[1], "-o", path("whole.pfm")));
    assertDone(
        onSpark(scene, "-s", "5", size[0], size[1], "-o", path("a.pfm"), "--checkpoint", film));
    assertThat(onSpark(scene, "-s", "5", "-o", path("a.pfm"), "--checkpoint", film).err())
        .contains("already exists; 'resume file:");
    assertDone(onSpark("resume", film, "-s", "12"));
    assertThat(bytes("a.pfm")).isEqualTo(bytes("whole.pfm"));
    assertDone(here("resume", path("remote.film"), "-o", path("b.pfm")));
    assertThat(bytes("b.pfm")).isEqualTo(bytes("whole.pfm"));
    assertThat(onSpark("resume", film + "-missing").exitCode()).isEqualTo(3);
  }

  @Test
  void listsOfScenesMakePicturesInAFolder() throws IOException {
    Path list =
        Files.writeString(
            directory.resolve("list.txt"),
            SCENES + "cornell-box.json\n\n" + SCENES + "torus-knot.json\n");
    Files.createDirectories(directory.resolve("out"));
    assertDone(onSpark("--list", list.toString(), "-s", "1", "--size", "20x20", "-o", path("out")));
    assertThat(directory.resolve("out/cornell-box.png")).exists();
    assertThat(directory.resolve("out/torus-knot.png")).exists();
  }

  /** As on one machine, where a folder need not exist, and the endings of all scenes go. */
  @Test
  void picturesOfAListAreNamedAsHere() throws IOException {
    String model = path("sheet.glb");
    GlbSample.write(directory.resolve("sheet.glb"));
    String[] flags = {"-s", "1", "--size", "20x20", "--output=" + path("new")};
    List<String> args = new ArrayList<>(List.of(SCENES + "torus-knot.json", model));
    args.addAll(List.of(flags));
    assertDone(onSpark(args));
    assertThat(directory.resolve("new/torus-knot.png")).exists();
    assertThat(directory.resolve("new/sheet.png")).exists();
  }

  @Test
  void scenesWithOnePictureAreRefused() {
    String a = path("a/x.json");
    String b = path("b/X.glb");
    for (String folder : List.of("-oout", "--output=out", "")) {
      List<String> args = new ArrayList<>(List.of(a, b, "-s", "1"));
      args.addAll(folder.isEmpty() ? List.of() : List.of(folder));
      Outcome outcome = onSpark(args);
      assertThat(outcome.exitCode()).isEqualTo(6);
      assertThat(outcome.err())
          .contains(
              a + " and " + b + ": both pictures would be X.png; rename one, or render them into");
    }
  }

  /** The pictures of a list are those of single renders, although they share the cores. */
  @Test
  void picturesOfAListAreBitIdentical() throws IOException {
    Files.createDirectories(directory.resolve("out"));
    List<String> names = List.of("cornell-box", "torus-knot", "glass-and-mirror", "table-12-wood");
    List<String> args = new ArrayList<>();
    names.forEach(name -> args.add(SCENES + name + ".json"));
    args.add(SCENES + "no-such-scene.json");
    args.addAll(List.of("-s", "9", "--size", "40x30", "--unit", "0.1s", "-o", path("out")));
    Outcome outcome = onSpark(args);
    assertThat(outcome.exitCode()).isEqualTo(3);
    assertThat(outcome.err()).contains("no-such-scene.json: expected a scene file, found none");
    for (String name : names) {
      String own = path(name + ".png");
      assertDone(here("render", SCENES + name + ".json", "-s", "9", "--size", "40x30", "-o", own));
      assertThat(pixels("out/" + name + ".png")).isEqualTo(pixels(name + ".png"));
    }
  }

  /** Twelve samples give rounded shares of names, and the balls of a pixel have the same names. */
  @Test
  void layersAndDenoisedPicturesAreBitIdentical() throws IOException {
    String[] args = {
      balls().toString(), "-s", "12", "--size", "40x30", "--layers", "all", "--denoise"
    };
    List<String> here = new ArrayList<>(List.of("render"));
    here.addAll(List.of(args));
    here.addAll(List.of("-o", path("here.exr")));
    assertDone(here(here.toArray(String[]::new)));
    List<String> there = new ArrayList<>(List.of(args));
    there.addAll(List.of("-o", path("spark.exr"), "--unit", "0.1s"));
    assertDone(onSpark(there));

    assertSameLayers("spark.exr", "here.exr");
  }

  private Path balls() throws IOException {
    StringBuilder objects = new StringBuilder();
    for (int i = 0; i < 400; i++) {
      objects.append(
          """
          {"name": "ball", "type": "Shape", "shapeType": "Sphere", "materialID": %d, "radius": 0.07,
           "localPosition": {"x": %s, "y": %s, "z": 0}},
          """
              .formatted(1 + i % 2, .13 * (i % 25) - 1.6, .13 * (i / 25) - 1));
    }
    return Files.writeString(
        directory.resolve("balls.json"),
        """
        {"mainCameraId": 1,
         "assets": [
          {"id": 1, "assetType": "Material", "materialType": "Diffuse"},
          {"id": 2, "assetType": "Material", "materialType": "Reflective"}],
         "objects": [%s
          {"id": 1, "type": "Camera", "cameraType": "Pinhole",
           "localPosition": {"x": 0, "y": 0, "z": -4}},
          {"type": "Light", "lightType": "Point", "intensity": 3,
           "localPosition": {"x": 2, "y": 4, "z": -3}}]}
        """
            .formatted(objects));
  }

  private void assertSameLayers(String name, String expectedName) throws IOException {
    LayeredImage found = LayeredImage.read(directory.resolve(name));
    LayeredImage expected = LayeredImage.read(directory.resolve(expectedName));
    assertThat(found.layers()).hasSameSizeAs(expected.layers());
    for (int i = 0; i < expected.layers().size(); i++) {
      assertThat(found.layers().get(i).name()).isEqualTo(expected.layers().get(i).name());
      assertThat(found.layers().get(i).values()).isEqualTo(expected.layers().get(i).values());
    }
  }

  /** The colors of a picture, without the file's metadata, which has the time of the render. */
  private int[] pixels(String name) throws IOException {
    BufferedImage image = ImageIO.read(directory.resolve(name).toFile());
    return image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
  }

  /** Writes a program that converts a model and then does something else. */
  private String converter(String then) throws IOException {
    GlbSample.write(directory.resolve("sheet.glb"));
    Files.writeString(directory.resolve("a.fbx"), "a model");
    Path tool = directory.resolve("tool");
    String glb = path("sheet.glb");
    Files.writeString(tool, "#!/bin/sh\ncp '" + glb + "' \"$2\"\n" + then);
    Files.setPosixFilePermissions(tool, PosixFilePermissions.fromString("rwxr-xr-x"));
    return tool + " {in} {out}";
  }

  /** Executors get what the program has made, and need neither it nor what it has read. */
  @Test
  @DisabledOnOs(OS.WINDOWS)
  void aModelIsConvertedByTheDriverAlone() throws IOException {
    String[] args = {path("a.fbx"), "-s", "9", "--size", "40x30", "--import-with"};
    List<String> here = new ArrayList<>(List.of("render"));
    here.addAll(List.of(args));
    here.addAll(List.of(converter(""), "-o", path("here.pfm")));
    assertDone(here(here.toArray(String[]::new)));
    List<String> there = new ArrayList<>(List.of(args));
    there.add(converter("rm \"$0\" \"$1\"\n"));
    there.addAll(List.of("-o", path("spark.pfm"), "--unit", "0.1s"));
    assertDone(onSpark(there));

    assertThat(directory.resolve("tool")).doesNotExist();
    assertThat(directory.resolve("a.fbx")).doesNotExist();
    assertThat(bytes("spark.pfm")).isEqualTo(bytes("here.pfm"));
  }

  @Test
  @DisabledOnOs(OS.WINDOWS)
  void checkpointsOfConvertedModelsAreResumedHereAndThere() throws IOException {
    String[] flags = {"--size", "40x30", "--import-with", converter("")};
    String model = path("a.fbx");
    String film = path("a.film");
    List<String> whole = new ArrayList<>(List.of("render", model, "-s", "24", "-o", path("b.pfm")));
    whole.addAll(List.of(flags));
    assertDone(here(whole.toArray(String[]::new)));
    List<String> first = new ArrayList<>(List.of(model, "-s", "6", "-o", path("a.pfm")));
    first.addAll(List.of(flags));
    first.addAll(List.of("--checkpoint", film));
    assertDone(onSpark(first));
    assertThat(onSpark("resume", film, "-s", "24").err())
        .contains("--import-with: required as when rendering began");
    assertDone(here("resume", film, "-s", "13", "--import-with", flags[3]));
    assertDone(onSpark("resume", film, "-s", "24", "--import-with", flags[3], "--unit", "0.1s"));
    assertThat(bytes("a.pfm")).isEqualTo(bytes("b.pfm"));
  }

  /** Each frame is a scene of its own. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "--turntable 6",
        "--animation lift --fps 6",
        "--animation lift --fps 6 --shutter 0.5",
        "--explode 0..1 --fps 3"
      })
  void framesAreBitIdentical(String motion) throws IOException {
    GlbSample.write(directory.resolve("sheet.glb"));
    List<String> args = new ArrayList<>(List.of(path("sheet.glb"), "-s", "5", "--size", "24x20"));
    args.addAll(List.of(motion.split(" ")));
    List<String> here = new ArrayList<>(args);
    here.add(0, "render");
    here.addAll(List.of("-o", path("here.pfm")));
    assertDone(here(here.toArray(String[]::new)));
    args.addAll(List.of("-o", path("spark.pfm"), "--unit", "0.1s"));
    assertDone(onSpark(args));
    for (int frame = 0; frame < 6; frame++) {
      String number = "-%03d.pfm".formatted(frame);
      assertThat(bytes("spark" + number)).isEqualTo(bytes("here" + number));
    }
  }

  /** A sequence that ended there is continued here: the frames that are missing. */
  @Test
  void framesAreContinuedHere() throws IOException {
    GlbSample.write(directory.resolve("sheet.glb"));
    List<String> args = new ArrayList<>(List.of(path("sheet.glb"), "-s", "5", "--size", "24x20"));
    args.addAll(List.of("--turntable", "4", "--no-denoise"));
    List<String> whole = new ArrayList<>(args);
    whole.add(0, "render");
    whole.addAll(List.of("-o", path("whole.gif")));
    assertDone(here(whole.toArray(String[]::new)));
    args.addAll(List.of("-o", path("a.gif")));
    List<String> part = new ArrayList<>(args);
    part.addAll(List.of("--frames", "1/2", "--unit", "0.1s"));
    assertDone(onSpark(part));
    args.add(0, "render");
    args.add("--continue");
    assertDone(here(args.toArray(String[]::new)));
    assertThat(bytes("a.gif")).isEqualTo(bytes("whole.gif"));
  }

  @Test
  void memoryOfExecutorsIsEstimatedBeforeWorkStarts() {
    Outcome outcome =
        onSpark(SCENES + "cornell-box.json", "-s", "1", "--size", "20x20", "-o", path("a.png"));
    assertDone(outcome);
    assertThat(outcome.err()).containsPattern("Spark on local\\[2]: an executor has 2 cores");
    ExecutorPlan small = new ExecutorPlan("spark://host:7077", 4, 1 << 20, 2 << 20, false);
    assertThatThrownBy(small::require)
        .hasMessage(
            "an executor with 4 cores needs about 2 MiB of memory, but has 1 MiB;"
                + " raise it with --conf spark.executor.memory=8g");
    assertThat(small.line())
        .endsWith(
            "vector kernel off"
                + " (spark.executor.extraJavaOptions=--add-modules=jdk.incubator.vector)");
  }

  @Test
  void wrongCommandLinesAreRefused() {
    assertThat(onSpark().exitCode()).isEqualTo(2);
    assertThat(onSpark(SCENES + "cornell-box.json", "--adaptive").err())
        .contains("--adaptive: not available on Spark");
    assertThat(onSpark(SCENES + "cornell-box.json", "--sheet", "a.png").err())
        .contains("--sheet: not available on Spark");
    assertThat(onSpark("--unit", "soon", SCENES + "cornell-box.json").err())
        .contains("--unit: expected 0.1s to 3600s, found soon");
    for (String output : List.of("-oa.png", "-o=a.png", "--output=a.png")) {
      assertThat(onSpark(path("a.json"), path("b.json"), output).err())
          .contains("-o: expected a folder for the pictures of several scenes, which exists or")
          .contains("found a.png");
    }
    assertThat(onSpark(path("a.json"), path("b.json"), "--checkpoint=" + path("a.film")).err())
        .contains("--checkpoint: requires one scene, found 2");
    assertThat(onSpark(path("a.json"), path("b.json"), "-o", "a.gif").err())
        .contains("found a.gif; only frames of one model are joined on Spark");
    assertThat(onSpark(path("missing.json")).exitCode()).isEqualTo(3);
    assertThat(onSpark("--help").out()).contains("Usage: lumbre-spark");
  }
}
