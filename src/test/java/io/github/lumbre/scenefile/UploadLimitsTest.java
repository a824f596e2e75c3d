package io.github.lumbre.scenefile;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.image.format.exr.ExrBuilder;
import io.github.lumbre.image.format.imageio.LegacyFixture;
import io.github.lumbre.image.format.ktx.KtxSamples;
import io.github.lumbre.model.format.threemf.ThreeMfSample;
import io.github.lumbre.model.internal.ModelReader;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.StagedModel;
import io.github.lumbre.testing.Pictures;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.Random;
import java.util.zip.CRC32;
import java.util.zip.Deflater;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Limits stop scenes and models before they cost memory or time. */
class UploadLimitsTest {
  /** More than reading a refused file needs, and less than what it claims. */
  private static final long MAX_ALLOCATED = 40L << 20;

  @TempDir private Path directory;

  private static final String TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n";

  private static final String TEXTURE = "{\"assetType\":\"Texture\",\"id\":%d,\"file\":\"%s\"}";

  private static final String DOME = "{\"type\":\"Light\",\"lightType\":\"Dome\",\"textureId\":%d}";

  private Path scene(String assets, String objects) throws IOException {
    return file(
        "s.json",
        "{\"mainCameraId\":7,\"assets\":["
            + assets
            + "],\"objects\":[{\"type\":\"Camera\",\"id\":7,\"cameraType\":\"Pinhole\"},"
            + objects
            + "]}");
  }

  private Path file(String name, byte[] content) throws IOException {
    return Files.write(directory.resolve(name), content);
  }

  private Path file(String name, String content) throws IOException {
    return file(name, content.getBytes(StandardCharsets.US_ASCII));
  }

