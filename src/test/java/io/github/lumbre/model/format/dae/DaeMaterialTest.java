package io.github.lumbre.model.format.dae;

import static io.github.lumbre.model.format.dae.DaeSample.SQUARE;
import static io.github.lumbre.model.format.dae.DaeSample.VERTEX;
import static io.github.lumbre.model.format.dae.DaeSample.VERTICES;
import static io.github.lumbre.model.format.dae.DaeSample.source;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.image.ImageReader;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.MaterialParameter;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelFixture;
import io.github.lumbre.model.internal.ModelMaterial;
import io.github.lumbre.model.internal.ModelMaterial.AlphaMode;
import io.github.lumbre.model.internal.ModelPart;
import io.github.lumbre.model.internal.ModelReader;
import io.github.lumbre.model.internal.ModelTexture;
import io.github.lumbre.model.internal.ModelTexture.Wrap;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the materials of COLLADA files. */
class DaeMaterialTest {
  private static final byte[] PNG = Pixels.of(1, 1, 3, new byte[] {1, 2, 3}).toPng();

  private static final String GRAY_GLASS =
      "<diffuse><color>.5 .5 .5 1</color></diffuse><transparent%s><color>%s</color></transparent>"
          + "<transparency><float>%s</float></transparency>";

  /** A square with two sets of texture coordinates, the sets 2 and 7. */
  private static final String MAPPED =
      DaeSample.geometry(
          SQUARE
              + source("t2", "S T", "0 0 1 0 1 1 0 1")
              + source("t7", "S T", "2 2 3 2 3 3 2 3")
              + VERTICES
              + "<triangles material=\"m\">"
              + VERTEX
              + "<input semantic=\"TEXCOORD\" source=\"#t2\" offset=\"0\" set=\"2\"/>"
              + "<input semantic=\"TEXCOORD\" source=\"#t7\" offset=\"0\" set=\"7\"/>"
              + "<p>0 1 2</p></triangles>");

  private static final String DIFFUSE =
      "<diffuse><texture texture=\"sampler\" texcoord=\"UV\"/></diffuse>";

  private static final String IMAGES =
      "<library_images><image id=\"i\" name=\"picture\"><init_from>%s</init_from></image>"
          + "</library_images>";

  private static ModelFixture painted(String shader, String content) {
    String libraries = DaeSample.square() + DaeSample.material(shader, content);
    return DaeSample.fixture(DaeSample.file(libraries, DaeSample.instance()));
  }

  private static ModelMaterial material(String shader, String content)
      throws ModelFormatException {
    return painted(shader, content).part().material();
  }

  private static Rgb color(ModelMaterial material) {
    return material.input(MaterialParameter.BASE_COLOR).factor();
  }

  private static double opacity(ModelMaterial material) {
    return material.alphaMode() == AlphaMode.OPAQUE
        ? 1
        : material.input(MaterialParameter.OPACITY).factor().r();
  }

  @Test
  void lambertIsDiffuse() throws ModelFormatException {
    ModelMaterial read =
        material(
            "lambert",
            "<emission><color>2 3 4 1</color></emission><diffuse><color>.1 .2 .3 1</color>"
                + "</diffuse><specular><color>1 1 1 1</color></specular>");
    assertThat(read.name()).isEqualTo("paint a");
    assertThat(color(read)).isEqualTo(new Rgb(.1, .2, .3));
    assertThat(read.emission().factor()).isEqualTo(new Rgb(2, 3, 4));
    assertThat(read.input(MaterialParameter.SPECULAR).factor()).isEqualTo(Rgb.BLACK);
    assertThat(read.alphaMode()).isEqualTo(AlphaMode.OPAQUE);
    assertThat(read.doubleSided()).isTrue();
  }

  @ParameterizedTest
  @ValueSource(strings = {"phong", "blinn"})
  void phongReflectsAsMtlDoes(String shader) throws ModelFormatException {
    ModelMaterial read =
        material(
            shader,
            "<diffuse><color>.1 .2 .3 1</color></diffuse><specular><color>.5 .25 1 1</color>"
                + "</specular><shininess><float>30</float></shininess>");
    ModelMaterial ofMtl =
        new ModelFixture("a.obj", "mtllib a.mtl\nusemtl x\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n")
            .with("a.mtl", "newmtl x\nKd .1 .2 .3\nKs .5 .25 1\nNs 30\n")
            .part()
            .material();
    assertThat(read.inputs()).isEqualTo(ofMtl.inputs());
    // (2 / 32)^(1/4)
    assertThat(read.input(MaterialParameter.ROUGHNESS).factor().r()).isEqualTo(.5);
  }

