package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageLayer;
import io.github.lumbre.image.LayeredImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Renders each of the small files in {@code src/test/resources/cases}, whose README says what each
 * must show. Tests of the kinds they stand for, with generated files, are beside the readers.
 */
class CasesTest {
  private static final Path CASES = Path.of("src/test/resources/cases");
  private static final List<String> FRAME =
      List.of("-s", "4", "--size", "64x64", "--background", "transparent");

  @TempDir private Path folder;

  /** What a command printed, and its picture. */
  private record Shown(Outcome outcome, Image image) {
    double coverage() {
      double sum = 0;
      for (int y = 0; y < image.height(); y++) {
        for (int x = 0; x < image.width(); x++) {
          sum += image.alpha(x, y);
        }
      }
      return sum / (image.width() * image.height());
    }

    boolean isCovered(int x, int y) {
      return x >= 0 && y >= 0 && x < image.width() && y < image.height() && image.alpha(x, y) > 0;
    }

    /** Returns the smallest alpha of the pixels whose eight neighbors are covered. */
    float leastInside() {
      float least = Float.POSITIVE_INFINITY;
      for (int y = 0; y < image.height(); y++) {
        for (int x = 0; x < image.width(); x++) {
          boolean isInside = true;
          for (int i = 0; i < 9; i++) {
            isInside &= isCovered(x + i % 3 - 1, y + i / 3 - 1);
          }
          if (isInside) {
            least = Math.min(least, image.alpha(x, y));
          }
        }
      }
      return least;
    }

    /** Returns the color in the middle of a quadrant of the frame, red above .5 as R and so on. */
    String quadrant(int number) {
      int x = image.width() * (2 + 4 * (number % 2)) / 8;
      int y = image.height() * (2 + 4 * (number / 2)) / 8;
      double red = image.pixel(x, y).r();
      double green = image.pixel(x, y).g();
      double blue = image.pixel(x, y).b();
      double half = Math.max(red, Math.max(green, blue)) / 2;
      return (red > half ? "r" : "") + (green > half ? "g" : "") + (blue > half ? "b" : "");
    }

    List<String> quadrants() {
      return Stream.of(0, 1, 2, 3).map(this::quadrant).toList();
    }
  }

  private Shown show(String name, String... flags) throws IOException {
    return show(CASES.resolve(name), flags);
  }

  private Shown show(Path model, String... flags) throws IOException {
    Path picture = folder.resolve("x.exr");
    List<String> command = new ArrayList<>(List.of("render", model.toString()));
    command.addAll(FRAME);
    command.addAll(Arrays.asList(flags));
    if (!command.contains("--view")) {
      command.addAll(List.of("--view", "front"));
    }
    if (!command.contains("--sky")) {
      command.addAll(List.of("--sky", "white"));
    }
    command.addAll(List.of("-o", picture.toString(), "--overwrite"));
    Outcome outcome = Outcome.of(command.toArray(String[]::new)).done();
    return new Shown(outcome, image(LayeredImage.read(picture)));
  }

  /** Returns the picture of an OpenEXR file, with its colors as stored. */
  private static Image image(LayeredImage file) {
    ImageLayer layer = file.layer("").orElseThrow();
    int count = layer.channels().size();
    float[] rgb = new float[3 * file.width() * file.height()];
    float[] alpha = new float[file.width() * file.height()];
    for (int i = 0; i < alpha.length; i++) {
      for (int c = 0; c < 3; c++) {
        int channel = layer.channels().indexOf(List.of("R", "G", "B").get(c));
        rgb[3 * i + c] = layer.values()[count * i + channel];
      }
      alpha[i] = layer.values()[count * i + layer.channels().indexOf("A")];
    }
    return new Image(file.width(), file.height(), rgb, alpha);
  }

  private static void assertSamePixels(Shown one, Shown other) {
    assertThat(Arrays.equals(one.image().rgb(), other.image().rgb())).isTrue();
    assertThat(one.coverage()).isEqualTo(other.coverage());
  }

  /** The quad fills most of the frame, with a warning where one is due. */
  @ParameterizedTest
  @CsvSource({
    "tr1.obj, Tr 1",
    "empty_list.ply, warning",
    "nanv.ply, warning",
    "case.obj, QUAD.PNG",
    "quoted.obj, warning",
    "nr_back.glb, ''",
    "back_nomat.glb, ''"
  })
  void isShownFromTheFront(String name, String warning) throws IOException {
    Shown shown = show(name);
    assertThat(shown.coverage()).isGreaterThan(.6);
    assertThat(shown.leastInside()).isEqualTo(1);
    assertThat(shown.outcome().err()).contains(warning);
    if (warning.isEmpty()) {
      assertThat(shown.outcome().err()).doesNotContain("warning");
    }
  }

  @ParameterizedTest
  @CsvSource({"nr_back.glb", "back_nomat.glb"})
  void isCulledFromTheBack(String name) throws IOException {
    assertThat(show(name, "--view", "back").coverage()).isZero();
  }

