package io.github.lumbre.fuzz;

import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import java.io.IOException;
import java.nio.file.Path;

/** Any bytes as a scene, beside a picture and a mesh that it may read. */
public final class SceneTarget {
  private static final Path SCENE = TargetFiles.file("scene.json");

  static {
    TargetFiles.write(HostileScenes.INSIDE_PICTURE, PictureMutator.sound());
    TargetFiles.write(HostileScenes.INSIDE_MESH, new byte[0]);
  }

  private SceneTarget() {}

  /** Reads a scene; what else it throws is a defect. */
  public static void fuzzerTestOneInput(byte[] text) throws IOException {
    TargetFiles.write("scene.json", text);
    try {
      new SceneParser().parse(SCENE);
    } catch (SceneFormatException e) {
      return;
    }
  }
}
