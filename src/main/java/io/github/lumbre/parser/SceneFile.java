package io.github.lumbre.parser;

import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * The content of a scene file.
 *
 * @param warnings problems that do not prevent rendering; empty if there are none
 * @param hash SHA-256 over the scene file and every asset file it uses, in hexadecimal
 * @param files the SHA-256 of each of these files
 * @param contents numbers of objects and assets, for reports
 * @param origins places of objects and assets in the file
 * @param text the scene, if it was not read from a file
 */
public record SceneFile(
    Scene scene,
    RenderSettings settings,
    List<Problem> warnings,
    String hash,
    FileHashes files,
    SceneContents contents,
    SceneOrigins origins,
    Optional<SceneText> text) {
  public SceneFile {
    warnings = List.copyOf(warnings);
  }

  /**
   * Returns the absolute paths of the asset files that the scene uses.
   *
   * @param path of the scene, in whose folder the names of assets start
   */
  public Set<Path> assetPaths(Path path) {
    Path absolute = path.toAbsolutePath();
    return files.assets().keySet().stream()
        .map(name -> absolute.resolveSibling(name).normalize())
        .collect(Collectors.toSet());
  }

  /** Returns a copy with a different scene. */
  public SceneFile with(Scene other) {
    return new SceneFile(other, settings, warnings, hash, files, contents, origins, text);
  }

  /**
   * Returns this scene, seen by its camera from another place. The hash is another one too, made of
   * this hash and the pose.
   */
  public SceneFile seenFrom(CameraPose pose) {
    MessageDigest digest = Sha256.digest();
    digest.update((hash + pose).getBytes(StandardCharsets.UTF_8));
    String newHash = HexFormat.of().formatHex(digest.digest());
    Scene moved = scene.seenBy(pose.place(scene.camera()));
    return new SceneFile(moved, settings, warnings, newHash, files, contents, origins, text);
  }

  /** Returns a copy with different settings. */
  public SceneFile with(RenderSettings other) {
    return new SceneFile(scene, other, warnings, hash, files, contents, origins, text);
  }
}
