package io.github.lumbre.cli.mcp;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonObject;
import io.github.lumbre.cli.ModelSample;
import io.github.lumbre.testing.Effort;
import io.github.lumbre.testing.Pictures;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that no call and no file of it ends the server, or reads what is not in its folder. */
class HostileCallsTest {
  private static final String TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

  @TempDir private Path temporary;
  private Path folder;
  private McpClient client;

  @BeforeEach
  void start() throws IOException {
    folder = Files.createDirectory(temporary.resolve("parts"));
    ModelSample.write(folder);
    client = new McpClient((in, out) -> Mcp.serve(List.of(folder), in, out));
  }

  @AfterEach
  void end() throws IOException {
    client.close();
  }

  static void write(Path file, int rgb) throws IOException {
    String name = file.getFileName().toString();
    Files.write(
        file, Pictures.file(Pictures.of(24, 16, rgb), name.substring(name.indexOf('.') + 1)));
  }

  /** Formats whose readers are seldom used are as closed to clients as to uploads. */
  @ParameterizedTest
  @ValueSource(strings = {"gif", "bmp", "tiff"})
  void seldomPicturesAreRefused(String format) throws Exception {
    String name = "a." + format;
    write(folder.resolve(name), 0x808080);
    assertThat(client.failure("compare", "'picture':'" + name + "','reference':'" + name + "'"))
        .contains("save it as a PNG or JPEG");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        ".",
        "..",
        "../secret.stl",
        "../parts/../secret.stl",
        "folder.stl",
        "link.stl",
        "linked/secret.stl",
        "/proc/self/environ",
        "/etc/passwd",
        "a\\u0000.stl",
        "missing.stl",
        "pipe.stl"
      })
  @DisabledOnOs(OS.WINDOWS)
  void filesOutsideAreNotRead(String name) throws Exception {
    Files.writeString(temporary.resolve("secret.stl"), "solid a\nendsolid a\n");
    Files.createDirectory(folder.resolve("folder.stl"));
    Files.createSymbolicLink(folder.resolve("link.stl"), temporary.resolve("secret.stl"));
    Files.createSymbolicLink(folder.resolve("linked"), temporary);
    pipe("pipe.stl");
    for (String tool : List.of("views", "describe")) {
      assertThat(client.failure(tool, "'model':'" + name + "'"))
          .matches("(?s).*(expected a file in " + folder.toRealPath() + "|nul character).*");
    }
    assertThat(client.failure("compare", "'picture':'" + name + "','reference':'sample.glb'"))
        .doesNotContain("solid");
  }

  private void pipe(String name) throws IOException, InterruptedException {
    Process made = new ProcessBuilder("mkfifo", folder.resolve(name).toString()).start();
    assertThat(made.waitFor(30, TimeUnit.SECONDS)).isTrue();
  }

  /** What a model names is read from its own folder only, and no pipe holds up the server. */
  @ParameterizedTest
  @ValueSource(strings = {"../outside.png", "link.png", "linked/outside.png", "pipe.png"})
  @DisabledOnOs(OS.WINDOWS)
  void texturesOutsideAreNotRead(String name) throws Exception {
    Files.copy(folder.resolve("paint.png"), temporary.resolve("outside.png"));
    Files.createSymbolicLink(folder.resolve("link.png"), temporary.resolve("outside.png"));
    Files.createSymbolicLink(folder.resolve("linked"), temporary);
    pipe("pipe.png");
    Files.writeString(
        folder.resolve("a.obj"), "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n");
    Files.writeString(folder.resolve("a.mtl"), "newmtl m\nmap_Kd " + name + "\n");
    JsonObject numbers = client.numbers("describe", "'model':'a.obj'");
    assertThat(numbers.get("textures").getAsInt()).isZero();
    assertThat(numbers.get("warnings").toString()).contains("expected a file");
  }

  /** The parts of a glTF file, one of which is replaced. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "{'mesh':0} | {'mesh':0,'children':[0]} | nodes[0]: expected a node that is not below"
            + " itself",
        "'byteLength':36,'uri' | 'byteLength':2000000000,'uri' | buffers[0].byteLength: expected",
        "'byteLength':36} | 'byteLength':99999999999} | bufferViews[0]",
        "'count':3 | 'count':2147483647 | accessors[0].count: expected at most",
        "URI | ../outside.bin | buffers[0].uri: expected a file inside the model's folder",
        "URI | %2e%2e/outside.bin | buffers[0].uri: expected a file inside the model's folder",
        "URI | link.bin | buffers[0].uri: expected a file inside the model's folder",
        "URI | /dev/zero | buffers[0].uri: expected a file inside the model's folder",
        "URI | pipe.bin | buffers[0].uri: expected a file, found no regular file",
        "URI | /etc/passwd | buffers[0].uri: expected a file inside the model's folder",
        "URI | file:///etc/passwd | buffers[0].uri: expected a relative path or a data URI",
        "URI | http://127.0.0.1/a | buffers[0].uri: expected a relative path or a data URI",
        "URI | data:application/octet-stream;base64,!! | buffers[0].uri: expected base64"
      })
  @DisabledOnOs(OS.WINDOWS)
  void modelsThatLieAreExplained(String part, String lie, String message) throws Exception {
    Files.write(temporary.resolve("outside.bin"), new byte[36]);
    Files.createSymbolicLink(folder.resolve("link.bin"), temporary.resolve("outside.bin"));
    pipe("pipe.bin");
    String gltf =
        "{'asset':{'version':'2.0'},'scene':0,'scenes':[{'nodes':[0]}],'nodes':[{'mesh':0}],"
            + "'meshes':[{'primitives':[{'attributes':{'POSITION':0}}]}],'accessors':[{"
            + "'bufferView':0,'componentType':5126,'count':3,'type':'VEC3'}],"
            + "'bufferViews':[{'buffer':0,'byteLength':36}],"
            + "'buffers':[{'byteLength':36,'uri':'URI'}]}";
    String data = "data:application/octet-stream;base64," + "A".repeat(48);
    Files.writeString(
        folder.resolve("a.gltf"), gltf.replace(part, lie).replace("URI", data).replace('\'', '"'));
    assertThat(client.failure("describe", "'model':'a.gltf'"))
        .startsWith("a.gltf: ")
        .contains(message);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "a.ply | ply\\nformat ascii 1.0\\nelement vertex 2000000000\\nproperty float x\\n"
            + "property float y\\nproperty float z\\nend_header\\n0 0 0\\n | expected",
        "a.off | OFF\\n2000000000 2000000000 0\\n0 0 0\\n | line 3: expected",
        "a.obj | v 0 0 0\\nf 1 2 99999999999\\n | line 2: expected a vertex from 1 to 1, found",
        "a.obj | v 1e999 0 0\\nf 1 1 1\\n | expected"
      })
  void countsThatLieAreExplained(String name, String text, String message) throws Exception {
    Files.writeString(folder.resolve(name), text.replace("\\n", "\n"));
    assertThat(client.failure("views", "'model':'" + name + "'"))
        .startsWith(name + ": ")
        .contains(message);
  }

  @ParameterizedTest
  @CsvSource({
    "3D/3dmodel.model, inflated bytes of an archive",
    "../outside.model, 'expected names inside the archive, found \"../outside.model\"'"
  })
  void archivesThatLieAreExplained(String name, String message) throws Exception {
    try (ZipOutputStream zip =
        new ZipOutputStream(Files.newOutputStream(folder.resolve("a.3mf")))) {
      zip.putNextEntry(new ZipEntry(name));
      zip.write(new byte[10_000_000]);
    }
    assertThat(client.failure("render", "'model':'a.3mf'")).startsWith("a.3mf: ").contains(message);
  }

  @ParameterizedTest
  @ValueSource(strings = {"../outside.mtl", "link.mtl", "linked/outside.mtl", "pipe.mtl"})
  @DisabledOnOs(OS.WINDOWS)
  void librariesOutsideAreNotRead(String name) throws Exception {
    Files.writeString(temporary.resolve("outside.mtl"), "newmtl secret\nKd 1 0 0\n");
    Files.createSymbolicLink(folder.resolve("link.mtl"), temporary.resolve("outside.mtl"));
    Files.createSymbolicLink(folder.resolve("linked"), temporary);
    pipe("pipe.mtl");
    Files.writeString(
        folder.resolve("a.obj"), "mtllib " + name + "\n" + TRIANGLE + "usemtl secret\nf 1 2 3\n");
    assertThat(client.numbers("describe", "'model':'a.obj'").get("warnings").toString())
        .contains("a.obj: line 1: expected a file", "expected a material of a library");
  }

  @Test
  @DisabledOnOs(OS.WINDOWS)
  void picturesOutsideAreNotCompared() throws Exception {
    Files.copy(folder.resolve("paint.png"), temporary.resolve("outside.png"));
    Files.createSymbolicLink(folder.resolve("link.png"), temporary.resolve("outside.png"));
    pipe("pipe.png");
    for (String name : List.of("../outside.png", "link.png", "pipe.png", "/dev/zero")) {
      for (String order :
          List.of("'picture':'%s','reference':'%s'", "'reference':'%s','picture':'%s'")) {
        assertThat(client.failure("compare", order.formatted("paint.png", name)))
            .isEqualTo("\"" + name + "\": expected a file in " + folder.toRealPath());
      }
    }
  }

  /** What is kept of a model is not shown for another file of the same name. */
  @Test
  @DisabledOnOs(OS.WINDOWS)
  void aModelThatIsReplacedIsReadAnew() throws Exception {
    Path model = folder.resolve("a.obj");
    Files.writeString(model, TRIANGLE + "f 1 2 3\n");
    assertThat(triangles()).isEqualTo(1);
    Files.writeString(model, TRIANGLE + "f 1 2 3\nf 3 2 1\n");
    assertThat(triangles()).isEqualTo(2);
    Files.move(model, temporary.resolve("b.obj"));
    Files.createSymbolicLink(model, temporary.resolve("b.obj"));
    assertThat(client.failure("describe", "'model':'a.obj'")).contains("expected a file in ");
    Files.delete(model);
    Files.writeString(model, TRIANGLE + "f 1 2 3\n");
    assertThat(triangles()).isEqualTo(1);
  }

  private int triangles() throws IOException, InterruptedException {
    return client.numbers("describe", "'model':'a.obj'").get("triangles").getAsInt();
  }

  @Test
  void withoutARootNothingIsRead() throws Exception {
    try (McpClient other = new McpClient((in, out) -> Mcp.serve(List.of(), in, out))) {
      McpClient before = client;
      client = other;
      assertThat(client.failure("describe", "'model':'" + folder.resolve("sample.glb") + "'"))
          .contains("a folder that 'lumbre mcp --root DIR' names, and none is named");
      client = before;
    }
  }

  /** Each call is answered, whatever its arguments are. */
  @Test
  void changedArgumentsEndNothing() throws Exception {
    Random random = new Random(Effort.seed(12));
    Map<String, String> usual = new LinkedHashMap<>();
    usual.put("model", "'sample.glb'");
    usual.put("width", "16");
    usual.put("height", "16");
    usual.put("view", "'30,20'");
    usual.put("planes", "['x=50%']");
    usual.put("highlight", "['b?dy']");
    usual.put("x", "3");
    usual.put("y", "4");
    usual.put("unit", "0.5");
    usual.put("crop", "'*b*o*d*y*'");
    usual.put("pose", "'lift@0.5'");
    usual.put("background", "'white'");
    usual.put("paths", "true");
    usual.put("old", "'sample.glb'");
    usual.put("new", "'sample.glb'");
    usual.put("tolerance", "1e-3");
    usual.put("picture", "'paint.png'");
    usual.put("reference", "'paint.png'");
    Map<String, List<String>> tools =
        Map.of(
            "views", List.of("model", "width", "height", "highlight", "planes", "background"),
            "render", List.of("model", "width", "height", "view", "unit", "pose", "crop"),
            "section", List.of("model", "width", "height", "view", "planes"),
            "describe", List.of("model"),
            "pixel", List.of("model", "x", "y", "width", "height", "view", "planes", "paths"),
            "compare", List.of("picture", "reference"),
            "diff", List.of("old", "new", "width", "height", "view", "tolerance", "planes"));
    String[] unusual =
        ("null true [] {} -1 0 17 1e-320 1e308 1e9 1.5 99999999999999999999 '' '*' ['*']"
             + " ['?','',''] ['x=oops'] ['0,0,1/1,1,0'] ['0,0,0/0,0,0'] ['x=1e300','-x=-1e300'] 'top'"
             + " '-1e308,90' '0,NaN'"
             + " '../x.stl' '.' 'sample.glb' 'paint.png' [['a']] '%'")
            .split(" ");
    int pictures = 0;
    int count = Effort.count(100, 10_000);
    for (int i = 0; i < count; i++) {
      String tool = List.copyOf(new TreeSet<>(tools.keySet())).get(random.nextInt(tools.size()));
      List<String> arguments = new ArrayList<>();
      for (String name : tools.get(tool)) {
        boolean isUsual = random.nextInt(4) > 0;
        String value = isUsual ? usual.get(name) : unusual[random.nextInt(unusual.length)];
        arguments.add("'" + name + "':" + value);
      }
      JsonObject result = client.result(tool, String.join(",", arguments));
      pictures += result.toString().contains("image/png") ? 1 : 0;
    }
    assertThat(pictures).isGreaterThan(count / 20);
  }

  /** Each request, and each line that is none, has one answer; notifications have none. */
  @Test
  void changedMessagesOfCallsEndNothing() throws Exception {
    Random random = new Random(Effort.seed(13));
    String small = "'model':'sample.glb','width':16,'height':16";
    List<String> seeds =
        List.of(
            McpClient.line(1, "views", small + ",'highlight':['b?dy']"),
            McpClient.line(2, "render", small + ",'samples':1,'look':'clay','view':'top'"),
            McpClient.line(3, "section", small + ",'samples':1,'planes':['x=50%']"),
            McpClient.line(4, "describe", "'model':'sample.glb','z_up':true"),
            McpClient.line(5, "pixel", small + ",'x':8,'y':9"),
            McpClient.line(6, "compare", "'picture':'paint.png','reference':'paint.png'"));
    client.send(
        "{'jsonrpc':'2.0','id':0,'method':'initialize','params':{'protocolVersion':'2025-11-25'}}\n"
            .replace('\'', '"'));
    assertThat(client.next().has("result")).isTrue();
    int answers = 0;
    int pictures = 0;
    int count = Effort.count(100, 10_000);
    for (int i = 0; i < count; i++) {
      String seed = seeds.get(random.nextInt(seeds.size()));
      byte[] line = changed(seed.replace(McpClient.META.replace('\'', '"'), ""), random);
      client.send(line);
      if (isAnswered(line)) {
        answers++;
        String answer = client.next().toString();
        assertThat(answer).doesNotContain("internal error");
        pictures += answer.contains("image/png") ? 1 : 0;
      }
    }
    assertThat(answers).isGreaterThan(count / 2);
    assertThat(pictures).isGreaterThan(count / 50);
    assertThat(client.numbers("describe", "'model':'sample.glb'").get("triangles").getAsInt())
        .isEqualTo(4);
  }

  /** Returns a line in which bits are flipped, or a part is left out or repeated. */
  private static byte[] changed(String seed, Random random) {
    byte[] line = seed.getBytes(StandardCharsets.UTF_8);
    int end = line.length - 1;
    if (random.nextInt(4) == 0) {
      int from = random.nextInt(end);
      int to = random.nextInt(end);
      return (seed.substring(0, from) + seed.substring(to)).getBytes(StandardCharsets.UTF_8);
    }
    for (int n = random.nextInt(3); n > 0; n--) {
      int at = random.nextInt(end);
      int flipped = line[at] ^ 1 << random.nextInt(8);
      line[at] = (byte) (flipped == '\n' ? '0' : flipped);
    }
    return line;
  }

  private static boolean isAnswered(byte[] line) {
    byte[] message = Arrays.copyOf(line, line.length - 1);
    try {
      return Message.of(Message.parse(message)).filter(m -> m.id().isPresent()).isPresent();
    } catch (RpcException e) {
      return true;
    }
  }
}
