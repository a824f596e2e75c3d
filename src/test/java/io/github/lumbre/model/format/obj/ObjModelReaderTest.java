package io.github.lumbre.model.format.obj;

import static io.github.lumbre.material.MaterialParameter.ATTENUATION_DISTANCE;
import static io.github.lumbre.material.MaterialParameter.BASE_COLOR;
import static io.github.lumbre.material.MaterialParameter.CLEARCOAT;
import static io.github.lumbre.material.MaterialParameter.CLEARCOAT_ROUGHNESS;
import static io.github.lumbre.material.MaterialParameter.IOR;
import static io.github.lumbre.material.MaterialParameter.METALLIC;
import static io.github.lumbre.material.MaterialParameter.OPACITY;
import static io.github.lumbre.material.MaterialParameter.ROUGHNESS;
import static io.github.lumbre.material.MaterialParameter.SHEEN_COLOR;
import static io.github.lumbre.material.MaterialParameter.SPECULAR;
import static io.github.lumbre.material.MaterialParameter.SPECULAR_COLOR;
import static io.github.lumbre.material.MaterialParameter.TRANSMISSION;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.internal.Srgb;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.MaterialInput;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelFixture;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelMaterial;
import io.github.lumbre.model.internal.ModelMaterial.AlphaMode;
import io.github.lumbre.model.internal.ModelPart;
import io.github.lumbre.model.internal.ModelTexture;
import io.github.lumbre.model.internal.ModelTexture.Wrap;
import io.github.lumbre.model.internal.PlainModel;
import io.github.lumbre.model.internal.UvTransform;
import io.github.lumbre.testing.Pictures;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the reading of OBJ files with objects, groups and materials. */
class ObjModelReaderTest {
  private static final String CORNERS = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  private static final byte[] PICTURE = Pixels.of(1, 1, 3, new byte[] {1, 2, 3}).toPng();

  private static ModelFixture obj(String text) {
    return new ModelFixture("a.obj", (CORNERS + text).replace(';', '\n'));
  }

  /** Returns a model whose only material, m, has the given statements. */
  private static ModelFixture material(String statements) {
    return obj("mtllib a.mtl;usemtl m;f 1 2 3")
        .with("a.mtl", ("newmtl m;" + statements).replace(';', '\n'))
        .with("a.png", PICTURE)
        .with("b c.png", PICTURE);
  }

  private static ModelMaterial read(String statements) throws ModelFormatException {
    return material(statements).part().material();
  }

  @Test
  void eachMaterialOfEachObjectIsAPart() throws ModelFormatException {
    Model model =
        obj("mtllib a.mtl;o left;usemtl a;f 1 2 3;usemtl b;f 1 3 4;o right;g ignored;f 2 3 4;"
                + "o left;usemtl a;f 1 2 4")
            .with("a.mtl", "newmtl a\nnewmtl b\nnewmtl unused\nmap_Kd missing.png")
            .read();
    assertThat(model.parts())
        .extracting(p -> p.name() + " " + p.material().name() + " " + p.location())
        .containsExactly("left a line 8", "left b line 10", "right b line 13");
    assertThat(model.parts().get(0).geometry().triangleCount()).isEqualTo(2);
    assertThat(model.parts().get(0).material().location()).isEqualTo("a.mtl line 1");
    assertThat(model.warnings()).isEmpty();
  }

  @Test
  void groupsAreObjectsInFilesWithoutObjects() throws ModelFormatException {
    Model model = obj("g red wall;f 1 2 3;g floor;f 1 3 4;g red wall;f 2 3 4").read();
    assertThat(model.parts()).extracting(ModelPart::name).containsExactly("red wall", "floor");
  }

  @Test
  void namesHaveSpacesAndLibrariesMayComeLater() throws ModelFormatException {
    ModelPart part =
        obj("usemtl  Hard  plastic ;f 1 2 3;mtllib .\\b\\my lib.mtl")
            .with("b/my lib.mtl", "newmtl Hard plastic\nKd 1 0 0\nmap_Kd t.png")
            .with("b/t.png", PICTURE)
            .part();
    assertThat(part.material().input(BASE_COLOR).factor()).isEqualTo(new Rgb(1, 0, 0));
    assertThat(part.material().input(BASE_COLOR).texture().orElseThrow().image().location())
        .isEqualTo("b/t.png");
  }

