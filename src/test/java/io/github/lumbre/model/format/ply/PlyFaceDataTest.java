package io.github.lumbre.model.format.ply;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.internal.Srgb;
import io.github.lumbre.material.MaterialParameter;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelFixture;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelPart;
import io.github.lumbre.testing.Pictures;
import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Textures of PLY files, and texture coordinates and colors of their faces. */
class PlyFaceDataTest {
  private static final String XYZ = "property float x;property float y;property float z;";
  private static final String SQUARE = "0 0 0;1 0 0;1 1 0;0 1 0;";
  private static final String CORNERS = "property list uchar int vertex_indices;";
  private static final String TEXCOORD = "property list uchar float texcoord;";

  private static ModelFixture ply(String comments, String face, String body) throws Exception {
    String text =
        "ply;format ascii 1.0;" + comments + "element vertex 4;" + XYZ + face + "end_header;";
    return pictured(new ModelFixture("a.ply", (text + body).replace(';', '\n')));
  }

  private static ModelFixture pictured(ModelFixture file) throws Exception {
    byte[] png = Pictures.png(1, 1, 0);
    return file.with("a b.png", png).with("c.png", png);
  }

  private static String picture(ModelPart part) {
    return part.material()
        .input(MaterialParameter.BASE_COLOR)
        .texture()
        .orElseThrow()
        .image()
        .location();
  }

  @Test
  void commentsNameTheTexture() throws Exception {
    ModelFixture file =
        pictured(
            new ModelFixture(
                "a.ply",
                ("ply;format ascii 1.0;comment TextureFile a b.png;element vertex 3;"
                        + XYZ
                        + "property float s;property float t;property uchar red;"
                        + "property uchar green;property uchar blue;element face 1;"
                        + CORNERS
                        + "end_header;0 0 0 0 0 1 2 3;1 0 0 1 0 1 2 3;0 1 0 0 1 1 2 3;3 0 1 2")
                    .replace(';', '\n')));
    assertThat(picture(file.part())).isEqualTo("a b.png");
    assertThat(file.part().material().input(MaterialParameter.BASE_COLOR).factor())
        .isEqualTo(Rgb.WHITE);
    assertThat(file.part().geometry().colors()).isEmpty();
    assertThat(file.read().warnings())
        .containsExactly("ignored the colors, since there is a texture");
  }

  @Test
  void commentsNameTheParts() throws Exception {
    String comments = "comment PartName left wing;comment partname right;";
    String face = "element face 2;" + CORNERS + "property uchar part;";
    ModelFixture file = ply(comments, face, SQUARE + "3 0 1 2 1;3 0 2 3 0");
    assertThat(file.read().warnings()).isEmpty();
    assertThat(file.read().parts().stream().map(ModelPart::name))
        .containsExactly("left wing", "right");
    assertThat(file.read().parts().get(1).geometry().positions())
        .containsExactly(0, 0, 0, 1, 0, 0, 1, 1, 0);
    assertThatThrownBy(() -> ply(comments, face, SQUARE + "3 0 1 2 1;3 0 2 3 2").read())
        .hasMessageContaining("line 18: element face: expected a part from 0 to 1, found 2");
    ModelFixture unnamed = ply("", face, SQUARE + "3 0 1 2 1;3 0 2 3 7");
    assertThat(unnamed.read().warnings())
        .containsExactly("element face: ignored the properties part");
  }

  /** Faces count the comments, and writers may leave names out. */
  @Test
  void commentsWithoutANameCountAsParts() throws Exception {
    String face = "element face 2;" + CORNERS + "property uchar part;";
    Model model =
        ply("comment PartName;comment PartName lid;", face, SQUARE + "3 0 1 2 0;3 0 2 3 1").read();
    assertThat(model.warnings()).isEmpty();
    assertThat(model.parts().stream().map(part -> part.node().label()))
        .containsExactly("part 0", "lid");
  }

  @Test
  void namesThatNoFaceUsesAreReported() throws Exception {
    String names = "comment PartName a;comment PartName b;";
    String ignored =
        "comment PartName: ignored, since no face has the integer property part";
    String face = "element face 1;" + CORNERS;
    assertThat(ply(names, face, SQUARE + "3 0 1 2").read().warnings()).containsExactly(ignored);
    assertThat(ply(names, face + "property float part;", SQUARE + "3 0 1 2 1").read().warnings())
        .containsExactly("element face: ignored the properties part", ignored);
    assertThat(ply(names, "", SQUARE).read().warnings()).containsExactly(ignored);
  }

  /** Strips have neither parts nor data of their own, before the faces or after them. */
  @Test
  void stripsBesideFacesDoNotChangeThem() throws Exception {
    String strip = "element tristrips 1;property list int int vertex_indices;";
    String faces =
        "element face 1;"
            + CORNERS
            + "property uchar red;property uchar green;property uchar blue;property uchar part;";
    String names = "comment PartName a;comment PartName b;";
    String stripLine = "11 0 1 2 3 -1 0 1 2 3 0 1;";
    String faceLine = "3 1 2 3 255 0 0 1;";
    for (boolean isBefore : new boolean[] {true, false}) {
      Model model =
          ply(
                  names,
                  isBefore ? strip + faces : faces + strip,
                  SQUARE + (isBefore ? stripLine + faceLine : faceLine + stripLine))
              .read();
      assertThat(model.warnings())
          .containsExactly(
              "element tristrips: triangles without the colors or texture coordinates of faces: 6",
              "element tristrips: triangles without a part, which are in the first one: 6");
      List<ModelGeometry> parts = model.parts().stream().map(ModelPart::geometry).toList();
      assertThat(parts.get(0).indices()).hasSize(18);
      assertThat(parts.get(0).colors()).contains(1, .7f).doesNotContain(0);
      assertThat(parts.get(1).positions()).containsExactly(1, 0, 0, 1, 1, 0, 0, 1, 0);
      assertThat(parts.get(1).colors()).containsExactly(1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1);
    }
  }