  @Test
  void constantShowsItsEmission() throws ModelFormatException {
    ModelMaterial read = material("constant", "<emission><color>.5 .6 .7 1</color></emission>");
    assertThat(color(read)).isEqualTo(Rgb.BLACK);
    assertThat(read.emission().factor()).isEqualTo(new Rgb(.5, .6, .7));
  }

  @Test
  void colorsMayBeParametersOfTheEffectAndOfItsInstance() throws ModelFormatException {
    String text =
        DaeSample.material("lambert", "<diffuse><param ref=\"c\"/></diffuse>")
            .replace(
                "<profile_COMMON>",
                "<profile_COMMON><newparam sid=\"c\"><float3>.1 .2 .3</float3></newparam>");
    String file = DaeSample.file(DaeSample.square() + text, DaeSample.instance());
    assertThat(color(DaeSample.fixture(file).part().material())).isEqualTo(new Rgb(.1, .2, .3));
    String set =
        file.replace(
            "url=\"#a-fx\"/>",
            "url=\"#a-fx\"><setparam ref=\"c\"><float3>.4 .5 .6</float3></setparam>"
                + "</instance_effect>");
    assertThat(color(DaeSample.fixture(set).part().material())).isEqualTo(new Rgb(.4, .5, .6));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "|0 0 0 .5|.5|.25",
        " opaque='A_ONE'|0 0 0 .5|.5|.25",
        " opaque='A_ZERO'|0 0 0 .5|.5|.75",
        " opaque='RGB_ONE'|1 1 1 0|.25|.25",
        " opaque='RGB_ZERO'|1 1 1 0|.25|.75",
        " opaque='RGB_ONE'|0 1 0 0|.5|.35758",
        " opaque='RGB_ZERO'|0 1 0 0|.5|.64242",
        " opaque='RGB_ZERO'|0 0 0 1|0|1",
        " opaque='RGB_ZERO'|0 0 0 1|1|1",
        " opaque='A_ONE'|1 1 1 1|1|1"
      })
  void transparencyHasFourModes(String mode, String color, String transparency, double expected)
      throws ModelFormatException {
    String stated = mode == null ? "" : " " + mode;
    ModelMaterial read = material("phong", GRAY_GLASS.formatted(stated, color, transparency));
    assertThat(opacity(read)).isCloseTo(expected, within(1e-12));
  }

  @Test
  void transparencyNeedsOnlyOneOfItsParts() throws ModelFormatException {
    assertThat(opacity(material("phong", "<transparency><float>.3</float></transparency>")))
        .isEqualTo(.3);
    assertThat(opacity(material("phong", "<transparent><color>1 1 1 .6</color></transparent>")))
        .isEqualTo(.6);
  }

  @Test
  void whollyTransparentModelsAreShown() throws ModelFormatException {
    Model read = painted("phong", GRAY_GLASS.formatted("", "1 1 1 1", "0")).read();
    assertThat(opacity(read.parts().get(0).material())).isEqualTo(1);
    assertThat(read.warnings())
        .containsExactly(
            "all materials are wholly transparent, as some programs write opaque ones; they are"
                + " shown opaque");
  }

  /** If others are visible, an invisible material is meant. */
  @Test
  void oneInvisibleMaterialStaysSo() throws ModelFormatException {
    String libraries =
        DaeSample.square()
            + DaeSample.material("a", "phong", GRAY_GLASS.formatted("", "1 1 1 1", "0"))
            + DaeSample.material("b", "phong", GRAY_GLASS.formatted("", "1 1 1 1", "1"));
    String second = DaeSample.instance().replace("#a", "#b");
    Model read = DaeSample.fixture(DaeSample.file(libraries, DaeSample.instance() + second)).read();
    assertThat(opacity(read.parts().get(0).material())).isZero();
    assertThat(opacity(read.parts().get(1).material())).isEqualTo(1);
    assertThat(read.warnings()).hasSize(1);
    assertThat(read.warnings().get(0)).endsWith("the material is invisible: its opacity is 0");
  }

  @Test
  void numbersOutOfRangeAreReplaced() throws ModelFormatException {
    ModelFixture file =
        painted(
            "phong",
            "<diffuse><color>2 -1 .5 1</color></diffuse><specular><color>nan 1 1 1</color>"
                + "</specular><shininess><float>-5</float></shininess>"
                + "<emission><color>1 2</color></emission>");
    ModelMaterial read = file.part().material();
    assertThat(color(read)).isEqualTo(new Rgb(1, 0, .5));
    assertThat(read.emission().factor()).isEqualTo(Rgb.BLACK);
    assertThat(file.read().warnings())
        .anyMatch(w -> w.endsWith("diffuse: expected 0 to 1, found 2; 1 is used"))
        .anyMatch(w -> w.endsWith("diffuse: expected 0 to 1, found -1; 0 is used"))
        .anyMatch(w -> w.contains("in <color>, found \"nan 1 1 1\"; it is ignored"))
        .anyMatch(w -> w.contains("expected 3 finite numbers in <color>, found \"1 2\""));
  }

  @Test
  void extrasMakeMaterialsOneSided() throws ModelFormatException {
    for (String place : new String[] {"</profile_COMMON>", "</effect>", "</technique></profile"}) {
      for (int sides = 0; sides < 2; sides++) {
        String extra =
            "<extra><technique profile=\"GOOGLEEARTH\"><double_sided>%d</double_sided></technique>"
                .formatted(sides)
                + "</extra>";
        String look =
            DaeSample.material("lambert", "").replaceFirst(place, extra + place);
        String file = DaeSample.file(DaeSample.square() + look, DaeSample.instance());
        assertThat(DaeSample.fixture(file).part().material().doubleSided()).isEqualTo(sides == 1);
      }
    }
  }

  @Test
  void unboundAndMissingMaterialsAreLightGray() throws ModelFormatException {
    String unbound = DaeSample.file(DaeSample.square(), "<instance_geometry url=\"#g\"/>");
    Model read = DaeSample.fixture(unbound).read();
    assertThat(color(read.parts().get(0).material())).isEqualTo(Rgb.gray(.7));
    assertThat(read.warnings())
        .containsExactly(
            "line 8: expected a material bound to \"m\", found none; light gray is used");
    String missing = DaeSample.file(DaeSample.square(), DaeSample.instance());
    assertThat(DaeSample.fixture(missing).read().warnings())
        .containsExactly(
            "line 8: expected the id of a <material>, found \"#a\", which is left out");
    String sameName =
        DaeSample.file(
            DaeSample.square()
                + DaeSample.material("m", "lambert", "<diffuse><color>1 0 0</color></diffuse>"),
            "<instance_geometry url=\"#g\"/>");
    Model guessed = DaeSample.fixture(sameName).read();
    assertThat(color(guessed.parts().get(0).material())).isEqualTo(new Rgb(1, 0, 0));
    assertThat(guessed.warnings().get(0)).endsWith("found none; that of this id is used");
  }

  /** Returns a file with a picture, which is found through parameters of the effect. */
  private static ModelFixture mapped(String parameters, String uri, String bound) {
    String look =
        DaeSample.material("lambert", DIFFUSE)
            .replace("<profile_COMMON>", "<profile_COMMON>" + parameters);
    return DaeSample.fixture(
            DaeSample.file(
                MAPPED + IMAGES.formatted(uri) + look,
                DaeSample.instance(
                    "<instance_material symbol=\"m\" target=\"#a\">"
                        + bound
                        + "</instance_material>")))
        .with("a.png", PNG);
  }

  private static final String SURFACE =
      "<newparam sid=\"s\"><surface type=\"2D\"><init_from>i</init_from></surface></newparam>"
          + "<newparam sid=\"sampler\"><sampler2D><source>s</source><wrap_s>MIRROR</wrap_s>"
          + "<wrap_t>CLAMP</wrap_t><magfilter>NEAREST</magfilter></sampler2D></newparam>";

  private static final String SET_7 =
      "<bind_vertex_input semantic=\"UV\" input_semantic=\"TEXCOORD\" input_set=\"7\"/>";

  private static ModelTexture texture(ModelPart part) {
    return part.material().input(MaterialParameter.BASE_COLOR).texture().orElseThrow();
  }

  @Test
  void picturesAreFoundThroughSamplerAndSurface() throws ModelFormatException {
    ModelPart part = mapped(SURFACE, "./a.png", SET_7).part();
    ModelTexture texture = texture(part);
    assertThat(texture.image().encoded()).isEqualTo(PNG);
    assertThat(texture.wrapU()).isEqualTo(Wrap.MIRROR);
    assertThat(texture.wrapV()).isEqualTo(Wrap.CLAMP);
    assertThat(texture.nearest()).isTrue();
    assertThat(texture.uvSet()).isZero();
    assertThat(color(part.material())).isEqualTo(Rgb.WHITE);
    assertThat(part.geometry().uv0()).containsExactly(2, 2, 3, 2, 3, 3);
  }

  @Test
  void picturesAreFoundOtherwise() throws ModelFormatException {
    String of15 =
        "<newparam sid=\"sampler\"><sampler2D><instance_image url=\"#i\"/></sampler2D></newparam>";
    assertThat(texture(mapped(of15, "<ref>a.png</ref>", SET_7).part()).wrapU())
        .isEqualTo(Wrap.REPEAT);
    String direct = DIFFUSE.replace("sampler", "i");
    for (String id : new String[] {"i", "picture"}) {
      String look = DaeSample.material("lambert", direct.replace("\"i\"", "\"" + id + "\""));
      String file =
          DaeSample.file(MAPPED + IMAGES.formatted("a.png") + look, DaeSample.instance());
      assertThat(texture(DaeSample.fixture(file).with("a.png", PNG).part()).image().encoded())
          .isEqualTo(PNG);
    }
  }

  @Test
  void setsThatAreNotBoundAreTheFirst() throws ModelFormatException {
    ModelFixture file = mapped(SURFACE, "a.png", "");
    assertThat(file.geometry().uv0()).containsExactly(0, 0, 1, 0, 1, 1);
    assertThat(file.read().warnings())
        .anyMatch(
            w -> w.endsWith("texture coordinates bound to \"UV\", found none; the set 2 is used"));
  }

  @Test
  void twoPicturesMayHaveTwoSets() throws ModelFormatException {
    String both = DIFFUSE + DIFFUSE.replace("diffuse", "emission").replace("UV", "GLOW");
    String look =
        DaeSample.material("lambert", both)
            .replace("<profile_COMMON>", "<profile_COMMON>" + SURFACE);
    String bound =
        "<instance_material symbol=\"m\" target=\"#a\">"
            + SET_7
            + SET_7.replace("UV", "GLOW").replace("7", "2")
            + "</instance_material>";
    ModelPart part =
        DaeSample.fixture(
                DaeSample.file(
                    MAPPED + IMAGES.formatted("a.png") + look, DaeSample.instance(bound)))
            .with("a.png", PNG)
            .part();
    assertThat(part.geometry().uv0()).containsExactly(2, 2, 3, 2, 3, 3);
    assertThat(part.geometry().uv1()).containsExactly(0, 0, 1, 0, 1, 1);
    assertThat(texture(part).uvSet()).isZero();
    assertThat(part.material().emission().texture().orElseThrow().uvSet()).isEqualTo(1);
  }

  @ParameterizedTest
  @CsvSource({
    "../pictures/a.png",
    "file:///C:/Users/x/a.png",
    "file://C:/Users/x/a.png",
    "C:\\Users\\x\\A.PNG",
    "/home/x/a.png",
    "file:///home/x/a.png",
    "file://./a.png",
    "./deep/a.png",
    "de%65p/a.png"
  })
  void picturesInOtherPlacesAreFoundByName(String uri, @TempDir Path folder) throws Exception {
    Files.createDirectories(folder.resolve("deep"));
    Files.write(folder.resolve("deep/a.png"), PNG);
    String look =
        DaeSample.material("lambert", DIFFUSE)
            .replace("<profile_COMMON>", "<profile_COMMON>" + SURFACE);
    byte[] text =
        DaeSample.file(MAPPED + IMAGES.formatted(uri) + look, DaeSample.instance())
            .getBytes(StandardCharsets.UTF_8);
    Model read =
        ModelReader.read("a.dae", text, ModelFolder.of(folder), ModelOptions.DEFAULT);
    assertThat(texture(read.parts().get(0)).image().encoded()).isEqualTo(PNG);
    boolean isSearched = !uri.replace("%65", "e").contains("deep/");
    assertThat(read.warnings().stream().anyMatch(w -> w.endsWith("\"deep/a.png\" is used")))
        .isEqualTo(isSearched);
  }

  @Test
  void missingPicturesAreLeftOut() throws ModelFormatException {
    ModelFixture file = mapped(SURFACE, "b.png", SET_7);
    assertThat(color(file.part().material())).isEqualTo(Rgb.gray(.7));
    assertThat(file.read().warnings())
        .anyMatch(w -> w.contains("b.png") && w.endsWith("the picture is left out"));
  }

  /** Red 255 and alpha 51 of 255: a luminance of 0.2127, and an alpha of 0.2. */
  @ParameterizedTest
  @CsvSource({
    "A_ONE,-1,.5",
    "A_ZERO,230,1", // 1 - 0.5 * 0.2
    "RGB_ONE,27,1", // 0.5 * 0.2127
    "RGB_ZERO,228,1"
  })
  void picturesOfTransparencyHaveFourModes(String mode, int value, double factor)
      throws Exception {
    byte[] picture = Pixels.of(1, 1, 4, new byte[] {-1, 0, 0, 51}).toPng();
    String content =
        "<diffuse><color>1 1 1 1</color></diffuse><transparent opaque=\"%s\">".formatted(mode)
            + "<texture texture=\"sampler\" texcoord=\"UV\"/></transparent>"
            + "<transparency><float>.5</float></transparency>";
    String look =
        DaeSample.material("lambert", content)
            .replace("<profile_COMMON>", "<profile_COMMON>" + SURFACE);
    ModelMaterial read =
        DaeSample.fixture(
                DaeSample.file(MAPPED + IMAGES.formatted("a.png") + look, DaeSample.instance()))
            .with("a.png", picture)
            .part()
            .material();
    ModelTexture texture = read.input(MaterialParameter.OPACITY).texture().orElseThrow();
    assertThat(opacity(read)).isEqualTo(factor);
    if (value < 0) {
      assertThat(read.input(MaterialParameter.OPACITY).channel()).isEqualTo(3);
      assertThat(texture.image().encoded()).isEqualTo(picture);
    } else {
      Pixels made =
          ImageReader.decode(texture.image().encoded(), Limits.NONE);
      assertThat(made.raw(0, 0, 0)).isBetween(value - 1, value + 1);
    }
  }

  @Test
  void normalMapsAreOfExtras() throws ModelFormatException {
    String bump =
        "<extra><technique profile=\"FCOLLADA\"><bump><texture texture=\"sampler\""
            + " texcoord=\"UV\"/></bump></technique></extra>";
    String look =
        DaeSample.material("lambert", "")
            .replace("<profile_COMMON>", "<profile_COMMON>" + SURFACE)
            .replace("</technique></profile", bump + "</technique></profile");
    String file = DaeSample.file(MAPPED + IMAGES.formatted("a.png") + look, DaeSample.instance());
    assertThat(DaeSample.fixture(file).with("a.png", PNG).part().material().normalMap())
        .isPresent();
    byte[] heights = Pixels.of(1, 1, 1, new byte[] {9}).toPng();
    Model gray = DaeSample.fixture(file).with("a.png", heights).read();
    assertThat(gray.parts().get(0).material().normalMap()).isEmpty();
    assertThat(String.join(";", gray.warnings())).contains("ignored a height map");
  }

  @Test
  void whatIsLeftOutIsSaid() throws ModelFormatException {
    Model read =
        painted("phong", "<reflective><color>.1 .1 .1 1</color></reflective>").read();
    assertThat(read.warnings())
        .containsExactly("line 7: left out <reflective>: surfaces reflect what is around them");
    String black = "<reflective><color>0 0 0 1</color></reflective>";
    assertThat(painted("phong", black).read().warnings()).isEmpty();
  }
}