  @Test
  void aTransparentMaterialIsNamed() throws IOException {
    Shown shown = show("d0.obj");
    assertThat(shown.coverage()).isZero();
    assertThat(shown.outcome().err()).contains("warning", "invisible");
  }

  @ParameterizedTest
  @CsvSource({"pal8_trns_MASK.glb", "rgb_trns_MASK.glb"})
  void transparencyOfPngIsRead(String name) throws IOException {
    Shown shown = show(name);
    assertSamePixels(shown, show("rgba_MASK.glb"));
    assertThat(shown.coverage()).isBetween(.63, .642);
  }

  @Test
  void aNodeFlattenedToAPlaneIsShown() throws IOException {
    Shown shown = show("flat_plane_only.glb", "--view", "30,40");
    assertThat(shown.coverage()).isGreaterThan(.2);
    assertThat(shown.leastInside()).isEqualTo(1);
  }

  @ParameterizedTest
  @CsvSource({
    "twoprims.glb, front",
    "twoprims.glb, '25,10'",
    "decal_mask0.glb, front",
    "decal_mask0.glb, '25,10'",
    "decal_mask0_o.glb, front",
    "decal_mask0_o.glb, '25,10'"
  })
  void surfacesAtOnePlaceHaveNoHoles(String name, String view) throws IOException {
    for (String kernel : List.of("scalar", "auto")) {
      Shown shown = show(name, "--view", view, "--kernel", kernel);
      assertThat(shown.leastInside()).isEqualTo(1);
    }
  }

  @Test
  void cornersHaveTheirColors() throws IOException {
    assertThat(show("q_unlit.gltf").quadrants())
        .isEqualTo(show("q_lit.gltf").quadrants())
        .doesNotHaveDuplicates();
  }

  @Test
  void normalMapsUseTheirCoordinates() throws IOException {
    assertSamePixels(show("uv1_normal.gltf"), show("uv1_as_set0.gltf"));
  }

  @Test
  void aCoatHasItsNormalMap() throws IOException {
    float[] bumpy = show("coat_normal.gltf", "--sky", "studio").image().rgb();
    float[] plain = show("coat_plain.gltf", "--sky", "studio").image().rgb();
    assertThat(Arrays.equals(bumpy, plain)).isFalse();
  }

  /** {@code quad.png} has four colors, one for each quadrant. */
  @ParameterizedTest
  @CsvSource({"texfile.ply", "case.obj", "quoted.obj"})
  void texturesAreFound(String name) throws IOException {
    Shown shown = show(name);
    assertThat(shown.quadrants()).doesNotHaveDuplicates();
  }

  /** The file has coordinates for each face, but names no picture; here it gets the name. */
  @Test
  void coordinatesOfFacesAreRead() throws IOException {
    String text = Files.readString(CASES.resolve("ushort_texcoord.ply"));
    Path named = folder.resolve("named.ply");
    Files.writeString(
        named, text.replaceFirst("\nelement", "\ncomment TextureFile quad.png\nelement"));
    Files.copy(CASES.resolve("quad.png"), folder.resolve("quad.png"));
    assertThat(show(named).quadrants()).isEqualTo(show("texfile.ply").quadrants());
    assertThat(show("ushort_texcoord.ply").leastInside()).isEqualTo(1);
  }

  /** Colors of vertices are the albedo: the linear value of an sRGB .5 is .2140. */
  @Test
  void colorsOfVerticesAreTheAlbedo() throws IOException {
    Shown shown = show("vc.obj", "--layers", "albedo");
    LayeredImage layers = LayeredImage.read(folder.resolve("x.exr"));
    float[] albedo = layers.layer("albedo").orElseThrow().values();
    float middle = albedo[3 * (32 * 64 + 32)];
    assertThat(shown.leastInside()).isEqualTo(1);
    assertThat(middle).isBetween(.213f, .217f);
  }

  @Test
  void skiesHaveTheirDisplayWindow() throws IOException {
    assertSamePixels(
        show("tr1.obj", "--sky", CASES.resolve("e_overscan.exr").toString()),
        show("tr1.obj", "--sky", CASES.resolve("ref.pfm").toString()));
  }

  @Test
  void aPixelThatIsNotANumberIsNamed() throws IOException {
    String sky = CASES.resolve("e_nan.exr").toString();
    Outcome refused =
        Outcome.in(folder, "render " + CASES.resolve("tr1.obj") + " -o T/y.png --sky " + sky);
    assertThat(refused.exitCode()).isEqualTo(ExitCodes.ASSET);
    assertThat(refused.err()).containsPattern("pixel \\(?\\d+, ?\\d+");
    Shown lenient = show("tr1.obj", "--sky", sky, "--lenient");
    assertThat(lenient.outcome().err()).contains("warning");
  }
}
