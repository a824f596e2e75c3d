package io.github.lumbre.model.internal;

import static io.github.lumbre.material.MaterialParameter.BASE_COLOR;
import static io.github.lumbre.material.MaterialParameter.CLEARCOAT;
import static io.github.lumbre.material.MaterialParameter.CLEARCOAT_ROUGHNESS;
import static io.github.lumbre.material.MaterialParameter.IOR;
import static io.github.lumbre.material.MaterialParameter.METALLIC;
import static io.github.lumbre.material.MaterialParameter.OPACITY;
import static io.github.lumbre.material.MaterialParameter.ROUGHNESS;
import static io.github.lumbre.material.MaterialParameter.SHEEN_COLOR;
import static io.github.lumbre.material.MaterialParameter.SPECULAR_COLOR;
import static io.github.lumbre.material.MaterialParameter.TRANSMISSION;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Transform;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.testing.FileMutator;
import io.github.lumbre.testing.Mutants;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Every changed STL, PLY, OBJ, MTL and OFF file is read as a consistent model, or is refused. */
class HostileModelsTest {
  private static final int QUICK = 500;
  private static final int LONGEST_LINE = 500;

  private static final String STL =
      """
      solid a name
      facet normal 0 0 1
      outer loop
      vertex 0 0 0
      vertex 1 0 0
      vertex 0 1 .5
      endloop
      endfacet
      endsolid a name
      solid
      facet normal 0 0 0 outer loop vertex 1 2 3 vertex 2 2 2 vertex 3 2 1 endloop endfacet
      endsolid
      """;

  private static final String PLY_HEADER =
      """
      ply
      format FORMAT 1.0
      comment a comment
      element vertex 4
      property float x
      property float y
      property double z
      property float nx
      property float ny
      property float nz
      property uchar red
      property uchar green
      property ushort blue
      element face 2
      property list uchar int vertex_indices
      property short flag
      element tristrips 1
      property list int int vertex_indices
      end_header
      """;

  private static final String PLY_BODY =
      """
      0 0 0 0 0 1 255 0 1
      1 0 0 0 1 0 0 255 2
      1 1 0 0 0 1 0 0 3
      0 1 .5 0 0 1 9 9 4
      3 0 1 2 7
      4 0 1 2 3 8
      6 0 1 2 -1 3 0
      """;

  private static final String PLY_CLOUD =
      """
      ply
      format ascii 1.0
      comment TextureFile a.png
      element vertex 3
      property float x
      property float y
      property float z
      property float s
      property float t
      property uchar red
      property uchar green
      property uchar blue
      property uchar alpha
      end_header
      0 0 0 .5 .5 255 0 1 255
      1 0 0 .5 1 0 255 2 128
      1 1 .25 0 .5 1 0 0 255
      """;

  private static final String OBJ_CLOUD =
      """
      mtllib a.mtl
      v 0 0 0 1 0 0
      v 1 0 0 1 0 .5
      v 1 1 0
      p 1 2
      o thing
      usemtl red
      p -1 2/1
      l 1 2
      """;

  private static final String OBJ =
      """
      mtllib a.mtl
      o thing
      v 0 0 0
      v 1 0 0 1 0 .5
      v 1 1 0
      v 0 1 .5
      vt 0 0
      vt 1 1
      vn 0 0 1
      g group
      usemtl red
      s 1
      f 1/1/1 2/2/1 3/2/1
      f 1//1 3//1 4//1
      usemtl two words
      s off
      f -4 -3 -2 -1
      l 1 2
      """;

  private static final String MTL =
      """
      newmtl red
      Kd 1 0 .5
      Ks .5
      Ns 250
      Ni 1.5
      d .5
      illum 7
      map_Kd -s 2 2 1 -o .5 -clamp on a.png
      newmtl two words
      Pr .5
      Pm .25
      Ke 1 2 3
      Tr .125
      map_Bump -bm .5 a.png
      map_d -imfchan m a.png
      """;

  private static final String OFF =
      """
      # A comment.
      STCNOFF 5 3 8
      0 0 0 0 0 1 255 0 0 255 0 0
      1 0 0 0 0 1 0 255 0 128 1 0
      1 1 0 0 0 1 0 0 255 255 1 1
      0 1 .5 0 1 0 .5 1 0 0 1
      0.5 0.5 1 1 0 0 1 1 1 1 0 .5
      3 0 1 2
      4 0 1 2 3 255 0 0
      3 2 3 4 0.5 0.25 1 1
      """;

  private static final String PAINTED_OFF =
      """
      STOFF
      4 3 0
      0 0 0 0 0
      1 0 0 1 0
      1 1 0 1 1
      0 1 .5 0 1
      3 0 1 2 255 0 0
      4 0 1 2 3 0 128 255 128
      3 2 3 0
      """;