  /** The corners of such a face are as those without a normal; its triangle is flat. */
  @ParameterizedTest
  @ValueSource(strings = {"1//1 3//2 4//1", "1//-1 3//-2 4//-1"})
  void normalsBeyondTheirListAreAsNone(String face) throws ModelFormatException {
    Model model = obj("vn 0 0 -1;f 1//1 2//1 3//1;f " + face).read();
    double[] normals = model.parts().get(0).geometry().normals();
    assertThat(normals).startsWith(0, 0, -1).endsWith(0, 0, 1);
    assertThat(model.warnings())
        .containsExactly("line 7: ignored indices of normals beyond their list: 1");
  }

  @Test
  void textureCoordinatesBeyondTheirListAreAsNone() throws ModelFormatException {
    Model model = obj("vt .5 .25;f 1/1 2/7 3/-2").read();
    ModelGeometry mesh = model.parts().get(0).geometry();
    assertThat(mesh.uv0()).containsExactly(0, 0, 1, 0, 0, 1);
    assertThat(model.warnings())
        .containsExactly("line 6: ignored indices of texture coordinates beyond their list: 2");
    assertThat(obj("f 1 2 5").refusal()).contains("expected a vertex from 1 to 4, found 5");
  }

  @Test
  void missingLibrariesAndMaterialsAreReported() throws ModelFormatException {
    Model model = obj("mtllib no.mtl;usemtl m;f 1 2 3;usemtl m;f 1 3 4").read();
    assertThat(model.warnings())
        .containsExactly(
            "line 5: expected a file, found none: no.mtl",
            "line 6: expected a material of a library, found \"m\", which is replaced by light"
                + " gray");
    assertThat(model.parts().get(0).material().name()).isEmpty();
  }

  @Test
  void missingPicturesAreLeftOutAndReportedOnce() throws ModelFormatException {
    Model model =
        material(
                "Kd .5;Ks 0;Ke 0;Pm 0;map_Kd no.png;map_Ks no.png;map_Ke no.png;map_d no.png;"
                    + "norm no.png;map_Pr other.png;map_Pm a.png")
            .read();
    ModelMaterial material = model.parts().get(0).material();
    assertThat(material.input(BASE_COLOR)).isEqualTo(MaterialInput.of(Rgb.gray(.5)));
    assertThat(material.emission()).isEqualTo(MaterialInput.of(Rgb.BLACK));
    assertThat(material.alphaMode()).isEqualTo(AlphaMode.OPAQUE);
    assertThat(material.normalMap()).isEmpty();
    assertThat(material.input(ROUGHNESS)).isEqualTo(MaterialInput.of(1));
    assertThat(material.input(METALLIC).texture()).isPresent();
    assertThat(model.warnings())
        .containsExactly(
            "a.mtl line 6: expected a file, found none: no.png; the picture is left out",
            "a.mtl line 11: expected a file, found none: other.png; the picture is left out");
  }

  @Test
  void blackStandsForAMissingPicture() throws ModelFormatException {
    Rgb lightGray = PlainModel.defaultMaterial().input(BASE_COLOR).factor();
    assertThat(read("Kd 0;map_Kd no.png").input(BASE_COLOR)).isEqualTo(MaterialInput.of(lightGray));
    assertThat(read("Kd 0").input(BASE_COLOR)).isEqualTo(MaterialInput.of(Rgb.BLACK));
    assertThat(read("Ke 0;map_Ke no.png").emission()).isEqualTo(MaterialInput.of(Rgb.BLACK));
  }

  @Test
  void otherStatementsAreReportedOnce() throws ModelFormatException {
    Model model = obj("l 1 2;l 2 3;foo;foo;lod 3;f 1 2 3").read();
    assertThat(model.warnings())
        .containsExactly(
            "line 5: ignored statements \"l\": only polygons and points are supported",
            "line 7: ignored the unknown statement \"foo\"");
  }

  @Test
  void facesOfTwoCornersAreReportedOnce() throws ModelFormatException {
    Model model = obj("f 1 2;f 1 2 3;f 2;f 2 3 4").read();
    assertThat(model.parts()).hasSize(1);
    assertThat(model.parts().get(0).geometry().triangleCount()).isEqualTo(2);
    assertThat(model.warnings())
        .containsExactly("line 5: ignored faces of fewer than 3 corners: 2");
  }

