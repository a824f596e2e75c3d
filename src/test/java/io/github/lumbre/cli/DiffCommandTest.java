package io.github.lumbre.cli;

import static java.nio.charset.StandardCharsets.ISO_8859_1;
import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonObject;
import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.image.internal.Srgb;
import io.github.lumbre.model.format.threemf.ThreeMfSample;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Base64;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class DiffCommandTest extends CommandFixture {
  private static final String PLATE =
      "v 0 0 0\nv 4 0 0\nv 0 3 0\no plate\nusemtl steel\nf -3 -2 -1\n";
  private static final String BOLT =
      "v 9 0 %s\nv 10 0 %s\nv 9 2 %s\no bolt\nusemtl %s\nf -3 -2 -1\n";

  @BeforeEach
  void write() throws IOException {
    Files.writeString(
        directory.resolve("a.mtl"), "newmtl steel\nKd .5 .5 .5\nnewmtl brass\nKd 1 .8 .1\n");
    write("old.obj", PLATE + bolt("0", "steel"));
    write("same.obj", bolt("1e-7", "steel") + PLATE);
    write("moved.obj", PLATE + bolt(".001", "steel"));
    write("brass.obj", PLATE + bolt("0", "brass"));
    write("plate.obj", PLATE);
  }

  private void write(String name, String model) throws IOException {
    Files.writeString(directory.resolve(name), "mtllib a.mtl\n" + model);
  }

  private static String bolt(String z, String material) {
    return BOLT.formatted(z, z, z, material);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "old.obj   | 0 | 2 the same",
        "same.obj  | 0 | 2 the same",
        "moved.obj | 1 | 'moved    bolt  by (0, 0, 0.001)'",
        "brass.obj | 1 | 'changed  bolt  another material'",
        "plate.obj | 1 | 'removed  bolt'"
      })
  void whatChangedIsSaid(String now, int code, String part) {
    Outcome outcome = run("diff T/old.obj T/" + now);
    assertThat(outcome.exitCode()).as(outcome.err()).isEqualTo(code);
    assertThat(outcome.out()).contains(part);
    assertThat(outcome.err()).isEmpty();
  }

  /** The flags correct a file that states its axis and unit, unless the other one states none. */
  @Test
  void axisAndUnitAreMeantForTheFileThatStatesNone() throws IOException {
    Files.write(directory.resolve("a.3mf"), ThreeMfSample.square());
    Files.writeString(
        directory.resolve("a.stl"),
        """
        solid
        facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0
        endloop\nendfacet
        facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 1 0\nvertex 0 1 0
        endloop\nendfacet
        endsolid
        """);
    String flags = " --up z --unit 0.001";
    assertThat(run("diff T/a.stl T/a.3mf" + flags).out()).contains("1 without a change found");
    assertThat(run("diff T/a.3mf T/a.stl" + flags).out()).contains("1 without a change found");
    assertThat(run("diff T/a.3mf T/a.stl").exitCode()).isEqualTo(1);
    assertThat(run("diff T/a.3mf T/a.3mf --up y --unit 2").exitCode()).isZero();
  }

  /** What a file lacks for its pictures, it lacks for a comparison. */
  @Test
  void warningsOfTheModelsArePrinted() throws IOException {
    write("lines.obj", PLATE + "l 1 2\n");
    Outcome outcome = run("diff T/lines.obj T/plate.obj").done();
    assertThat(outcome.err()).contains("warning: ", "lines.obj: ").hasLineCount(1);
  }

  @Test
  void aCoarserToleranceAllowsMore() {
    assertThat(run("diff T/old.obj T/moved.obj --tolerance .01").exitCode()).isZero();
  }

  @Test
  void jsonHasTheNumbers() {
    Outcome outcome = run("diff T/old.obj T/moved.obj --json --tolerance 1e-5");
    JsonObject json = outcome.json();
    assertThat(json.get("format").getAsString()).isEqualTo("lumbre-diff-1");
    assertThat(json.get("same").getAsInt()).isEqualTo(1);
    assertThat(outcome.out()).contains("\"tolerance\": 0.00001,", "\"distance\": 0.001,");
  }

  @Test
  void namesAreSafeInTheTerminalAndOnThePage() throws IOException {
    String evil = "<b>\"'&\u001b[31m";
    write("evil.obj", PLATE + bolt("0", "steel"));
    write("evil2.obj", PLATE + bolt("1", "steel"));
    for (String name : new String[] {"evil.obj", "evil2.obj"}) {
      Path file = directory.resolve(name);
      Files.writeString(file, Files.readString(file).replace("o bolt", "o " + evil));
    }
    Outcome outcome = run("diff T/evil.obj T/evil2.obj -o T/page.html --size 64x48");
    assertThat(outcome.exitCode()).as(outcome.err()).isEqualTo(ExitCodes.DIFFERENT);
    assertThat(outcome.out()).contains("<b>\"'&\\u001b[31m").doesNotContain("\u001b");
    String page = Files.readString(directory.resolve("page.html"));
    assertThat(page)
        .contains("&lt;b&gt;&quot;'&amp;")
        .doesNotContain("<b>", "\u001b", "<script")
        .doesNotContainPattern("(src|href)=\"(?!data:)");
    assertThat(page.split("data:image/png;base64,")).hasSize(4);
  }

  /** A part that is gone is shown where it was, also in front of one that changed. */
  @Test
  void whatIsGoneIsShownBeforeWhatChanged() throws IOException {
    String bolt = "v 1 1 %s\nv 2 1 %s\nv 1 2 %s\no bolt\nf -3 -2 -1\n";
    write("brass.obj", PLATE.replace("steel", "brass"));
    for (String z : new String[] {"1", "-1"}) {
      write("gone.obj", PLATE + bolt.replace("%s", z));
      long mixed = 0;
      for (int rgb : changes("diff T/gone.obj T/brass.obj --size 160x120")) {
        double green = Srgb.decode((rgb >> 8 & 255) / 255.) / Srgb.decode((rgb >> 16 & 255) / 255.);
        // Green by red: 0.44 of what changed, 0.17 of what is gone; blue is in pale parts only.
        mixed += (rgb & 255) < 20 && green > .2 && green < .38 ? 1 : 0;
      }
      assertThat(mixed > 250).as(z + ": " + mixed).isEqualTo(z.equals("1"));
    }
  }

  /** Its old place is not drawn over it: the colors of both are mixed nowhere in its middle. */
  @Test
  void aMovedPartIsShownWhereItIs() throws IOException {
    write("old.obj", PLATE.replace(" 0\n", " .5\n"));
    write("moved.obj", PLATE);
    long moved = 0;
    long mixed = 0;
    for (int rgb : changes("diff T/old.obj T/moved.obj --size 320x240")) {
      // What moved has no red, what is gone no blue, and what is pale has red, green and blue.
      boolean isBlue = (rgb & 255) > (rgb >> 8 & 255) + 20;
      moved += isBlue && (rgb >> 16 & 255) < 20 ? 1 : 0;
      mixed += (rgb >> 16 & 255) > (rgb >> 8 & 255) + 20 && (rgb & 255) > 60 ? 1 : 0;
    }
    assertThat(moved).isGreaterThan(2500);
    assertThat(mixed).isLessThan(moved / 5);
  }

  /** Returns the pixels of the last picture on the page of a comparison, seen from the front. */
  private int[] changes(String line) throws IOException {
    run(line + " -o T/page.html --view front");
    String page = Files.readString(directory.resolve("page.html"));
    String data = page.substring(page.lastIndexOf("base64,") + 7);
    byte[] png = Base64.getDecoder().decode(data.substring(0, data.indexOf('"')));
    BufferedImage image = ImageIO.read(new ByteArrayInputStream(png));
    int width = image.getWidth();
    return image.getRGB(0, 0, width, image.getHeight(), null, 0, width);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "T/old.obj T/moved.obj --size 0x4 | 2 | --size: expected",
        "T/none.obj T/old.obj             | 3 | none.obj",
        "T/a.mtl T/old.obj                | 2 | expected a model file",
        "T/old.obj T/old.obj --tolerance 0   | 2 | --tolerance",
        "T/old.obj T/old.obj --tolerance NaN | 2 | --tolerance",
        "T/old.obj T/moved.obj -o T/moved.obj   | 6 | is a model",
        "T/old.obj T/broken.glb | 3 | broken.glb",
        "T/old.obj T/moved.obj --hide nut | 3 | old.obj: --hide: expected",
        "T/old.obj T/moved.obj --camera a | 2 | --camera: cannot be used; one camera, from --view",
        "T/old.obj T/moved.obj -o T/p.html --sky T/broken.png | 4 | --sky: "
      })
  void faultsAreExplained(String arguments, int code, String part) throws IOException {
    Files.write(directory.resolve("broken.glb"), new byte[40]);
    Files.writeString(directory.resolve("broken.png"), "\211PNG\r\n\032\n", ISO_8859_1);
    Outcome outcome = run("diff " + arguments);
    assertThat(outcome.err()).contains(part).doesNotContain("Exception");
    assertThat(outcome.exitCode()).isEqualTo(code);
    assertThat(Files.readString(directory.resolve("moved.obj"))).contains("o bolt");
  }

  /** Far and tiny parts, and points. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "v 1e30 0 0\nv 0 1e30 0\nv 0 0 1e30\no far\nf 1 2 3\n",
        "v 1e-30 0 0\nv 0 1e-30 0\nv 0 0 1e-30\no tiny\nf 1 2 3\n",
        "v 0 0 0\nv 0 1 0\nv 5 0 1\np 1 2 3\n"
      })
  void unusualModelsHaveADifference(String model) throws IOException {
    write("odd.obj", model);
    write("odd2.obj", model + PLATE);
    assertThat(run("diff T/odd.obj T/odd.obj").out()).contains(": 1 the same");
    Outcome outcome = run("diff T/odd.obj T/odd2.obj --json");
    assertThat(outcome.err()).isEmpty();
    assertThat(outcome.json().get("changes").toString()).contains("added");
  }

  /** Variants that are not shown may differ, so that nothing is called the same. */
  @Test
  void whatIsNotComparedIsSaidInsteadOfTheSame() throws IOException {
    ModelSample.write(directory);
    String files = "T/sample.glb T/sample.glb";
    Outcome outcome = run("diff " + files + " -o T/page.html --view front --size 64x48").done();
    String line = "materials of variants that are not shown";
    assertThat(outcome.out())
        .contains(": 1 without a change found\n", "\nnot compared: " + line + "\n")
        .doesNotContain("same");
    assertThat(Files.readString(directory.resolve("page.html")))
        .contains("<p>Not compared: " + line + ".</p>")
        .doesNotContain("same");
    assertThat(run("diff " + files + " --json").out())
        .contains("\"notCompared\": [\n", line, "\"withoutChangeFound\": 1")
        .doesNotContain("\"same\"");
  }

  @Test
  void whatFacesShowIsCompared() throws IOException {
    String face = "v 0 0 0 1 0 0\nv 4 0 0 1 0 0\nv 0 3 0 1 0 0\no plate\nf -3 -2 -1\n";
    write("red.obj", face);
    write("blue.obj", face.replace("1 0 0\n", "0 0 1\n"));
    write("back.obj", face.replace("-3 -2 -1", "-3 -1 -2"));
    Outcome blue = run("diff T/red.obj T/blue.obj");
    assertThat(blue.exitCode()).isEqualTo(ExitCodes.DIFFERENT);
    assertThat(blue.out()).contains("changed  plate  other vertex colors");
    Outcome back = run("diff T/red.obj T/back.obj");
    assertThat(back.exitCode()).isEqualTo(ExitCodes.DIFFERENT);
    assertThat(back.out()).contains("changed  plate  triangles turned over");
  }

  /** The colors beside the words are those of the picture, which is shaded. */
  @Test
  void theLegendHasTheColorsOfThePicture() throws IOException {
    write("far.obj", PLATE.replace("v 4", "v 10").replace("v 0", "v 6"));
    write("near.obj", PLATE);
    int[] pixels = changes("diff T/far.obj T/near.obj --size 120x90");
    assertThat(pixels).hasSize(120 * 90);
    Matcher keys =
        Pattern.compile("background:#([0-9a-f]{6})\"></span>([a-z ]+)")
            .matcher(Files.readString(directory.resolve("page.html")));
    int count = 0;
    while (keys.find()) {
      int key = Integer.parseInt(keys.group(1), 16);
      long near = Arrays.stream(pixels).filter(rgb -> isNear(rgb, key)).count();
      assertThat(near).as(keys.group(2)).isGreaterThan(300);
      count++;
    }
    assertThat(count).as("moved, where it was").isEqualTo(2);
  }

  private static boolean isNear(int rgb, int key) {
    int most = 0;
    for (int shift = 0; shift < 24; shift += 8) {
      most = Math.max(most, Math.abs((rgb >> shift & 255) - (key >> shift & 255)));
    }
    return most < 12;
  }
}
