package io.github.lumbre.fuzz;

import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;

/** Any bytes as the OBJ file of a sound scene. */
public final class MeshTarget {
  private static final String MESH = "fuzzed.obj";
  private static final Path SCENE = TargetFiles.file("mesh.json");

  static {
    String scene =
        """
        {"mainCameraId": 1,
         "assets": [
          {"id": 1, "assetType": "Material", "materialType": "Diffuse"},
          {"id": 2, "assetType": "Mesh", "file": "%s"}],
         "objects": [
          {"id": 1, "type": "Camera", "cameraType": "Pinhole"},
          {"id": 2, "type": "Shape", "shapeType": "Mesh", "materialID": 1, "meshId": 2}]}
        """;
    TargetFiles.write("mesh.json", scene.formatted(MESH).getBytes(StandardCharsets.UTF_8));
  }

  private MeshTarget() {}

  /** Reads a mesh and builds its hierarchy; what else it throws is a defect. */
  public static void fuzzerTestOneInput(byte[] text) throws IOException {
    TargetFiles.write(MESH, text);
    try {
      new SceneParser().parse(SCENE);
    } catch (SceneFormatException e) {
      return;
    }
  }
}
