package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.testing.Pictures;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.Writer;
import java.lang.reflect.Method;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;
import java.util.stream.Stream;
import java.util.zip.CRC32;
import java.util.zip.ZipEntry;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the program as users run it: its process, its exit code and its files. */
class RunnableJarIT {
  @TempDir private Path directory;

  private Outcome lumbre(String... args) throws IOException, InterruptedException {
    return Program.run(directory, Program.lumbre(args));
  }

  @Test
  void sceneBecomesAPictureBesideTheUser() throws IOException, InterruptedException {
    TinyScene.write(directory, TinyScene.JSON);
    Outcome outcome = lumbre("render", "tiny.json");
    assertThat(outcome.err()).startsWith("tiny.png: 16x12 pixels").hasLineCount(1);
    assertThat(outcome.out()).isEmpty();
    assertThat(outcome.exitCode()).isZero();
    assertThat(ImageIO.read(directory.resolve("tiny.png").toFile()).getWidth()).isEqualTo(16);
  }

  @Test
  void measuringFindsTheJarOfTheLabBesideTheProgram() throws IOException, InterruptedException {
    TinyScene.write(directory, TinyScene.JSON);
    Outcome outcome = lumbre("perf", "tiny.json", "--samples", "1", "--repeat", "1").done();
    assertThat(outcome.out()).contains("| tiny |");
  }

  @Test
  void withoutTheJarOfTheLabItIsNamed() throws IOException, InterruptedException {
    Files.copy(Program.JAR, directory.resolve("lumbre-1-cli.jar"));
    List<String> command = List.of(Program.java("java"), "-jar", "lumbre-1-cli.jar");
    Outcome outcome = Program.run(directory, with(command, "perf", "tiny.json"));
    assertThat(outcome.exitCode()).isEqualTo(ExitCodes.INTERNAL);
    assertThat(outcome.err())
        .contains("lumbre-1-lab.jar, which is missing; put it there: each release and package has");
    assertThat(Program.run(directory, with(command, "help", "perf")).exitCode()).isZero();
  }

  @Test
  void theDirectoryForTemporaryFilesNeedNotExist() throws IOException, InterruptedException {
    TinyScene.write(directory, TinyScene.JSON);
    List<String> command = Program.lumbre("render", "tiny.json");
    command.add(1, "-Djava.io.tmpdir=" + directory.resolve("none"));
    Outcome outcome = Program.run(directory, command);
    assertThat(outcome.err()).startsWith("tiny.png: 16x12 pixels").hasLineCount(1);
    assertThat(outcome.exitCode()).isZero();
  }

  /** Java archives no classes of formats before Java 6 (50), and would load them anew each time. */
  @Test
  void allClassesCanBeArchived() throws IOException {
    Map<String, Integer> versions = new TreeMap<>();
    try (JarFile jar = new JarFile(Path.of("target", "lumbre-all.jar").toFile())) {
      for (JarEntry entry : Collections.list(jar.entries())) {
        if (entry.getName().endsWith(".class")) {
          try (DataInputStream in = new DataInputStream(jar.getInputStream(entry))) {
            in.skipNBytes(6);
            versions.put(entry.getName(), in.readUnsignedShort());
          }
        }
      }
    }
    assertThat(versions).containsKey("picocli/CommandLine.class");
    assertThat(versions.values()).allMatch(version -> version >= 50);
  }

  /** Java 17 links lambdas at each start, and archives classes. */
  @Test
  void lambdasAreClassesOfTheJar() throws Exception {
    TinyScene.write(directory, TinyScene.JSON);
    List<String> command = Program.lumbre("check", "tiny.json");
    command.add(1, "-Xlog:class+load");
    String loaded = Program.run(directory, command).done().out();
    assertThat(loaded).contains("io.github.lumbre.cli.Lumbre$$0 ");
    assertThat(loaded).doesNotContainPattern("io\\.github\\.lumbre\\.[\\w.$]*Lambda[^s]");
  }

  /** Listing the methods of a class makes Java verify it. */
  @Test
  void allClassesThatTheBuildChangesAreValid() throws Exception {
    int count = 0;
    try (JarFile jar = new JarFile(Program.JAR.toFile());
        URLClassLoader loader =
            new URLClassLoader(
                new URL[] {
                  Program.JAR.toUri().toURL(),
                  Program.JAR.resolveSibling("lumbre-lab.jar").toUri().toURL()
                },
                ClassLoader.getPlatformClassLoader())) {
      for (JarEntry entry : Collections.list(jar.entries())) {
        String name = entry.getName();
        if (name.matches("(io/github/lumbre/|picocli/CommandLine).*[.]class")) {
          Class<?> type =
              loader.loadClass(name.substring(0, name.length() - 6).replace('/', '.'));
          try {
            assertThat(type.getDeclaredMethods()).isNotNull();
          } catch (NoClassDefFoundError e) {
            // The tests run without the module of vectors.
            assertThat(e.getMessage()).startsWith("jdk/incubator/vector/");
          }
          count++;
        }
      }
    }
    assertThat(count).isGreaterThan(4000);
  }