  @Test
  void partsOfTexturedFacesAreReported() throws Exception {
    String face = "element face 2;" + CORNERS + TEXCOORD + "property uchar part;";
    String corners = " 6 0 0 1 0 1 1 ";
    ModelFixture file =
        ply(
            "comment TextureFile c.png;comment PartName a;",
            face,
            SQUARE + "3 0 1 2" + corners + "0;3 0 2 3" + corners + "0");
    assertThat(file.read().warnings())
        .containsExactly("ignored the parts, since there is a texture");
  }

  @Test
  void texturesThatCannotBeShownAreReported() throws Exception {
    String comment = "comment TextureFile a b.png;";
    ModelFixture file = ply(comment, "element face 1;" + CORNERS, SQUARE + "3 0 1 2");
    assertThat(file.read().warnings())
        .containsExactly("comment TextureFile: ignored, since there are no texture coordinates");
    file =
        ply(
            "comment texturefile no.png;",
            "element face 1;" + CORNERS + TEXCOORD,
            SQUARE + "3 0 1 2 6 0 0 1 0 1 1");
    assertThat(file.part().material().input(MaterialParameter.BASE_COLOR).texture()).isEmpty();
    assertThat(file.read().warnings()).hasSize(1);
    assertThat(file.read().warnings().get(0)).endsWith("no.png; the picture is left out");
  }

  /** A square and a triangle share vertices, which have other coordinates in each. */
  @Test
  void facesHaveCoordinatesOfTheirCorners() throws Exception {
    for (String face : List.of(CORNERS + TEXCOORD, TEXCOORD + CORNERS)) {
      boolean isFirst = face.startsWith(CORNERS);
      String square = isFirst ? "4 0 1 2 3 8 0 0 1 0 1 1 0 1;" : "8 0 0 1 0 1 1 0 1 4 0 1 2 3;";
      String triangle = isFirst ? "3 2 1 0 6 .5 .5 .25 0 1 0" : "6 .5 .5 .25 0 1 0 3 2 1 0";
      ModelFixture file =
          ply(
              "comment made by hand;comment TextureFile a b.png;",
              "element face 2;" + face,
              SQUARE + square + triangle);
      ModelGeometry mesh = file.geometry();
      assertThat(file.read().warnings()).isEmpty();
      assertThat(picture(file.part())).isEqualTo("a b.png");
      assertThat(mesh.triangleCount()).isEqualTo(3);
      assertThat(mesh.uv0())
          .containsExactly(0, 0, 1, 0, 1, 1, 0, 0, 1, 1, 0, 1, .5, .5, .25, 0, 1, 0);
      assertThat(mesh.positions()).startsWith(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0);
    }
  }

  @Test
  void binaryFacesHaveCoordinatesOfTheirCorners() throws Exception {
    String header =
        "ply;format binary_little_endian 1.0;comment TextureFile c.png;element vertex 4;"
            + XYZ
            + "element face 1;property list ushort uint vertex_indices;"
            + TEXCOORD
            + "end_header;";
    ByteBuffer body = ByteBuffer.allocate(200).order(ByteOrder.LITTLE_ENDIAN);
    for (float number : new float[] {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}) {
      body.putFloat(number);
    }
    body.putShort((short) 3).putInt(3).putInt(1).putInt(2).put((byte) 6);
    for (float number : new float[] {0, .5f, 1, 0, 1, Float.NaN}) {
      body.putFloat(number);
    }
    ByteArrayOutputStream file = new ByteArrayOutputStream();
    file.writeBytes(header.replace(';', '\n').getBytes(StandardCharsets.US_ASCII));
    file.write(body.array(), 0, body.position());
    ModelPart part = pictured(new ModelFixture("a.ply", file.toByteArray())).part();
    assertThat(part.geometry().uv0()).containsExactly(0, .5, 1, 0, 1, 0);
    assertThat(picture(part)).isEqualTo("c.png");
  }

  @Test
  void facesHaveTexturesByNumber() throws Exception {
    Model model =
        ply(
                "comment TextureFile a b.png;comment TextureFile c.png;",
                "element face 3;" + CORNERS + TEXCOORD + "property int texnumber;",
                SQUARE + "3 0 1 1 6 0 0 0 0 0 0 0;3 0 1 2 6 0 0 1 0 1 1 1;3 0 2 3 6 0 0 1 1 0 1 0")
            .read();
    assertThat(model.parts())
        .extracting(PlyFaceDataTest::picture)
        .containsExactly("a b.png", "c.png");
    assertThat(model.parts().get(0).geometry().indices()).containsExactly(6, 7, 8);
    assertThat(model.parts().get(1).geometry().indices()).containsExactly(3, 4, 5);
    assertThat(model.warnings()).containsExactly("dropped triangles of zero area: 1");
  }

  @Test
  void facesHaveColors() throws Exception {
    String colors = "property uchar red;property uchar green;property uchar blue;";
    String face = "element face 2;" + CORNERS + colors;
    ModelFixture file = ply("", face, SQUARE + "3 0 1 2 255 0 128;3 0 2 3 0 255 0");
    float middle = (float) Srgb.decode(128 / 255.);
    assertThat(file.geometry().colors()).startsWith(1, 0, middle, 1, 1, 0, middle, 1);
    assertThat(file.geometry().colors()).endsWith(0, 1, 0, 1);
    assertThat(file.part().material().input(MaterialParameter.BASE_COLOR).factor())
        .isEqualTo(Rgb.WHITE);
    assertThat(file.read().warnings()).isEmpty();
  }
}
