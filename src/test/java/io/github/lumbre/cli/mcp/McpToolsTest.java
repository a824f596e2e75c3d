package io.github.lumbre.cli.mcp;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import io.github.lumbre.cli.ModelSample;
import io.github.lumbre.cli.Outcome;
import io.github.lumbre.testing.Effort;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the tools as a client calls them. */
class McpToolsTest {
  private static final String SMALL = "'model':'sample.glb','width':32,'height':24";

  private static final String META =
      "'_meta':{'io.modelcontextprotocol/protocolVersion':'2026-07-28',"
          + "'io.modelcontextprotocol/clientCapabilities':{}},";

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

  /** Returns a call; single quotes stand for double ones. */
  private static String line(int id, String tool, String arguments) {
    return ("{'jsonrpc':'2.0','id':%d,'method':'tools/call','params':{%s'name':'%s',"
            + "'arguments':{%s}}}\n")
        .formatted(id, META, tool, arguments)
        .replace('\'', '"');
  }

  private void send(int id, String tool, String arguments) throws IOException {
    client.send(line(id, tool, arguments));
  }

  private JsonObject result(String tool, String arguments)
      throws IOException, InterruptedException {
    send(1, tool, arguments);
    JsonObject answer = client.next();
    assertThat(answer.has("result")).as(answer.toString()).isTrue();
    return answer.getAsJsonObject("result");
  }

  private JsonObject numbers(String tool, String arguments)
      throws IOException, InterruptedException {
    JsonObject result = result(tool, arguments);
    assertThat(result.has("isError")).as(result.toString()).isFalse();
    return result.getAsJsonObject("structuredContent");
  }

  private String failure(String tool, String arguments) throws IOException, InterruptedException {
    JsonObject result = result(tool, arguments);
    assertThat(result.has("isError")).as(result.toString()).isTrue();
    return result.getAsJsonArray("content").get(0).getAsJsonObject().get("text").getAsString();
  }

  private static int[] pixels(BufferedImage image) {
    return image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
  }

  private static int[] picture(JsonObject result) throws IOException {
    JsonObject content = result.getAsJsonArray("content").get(0).getAsJsonObject();
    byte[] png = Base64.getDecoder().decode(content.get("data").getAsString());
    return pixels(ImageIO.read(new ByteArrayInputStream(png)));
  }