  /** Colors are the albedo, as in a PLY file; parts without colors stay light gray. */
  @Test
  void verticesMayHaveColors() throws ModelFormatException {
    ModelPart part =
        new ModelFixture("a.obj", "v 0 0 0 1 .5 0\nv 1 0 0\nv 0 1 0 7\nf 1 2 3").part();
    float gray = (float) PlainModel.ALBEDO;
    assertThat(part.material().input(BASE_COLOR).factor()).isEqualTo(Rgb.WHITE);
    assertThat(part.geometry().colors())
        .startsWith(1, (float) Srgb.decode(.5), 0, 1, gray, gray, gray, 1);
    ModelPart plain = obj("v 0 0 1 1 1 1;o a;f 1 2 3").part();
    assertThat(plain.geometry().colors()).isEmpty();
    assertThat(plain.material().input(BASE_COLOR).factor()).isEqualTo(Rgb.gray(PlainModel.ALBEDO));
  }

  /** With a material of a library, colors are factors of its base color; others are 1. */
  @Test
  void colorsOfVerticesMultiplyTheMaterial() throws ModelFormatException {
    ModelPart part =
        new ModelFixture(
                "a.obj", "mtllib a.mtl\nusemtl m\nv 0 0 0 1 .5 0\nv 1 0 0\nv 0 1 0\nf 1 2 3")
            .with("a.mtl", "newmtl m\nKd .5")
            .part();
    assertThat(part.material().input(BASE_COLOR).factor()).isEqualTo(Rgb.gray(.5));
    assertThat(part.geometry().colors()).startsWith(1, (float) Srgb.decode(.5), 0, 1, 1, 1, 1, 1);
  }

  @ParameterizedTest
  @CsvSource({
    "1 .5 0, 1, .5, ",
    "1.0005 .5 -1, 1, .5, ",
    "255 128 0, 1, .5019607843137255, took the colors of vertices for 0 to 255",
    "2 127.5 0, .00784313725490196, .5, took the colors of vertices for 0 to 255",
    "256 128 0, -1, -1, ignored the colors of vertices"
  })
  void colorsOfVerticesMayBeBytes(String color, double red, double green, String warning)
      throws ModelFormatException {
    Model model =
        new ModelFixture("a.obj", "v 0 0 0 1 1 1\nv 1 0 0\nv 0 1 0 " + color + "\nf 1 2 3").read();
    float[] colors = model.parts().get(0).geometry().colors();
    if (red < 0) {
      assertThat(colors).isEmpty();
      assertThat(model.parts().get(0).material().input(BASE_COLOR))
          .isEqualTo(PlainModel.defaultMaterial().input(BASE_COLOR));
    } else {
      assertThat(colors[8]).isEqualTo((float) Srgb.decode(red));
      assertThat(colors[9]).isEqualTo((float) Srgb.decode(green));
      assertThat(colors[10]).isZero();
    }
    assertThat(model.warnings()).hasSize(warning == null ? 0 : 1);
    assertThat(String.join("", model.warnings()))
        .contains(warning == null ? "" : "line 3: " + warning);
  }

  /** Two faces at a right angle along an edge, within a group, share the mean normal. */
  @Test
  void smoothingGroupsHaveSmoothNormals() throws ModelFormatException {
    String roof = "v 0 0 1;f 1 2 4;f 1 5 2;";
    assertThat(obj(roof).geometry().normals()).isEmpty();
    assertThat(obj("s off;" + roof).geometry().normals()).isEmpty();
    double[] normals = obj("s 1;" + roof).geometry().normals();
    double half = Math.sqrt(.5);
    assertThat(normals).hasSize(12);
    assertThat(normals[1]).isCloseTo(half, within(1e-15));
    assertThat(normals[2]).isCloseTo(half, within(1e-15));
    ModelGeometry apart = obj("v 0 0 1;s 1;f 1 2 4;s 2;f 1 5 2;s 0;f 1 2 3").geometry();
    assertThat(apart.normals()).startsWith(0, 0, 1).hasSize(27);
  }

