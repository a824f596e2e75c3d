package io.github.lumbre.cli.mcp;

import static io.github.lumbre.testing.Pictures.pixels;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import io.github.lumbre.cli.ModelSample;
import io.github.lumbre.cli.Outcome;
import io.github.lumbre.math.Vec3;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the tools as a client calls them. */
class McpToolsTest {
  private static final String SMALL = "'model':'sample.glb','width':32,'height':24";

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

  private static int[] picture(JsonObject result) throws IOException {
    JsonObject content = result.getAsJsonArray("content").get(0).getAsJsonObject();
    byte[] png = Base64.getDecoder().decode(content.get("data").getAsString());
    return pixels(ImageIO.read(new ByteArrayInputStream(png)));
  }

  /** Returns the pixels of a picture that a command line writes; T is the folder of the model. */
  private int[] commanded(String line, String name) throws IOException {
    Outcome outcome = Outcome.of(line.replace("T", temporary.toString()).split(" ")).done();
    return pixels(temporary.resolve(name));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "'' | -s 1",
        ",'samples':3 | -s 3",
        ",'look':'lines' | -s 1 --look lines",
        ",'planes':['x=50%'] | -s 1 --section x=50%",
        ",'background':'white','ground':true | -s 1 --background white --ground",
        ",'pose':'lift@1','variant':'red','fov':50 | -s 1 --pose lift@1 --variant red --fov 50",
      },
      quoteCharacter = '`')
  void viewsAreThePictureOfTheCommandLine(String arguments, String flags) throws Exception {
    JsonObject result = client.result("views", SMALL + arguments.replace("''", ""));
    String line = "views T/parts/sample.glb --size 32x24 -o T/v " + flags;
    assertThat(picture(result)).isEqualTo(commanded(line, "v/views.png"));
    JsonArray views = result.getAsJsonObject("structuredContent").getAsJsonArray("views");
    assertThat(views)
        .extracting(view -> view.getAsJsonObject().get("view").getAsString())
        .containsExactly("front", "back", "left", "right", "top", "bottom", "iso");
  }

  @Test
  void viewsTellOfAllTheirSamplesAndOfLabelsWithoutRoom() throws Exception {
    String arguments =
        "'model':'sample.glb','width':160,'height':120,'samples':16,'labels':['parts']";
    String call = McpClient.line(1, "views", arguments);
    client.send(call.replace("\"_meta\":{", "\"_meta\":{\"progressToken\":7,"));
    JsonObject answer = client.next();
    assertThat(answer.has("method")).as(answer.toString()).isTrue();
    for (; answer.has("method"); answer = client.next()) {
      assertThat(answer.getAsJsonObject("params").get("total").getAsInt())
          .isEqualTo(160 * 120 * 16 * 7);
    }
    JsonArray notes =
        client
            .numbers("views", "'model':'sample.glb','width':16,'height':16,'labels':['parts']")
            .getAsJsonArray("notes");
    assertThat(notes.get(0).getAsString()).startsWith("front: ");
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
        "render | ,'background':'#204060' | --view 30,20 --background #204060",
        "render | ,'background':'transparent','ground':true | --view 30,20 --background"
            + " transparent --ground",
        "render | ,'pose':'lift@0.5','view':'front' | --view front --pose lift@0.5",
        "render | ,'variant':'red' | --view 30,20 --variant red",
        "render | ,'unit':0.001,'labels':['size'] | --view 30,20 --unit 0.001 --labels size",
        "render | ,'camera':'close' | --camera close",
        "render | ,'eye':'9,3,5','target':'5,1,-2','zoom':2 | --eye 9,3,5 --target 5,1,-2 --zoom 2",
        "render | ,'fit':'body','parallel':true | --view 30,20 --fit body --parallel",
        "render | ,'view':'front','perspective':true | --view front --perspective",
        "render | ,'camera':'1','fov':30 | --camera 1",
        "render | ,'fov':20,'view':'-40,10' | --view -40,10 --fov 20",
        "render | ,'look':'clay,lines','labels':['axes'] | --view 30,20 --look clay,lines --labels"
            + " axes",
        "section | ,'look':'lines','planes':['x=50%'] | --view 30,20 --look lines --section x=50%"
      },
      quoteCharacter = '`')
  void rendersAreThePicturesOfTheCommandLine(String tool, String arguments, String flags)
      throws Exception {
    String line = "render T/parts/sample.glb --size 32x24 --quiet -o T/a.png " + flags;
    assertThat(picture(client.result(tool, SMALL + arguments.replace("''", ""))))
        .isEqualTo(commanded(line, "a.png"));
  }

  @Test
  void aPixelIsOfThePicture() throws Exception {
    String arguments = SMALL + ",'x':16,'y':12,'view':'front'";
    JsonObject result = client.result("pixel", arguments);
    String text =
        result.getAsJsonArray("content").get(0).getAsJsonObject().get("text").getAsString();
    assertThat(text.lines().map(line -> line.replaceAll(": .*", "")))
        .containsExactly("part", "position", "normal", "color", "depth");
    assertThat(text).startsWith("part: body, material paint\n").hasSizeLessThan(200);
    JsonObject pixel = result.getAsJsonObject("structuredContent");
    assertThat(pixel.keySet())
        .containsExactly("x", "y", "part", "material", "position", "normal", "depth", "color");
    int[] shown = picture(client.result("render", SMALL + ",'view':'front'"));
    assertThat(pixel.get("color").getAsString())
        .isEqualTo("#%06x".formatted(shown[12 * 32 + 16] & 0xffffff));
    assertThat(client.failure("pixel", SMALL + ",'x':32,'y':1"))
        .isEqualTo("x, y: expected a pixel of 32x24, found 32,1");
  }

  /** The matrix of the picture maps the position to the center of the pixel, at its depth. */
  @Test
  void aPixelHasThePlaceOfItsPart() throws Exception {
    JsonObject pixel = client.numbers("pixel", SMALL + ",'x':17,'y':12");
    JsonObject view =
        client.numbers("render", SMALL).getAsJsonArray("views").get(0).getAsJsonObject();
    List<Double> point = numbers(pixel.getAsJsonArray("position"));
    List<Double> product = new ArrayList<>();
    for (JsonElement element : view.getAsJsonArray("matrix")) {
      List<Double> row = numbers(element.getAsJsonArray());
      product.add(
          row.get(0) * point.get(0)
              + row.get(1) * point.get(1)
              + row.get(2) * point.get(2)
              + row.get(3));
    }
    double w = product.get(3);
    assertThat(product.get(0) / w).isCloseTo(17.5, within(1e-3));
    assertThat(product.get(1) / w).isCloseTo(12.5, within(1e-3));
    assertThat(product.get(2)).isCloseTo(pixel.get("depth").getAsDouble(), within(1e-5));
    List<Double> normal = numbers(pixel.getAsJsonArray("normal"));
    assertThat(normal.stream().mapToDouble(x -> x * x).sum()).isCloseTo(1, within(1e-5));
  }

  /** Coordinates of a model of a diagonal of 17.32 have at most five digits after the point. */
  @ParameterizedTest
  @CsvSource({"describe, ''", "render, ''", "pixel, ',''x'':16,''y'':12'"})
  void lengthsHaveNoMoreDigitsThanTheyNeed(String tool, String arguments) throws Exception {
    String third = "v 0.3333333333 0 0\nv 10 0 0\nv 0 10 0\nv 0 0 10\n";
    Files.writeString(folder.resolve("a.obj"), third + "f 1 2 3\nf 1 3 4\nf 2 3 4\n");
    String small = SMALL.replace("sample.glb", "a.obj");
    String model = tool.equals("describe") ? "'model':'a.obj'" : small;
    JsonObject numbers = client.numbers(tool, model + arguments);
    JsonElement lengths =
        switch (tool) {
          case "describe" -> numbers.get("bounds");
          case "pixel" -> numbers.get("position");
          default -> numbers.getAsJsonArray("views").get(0).getAsJsonObject().get("depth");
        };
    assertThat(lengths.toString())
        .matches("[\\[\\],\\d.-]+")
        .doesNotContainPattern("\\.\\d{6}")
        .containsPattern(tool.equals("describe") ? "10\\.0" : "\\.\\d{4}");
  }

  /** The exact values of lengths are within a millionth of the diagonal. */
  @ParameterizedTest
  @CsvSource({"1, 1.2345678901", "1e-9, 1.2345678901e-9", "3e8, 123456789.123", "1e-300, 1e-301"})
  void roundedLengthsAreNearTheExactOnes(double side, double exact) {
    Rounding rounding = Rounding.of(Vec3.ZERO, new Vec3(side, 0, 0));
    double rounded = (Double) rounding.values(Map.of("depth", exact)).get("depth");
    assertThat(rounded).isCloseTo(exact, within(1e-6 * side));
    assertThat(rounding.values(Map.of("matrix", List.of(exact))))
        .isEqualTo(Map.of("matrix", List.of(exact)));
  }

  private static List<Double> numbers(JsonArray array) {
    return array.asList().stream().map(JsonElement::getAsDouble).toList();
  }

  /** The rectangle has the pixels of the picture that a command renders of it. */
  @Test
  void aPartIsCutOut() throws Exception {
    String parts =
        "o low\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
            + "o high\nv 5 5 0\nv 6 5 0\nv 5 6 0\nv 5 5 1\nf 5 7 6\nf 5 6 8\nf 5 8 7\nf 6 7 8\n";
    Files.writeString(folder.resolve("a.obj"), parts);
    String call = "'model':'a.obj','width':64,'height':48,'view':'front'";
    JsonObject whole = client.numbers("render", call);
    JsonObject result = client.result("render", call + ",'crop':'hi*'");
    JsonObject values = result.getAsJsonObject("structuredContent");
    List<Integer> crop =
        Arrays.stream(values.get("crop").getAsString().split(",")).map(Integer::valueOf).toList();
    JsonArray box = null;
    JsonObject view = whole.getAsJsonArray("views").get(0).getAsJsonObject();
    for (JsonElement part : view.getAsJsonArray("visible_parts")) {
      if (part.getAsJsonObject().get("name").getAsString().equals("high")) {
        box = part.getAsJsonObject().getAsJsonArray("box");
      }
    }
    assertThat(crop.get(0)).isEqualTo(box.get(0).getAsInt() - 2);
    assertThat(crop.get(1)).isEqualTo(Math.max(0, box.get(1).getAsInt() - 2));
    assertThat(crop.get(0) + crop.get(2)).isEqualTo(Math.min(64, box.get(2).getAsInt() + 2));
    assertThat(crop.get(1) + crop.get(3)).isEqualTo(box.get(3).getAsInt() + 2);
    String line = "render T/parts/a.obj --size 64x48 --view front --quiet -o T/a.png --crop ";
    int[] expected = commanded(line + values.get("crop").getAsString(), "a.png");
    assertThat(picture(result)).isEqualTo(expected);
    int low = crop.get(3) - 4; // In the corner of the part that is at the lower left.
    JsonObject pixel = client.numbers("pixel", call + ",'crop':'high','x':3,'y':" + low);
    assertThat(pixel.get("color").getAsString())
        .isEqualTo("#%06x".formatted(expected[low * crop.get(2) + 3] & 0xffffff));
    assertThat(pixel.get("part").getAsString()).isEqualTo("high");
    assertThat(client.failure("pixel", call + ",'crop':'high','x':63,'y':0"))
        .isEqualTo(
            "x, y: expected a pixel of %dx%d, found 63,0".formatted(crop.get(2), crop.get(3)));
    assertThat(client.failure("render", call + ",'crop':'hihg'"))
        .isEqualTo(
            "crop: expected \"low\", \"high\", found \"hihg\"; did you mean high?");
    Files.writeString(
        folder.resolve("a.obj"), parts + "o wall\nv 0 0 9\nv 99 0 9\nv 0 99 9\nf 9 10 11\n");
    assertThat(client.failure("render", "'model':'a.obj','view':'front','crop':'high'"))
        .startsWith("crop: expected \"wall\", found \"high\", which is not seen");
  }

  @Test
  void aPixelHasPathsIfAskedFor() throws Exception {
    String arguments = SMALL + ",'x':16,'y':12,'view':'front','samples':3,'paths':true";
    JsonObject paths = client.numbers("pixel", arguments).getAsJsonObject("paths");
    assertThat(paths.get("samples").getAsInt()).isEqualTo(3);
    assertThat(paths.getAsJsonArray("brightest")).hasSize(1);
  }

  @Test
  void aPixelBesideTheModelHasNoPart() throws Exception {
    JsonObject result = client.result("pixel", SMALL + ",'x':0,'y':0,'background':'#123456'");
    String text =
        result.getAsJsonArray("content").get(0).getAsJsonObject().get("text").getAsString();
    assertThat(text)
        .isEqualTo("part: none\nposition: none\nnormal: none\ncolor: #123456\ndepth: none");
  }

  @Test
  void aModelIsDescribed() throws Exception {
    JsonObject numbers = client.numbers("describe", "'model':'sample.glb'");
    assertThat(numbers.get("triangles").getAsInt()).isEqualTo(4);
    assertThat(numbers.get("material_names")).hasToString("[\"paint\"]");
  }

  @Test
  void picturesAreCompared() throws Exception {
    HostileCallsTest.write(folder.resolve("a.png"), 0x808080);
    HostileCallsTest.write(folder.resolve("b.png"), 0xff8000);
    JsonObject same = client.numbers("compare", "'picture':'a.png','reference':'a.png'");
    assertThat(same.get("flip").getAsDouble()).isZero();
    assertThat(same.get("ssim").getAsDouble()).isEqualTo(1);
    JsonObject other = client.result("compare", "'picture':'a.png','reference':'b.png'");
    assertThat(other.getAsJsonObject("structuredContent").get("flip").getAsDouble())
        .isGreaterThan(.1);
    assertThat(picture(other)).hasSize(24 * 16);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "render | ,'view':'up' | view: ",
        "render | ,'view':'1e99,nan' | view: ",
        "render | ,'width':4096 | width: expected an integer from 16 to 1024, found 4096",
        "render | ,'hide':['nothing'] | sample.glb: hide: expected",
        "section | ,'planes':['x=-50%'] | sample.glb: section: ",
        "render | ,'planes':['x=1'] | \"planes\": expected one of the arguments",
        "section | ,'planes':['x=oops'] | planes: ",
        "render | ,'camera':'near' | sample.glb: cameras: expected",
        "render | ,'camera':'close','view':'top' | camera and view: expected only one of them",
        "render | ,'eye':'1,1,1','target':'1,1,1' | eye and target: expected two different points",
        "render | ,'eye':'1,1' | eye: expected",
        "render | ,'zoom':0 | zoom: expected a number from",
        "render | ,'fit':'nothing' | fit: expected",
        "views | ,'eye':'1,1,1' | \"eye\": expected one of the arguments",
        "render | ,'ground':true,'look':'lines' | ground: cannot be combined with the look",
        "render | ,'fov':180 | fov: expected a number in (0, 180), found 180",
        "render | ,'fov':'30' | fov: expected a number in (0, 180), found \"30\"",
        "render | ,'unit':0 | unit: expected a number from ",
        "views | ,'pose':'fly@0' | sample.glb: animations: expected",
        "views | ,'pose':'lift@1e999' | pose: expected a finite number",
        "views | ,'variant':'green' | variants: expected",
        "views | ,'background':'blurple' | background: expected sky, transparent,",
        "views | ,'view':'top' | \"view\": expected one of the arguments",
        "views | ,'look':'clay,' | look: expected clay, lines or clay,lines, found clay,",
        "views | ,'highlight':'body' | highlight: expected an array of at most 64 strings"
      })
  void faultsOfArgumentsAreExplained(String tool, String arguments, String part) throws Exception {
    assertThat(
            client.failure(
                tool,
                SMALL.replace(",'width':32", arguments.contains("width") ? "" : ",'width':32")
                    + arguments))
        .contains(part)
        .doesNotContain("Exception");
  }

  @Test
  void aFileThatIsNoModelIsExplained() throws Exception {
    assertThat(client.failure("describe", "'model':'paint.png'"))
        .startsWith("\"paint.png\": expected a model: ");
    Files.writeString(folder.resolve("a.stl"), "solid a\nfacet\n");
    assertThat(client.failure("describe", "'model':'a.stl'")).startsWith("a.stl: ");
    Files.write(folder.resolve("b.glb"), new byte[100]);
    assertThat(client.failure("render", "'model':'b.glb'")).startsWith("b.glb: ");
  }

  /** Four calls at once see the same model from different sides. */
  @Test
  void callsAtOnceShareAModel() throws Exception {
    List<String> views = List.of("front", "top", "iso", "left", "30,20", "-40,70");
    List<String> expected = new ArrayList<>();
    for (String view : views) {
      expected.add(content(client.result("render", SMALL + ",'view':'" + view + "'")));
    }
    for (int round = 0; round < 3; round++) {
      for (int i = 0; i < views.size(); i++) {
        client.send(i, "render", SMALL + ",'view':'" + views.get(i) + "'");
      }
      for (int i = 0; i < views.size(); i++) {
        JsonObject answer = client.next();
        assertThat(content(answer.getAsJsonObject("result")))
            .isEqualTo(expected.get(answer.get("id").getAsInt()));
      }
    }
  }

  private static String content(JsonObject result) {
    JsonElement content = result.get("content");
    return content.toString();
  }
}