  /** Requires that a file is refused, without much memory. */
  private static void assertRefused(Path file, Limits limits, String message) {
    com.sun.management.ThreadMXBean threads =
        (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
    SceneParser parser = new SceneParser().limitedTo(limits);
    long before = threads.getCurrentThreadAllocatedBytes();
    SceneFormatException thrown =
        catchThrowableOfType(
            SceneFormatException.class,
            () -> {
              if (ModelReader.isModel(file)) {
                StagedModel.read(file, Stage.DEFAULT, parser);
              } else {
                parser.parse(file);
              }
            });
    long allocated = threads.getCurrentThreadAllocatedBytes() - before;
    assertThat(thrown).hasMessageContaining(message);
    assertThat(thrown.kind()).isEqualTo(SceneFormatException.Kind.LIMIT);
    assertThat(allocated).as("allocated bytes").isLessThan(MAX_ALLOCATED);
  }

  private static byte[] stl(int triangles) {
    ByteBuffer stl = ByteBuffer.allocate(84 + 50 * triangles).order(ByteOrder.LITTLE_ENDIAN);
    stl.putInt(80, triangles);
    float[] corners = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    for (int i = 0; i < triangles; i++) {
      for (int k = 0; k < 9; k++) {
        stl.putFloat(84 + 50 * i + 12 + 4 * k, corners[k] + i % 7);
      }
    }
    return stl.array();
  }

  @Test
  void modelWithinTheLimitsIsRead() throws Exception {
    Limits limits = Limits.UPLOADS.withTriangles(1).withBytes(4000).withTexels(0);
    SceneParser parser = new SceneParser().limitedTo(limits);
    Path triangle = file("a.obj", TRIANGLE);
    assertThat(StagedModel.read(triangle, Stage.DEFAULT, parser).scene().scene().primitives())
        .isNotEmpty();
  }

  private static final String REFUSED =
      "picture, which these limits refuse; save it as a PNG or JPEG, or call"
          + " Limits.withLegacyPictures(true)";

  @Test
  void legacyPicturesAreRefusedUnlessAllowed() throws Exception {
    file("a.gif", LegacyFixture.gifs().findFirst().orElseThrow());
    file("a.mtl", "newmtl a\nmap_Kd a.gif\n");
    Path obj = file("a.obj", "mtllib a.mtl\nusemtl a\n" + TRIANGLE);
    SceneParser parser = new SceneParser().limitedTo(Limits.UPLOADS);
    assertThat(StagedModel.read(obj, Stage.DEFAULT, parser).scene().warnings().toString())
        .contains("GIF " + REFUSED);
    Path scene = scene(TEXTURE.formatted(2, "a.gif"), DOME.formatted(2));
    SceneFormatException thrown =
        catchThrowableOfType(SceneFormatException.class, () -> parser.parse(scene));
    assertThat(thrown).hasMessageContaining("GIF " + REFUSED);
    SceneParser allowing = new SceneParser().limitedTo(Limits.UPLOADS.withLegacyPictures(true));
    assertThat(StagedModel.read(obj, Stage.DEFAULT, allowing).scene().warnings()).isEmpty();
    assertThat(allowing.parse(scene).warnings().toString()).doesNotContain("GIF");
  }

  /** Files of 2 KB that claim 10000x10000 pixels, in formats that need few bytes for them. */
  @Test
  void claimsOfLegacyPicturesAreRefused() throws IOException {
    Limits limits = Limits.UPLOADS.withLegacyPictures(true);
    Path scene = scene(TEXTURE.formatted(2, "a"), DOME.formatted(2));
    byte[] gif = LegacyFixture.gifs().findFirst().orElseThrow();
    file("a", ByteBuffer.wrap(gif).putInt(6, 0x10271027).array());
    assertRefused(scene, limits, "10000x10000 pixels, expected at most 67108864 in total");
    byte[] tiff = LegacyFixture.tiffs().findFirst().orElseThrow();
    file("a", LegacyFixture.with(LegacyFixture.with(tiff, 256, 20000), 257, 20000));
    assertRefused(scene, limits, "20000x20000 pixels, expected at most 65535 per side");
  }

  /** The picture of 2048x512 pixels is a file of 1 KB. */
  @Test
  void linearPicturesFitIntoTheMemory() throws IOException {
    file("black.exr", ExrBuilder.class.getResourceAsStream("black.exr").readAllBytes());
    Path scene = scene(TEXTURE.formatted(2, "black.exr"), DOME.formatted(2));
    int bytes = 12 * 2048 * 512;
    assertRefused(
        scene, Limits.UPLOADS.withMemory(bytes - 1), "2048x512 pixels, expected at most 1048575");
    assertRefused(
        scene, Limits.UPLOADS.withTexels(1 << 19), "2048x512 pixels, expected at most 524288");
  }

  @Test
  void bytesCountOverAllFiles() throws IOException {
    Path stl = file("a.stl", stl(100));
    assertRefused(stl, Limits.NONE.withBytes(5083), "expected at most 5083 bytes in all files");
    file("a.mtl", "newmtl a\nmap_Kd a.png\n");
    file("a.png", new byte[3000]);
    Path obj = file("a.obj", "mtllib a.mtl\nusemtl a\n" + TRIANGLE);
    assertRefused(
        obj, Limits.NONE.withBytes(2000), "expected at most 2000 bytes in all files, found 3089");
    Path scene = file("s.json", "{\"objects\": []}");
    assertRefused(scene, Limits.NONE.withBytes(10), "expected at most 10 bytes, found 15");
  }

  private static final String VERTICES =
      "<vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" z=\"0\"/>"
          + "<vertex x=\"0\" y=\"1\" z=\"0\"/>";

  @Test
  void archivesThatUnfoldTooFarAreRefused() throws IOException {
    String spaces = " ".repeat(60 << 20);
    byte[] bomb = ThreeMfSample.ofItems(spaces, "");
    assertRefused(file("a.3mf", bomb), Limits.NONE, "inflated bytes of an archive of");
    byte[] small = ThreeMfSample.ofItems(" ".repeat(1 << 19), "");
    Limits limits = Limits.NONE.withBytes(1 << 19);
    assertRefused(file("a.3mf", small), limits, "expected at most 524288 bytes in all files");
  }

  @Test
  void trianglesOfEveryFormat() throws IOException {
    String message = "expected at most 9 triangles, found 10";
    Limits limits = Limits.NONE.withTriangles(9);
    assertRefused(file("a.stl", stl(10)), limits, message);
    assertRefused(file("a.obj", TRIANGLE + "f 1 2 3\n".repeat(9)), limits, message);
    String ply =
        "ply\n"
            + "format ascii 1.0\n"
            + "element vertex 3\n"
            + "property float x\n"
            + "property float y\n"
            + "property float z\n"
            + "element face 10\n"
            + "property list uchar int vertex_indices\n"
            + "end_header\n"
            + "0 0 0\n"
            + "1 0 0\n"
            + "0 1 0\n"
            + "3 0 1 2\n".repeat(10);
    assertRefused(file("a.ply", ply), limits, message);
    String off = "OFF\n3 10 0\n0 0 0\n1 0 0\n0 1 0\n" + "3 0 1 2\n".repeat(10);
    assertRefused(file("a.off", off), limits, message);
    String item = "<item objectid=\"1\"/>";
    String object =
        "<object id=\"1\"><mesh><vertices>"
            + VERTICES
            + "</vertices><triangles>"
            + "<triangle v1=\"0\" v2=\"1\" v3=\"2\"/>".repeat(5)
            + "</triangles></mesh></object>";
    assertRefused(file("a.3mf", ThreeMfSample.ofItems(object, item + item)), limits, message);
    String solid =
        "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
            + "endloop\nendfacet\n";
    assertRefused(
        file("text.stl", "solid a\n" + solid.repeat(10) + "endsolid a\n"), limits, message);
    assertRefused(file("a.gltf", gltf(10)), limits, message);
  }

  /** One triangle that is used by many nodes. */
  private static String gltf(int nodes) {
    ByteBuffer data = ByteBuffer.allocate(36).order(ByteOrder.LITTLE_ENDIAN);
    data.putFloat(12, 1).putFloat(28, 1);
    String node = "{\"mesh\":0}";
    StringBuilder numbers = new StringBuilder("0");
    for (int i = 1; i < nodes; i++) {
      numbers.append(",").append(i);
    }
    return "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":["
        + numbers
        + "]}],\"nodes\":["
        + String.join(",", java.util.Collections.nCopies(nodes, node))
        + "],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],"
        + "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\","
        + "\"min\":[0,0,0],\"max\":[1,1,0]}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],"
        + "\"buffers\":[{\"byteLength\":36,\"uri\":\"data:application/octet-stream;base64,"
        + Base64.getEncoder().encodeToString(data.array())
        + "\"}]}";
  }

  @Test
  void trianglesCountForEachUseInAScene() throws IOException {
    file("a.stl", stl(5));
    String model = "{\"type\":\"Model\",\"file\":\"a.stl\"}";
    Path scene = scene("", model + "," + model);
    assertRefused(scene, Limits.NONE.withTriangles(9), "expected at most 4 triangles, found 5");
  }

  /** Returns a PNG of one color, with a true header: it is small, and its picture is large. */
  private static byte[] bomb(int side) throws IOException {
    ByteArrayOutputStream idat = new ByteArrayOutputStream();
    Deflater deflater = new Deflater(9);
    byte[] row = new byte[side + 1];
    byte[] out = new byte[8192];
    for (int y = 0; y <= side; y++) {
      if (y < side) {
        deflater.setInput(row);
      } else {
        deflater.finish();
      }
      for (int n = deflater.deflate(out); n > 0; n = deflater.deflate(out)) {
        idat.write(out, 0, n);
      }
    }
    deflater.end();
    ByteArrayOutputStream png = new ByteArrayOutputStream();
    png.write(new byte[] {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'});
    ByteBuffer header = ByteBuffer.allocate(13).putInt(side).putInt(side).put((byte) 8);
    chunk(png, "IHDR", header.array());
    chunk(png, "IDAT", idat.toByteArray());
    chunk(png, "IEND", new byte[0]);
    return png.toByteArray();
  }

  private static void chunk(ByteArrayOutputStream png, String type, byte[] content)
      throws IOException {
    ByteArrayOutputStream body = new ByteArrayOutputStream();
    body.write(type.getBytes(StandardCharsets.US_ASCII));
    body.write(content);
    CRC32 crc = new CRC32();
    crc.update(body.toByteArray());
    png.write(ByteBuffer.allocate(4).putInt(content.length).array());
    png.write(body.toByteArray());
    png.write(ByteBuffer.allocate(4).putInt((int) crc.getValue()).array());
  }

  static List<byte[]> bombs() throws IOException {
    byte[] ktx = KtxSamples.file("ETC1S of one color");
    ByteBuffer.wrap(ktx).order(ByteOrder.LITTLE_ENDIAN).putInt(20, 8000).putInt(24, 8000);
    return List.of(bomb(8000), ktx);
  }

  @ParameterizedTest
  @MethodSource("bombs")
  void texelsOfPicturesInModelsAndScenes(byte[] bomb) throws IOException {
    file("bomb.png", bomb);
    file("a.mtl", "newmtl a\nmap_Kd bomb.png\n");
    Path obj = file("a.obj", "mtllib a.mtl\nusemtl a\n" + TRIANGLE);
    Limits limits = Limits.NONE.withTexels(1 << 20);
    assertRefused(obj, limits, "8000x8000 pixels, expected at most 1048576 in total");
    Path scene = scene(TEXTURE.formatted(1, "bomb.png"), DOME.formatted(1));
    assertRefused(scene, limits, "8000x8000 pixels, expected at most 1048576 in total");
  }

  @Test
  void texelsAddUp() throws IOException {
    file("a.png", Pictures.png(16, 16, 0));
    file("b.png", Pictures.png(16, 16, 0));
    file("a.mtl", "newmtl a\nmap_Kd a.png\nmap_Ks b.png\nillum 2\n");
    Path obj = file("a.obj", "mtllib a.mtl\nusemtl a\n" + TRIANGLE);
    assertRefused(obj, Limits.NONE.withTexels(511), "16x16 pixels, expected at most 255");
    Path scene =
        scene(
            TEXTURE.formatted(1, "a.png") + "," + TEXTURE.formatted(2, "b.png"),
            DOME.formatted(1) + "," + DOME.formatted(2));
    assertRefused(scene, Limits.NONE.withTexels(511), "16x16 pixels, expected at most 255");
  }

  @Test
  void texelsOfLinearPictures() throws IOException {
    ByteBuffer pfm = ByteBuffer.allocate(13 + 12 * 64 * 64);
    pfm.put("PF\n64 64\n1.0\n".getBytes(StandardCharsets.US_ASCII));
    file("sky.pfm", pfm.array());
    Path scene = scene(TEXTURE.formatted(1, "sky.pfm"), DOME.formatted(1));
    assertRefused(scene, Limits.NONE.withTexels(4095), "64x64 pixels, expected at most 4095");
  }

  @Test
  void pixelsAndSamples() throws IOException {
    Path scene =
        file("s.json", "{\"renderOptions\":{\"width\":100,\"height\":50,\"sampleCount\":9}}");
    assertRefused(scene, Limits.NONE.withPixels(4999), "width x height <= 4999, found 100x50");
    assertRefused(
        file("a.obj", TRIANGLE), Limits.NONE.withPixels(999), "height <= 999, found 1024x768");
    assertRefused(
        file("a.obj", TRIANGLE), Limits.NONE.withSamples(1), "at most 1 samples per pixel");
  }

  @Test
  void memoryOfMeshesAndJson() throws IOException {
    Limits limits = Limits.NONE.withMemory(1 << 20);
    String vertices = "v 0 0 0\n".repeat(60_000);
    assertRefused(file("a.obj", vertices + TRIANGLE), limits, "at most 1048576 bytes of memory");
    String numbers = "0,".repeat(60_000) + "0";
    assertRefused(file("a.gltf", "{\"a\":[" + numbers + "]}"), limits, "JSON tokens");
    assertRefused(file("s.json", "{\"a\":[" + numbers + "]}"), limits, "JSON tokens");
  }

  @Test
  void timeOfReading() throws IOException {
    byte[] noise = new byte[20 << 20];
    new Random(1).nextBytes(noise);
    for (int i = 0; i < noise.length; i++) {
      noise[i] = (byte) (noise[i] % 7 == 0 ? '\n' : '#');
    }
    byte[] start = TRIANGLE.getBytes(StandardCharsets.US_ASCII);
    System.arraycopy(start, 0, noise, 0, start.length);
    Path obj = file("slow.obj", Arrays.copyOf(noise, noise.length));
    Limits limits = Limits.NONE.withTime(Duration.ofMillis(1));
    long before = System.nanoTime();
    assertRefused(obj, limits, "expected a scene that is read within 0.001 s");
    assertThat(System.nanoTime() - before).isLessThan(2_000_000_000L);
    assertThat(Thread.currentThread().isInterrupted()).isFalse();
  }
}
