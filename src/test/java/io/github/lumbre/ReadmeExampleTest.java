package io.github.lumbre;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.Lumbre;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.lang.reflect.Method;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.spi.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The Java example of the README compiles and writes the same files as {@code lumbre render},
 * except for the text chunks of PNG files, which describe the command line.
 */
class ReadmeExampleTest {
  private static final Pattern JAVA = Pattern.compile("```java\n(.*?)```", Pattern.DOTALL);
  private static final String SCENE = "scenes/cornell-box.json";
  private static final String PICTURE = "cornell-box.png";

  @TempDir private Path directory;

  private static String example() throws IOException {
    Matcher found = JAVA.matcher(Files.readString(Path.of("README.md")));
    assertThat(found.find()).isTrue();
    assertThat(found.group(1)).contains('"' + SCENE + '"', '"' + PICTURE + '"');
    return found.group(1);
  }

  private void runExample(Path scene, Path picture) throws Exception {
    String code =
        example().replace('"' + SCENE + '"', "args[0]").replace('"' + PICTURE + '"', "args[1]");
    String packages =
        "import io.github.lumbre.image.*; import io.github.lumbre.scenefile.*;"
            + " import io.github.lumbre.render.*; import java.nio.file.Path;";
    Path source =
        Files.writeString(
            directory.resolve("Example.java"),
            packages
                + " public class Example { public static void main(String[] args)"
                + " throws Exception {\n"
                + code
                + "} }");
    StringWriter messages = new StringWriter();
    PrintWriter writer = new PrintWriter(messages);
    String[] options = {
      "-cp", System.getProperty("java.class.path"), "-d", "" + directory, "" + source
    };
    int failed = ToolProvider.findFirst("javac").orElseThrow().run(writer, writer, options);
    assertThat(failed).as(messages.toString()).isZero();
    try (URLClassLoader loader = new URLClassLoader(new URL[] {directory.toUri().toURL()})) {
      Method main = loader.loadClass("Example").getMethod("main", String[].class);
      main.invoke(null, (Object) new String[] {"" + scene, "" + picture});
    }
  }

  private static void runCommandLine(Path scene, Path picture) throws Exception {
    Method run =
        Lumbre.class.getDeclaredMethod("run", String[].class, PrintWriter.class, PrintWriter.class);
    run.setAccessible(true);
    StringWriter out = new StringWriter();
    PrintWriter writer = new PrintWriter(out);
    String[] args = {"render", "" + scene, "-o", "" + picture};
    assertThat(run.invoke(null, args, writer, writer)).as(out.toString()).isEqualTo(0);
  }

  private Path scene(String options) throws IOException {
    String text =
        """
        {"mainCameraId": 1,
         "renderOptions": {"width": 20, "height": 15, "samples": 8, OPTIONS},
         "assets": [{"id": 1, "assetType": "Material", "materialType": "Diffuse"}],
         "objects": [
          {"id": 1, "type": "Camera", "cameraType": "Pinhole", "localPosition": {"y": 1, "z": -4}},
          {"id": 2, "type": "Shape", "shapeType": "Sphere", "materialID": 1},
          {"id": 5, "type": "Light", "lightType": "Point", "intensity": 30,
           "localPosition": {"x": 2, "y": 4, "z": -3}}
         ]}
        """;
    return Files.writeString(directory.resolve("scene.json"), text.replace("OPTIONS", options));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "\"seed\": 1",
        "\"exposure\": 1.5",
        "\"exposure\": \"auto\"",
        "\"toneMap\": \"aces\"",
        "\"toneMap\": \"reinhard\", \"exposure\": -2",
        "\"toneMap\": \"gamma22\", \"transparent\": true",
        "\"mode\": \"ray\", \"exposure\": 0.5"
      })
  void exampleWritesTheBytesOfTheCommandLine(String options) throws Exception {
    Path scene = scene(options);
    for (String ending : new String[] {".png", ".pfm"}) {
      Path ours = directory.resolve("ours" + ending);
      Path theirs = directory.resolve("theirs" + ending);
      runExample(scene, ours);
      runCommandLine(scene, theirs);
      assertThat(withoutTexts(Files.readAllBytes(ours)))
          .isEqualTo(withoutTexts(Files.readAllBytes(theirs)));
    }
  }

  /** Without the settings, the same scene gives different bytes. */
  @Test
  void settingsChangeTheBytes() throws Exception {
    Path plain = directory.resolve("plain.png");
    Path bright = directory.resolve("bright.png");
    runExample(scene("\"seed\": 1"), plain);
    runExample(scene("\"seed\": 1, \"exposure\": 1.5"), bright);
    assertThat(Files.readAllBytes(plain)).isNotEqualTo(Files.readAllBytes(bright));
  }

  /** Returns a PNG file without its text chunks; other files unchanged. */
  private static byte[] withoutTexts(byte[] file) {
    if (file[0] == 'P') {
      return file;
    }
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    ByteBuffer in = ByteBuffer.wrap(file);
    out.write(file, 0, 8);
    for (int at = 8; at < file.length; ) {
      int bytes = in.getInt(at) + 12;
      String type = new String(file, at + 4, 4, StandardCharsets.US_ASCII);
      if (!type.equals("tEXt") && !type.equals("iTXt") && !type.equals("zTXt")) {
        out.write(file, at, bytes);
      }
      at += bytes;
    }
    return out.toByteArray();
  }
}
