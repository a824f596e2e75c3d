package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageReader;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.internal.CssColor;
import io.github.lumbre.image.internal.LinearReader;
import io.github.lumbre.image.internal.Srgb;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import javax.imageio.ImageIO;
import javax.imageio.ImageReadParam;
import javax.imageio.stream.ImageInputStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The color behind a model is the stated one in every picture for the screen. */
class BackgroundColorTest extends CommandFixture {
  private static final String SMALL = " --size 24x18 -s 2 --quiet --overwrite";

  @BeforeEach
  void writeModel() throws IOException {
    ModelSample.write(directory);
  }

  private int corner(String name) throws IOException {
    BufferedImage picture = picture(name);
    assertThat(picture.getColorModel().hasAlpha()).isFalse();
    return picture.getRGB(0, 0) & 0xffffff;
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "white | ffffff",
        "#ff0000 | ff0000",
        "336699 | 336699",
        "#0Af | 00aaff",
        "RebeccaPurple | 663399",
        "gray --exposure 2 --tonemap aces | 808080",
        "tomato --exposure -3 --tonemap gamma22 | ff6347",
        "Peru --exposure auto --no-denoise --tonemap agx | cd853f",
        "black --sky-intensity 1000 | 000000",
        "orange --look clay,lines --labels all --exposure 1 | ffa500",
        "navy --ground --view 20,5 | 000080"
      })
  void pngsHaveTheStatedColor(String flags, String expected) throws IOException {
    runs("render T/sample.glb -o T/a.png --background " + flags + SMALL);
    assertThat(corner("a.png")).isEqualTo(Integer.parseInt(expected, 16));
  }

  @Test
  void allColorsAndDepthsAreExact() {
    for (int i = 0; i < 256; i++) {
      Rgb color = CssColor.of("#%02x%02x%02x".formatted(i, 255 - i, i / 2)).orElseThrow();
      assertThat(CssColor.of(CssColor.text(color))).contains(color);
    }
    Rgb between = new Rgb(.1, .2, 1 / 3.);
    assertThat(CssColor.of(CssColor.text(between))).contains(between);
    assertThat(CssColor.known()).hasSize(148);
    for (String text : new String[] {"", "#", "#12", "#12345", "#1234567", "#ff00ff80", "reds"}) {
      assertThat(CssColor.of(text)).as(text).isEmpty();
    }
  }

  @Test
  void deepPicturesAndJpegsHaveTheColor() throws IOException {
    runs("render T/sample.glb -o T/a.png --bits 16 --background salmon" + SMALL);
    Pixels deep = ImageReader.decode(bytes("a.png"));
    assertThat(deep.raw(0, 0, 0)).isEqualTo(257 * 0xfa);
    assertThat(deep.raw(0, 0, 1)).isEqualTo(257 * 0x80);
    runs("render T/sample.glb -o T/a.jpg --background salmon" + SMALL);
    int jpeg = corner("a.jpg");
    assertThat(jpeg >> 16).isCloseTo(0xfa, within(2));
    assertThat(jpeg >> 8 & 255).isCloseTo(0x80, within(2));
    assertThat(jpeg & 255).isCloseTo(0x72, within(2));
  }

  /** In linear light, the background is the light of the color, and there is no alpha. */
  @ParameterizedTest
  @ValueSource(strings = {"a.exr", "a.pfm"})
  void linearPicturesHaveItsLight(String name) throws IOException {
    runs("render T/sample.glb -o T/" + name + " --background teal --exposure 3" + SMALL);
    Image image = LinearReader.read(directory.resolve(name));
    assertThat(image.hasAlpha()).isFalse();
    assertThat(image.pixel(0, 0).r()).isZero();
    assertThat(image.pixel(0, 0).g()).isCloseTo(Srgb.decode(128 / 255.), within(1e-6));
  }

  /** Each pixel mixes the color with what the model's samples show, in the light of the screen. */
  @ParameterizedTest
  @ValueSource(strings = {"neutral", "gamma22"})
  void edgesAreMixedByCoverage(String curve) throws IOException {
    String how = " --no-denoise --bits 16 --exposure 1.5 --tonemap " + curve;
    how += " --size 32x24 -s 16 --quiet --overwrite";
    runs("render T/sample.glb -o T/alpha.png --background transparent" + how);
    runs("render T/sample.glb -o T/lime.png --background lime" + how);
    Pixels alpha = ImageReader.decode(bytes("alpha.png"));
    Pixels lime = ImageReader.decode(bytes("lime.png"));
    int partial = 0;
    for (int i = 0; i < 32 * 24; i++) {
      int x = i % 32;
      int y = i / 32;
      double share = alpha.alpha(x, y) / 65535.;
      partial += share > 0 && share < 1 ? 1 : 0;
      for (int c = 0; c < 3; c++) {
        double light = share * linear(alpha.raw(x, y, c), curve) + (c == 1 ? 1 - share : 0);
        assertThat(linear(lime.raw(x, y, c), curve)).isCloseTo(light, within(1e-4));
      }
    }
    assertThat(partial).isGreaterThan(10);
  }

  private static double linear(int value, String curve) {
    double encoded = value / 65535.;
    return curve.equals("gamma22") ? Math.pow(encoded, 2.2) : Srgb.decode(encoded);
  }

  @Test
  void viewsAndTheirSheetHaveTheColor() throws IOException {
    runs("views T/sample.glb -o T/v --background plum --size 64x48 -s 1");
    assertThat(corner("v/front.png")).isEqualTo(0xdda0dd);
    BufferedImage sheet = ImageIO.read(directory.resolve("v/views.png").toFile());
    assertThat(sheet.getRGB(0, 0) & 0xffffff).isEqualTo(0xdda0dd);
    assertThat(sheet.getRGB(64, 0) & 0xffffff).as("the gap").isEqualTo(0xffffff);
  }

  @ParameterizedTest
  @ValueSource(strings = {"a.gif", "a.apng"})
  void animationsHaveTheColor(String name) throws IOException {
    // Many colors: the palette of a GIF must not mix the background with them.
    String flags = " --no-denoise --sky sun --look clay --background #7b5d3f --size 96x72 -s 2";
    runs("render T/sample.glb --turntable 2 --quiet -o T/" + name + flags);
    try (ImageInputStream in = ImageIO.createImageInputStream(directory.resolve(name).toFile())) {
      javax.imageio.ImageReader reader = ImageIO.getImageReaders(in).next();
      reader.setInput(in);
      BufferedImage frame = reader.read(0, new ImageReadParam());
      assertThat(frame.getRGB(0, 0) & 0xffffff).isEqualTo(0x7b5d3f);
      assertThat(frame.getRGB(95, 30) & 0xffffff).isEqualTo(0x7b5d3f);
    }
  }

  @Test
  void filmsAreDevelopedAndMergedWithTheColor() throws IOException {
    String flags = " --size 24x18 -s 4 --quiet --no-denoise --background ";
    runs("render T/sample.glb -o T/a.png --checkpoint T/a.film" + flags + "coral");
    runs("render T/sample.glb -o T/c.png --checkpoint T/c.film --samples-from 4" + flags + "coral");
    runs("render T/sample.glb -o T/b.png --checkpoint T/b.film --samples-from 4" + flags + "blue");
    runs("develop T/a.film -o T/developed.png");
    assertThat(pixels("developed.png")).isEqualTo(pixels("a.png"));
    runs("develop T/a.film -o T/bright.png --exposure 2 --tonemap aces --denoise");
    assertThat(corner("bright.png")).isEqualTo(0xff7f50);
    runs("develop T/a.film -o T/light.exr");
    assertThat(LinearReader.read(directory.resolve("light.exr")).hasAlpha()).isFalse();
    runs("denoise T/a.film -o T/clean.png");
    assertThat(corner("clean.png")).isEqualTo(0xff7f50);
    runs("merge T/a.film T/c.film -o T/merged.png");
    assertThat(corner("merged.png")).isEqualTo(0xff7f50);
    run("merge T/a.film T/b.film -o T/no.png")
        .assertFailed(ExitCodes.SCENE, "backplate: ", "#ff7f50", "#0000ff");
  }

  @Test
  void importedScenesHaveTheColor() throws IOException {
    runs("import T/sample.glb --background Coral -o T/scene.json");
    assertThat(directory.resolve("scene.json")).content().contains("\"backplate\": \"#ff7f50\"");
    runs("render T/scene.json -o T/scene.png --no-denoise" + SMALL);
    runs("render T/sample.glb -o T/model.png --no-denoise --background coral" + SMALL);
    assertThat(pixels("scene.png")).isEqualTo(pixels("model.png"));
  }

  /** Clear glass shows the light of the color, times its tint; holes of a surface show the color. */
  @ParameterizedTest
  @ValueSource(strings = {"path", "ray"})
  void clearGlassShowsItsLight(String mode) throws IOException {
    Files.writeString(directory.resolve("pane.json"), PANES.replace("MODE", mode));
    runs("render T/pane.json -o T/a.png -s 16 --quiet --no-denoise --tonemap aces");
    BufferedImage picture = picture("a.png");
    assertThat(picture.getRGB(1, 1) & 0xffffff).isEqualTo(0xffffff);
    assertThat(picture.getRGB(8, 8) & 0xffffff).as("a hole").isEqualTo(0xffffff);
    runs("render T/pane.json -o T/a.exr -s 16 --quiet --no-denoise");
    Rgb glass = LinearReader.read(directory.resolve("a.exr")).pixel(24, 8);
    assertThat(glass.r()).isCloseTo(.5, within(1e-6));
    assertThat(glass.g()).isCloseTo(.25, within(1e-6));
    double x = .5;
    double shown = x * (2.51 * x + .03) / (x * (2.43 * x + .59) + .14);
    assertThat(picture.getRGB(24, 8) >> 16 & 255).isEqualTo((int) Math.round(255 * srgb(shown)));
  }

  private static double srgb(double linear) {
    return 1.055 * Math.pow(linear, 1 / 2.4) - .055;
  }

  private static final String PANES =
      """
      {"mainCameraId": 1,
       "renderOptions": {"width": 32, "height": 16, "mode": "MODE", "backplate": "white",
         "background": {"r": 0, "g": 0, "b": 0}},
       "assets": [
         {"assetType": "Material", "id": 1, "materialType": "MetallicRoughness", "metallic": 0,
          "baseColor": {"r": 0.5, "g": 0.25, "b": 0}, "roughness": 0, "specular": 0,
          "transmission": 1},
         {"assetType": "Material", "id": 2, "materialType": "MetallicRoughness", "opacity": 0}],
       "objects": [
         {"type": "Camera", "id": 1, "cameraType": "Orthographic", "height": 2,
          "localPosition": {"x": 0, "y": 0, "z": -5}},
         {"type": "Shape", "shapeType": "Plane", "materialID": 1, "finite": true,
          "twoSided": true, "localPosition": {"x": 1, "y": 0, "z": 0},
          "localRotation": {"x": -90, "y": 0, "z": 0}},
         {"type": "Shape", "shapeType": "Plane", "materialID": 2, "finite": true,
          "twoSided": true, "localPosition": {"x": -1, "y": 0, "z": 0},
          "localRotation": {"x": -90, "y": 0, "z": 0}}]}
      """;
}
