package io.github.lumbre.scenefile;

import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * The content of a scene file. {@link SceneParser} and {@link SceneWriter} make it; others cannot
 * implement it. Immutable.
 */
public interface SceneFile extends OpenSceneFile {
  /** Returns the scene. */
  Scene scene();

  /** Returns the settings that the file states, and the defaults of the others. */
  RenderSettings settings();

  /** Returns the problems that do not prevent rendering; empty if there are none. */
  List<Problem> warnings();

  /** Returns the SHA-256 over the scene file and every asset file it uses, in hexadecimal. */
  String hash();

  /** Returns the scene, if it was not read from a file. */
  Optional<SceneText> text();

  /**
   * Returns the absolute paths of the asset files that the scene uses.
   *
   * @param path of the scene, in whose folder the names of assets start
   */
  Set<Path> assetPaths(Path path);

  /** Returns a copy with a different scene. */
  SceneFile with(Scene other);

  /** Returns a copy with different settings. */
  SceneFile with(RenderSettings other);
}