  @ParameterizedTest
  @ValueSource(strings = {"cornell-box.json", "models/lantern.glb"})
  void theJarRendersThePicturesOfItsSources(String scene) throws Exception {
    String file = Path.of("scenes", scene).toAbsolutePath().toString();
    byte[][] pictures = new byte[2][];
    for (int i = 0; i < pictures.length; i++) {
      Path picture = directory.resolve(i + ".pfm");
      String[] render = {"render", file, "--size", "64x48", "-s", "4", "-o", picture.toString()};
      if (i == 0) {
        lumbre(render).done();
      } else {
        PrintWriter nowhere = new PrintWriter(Writer.nullWriter());
        assertThat(Lumbre.run(render, nowhere, nowhere)).isZero();
      }
      pictures[i] = Files.readAllBytes(picture);
    }
    assertThat(pictures[0]).isEqualTo(pictures[1]);
  }

  @Test
  void theNamesOfNegatedFlagsAreCompiledOnce() throws Exception {
    try (URLClassLoader loader =
        new URLClassLoader(
            new URL[] {Program.JAR.toUri().toURL()}, ClassLoader.getPlatformClassLoader())) {
      Method names =
          loader.loadClass("picocli.CommandLine$RegexTransformer").getMethod("createDefault");
      assertThat(names.invoke(null)).isNotNull().isSameAs(names.invoke(null));
    }
  }

  @Test
  void theWeightsOfTheDenoiserAreStored() throws IOException {
    try (JarFile jar = new JarFile(Program.JAR.toFile())) {
      JarEntry weights = jar.getJarEntry("io/github/lumbre/render/denoise/weights.f16");
      assertThat(weights.getMethod()).isEqualTo(ZipEntry.STORED);
    }
  }

  @Test
  void theVectorModuleIsLoadedWithoutAnOptionOrAWarning() throws Exception {
    assumeTrue(Kernel.vectorObstacle().isEmpty(), () -> Kernel.vectorObstacle().orElseThrow());
    assertThat(lumbre("--version").out()).contains("Kernel: vector");
    TinyScene.write(directory, TinyScene.JSON);
    byte[][] pictures = new byte[2][];
    for (int i = 0; i < pictures.length; i++) {
      String kernel = i == 0 ? "vector" : "scalar";
      String[] render = {"render", "tiny.json", "--kernel", kernel, "-o", kernel + ".pfm"};
      Outcome outcome = lumbre(render).done();
      assertThat(outcome.err()).startsWith(kernel + ".pfm: 16x12 pixels").hasLineCount(1);
      pictures[i] = Files.readAllBytes(directory.resolve(kernel + ".pfm"));
    }
    assertThat(pictures[0]).isEqualTo(pictures[1]);
  }

  /** The manifest, which Java reads with -jar alone, exports what loads the module. */
  @Test
  void whereTheVectorModuleCannotBeLoadedTheScalarKernelRuns() throws Exception {
    String reason = "Java runs without --add-modules jdk.incubator.vector";
    List<String> lumbre =
        List.of(Program.java("java"), "-cp", "" + Program.JAR, Lumbre.class.getName());
    Outcome version = Program.run(directory, with(lumbre, "--version"));
    assertThat(version.out()).contains("Kernel: scalar, because " + reason);
    TinyScene.write(directory, TinyScene.JSON);
    Outcome outcome =
        Program.run(directory, with(lumbre, "render", "tiny.json", "--kernel=vector"));
    assertThat(outcome.exitCode()).isEqualTo(ExitCodes.USAGE);
    assertThat(outcome.err()).contains("--kernel: vector is not available: " + reason);
    outcome = Program.run(directory, with(lumbre, "render", "tiny.json", "--kernel=scalar"));
    assertThat(outcome.exitCode()).isZero();
  }

  private static List<String> with(List<String> command, String... arguments) {
    return Stream.concat(command.stream(), Stream.of(arguments)).toList();
  }