  private static final String[] OFF_WORDS = {
    "OFF", "COFF", "NOFF", "STOFF", "4OFF", "OFF5", "BINARY", "#", "\n3 0 1 2", "4"
  };

  private static final byte[] PNG = Pixels.of(1, 1, 3, new byte[] {1, 2, 3}).toPng();

  private static final String[] OBJ_WORDS = {
    "f",
    "p",
    "v",
    "vt",
    "vn",
    "g",
    "o",
    "s",
    "usemtl",
    "mtllib",
    "1/0/0",
    "1//",
    "//",
    "1/99/1",
    "-9",
    "f 1 2 3 4 1 2 3 4 1 2 3 4",
    "red",
    "a.mtl"
  };

  private static final String[] MTL_WORDS = {
    "newmtl",
    "Kd",
    "Ks",
    "Ns",
    "Ni",
    "d",
    "Tr",
    "illum",
    "Tf",
    "map_Kd",
    "map_Pr",
    "norm",
    "-s",
    "-o",
    "-t",
    "-mm",
    "-clamp",
    "-bm",
    "-imfchan",
    "-foo",
    "spectral",
    "a.png",
    "b.png",
    "6"
  };

  private static final String[] PLY_WORDS = {
    "property",
    "element",
    "list",
    "float",
    "uchar",
    "int",
    "double",
    "char",
    "vertex",
    "face",
    "tristrips",
    "x",
    "nx",
    "s",
    "t",
    "alpha",
    "end_header",
    "binary_big_endian",
    "vertex_index"
  };

  private static final String[] STL_WORDS = {
    "solid", "facet", "normal", "outer", "loop", "vertex", "endloop", "endfacet", "endsolid"
  };