  @Test
  void axesAndUnitAreThoseOfTheOptions() throws ModelFormatException {
    ModelOptions options =
        new ModelOptions(Optional.empty(), Optional.empty(), ModelOptions.Up.Z, 1);
    assertThat(ModelFixture.mapped(obj("f 1 2 3").with(options).part(), 1, 2, 3))
        .isEqualTo(new Vec3(1, 3, -2));
  }

  @Test
  void phongBecomesRoughness() throws ModelFormatException {
    ModelMaterial material = read("Kd .1 .2 .3;Ks .5;Ns 510;Ka 1 1 1;Ni 1;illum 2");
    assertThat(material.input(BASE_COLOR).factor()).isEqualTo(new Rgb(.1, .2, .3));
    assertThat(material.input(METALLIC).number()).isZero();
    assertThat(material.input(ROUGHNESS).number()).isEqualTo(.25);
    assertThat(material.input(SPECULAR_COLOR).factor()).isEqualTo(Rgb.gray(1));
    assertThat(material.input(SPECULAR).number()).isEqualTo(1);
    assertThat(material.input(IOR).number()).isEqualTo(1.5);
    assertThat(material.doubleSided()).isTrue();
    assertThat(read("Ks .5;illum 1").input(SPECULAR).number()).isZero();
    assertThat(read("Ks 1;illum 3;Ns 0").input(SPECULAR_COLOR).factor().r()).isEqualTo(25);
    assertThat(read("Kd 1 1 1").input(SPECULAR).number()).isZero();
  }

  @Test
  void physicalStatementsAreTakenAsTheyAre() throws ModelFormatException {
    ModelMaterial material =
        read(
            "Kd 1 1 1;Ks 1;Pr .3;Pm .7;Pc .5;Pcr .25;Ps .125;Ke 2 3 4;Ni 1.4;aniso 1;"
                + "map_Pr a.png;map_Pm -imfchan g a.png");
    assertThat(material.input(ROUGHNESS).number()).isEqualTo(.3);
    assertThat(material.input(ROUGHNESS).channel()).isZero();
    assertThat(material.input(METALLIC).number()).isEqualTo(.7);
    assertThat(material.input(METALLIC).channel()).isEqualTo(1);
    assertThat(material.input(METALLIC).texture().orElseThrow().image())
        .isSameAs(material.input(ROUGHNESS).texture().orElseThrow().image());
    assertThat(material.input(CLEARCOAT).number()).isEqualTo(.5);
    assertThat(material.input(CLEARCOAT_ROUGHNESS).number()).isEqualTo(.25);
    assertThat(material.input(SHEEN_COLOR).factor()).isEqualTo(Rgb.gray(.125));
    assertThat(material.emission().factor()).isEqualTo(new Rgb(2, 3, 4));
    assertThat(material.input(IOR).number()).isEqualTo(1.4);
    assertThat(read("map_Pr a.png").input(ROUGHNESS).number()).isEqualTo(1);
  }

  @Test
  void transparencyIsOpacityOrRefraction() throws ModelFormatException {
    assertThat(read("d 1").alphaMode()).isEqualTo(AlphaMode.OPAQUE);
    assertThat(read("d .25").alphaMode()).isEqualTo(AlphaMode.BLEND);
    assertThat(read("d -halo .25").input(OPACITY).number()).isEqualTo(.25);
    assertThat(read("Tr .25").input(OPACITY).number()).isEqualTo(.75);
    assertThat(read("d 1;Tr 1").alphaMode()).isEqualTo(AlphaMode.OPAQUE);
    assertThat(read("map_Kd a.png;map_d a.png").input(OPACITY).channel()).isEqualTo(3);
    assertThat(read("map_Kd a.png;map_d b c.png").input(OPACITY).channel()).isZero();
    ModelMaterial glass = read("illum 7;Kd 0 0 0;Tf .9 1 1;Ni 1.33");
    assertThat(glass.input(TRANSMISSION).number()).isEqualTo(1);
    assertThat(glass.input(BASE_COLOR).factor()).isEqualTo(new Rgb(.9, 1, 1));
    assertThat(glass.input(IOR).number()).isEqualTo(1.33);
    assertThat(glass.input(ROUGHNESS).number()).isZero();
    assertThat(glass.uses(ATTENUATION_DISTANCE)).isTrue();
    assertThat(read("illum 6;d .25").input(TRANSMISSION).number()).isEqualTo(.75);
  }