  static Stream<Arguments> badScenes() throws IOException {
    String mesh = "{\"id\": 9, \"assetType\": \"Mesh\", \"base64OBJ\": \"%s\"}";
    String obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n";
    String badIndex = String.format(mesh, base64(obj.getBytes(StandardCharsets.UTF_8)));
    return Stream.of(
        bad("empty file", "", ExitCodes.SCENE, "tiny.json"),
        bad("not JSON", "hello", ExitCodes.SCENE, "tiny.json"),
        bad("cut off", TinyScene.JSON.substring(0, 300), ExitCodes.SCENE, "tiny.json"),
        bad("an array", "[]", ExitCodes.SCENE, "object"),
        bad("text for a number", exchanged("\"radius\": 1", "\"radius\": \"1\""), 3, "radius"),
        bad("number for text", exchanged("\"Sphere\"", "5"), ExitCodes.SCENE, "shapeType"),
        bad("NaN", exchanged("\"radius\": 1", "\"radius\": NaN"), ExitCodes.SCENE, "tiny.json"),
        bad("1e400", exchanged("\"radius\": 1", "\"radius\": 1e400"), ExitCodes.SCENE, "radius"),
        bad("dangling id", exchanged("\"materialID\": 2", "\"materialID\": 77"), 3, "77"),
        bad(
            "no camera",
            exchanged("\"mainCameraId\": 1", "\"mainCameraId\": 9"),
            3,
            "mainCameraId"),
        bad("singular", exchanged("\"radius\": 1", "\"localScale\": {\"x\": 0}"), 3, "singular"),
        bad("width 0", exchanged("\"width\": 16", "\"width\": 0"), ExitCodes.SCENE, "width"),
        bad("samples 0", exchanged("\"samples\": 2", "\"samples\": 0"), 3, "samples"),
        bad("too large", sized(60000), ExitCodes.LIMIT, "60000x60000"),
        bad("beyond the heap", sized(16000), ExitCodes.LIMIT, "16000x16000 pixels need"),
        bad("deep nesting", "[".repeat(5000), ExitCodes.LIMIT, "tiny.json"),
        bad("truncated base64", textured("iVBORw0KGgo"), ExitCodes.ASSET, "base64PNG"),
        bad("lying PNG", textured(base64(pngOfSize(20000))), ExitCodes.LIMIT, "base64PNG"),
        bad("cut off PNG", textured(base64(pngOfSize(64))), ExitCodes.ASSET, "too early"),
        bad("OBJ with a bad index", shown(badIndex), ExitCodes.ASSET, "line 4"));
  }

  private static Arguments bad(String name, String json, int exitCode, String message) {
    return Arguments.of(name, json, exitCode, message);
  }

  private static String exchanged(String old, String replacement) {
    return TinyScene.with(old, replacement);
  }

  private static String sized(int side) {
    String size = "\"width\": " + side + ", \"height\": " + side;
    return exchanged("\"width\": 16, \"height\": 12", size);
  }

  /** Returns the scene with its sphere's material textured by a picture. */
  private static String textured(String base64) {
    String asset = "{\"id\": 9, \"assetType\": \"Texture\", \"base64PNG\": \"" + base64 + "\"}";
    return TinyScene.withAsset(asset)
        .replace("\"Reflective\"", "\"Diffuse\", \"colorTextureId\": 9");
  }

  /** Returns the scene with its sphere replaced by a mesh. */
  private static String shown(String mesh) {
    return TinyScene.withAsset(mesh)
        .replace("\"Sphere\", \"materialID\": 2, \"radius\": 1", "\"Mesh\", \"meshId\": 9");
  }

  private static String base64(byte[] bytes) {
    return Base64.getEncoder().encodeToString(bytes);
  }

