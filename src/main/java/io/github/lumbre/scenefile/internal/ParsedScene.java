package io.github.lumbre.scenefile.internal;

import io.github.lumbre.camera.Camera;
import io.github.lumbre.math.internal.Sha256;
import io.github.lumbre.model.program.ImportProgram.Imported;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scenefile.Problem;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneText;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * A scene file, with what reports, audits and checkpoint files state of it.
 *
 * @param sha256 over the scene's text and each file it uses
 * @param files the SHA-256 of the scene file and of every asset file it uses
 * @param contents numbers of objects and assets
 * @param origins places of objects and assets in the file
 * @param model the content of the model that the scene is made around; empty for other scenes
 * @param imported the model for which the scene stands, if a program has converted it
 */
public record ParsedScene(
    Scene scene,
    RenderSettings settings,
    List<Problem> warnings,
    LateHash sha256,
    FileHashes files,
    SceneContents contents,
    SceneOrigins origins,
    Optional<SceneText> text,
    Optional<ModelContents> model,
    Optional<Imported> imported)
    implements SceneFile {
  public ParsedScene {
    warnings = List.copyOf(warnings);
  }

  @Override
  public String hash() {
    return sha256.value();
  }

  @Override
  public ParsedScene parsed() {
    return this;
  }

  @Override
  public Set<Path> assetPaths(Path path) {
    Path absolute = path.toAbsolutePath();
    return files.assets().keySet().stream()
        .map(name -> absolute.resolveSibling(name).normalize())
        .collect(Collectors.toSet());
  }

  @Override
  public ParsedScene with(Scene other) {
    return new ParsedScene(
        other, settings, warnings, sha256, files, contents, origins, text, model, imported);
  }

  /**
   * Returns this scene, seen by its camera from another place. The hash is another one too, made of
   * this hash and the pose.
   */
  public ParsedScene seenFrom(CameraPose pose) {
    return seenBy(pose.place(scene.camera()), pose.toString());
  }

  /**
   * Returns this scene, seen by another camera. The hash is another one too, made of this hash and
   * the camera.
   */
  public ParsedScene seenBy(PlacedCamera camera) {
    return seenBy(camera.placed(settings.aspect()), camera.toString());
  }

  private ParsedScene seenBy(Camera camera, String identity) {
    LateHash changed =
        new LateHash(
            () -> Sha256.of((sha256.value() + identity).getBytes(StandardCharsets.UTF_8)));
    return new ParsedScene(
        scene.seenBy(camera),
        settings,
        warnings,
        changed,
        files,
        contents,
        origins,
        text,
        model,
        imported);
  }

  @Override
  public ParsedScene with(RenderSettings other) {
    return new ParsedScene(
        scene, other, warnings, sha256, files, contents, origins, text, model, imported);
  }
}