  /** {@code Tr 1} without {@code d} is opaque; a material that shows nothing is reported. */
  @ParameterizedTest
  @CsvSource({
    "Tr 1, 1, took Tr 1 for opaque",
    "Tr 1.000, 1, took Tr 1 for opaque",
    "map_Kd a.png;Tr 1, 1, took Tr 1 for opaque",
    "Tr 1;map_Kd a.png;illum 2, 1, took Tr 1 for opaque",
    "Tr 1;d 0, 0, invisible",
    "d 0;Tr 1, 0, invisible",
    "Tr 1;d .5, .5, ",
    "d .5;Tr 1, .5, ",
    "d 1;Tr 0, 1, ",
    "Tr 0, 1, ",
    "Tr .99, .01, ",
    "Tr -1, 1, 0 is used",
    "Tr 2, 0, invisible",
    "d 0, 0, invisible",
    "d -halo 0;map_Kd a.png, 0, invisible",
    "d 0;map_d a.png, 1, ",
    "map_d a.png;Tr 1, 1, ",
    "d 0;map_d missing.png, 1, the picture is left out",
    "d 0;map_Kd a.png, 0, invisible",
    "illum 6;Tr 1, 1, ",
    "illum 7;d 0, 1, "
  })
  void opacityOfZeroIsMeantOnlyIfDSaysSo(String statements, double opacity, String warning)
      throws ModelFormatException {
    Model model = material(statements).read();
    ModelMaterial material = model.parts().get(0).material();
    assertThat(material.input(OPACITY).number()).isCloseTo(opacity, within(1e-12));
    if (material.input(OPACITY).texture().isEmpty()) {
      assertThat(material.alphaMode()).isEqualTo(opacity < 1 ? AlphaMode.BLEND : AlphaMode.OPAQUE);
    }
    assertThat(model.warnings().isEmpty()).isEqualTo(warning == null);
    assertThat(String.join("", model.warnings())).contains(warning == null ? "" : warning);
  }

  @Test
  void optionsOfTexturesAreHonored() throws ModelFormatException {
    ModelTexture texture =
        read("map_Kd -s 2 3 1 -o .5 -clamp on -blendu off -mm 0 1 b c.png # a comment")
            .input(BASE_COLOR)
            .texture()
            .orElseThrow();
    assertThat(texture.image().location()).isEqualTo("b c.png");
    assertThat(texture.wrapU()).isEqualTo(Wrap.CLAMP);
    assertThat(texture.uvTransform()).isEqualTo(new UvTransform(2, 0, .5, 0, 3, 0));
    assertThat(material("map_Kd -t 1 1 -mm .5 2 -texres 9 a.png").read().warnings())
        .containsExactly(
            "a.mtl line 2: ignored the option -t",
            "a.mtl line 2: ignored the option -mm",
            "a.mtl line 2: ignored the option -texres");
  }

  @Test
  void factorsOfZeroDoNotHidePictures() throws ModelFormatException {
    assertThat(read("Kd 0 0 0;map_Kd a.png").input(BASE_COLOR).factor()).isEqualTo(Rgb.WHITE);
    assertThat(read("map_Ke a.png").emission().factor()).isEqualTo(Rgb.WHITE);
    assertThat(read("Kd .5;map_Kd a.png").input(BASE_COLOR).factor()).isEqualTo(Rgb.gray(.5));
  }

  @Test
  void coloredBumpMapsAreNormalMaps() throws ModelFormatException {
    ModelFixture colored =
        material("map_Bump -bm .5 n.png").with("n.png", Pictures.png(2, 2, 0x8080ff));
    assertThat(colored.part().material().normalMap().orElseThrow().number()).isEqualTo(.5);
    Model gray = material("bump n.png").with("n.png", Pictures.png(2, 2, 0x808080)).read();
    assertThat(gray.parts().get(0).material().normalMap()).isEmpty();
    assertThat(gray.warnings())
        .containsExactly("a.mtl line 2: ignored a height map: only normal maps are supported");
    assertThat(
            material("norm n.png")
                .with("n.png", Pictures.png(2, 2, 0x808080))
                .part()
                .material()
                .normalMap())
        .isPresent();
  }