  /** Returns a PNG of one pixel whose header states another size, with a valid checksum. */
  private static byte[] pngOfSize(int side) throws IOException {
    ByteBuffer png = ByteBuffer.wrap(Pictures.png(1, 1, 0));
    png.putInt(16, side).putInt(20, side);
    CRC32 crc = new CRC32();
    crc.update(png.array(), 12, 17);
    return png.putInt(29, (int) crc.getValue()).array();
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("badScenes")
  void badScenesEndInALineAndACode(String name, String json, int exitCode, String message)
      throws IOException, InterruptedException {
    TinyScene.write(directory, json);
    lumbre("render", "tiny.json").assertFailed(exitCode, message);
    assertThat(directory.resolve("tiny.png")).doesNotExist();
    assertThat(directory.resolve(".tiny.png.tmp")).doesNotExist();
  }

  @Test
  void missingScenesWrongFlagsAndOutputsEndInALineAndACode()
      throws IOException, InterruptedException {
    lumbre("render", "none.json").assertFailed(ExitCodes.SCENE, "none.json");
    lumbre("render", "none.json", "-s", "0").assertFailed(ExitCodes.USAGE, "--samples");
    lumbre("render", "none.json", "-o", "p.gif").assertFailed(ExitCodes.USAGE, "p.gif");
    Files.writeString(directory.resolve("file"), "");
    lumbre("render", "none.json", "-o", "file/p.png")
        .assertFailed(ExitCodes.OUTPUT, "/file cannot");
    lumbre("render", ".", "-o", "p.png").assertFailed(ExitCodes.SCENE, "directory");
  }

  /** Rejected samples are counted and identified for replay; the picture is still written. */
  @Test
  void samplesThatAreNoNumbersFailUnderStrictnessOnly() throws IOException, InterruptedException {
    TinyScene.write(directory, TinyScene.blinding());
    String[] render = {"render", "tiny.json", "-o", "tiny.pfm", "--json", "--seed", "3", "-s", "4"};
    Outcome lax = lumbre(render).done();
    byte[] picture = Files.readAllBytes(directory.resolve("tiny.pfm"));
    Files.delete(directory.resolve("tiny.pfm"));
    List<String> strictly = new ArrayList<>(List.of(render));
    strictly.add("--strict");
    Outcome strict = lumbre(strictly.toArray(new String[0]));
    assertThat(strict.exitCode()).isEqualTo(ExitCodes.INTERNAL);
    assertThat(directory.resolve("tiny.pfm")).hasBinaryContent(picture);
    assertThat(strict.out()).contains("\"exit_code\":7").containsPattern("\"rejected\":[1-9]");
    assertThat(strict.err().lines().filter(line -> line.contains("lumbre pixel "))).hasSize(10);
  }

  /**
   * Results are bit-identical in the interpreter and both JIT compilers, because + - * / and sqrt
   * are exactly rounded.
   */
  @Test
  void interpreterAndCompilersGiveTheSameBits() throws IOException, InterruptedException {
    Path scene = Path.of("scenes", "glass-and-mirror.json").toAbsolutePath();
    List<String> modes =
        List.of(
            "-Xint",
            "-XX:TieredStopAtLevel=1",
            "-XX:-TieredCompilation -XX:CompileThreshold=1000 -Xbatch");
    byte[] expected = {};
    for (String mode : modes) {
      List<String> command = new ArrayList<>(List.of(Program.java("java")));
      command.addAll(List.of(mode.split(" ")));
      command.addAll(List.of("-jar", "" + Program.JAR, "render", "" + scene));
      command.addAll(List.of("--size", "24x16", "-s", "32", "-o", "p.pfm"));
      assertThat(Program.run(directory, command).exitCode()).isZero();
      byte[] picture = Files.readAllBytes(directory.resolve("p.pfm"));
      assertThat(picture).as(mode).isEqualTo(expected.length == 0 ? picture : expected);
      expected = picture;
    }
  }

  @Test
  @DisabledOnOs(OS.WINDOWS)
  void stoppedRenderSavesWhatItHas() throws IOException, InterruptedException {
    TinyScene.write(directory, TinyScene.JSON);
    Process process =
        Program.start(
            directory, Program.lumbre("render", "tiny.json", "-s", "100000000", "--size", "64x64"));
    awaitRender(process);
    process.destroy();
    Outcome outcome = Program.await(directory, process);
    assertThat(outcome.err()).contains("tiny.png: stopped early, partial picture").hasLineCount(1);
    assertThat(outcome.exitCode()).isEqualTo(ExitCodes.TERMINATED);
    Path picture = directory.resolve("tiny.png");
    assertThat(ImageIO.read(picture.toFile()).getWidth()).isEqualTo(64);
    assertThat(Files.readString(picture, StandardCharsets.ISO_8859_1)).contains("Partial\000");
    assertThat(directory.resolve(".tiny.png.tmp")).doesNotExist();
  }

  /** Waits until the process has started to render. */
  private static void awaitRender(Process process) throws InterruptedException {
    long enough = 3_000;
    while (process.toHandle().info().totalCpuDuration().orElseThrow().toMillis() < enough) {
      Thread.sleep(50);
    }
  }

  @Test
  void nothingIsDrawnIntoAPipe() throws IOException, InterruptedException {
    TinyScene.write(directory, TinyScene.JSON);
    Outcome outcome = lumbre("render", "tiny.json", "--size", "200x200", "-s", "20").done();
    assertThat(outcome.err()).startsWith("tiny.png: ").hasLineCount(1).doesNotContain("\r");
  }
}
