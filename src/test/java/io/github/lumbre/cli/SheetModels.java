package io.github.lumbre.cli;

import io.github.lumbre.model.format.threemf.ThreeMfSample;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;

/** The files of {@link SheetOfHashesTest}: small models, skies and scenes. */
final class SheetModels {
  private static final Path CASES = Path.of("src", "test", "resources", "cases");

  private static final String CORNERS =
      """
      mtllib parts.mtl
      v 0 0 0
      v 1 0 0
      v 1 1 0
      v 0 1 0
      v 2 0 %s
      v 3 0 %s
      v 3 1 %s
      v 2 1 %s
      o left
      usemtl gray
      f 1 2 3 4
      """;

  /** Two squares, the right one at some depth. */
  private static final String PARTS =
      CORNERS
          + """
          o %s
          usemtl %s
          f 5 6 7 8
          """;

  private static final String MATERIALS = "newmtl gray\nKd .5 .5 .5\nnewmtl red\nKd 1 0 0\n";

  private static final String BOX =
      """
      OFF
      8 6 0
      0 0 0
      1 0 0
      1 1 0
      0 1 0
      0 0 1
      1 0 1
      1 1 1
      0 1 1
      4 3 2 1 0
      4 4 5 6 7
      4 0 1 5 4
      4 1 2 6 5
      4 2 3 7 6
      4 3 0 4 7
      """;

  private static final String POINTS =
      """
      ply
      format ascii 1.0
      element vertex 5
      property float x
      property float y
      property float z
      property uchar red
      property uchar green
      property uchar blue
      end_header
      0 0 0 255 0 0
      1 0 0 0 255 0
      0 1 0 0 0 255
      1 1 0 255 255 0
      0.5 0.5 0.5 255 255 255
      """;

  private static final String SOLID =
      """
      solid wedge
      facet normal 0 0 1
      outer loop
      vertex 0 0 0
      vertex 1 0 0
      vertex 1 1 0
      endloop
      endfacet
      facet normal 0 1 0
      outer loop
      vertex 0 0 0
      vertex 1 1 0
      vertex 0 1 1
      endloop
      endfacet
      endsolid wedge
      """;

  private static final String BESIDE =
      """
      mtllib a.mtl
      v 0 0 0
      v 1 0 0
      v 0 1 0
      vt 0 0
      vt 1 0
      vt 0 1
      usemtl m
      f 1/1 2/2 3/3
      """;

  /** Misspelled, missing and of the wrong type, out of range, and twice the same. */
  private static final Map<String, String> MISTAKES =
      Map.of(
          "\"samples\": 2", "\"samples\": -2, \"sampels\": 1, \"toneMap\": \"acse\"",
          "\"antialiasing\": 1", "\"antialiasing\": \"no\"",
          "\"materialType\": \"Diffuse\"", "\"materialType\": \"Difuse\"",
          "\"cameraType\": \"Pinhole\"", "\"cameraType\": \"Pinhole\", \"fieldOfView\": 400",
          "\"shapeType\": \"Plane\"", "\"shapeType\": \"Plain\"",
          "\"materialID\": 2, \"radius\": 1", "\"materialID\": 9, \"radius\": -1",
          "{\"id\": 4, ", "{\"id\": 3, \"layer\": 2, ",
          "\"lightType\": \"Point\", \"intensity\": 3", "\"intensity\": null");

  private SheetModels() {}

  /** Writes the files into a folder. */
  static void write(Path folder) throws IOException {
    ModelSample.write(folder);
    // How ImageIO packs a picture may change with the JDK, and hashes of scenes are of its bytes.
    Files.write(folder.resolve("paint.png"), Files.readAllBytes(CASES.resolve("quad.png")));
    text(folder, "parts.mtl", MATERIALS);
    text(folder, "parts.obj", parts("0", "right", "red"));
    text(folder, "moved.obj", parts(".25", "right", "red"));
    text(folder, "gray.obj", parts("0", "right", "gray"));
    text(folder, "renamed.obj", parts("0", "other", "red"));
    text(folder, "box.off", BOX);
    text(folder, "points.ply", POINTS);
    text(folder, "wedge.stl", SOLID);
    Files.write(folder.resolve("square.3mf"), ThreeMfSample.square());
    Files.write(folder.resolve("sky.pfm"), sky());
    writeBeside(folder);
    text(folder, "tiny.json", TinyScene.JSON);
    text(folder, "mistakes.json", mistakes());
    text(folder, "cut.json", TinyScene.JSON.substring(0, 200));
    text(folder, "bad.obj", "v 0 0 0\nv 1 0\nf 1 2 3\n");
    text(folder, "bad.gltf", "{\"asset\": {\"version\": \"2.0\"}, \"scenes\": [{\"nodes\": [4]}]}");
    text(folder, "note.txt", "nothing to see\n");
  }

  /** Writes a model whose picture lies beside its own folder. */
  private static void writeBeside(Path folder) throws IOException {
    Files.createDirectories(folder.resolve("models"));
    Files.createDirectories(folder.resolve("assets"));
    Files.write(folder.resolve("assets/x.png"), Files.readAllBytes(CASES.resolve("quad.png")));
    text(folder, "models/a.obj", BESIDE);
    text(folder, "models/a.mtl", "newmtl m\nmap_Kd ../assets/x.png\n");
  }

  private static void text(Path folder, String name, String text) throws IOException {
    Files.writeString(folder.resolve(name), text);
  }

  private static String parts(String z, String name, String material) {
    return PARTS.formatted(z, z, z, z, name, material);
  }

  private static String mistakes() {
    String scene = TinyScene.JSON;
    for (Map.Entry<String, String> mistake : MISTAKES.entrySet()) {
      scene = scene.replace(mistake.getKey(), mistake.getValue());
    }
    return scene;
  }

  /** Returns a sky of 4x2 pixels: blue above, brown below, and a bright one. */
  private static byte[] sky() {
    ByteBuffer sky = ByteBuffer.allocate(12 + 96).order(ByteOrder.LITTLE_ENDIAN);
    sky.put("PF\n4 2\n-1.0\n".getBytes(StandardCharsets.US_ASCII));
    for (int i = 0; i < 8; i++) {
      sky.putFloat(i == 6 ? 5 : .3f).putFloat(i == 6 ? 4 : .25f).putFloat(i < 4 ? .1f : .8f);
    }
    return sky.array();
  }
}