  @Test
  void unknownKeysAreReportedOnce() throws ModelFormatException {
    assertThat(material("foo 1;FOO 2;Kd spectral a.rfl;disp a.png").read().warnings())
        .containsExactly(
            "a.mtl line 2: ignored the unknown key \"foo\"",
            "a.mtl line 4: ignored a color of the kind spectral",
            "a.mtl line 5: ignored the unknown key \"disp\"");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "Kd 1 x 1|ignored a wrong Kd: expected a finite number, found \"x\"",
        "Kd|ignored a wrong Kd: expected a number, found the end of the line",
        "Kd 1 2|ignored a wrong Kd: expected a number, found the end of the line",
        "Ns|ignored a wrong Ns: expected a number, found the end of the line",
        "Ns 1e999|ignored a wrong Ns: expected a finite number, found \"1e999\"",
        "map_Kd|ignored a wrong map_Kd: expected the name of a picture, found the end of the line",
        "map_Kd -s 1 2|ignored a wrong map_Kd: expected the name of a picture, found the end of the"
            + " line",
        "map_Kd -s a.png|ignored a wrong map_Kd: expected a finite number, found \"a.png\""
      })
  void wrongStatementsAreIgnored(String statement, String warning) throws ModelFormatException {
    Model model = material(statement + ";Ke 1 2 3").read();
    assertThat(model.warnings()).containsExactly("a.mtl line 2: " + warning);
    assertThat(model.parts().get(0).material())
        .usingRecursiveComparison()
        .isEqualTo(material(";Ke 1 2 3").part().material());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "Kd 1.5 .5 -1|Kd 1 .5 0|Kd: expected 0 to 1, found 1.5; 1 is used|Kd: expected 0 to 1,"
            + " found -1; 0 is used",
        "Ks 3|Ks 1|Ks: expected 0 to 1, found 3; 1 is used|",
        "Ke 5 -1 5|Ke 5 0 5|Ke: expected at least 0, found -1; 0 is used|",
        "Ks 1;Ns -5|Ks 1;Ns 0|Ns: expected at least 0, found -5; 0 is used|",
        "d -1|d 0|d: expected 0 to 1, found -1; 0 is used|the material is invisible: its opacity, d"
            + " or 1 - Tr, is 0",
        "d 2|d 1|d: expected 0 to 1, found 2; 1 is used|",
        "Tr -.5|Tr 0|Tr: expected 0 to 1, found -0.5; 0 is used|",
        "illum 7;Ni 0|illum 7;Ni 1|Ni: expected 1 to 1000000, found 0; 1 is used|",
        "illum 7;Tf 2 1 1|illum 7;Tf 1|Tf: expected 0 to 1, found 2; 1 is used|",
        "illum 70|illum 2|illum: expected 0 to 10, found 70; 2 is used|",
        "Pm 1.5|Pm 1|Pm: expected 0 to 1, found 1.5; 1 is used|",
        "Pr -1|Pr 0|Pr: expected 0 to 1, found -1; 0 is used|"
      })
  void numbersOutOfRangeAreReplaced(String wrong, String same, String first, String second)
      throws ModelFormatException {
    Model model = material(wrong).read();
    ModelMaterial expected = material(same).part().material();
    assertThat(model.parts().get(0).material()).usingRecursiveComparison().isEqualTo(expected);
    assertThat(model.warnings())
        .isEqualTo(
            Stream.of(first, second)
                .filter(Objects::nonNull)
                .map(warning -> "a.mtl line 1: " + warning)
                .toList());
  }

  private static final String NO_AREA =
      "MALFORMED expected at least one triangle with an area, found none";

  @Test
  void filesWithoutSurfacesAreRefused() {
    assertThat(obj("l 1 2").refusal())
        .isEqualTo(
            NO_AREA
                + " (line 5: ignored statements \"l\": only polygons and points are supported)");
    byte[] png = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    assertThat(new ModelFixture("a.obj", png).refusal())
        .isEqualTo(
            "MALFORMED expected an OBJ file, found a PNG picture; name the scene or model that"
                + " uses it");
    assertThat(obj("f 1 1 1").refusal())
        .isEqualTo(NO_AREA + " (line 5: dropped triangles of zero area: 1)");
  }
}
