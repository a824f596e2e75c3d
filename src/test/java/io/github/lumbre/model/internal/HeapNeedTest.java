package io.github.lumbre.model.internal;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.model.format.gltf.GltfFile;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests what the starts of model files state, and the heap that they take. */
class HeapNeedTest {
  private static final String VERTICES =
      "element vertex 8\nproperty float x\nproperty float y\nproperty float z\n";

  @TempDir private Path folder;

  private Path file(String name, String start, long size) throws IOException {
    Path file = folder.resolve(name);
    Files.write(file, start.getBytes(US_ASCII));
    try (RandomAccessFile sized = new RandomAccessFile(file.toFile(), "rw")) {
      sized.setLength(size);
    }
    return file;
  }

  private HeapNeed need(String name, String start, long more) throws IOException {
    return HeapNeed.of(file(name, start, start.length() + more));
  }

  private static String ply(String format, String faces) {
    return "ply\nformat " + format + " 1.0\n" + VERTICES + faces + "end_header\n";
  }

  @Test
  void aHeaderOfPlyStatesTriangles() throws IOException {
    String faces = "element face 12\nproperty list uchar int vertex_indices\n";
    String little = ply("binary_little_endian", faces);
    assertThat(need("a.ply", little, 8 * 12 + 12 * 13)).isEqualTo(HeapNeed.ofTriangles(12));
    // Quadrilaterals are two triangles each.
    assertThat(need("b.ply", little, 8 * 12 + 12 * 17)).isEqualTo(HeapNeed.ofTriangles(24));
    assertThat(need("c.ply", ply("ascii", faces), 400)).isEqualTo(HeapNeed.ofTriangles(12));
    assertThat(need("d.ply", ply("ascii", ""), 400)).isEqualTo(HeapNeed.ofPoints(8));
    assertThat(need("e.ply", "ply\nformat ascii 7.0\n", 0)).isEqualTo(HeapNeed.UNKNOWN);
  }

  @Test
  void sizesOfStlFilesStateTriangles() throws IOException {
    ByteBuffer header = ByteBuffer.allocate(84).order(ByteOrder.LITTLE_ENDIAN);
    byte[] file = header.putInt(80, 300).array();
    assertThat(ModelFormat.STL.need(file, 84 + 300 * 50)).isEqualTo(HeapNeed.ofTriangles(300));
    String text =
        """
        solid
          facet normal 0.000000e+00 0.000000e+00 1.000000e+00
            outer loop
              vertex 0.000000e+00 0.000000e+00 0.000000e+00
              vertex 1.000000e+00 0.000000e+00 0.000000e+00
              vertex 0.000000e+00 1.000000e+00 0.000000e+00
            endloop
          endfacet
        """;
    long triangles = need("a.stl", text, 999L * (text.length() - 6)).triangles();
    assertThat(triangles).isBetween(667L, 1500L);
  }

  @Test
  void aHeaderOfOffStatesFacesOrPoints() throws IOException {
    assertThat(need("a.off", "OFF\n9 7 0\n", 900)).isEqualTo(HeapNeed.ofTriangles(7));
    assertThat(need("b.off", "OFF\n9 0 0\n", 900)).isEqualTo(HeapNeed.ofPoints(9));
    assertThat(need("c.off", "OFF\nnine\n", 900)).isEqualTo(HeapNeed.UNKNOWN);
  }

  /** Meshes that share their triangles count once. */
  @Test
  void theAccessorsOfGltfStateTriangles() throws IOException {
    GltfFile file = GltfFile.ofTriangle();
    byte[] glb = file.glb();
    assertThat(ModelFormat.GLTF.need(glb, glb.length)).isEqualTo(HeapNeed.ofTriangles(1));
    byte[] text =
        """
        {"accessors": [{"count": 30}, {"count": 12}],
         "meshes": [
           {"primitives": [{"attributes": {"POSITION": 1}, "indices": 0},
                           {"attributes": {"POSITION": 1}, "indices": 0},
                           {"attributes": {"POSITION": 1}, "mode": 5},
                           {"attributes": {"POSITION": 1}, "indices": 0, "mode": 0}]}]}"""
            .getBytes(US_ASCII);
    assertThat(ModelFormat.GLTF.need(text, text.length)).isEqualTo(new HeapNeed(10 + 10, 12));
    assertThat(ModelFormat.GLTF.need(text, text.length + 1)).isEqualTo(HeapNeed.UNKNOWN);
  }

  @Test
  void largeModelsAreNotedBeforeTheyAreRead() throws IOException {
    String faces = "element face 1000000\nproperty list uchar int vertex_indices\n";
    String start = ply("binary_little_endian", faces);
    Path large = file("large.ply", start, start.length() + 8 * 12 + 13_000_000);
    assertThat(HeapNeed.note(large))
        .hasValueSatisfying(
            note ->
                assertThat(note)
                    .startsWith(large + ": 1000000 triangles take about 134 MiB of the heap of "));
    assertThat(HeapNeed.note(file("small.ply", start, 400_000))).isEmpty();
    assertThat(HeapNeed.note(folder.resolve("missing.ply"))).isEmpty();
  }
}