  /** Returns the pixels of a picture that a command line writes; T is the folder of the model. */
  private int[] commanded(String line, String name) throws IOException {
    Outcome outcome = Outcome.of(line.replace("T", temporary.toString()).split(" "));
    assertThat(outcome.exitCode()).as(outcome.err()).isZero();
    return pixels(ImageIO.read(temporary.resolve(name).toFile()));
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "lines"})
  void viewsAreThePictureOfTheCommandLine(String look) throws Exception {
    JsonObject result = result("views", SMALL + (look.isEmpty() ? "" : ",'look':'" + look + "'"));
    String line = "views T/parts/sample.glb --size 32x24 -o T/v";
    assertThat(picture(result))
        .isEqualTo(commanded(line + (look.isEmpty() ? "" : " --look " + look), "v/views.png"));
    JsonArray views = result.getAsJsonObject("structuredContent").getAsJsonArray("views");
    assertThat(views)
        .extracting(view -> view.getAsJsonObject().get("view").getAsString())
        .containsExactly("front", "back", "left", "right", "top", "bottom", "iso");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "render | '' | --view 30,20",
        "render | ,'view':'front','samples':2 | --view front -s 2",
        "render | ,'highlight':['body'] | --view 30,20 --highlight body",
        "section | ,'planes':['x=50%'] | --view 30,20 --section x=50%",
        "section | ,'planes':['-y=40%'],'view':'top' | --view top --section -y=40%",
        "render | ,'look':'clay' | --view 30,20 --look clay",
        "render | ,'look':'clay,lines','labels':['axes'] | --view 30,20 --look clay,lines --labels"
            + " axes",
        "section | ,'look':'lines','planes':['x=50%'] | --view 30,20 --look lines --section x=50%"
      },
      quoteCharacter = '`')
  void rendersAreThePicturesOfTheCommandLine(String tool, String arguments, String flags)
      throws Exception {
    String line = "render T/parts/sample.glb --size 32x24 --quiet -o T/a.png " + flags;
    assertThat(picture(result(tool, SMALL + arguments.replace("''", ""))))
        .isEqualTo(commanded(line, "a.png"));
  }

  @Test
  void aPixelIsOfThePicture() throws Exception {
    JsonObject pixel = numbers("pixel", SMALL + ",'x':16,'y':12,'view':'front'");
    assertThat(pixel.get("shows").toString()).contains("body");
    assertThat(failure("pixel", SMALL + ",'x':32,'y':1"))
        .isEqualTo("x, y: expected a pixel of 32x24, found 32,1");
  }

  @Test
  void aModelIsDescribed() throws Exception {
    JsonObject numbers = numbers("describe", "'model':'sample.glb'");
    assertThat(numbers.get("triangles").getAsInt()).isEqualTo(4);
    assertThat(numbers.get("material_names")).hasToString("[\"paint\"]");
  }

  private void write(String name, int rgb, String format) throws IOException {
    BufferedImage image = new BufferedImage(24, 16, BufferedImage.TYPE_INT_RGB);
    for (int i = 0; i < 24 * 16; i++) {
      image.setRGB(i % 24, i / 24, rgb);
    }
    ImageIO.write(image, format, folder.resolve(name).toFile());
  }

  @Test
  void picturesAreCompared() throws Exception {
    write("a.png", 0x808080, "png");
    write("b.png", 0xff8000, "png");
    JsonObject same = numbers("compare", "'picture':'a.png','reference':'a.png'");
    assertThat(same.get("flip").getAsDouble()).isZero();
    assertThat(same.get("ssim").getAsDouble()).isEqualTo(1);
    JsonObject other = result("compare", "'picture':'a.png','reference':'b.png'");
    assertThat(other.getAsJsonObject("structuredContent").get("flip").getAsDouble())
        .isGreaterThan(.1);
    assertThat(picture(other)).hasSize(24 * 16);
  }

  /** Formats whose readers are seldom used are as closed to clients as to uploads. */
  @ParameterizedTest
  @ValueSource(strings = {"gif", "bmp", "tiff"})
  void seldomPicturesAreRefused(String format) throws Exception {
    write("a." + format, 0x808080, format);
    String name = "a." + format;
    assertThat(failure("compare", "'picture':'" + name + "','reference':'" + name + "'"))
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
      assertThat(failure(tool, "'model':'" + name + "'"))
          .matches("(?s).*(expected a file in " + folder.toRealPath() + "|nul character).*");
    }
    assertThat(failure("compare", "'picture':'" + name + "','reference':'sample.glb'"))
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
    JsonObject numbers = numbers("describe", "'model':'a.obj'");
    assertThat(numbers.get("textures").getAsInt()).isZero();
    assertThat(numbers.get("warnings").toString()).contains("expected a file");
  }

  @Test
  void withoutARootNothingIsRead() throws Exception {
    try (McpClient other = new McpClient((in, out) -> Mcp.serve(List.of(), in, out))) {
      McpClient before = client;
      client = other;
      assertThat(failure("describe", "'model':'" + folder.resolve("sample.glb") + "'"))
          .contains("a folder that 'lumbre mcp --root DIR' names, and none is named");
      client = before;
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "render | ,'view':'up' | view: ",
        "render | ,'view':'1e99,nan' | view: ",
        "render | ,'width':4096 | width: expected an integer from 16 to 1024, found 4096",
        "render | ,'hide':['nothing'] | nothing",
        "render | ,'planes':['x=1'] | \"planes\": expected one of the arguments",
        "section | ,'planes':['x=oops'] | planes: ",
        "views | ,'look':'clay,' | look: expected clay, lines or clay,lines, found clay,",
        "views | ,'highlight':'body' | highlight: expected an array of at most 64 strings"
      })
  void faultsOfArgumentsAreExplained(String tool, String arguments, String part) throws Exception {
    assertThat(
            failure(
                tool,
                SMALL.replace(",'width':32", arguments.contains("width") ? "" : ",'width':32")
                    + arguments))
        .contains(part)
        .doesNotContain("Exception");
  }

  @Test
  void aFileThatIsNoModelIsExplained() throws Exception {
    assertThat(failure("describe", "'model':'paint.png'"))
        .startsWith("\"paint.png\": expected a model: ");
    Files.writeString(folder.resolve("a.stl"), "solid a\nfacet\n");
    assertThat(failure("describe", "'model':'a.stl'")).startsWith("a.stl: ");
    Files.write(folder.resolve("b.glb"), new byte[100]);
    assertThat(failure("render", "'model':'b.glb'")).startsWith("b.glb: ");
  }

  /** Four calls at once see the same model from different sides. */
  @Test
  void callsAtOnceShareAModel() throws Exception {
    List<String> views = List.of("front", "top", "iso", "left", "30,20", "-40,70");
    List<String> expected = new ArrayList<>();
    for (String view : views) {
      expected.add(content(result("render", SMALL + ",'view':'" + view + "'")));
    }
    for (int round = 0; round < 3; round++) {
      for (int i = 0; i < views.size(); i++) {
        send(i, "render", SMALL + ",'view':'" + views.get(i) + "'");
      }
      for (int i = 0; i < views.size(); i++) {
        JsonObject answer = client.next();
        assertThat(content(answer.getAsJsonObject("result")))
            .isEqualTo(expected.get(answer.get("id").getAsInt()));
      }
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
    usual.put("picture", "'paint.png'");
    usual.put("reference", "'paint.png'");
    Map<String, List<String>> tools =
        Map.of(
            "views", List.of("model", "width", "height", "highlight"),
            "render", List.of("model", "width", "height", "view", "highlight"),
            "section", List.of("model", "width", "height", "view", "planes"),
            "describe", List.of("model"),
            "pixel", List.of("model", "x", "y", "width", "height", "view", "planes"),
            "compare", List.of("picture", "reference"));
    String[] unusual =
        ("null true [] {} -1 0 17 1e9 1.5 99999999999999999999 '' '*' ['*'] ['?','',''] ['x=oops']"
             + " ['0,0,1/1,1,0'] ['0,0,0/0,0,0'] ['x=1e300','-x=-1e300'] 'top' '-1e308,90' '0,NaN'"
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
      JsonObject result = result(tool, String.join(",", arguments));
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
            line(1, "views", small + ",'highlight':['b?dy']"),
            line(2, "render", small + ",'samples':1,'look':'clay','view':'top'"),
            line(3, "section", small + ",'samples':1,'planes':['x=50%']"),
            line(4, "describe", "'model':'sample.glb','z_up':true"),
            line(5, "pixel", small + ",'x':8,'y':9"),
            line(6, "compare", "'picture':'paint.png','reference':'paint.png'"));
    client.send(
        "{'jsonrpc':'2.0','id':0,'method':'initialize','params':{'protocolVersion':'2025-11-25'}}\n"
            .replace('\'', '"'));
    assertThat(client.next().has("result")).isTrue();
    int answers = 0;
    int pictures = 0;
    int count = Effort.count(100, 10_000);
    for (int i = 0; i < count; i++) {
      String seed = seeds.get(random.nextInt(seeds.size()));
      byte[] line = changed(seed.replace(META.replace('\'', '"'), ""), random);
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
    assertThat(numbers("describe", "'model':'sample.glb'").get("triangles").getAsInt())
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

  private static String content(JsonObject result) {
    JsonElement content = result.get("content");
    return content.toString();
  }
}