  private enum Format {
    STL_TEXT,
    STL_BINARY,
    PLY_TEXT,
    PLY_LITTLE,
    PLY_BIG,
    PLY_POINTS,
    OBJ_TEXT,
    OBJ_POINTS,
    MTL_TEXT,
    OFF_TEXT
  }

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.ISO_8859_1);
  }

  private static byte[] binaryStl() {
    ByteBuffer out = ByteBuffer.allocate(84 + 50 * 3).order(ByteOrder.LITTLE_ENDIAN);
    out.put(bytes("solid")).putInt(80, 3).position(84);
    for (int i = 0; i < 3; i++) {
      for (int k = 0; k < 12; k++) {
        out.putFloat(k * k % 5 + i);
      }
      out.putShort((short) 0);
    }
    return out.array();
  }

  private static byte[] binaryPly(ByteOrder order) {
    boolean isLittle = order == ByteOrder.LITTLE_ENDIAN;
    String name = isLittle ? "binary_little_endian" : "binary_big_endian";
    ByteBuffer out = ByteBuffer.allocate(2000).order(order);
    out.put(bytes(PLY_HEADER.replace("FORMAT", name)));
    for (int i = 0; i < 4; i++) {
      out.putFloat(i & 1).putFloat(i >> 1).putDouble(i * i);
      out.putFloat(0).putFloat(0).putFloat(1);
      out.put((byte) i).put((byte) (50 * i)).putShort((short) i);
    }
    out.put((byte) 3).putInt(0).putInt(1).putInt(2).putShort((short) 7);
    out.put((byte) 4).putInt(0).putInt(1).putInt(3).putInt(2).putShort((short) 8);
    out.putInt(5).putInt(0).putInt(1).putInt(2).putInt(-1).putInt(3);
    return Arrays.copyOf(out.array(), out.position());
  }

  /** Returns the files of a seed: the model's, and that of its materials. */
  private static byte[][] files(Format format, long seed) {
    FileMutator mutator = new FileMutator(new Random(seed));
    byte[] mtl = bytes(MTL);
    return switch (format) {
      case STL_TEXT -> new byte[][] {mutator.changedWords(STL, STL_WORDS), mtl};
      case STL_BINARY -> new byte[][] {mutator.changed(binaryStl(), 100), mtl};
      case PLY_TEXT ->
          new byte[][] {
            mutator.changedWords(PLY_HEADER.replace("FORMAT", "ascii") + PLY_BODY, PLY_WORDS), mtl
          };
      case PLY_LITTLE ->
          new byte[][] {mutator.changed(binaryPly(ByteOrder.LITTLE_ENDIAN), 400), mtl};
      case PLY_BIG -> new byte[][] {mutator.changed(binaryPly(ByteOrder.BIG_ENDIAN), 400), mtl};
      case PLY_POINTS -> new byte[][] {mutator.changedWords(PLY_CLOUD, PLY_WORDS), mtl};
      case OBJ_POINTS -> new byte[][] {mutator.changedWords(OBJ_CLOUD, OBJ_WORDS), mtl};
      case OBJ_TEXT -> new byte[][] {mutator.changedWords(OBJ, OBJ_WORDS), mtl};
      case MTL_TEXT -> new byte[][] {bytes(OBJ), mutator.changedWords(MTL, MTL_WORDS)};
      case OFF_TEXT ->
          new byte[][] {mutator.changedWords(seed % 2 == 0 ? OFF : PAINTED_OFF, OFF_WORDS), mtl};
    };
  }

  /** Returns whether the model of a seed is read. */
  private static boolean isRead(Format format, long seed) throws IOException {
    byte[][] files = files(format, seed);
    try {
      Model model =
          ModelReader.read(name(format), files[0], folder(files[1]), ModelOptions.DEFAULT);
      check(model);
      return true;
    } catch (ModelFormatException e) {
      checkPrintable(e.getMessage());
      return false;
    }
  }

  private static String name(Format format) {
    return switch (format) {
      case STL_TEXT, STL_BINARY -> "a.stl";
      case PLY_TEXT, PLY_LITTLE, PLY_BIG, PLY_POINTS -> "a.ply";
      case OBJ_TEXT, MTL_TEXT, OBJ_POINTS -> "a.obj";
      case OFF_TEXT -> "a.off";
    };
  }

  private static ModelFolder folder(byte[] mtl) {
    return (name, location) -> {
      if (name.endsWith(".mtl")) {
        return mtl;
      }
      if (name.endsWith(".png")) {
        return PNG;
      }
      throw new ModelFormatException(Kind.ASSET, location, "expected a file, found none");
    };
  }

  private static void check(Model model) throws ModelFormatException {
    assertThat(model.pointRadius()).isPositive().isFinite();
    ModelScene scene = new ModelScene(model, Transform.IDENTITY, Kernel.SCALAR, Limits.NONE, false);
    long points = model.parts().stream().filter(part -> part.geometry().isPoints()).count();
    assertThat(scene.surfaces()).hasSizeGreaterThanOrEqualTo((int) points);
    assertThat(model.parts()).isNotEmpty();
    model.warnings().forEach(HostileModelsTest::checkPrintable);
    for (ModelPart part : model.parts()) {
      ModelGeometry mesh = part.geometry();
      TriangleMesh built =
          TriangleMesh.of(mesh.positions(), mesh.normals(), mesh.uv0(), mesh.indices());
      assertThat(mesh.isPoints() ? mesh.vertexCount() : built.triangleCount()).isPositive();
      assertThat(mesh.colors().length).isIn(0, 4 * mesh.vertexCount());
      for (float color : mesh.colors()) {
        assertThat(color).isBetween(0f, 1f);
      }
      assertThat(part.toWorld().isInvertible()).isTrue();
      checkPrintable(part.location());
      check(part.material());
    }
  }

  private static void check(ModelMaterial material) {
    for (Rgb color :
        new Rgb[] {
          material.input(BASE_COLOR).factor(),
          material.emission().factor(),
          material.input(SPECULAR_COLOR).factor(),
          material.input(SHEEN_COLOR).factor()
        }) {
      assertThat(color.isFinite() && Math.min(color.r(), Math.min(color.g(), color.b())) >= 0)
          .isTrue();
    }
    for (MaterialInput scalar :
        new MaterialInput[] {
          material.input(OPACITY),
          material.input(ROUGHNESS),
          material.input(METALLIC),
          material.input(TRANSMISSION),
          material.input(CLEARCOAT),
          material.input(CLEARCOAT_ROUGHNESS)
        }) {
      assertThat(scalar.number()).isBetween(0., 1.);
      assertThat(scalar.channel()).isBetween(0, 3);
    }
    assertThat(material.input(IOR).number()).isGreaterThanOrEqualTo(1).isFinite();
    checkPrintable(material.location());
  }

  private static void checkPrintable(String text) {
    Mutants.assertPrintable(text, LONGEST_LINE);
  }

  /** What is wrong in a material library does not take the model away. */
  private static double least(Format format) {
    return format == Format.MTL_TEXT ? 1 : .05;
  }

  private static double most(Format format) {
    return format == Format.MTL_TEXT ? 1 : .95;
  }

  @ParameterizedTest
  @EnumSource
  void changedFilesAreReadOrRefused(Format format) {
    Mutants.few(QUICK, least(format), most(format), seed -> isRead(format, seed));
  }

  @ParameterizedTest
  @EnumSource
  @Tag("fuzz")
  void manyChangedFilesAreReadOrRefused(Format format) {
    Mutants.many(least(format), most(format), seed -> isRead(format, seed));
  }
}
