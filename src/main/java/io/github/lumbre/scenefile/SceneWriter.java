package io.github.lumbre.scenefile;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import io.github.lumbre.base.file.OutputFile;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scene.internal.SceneDescription;
import io.github.lumbre.scene.internal.SceneInside;
import io.github.lumbre.scene.internal.SceneNode;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * Writes scenes that code built as scene files, with meshes and textures beside them. Read again,
 * such a file has the same samples, bit for bit, and the hash of {@link #file}.
 *
 * <p>The format has no place for textures, materials and apertures that a program computes itself,
 * for a scene in motion, and for a few combinations; a scene with one of them is refused with an
 * {@link IllegalArgumentException} that names the object. Such scenes can be rendered all the same.
 * Stateless.
 */
public final class SceneWriter {
  private static final Gson GSON = new GsonBuilder().disableHtmlEscaping().create();

  private SceneWriter() {}

  /** The text of a scene and the files that it names. */
  private record Parts(byte[] json, Map<String, byte[]> files) {}

  /**
   * Returns a scene as it would be read from the file that {@link #write} writes: with its hash,
   * and the places of its objects. Its scene is the given one, seen for the aspect ratio of the
   * settings, with the names that the file gives; if the settings have a {@link Setting#SHUTTER},
   * it is read anew, and its animated models move. Everything that takes a {@link SceneFile} takes
   * it.
   *
   * @param settings are part of the hash, as the {@code renderOptions} of a file are
   * @throws IllegalArgumentException if the scene was read from a file or the format cannot express
   *     it
   */
  public static SceneFile file(Scene scene, RenderSettings settings) {
    return file(scene, settings, parts(scene, settings), Path.of("scene.json"));
  }

  private static SceneFile file(Scene scene, RenderSettings settings, Parts parts, Path path) {
    try {
      return new SceneParser()
          .overriding(inFile -> settings)
          .parse(
              new SceneText(parts.json(), path),
              parts.files(),
              Optional.of(scene.framed(settings.aspect())));
    } catch (SceneFormatException e) {
      throw new IllegalArgumentException("scene: " + e.getMessage(), e);
    }
  }

  /**
   * Writes a scene. Meshes, textures and models are in the folder {@code assets} beside it, under
   * names that contain hashes of their content: frames of an animation share them.
   *
   * @param target path of the JSON file; the folder exists
   * @return the scene as it is read from the file
   * @throws FileAlreadyExistsException if the target exists with other content
   * @throws IOException if a file cannot be written
   * @throws IllegalArgumentException if the format cannot express the scene
   */
  public static SceneFile write(Scene scene, RenderSettings settings, Path target)
      throws IOException {
    return write(scene, settings, target, false);
  }

  /** Writes a scene in place of an existing file; see {@link #write}. */
  public static SceneFile replace(Scene scene, RenderSettings settings, Path target)
      throws IOException {
    return write(scene, settings, target, true);
  }

  private static SceneFile write(
      Scene scene, RenderSettings settings, Path target, boolean replacing) throws IOException {
    Parts parts = parts(scene, settings);
    SceneFile file = file(scene, settings, parts, target);
    Path folder = target.toAbsolutePath().getParent();
    if (!replacing && differs(target, parts.json())) {
      throw new FileAlreadyExistsException(target.toString());
    }
    for (Map.Entry<String, byte[]> asset : parts.files().entrySet()) {
      Path path = folder.resolve(asset.getKey());
      Files.createDirectories(path.getParent());
      if (differs(path, asset.getValue())) {
        throw new FileAlreadyExistsException(
            path.toString(), null, "its content differs from the content that its name states");
      }
      save(path, asset.getValue());
    }
    save(target, parts.json());
    return file;
  }

  /** Returns whether a file exists with other content. */
  private static boolean differs(Path path, byte[] content) throws IOException {
    return Files.exists(path) && !Arrays.equals(Files.readAllBytes(path), content);
  }

  private static void save(Path path, byte[] content) throws IOException {
    if (Files.exists(path) && !differs(path, content)) {
      return;
    }
    try (OutputFile output = OutputFile.open(path)) {
      output.write(ByteBuffer.wrap(content));
      output.commit();
    }
  }

  private static Parts parts(Scene scene, RenderSettings settings) {
    if (scene.poses().size() > 1) {
      throw new Unwritable("a scene that stands still", "one in motion");
    }
    SceneInside inside = SceneInside.of(scene);
    SceneDescription description =
        inside
            .description()
            .orElseThrow(() -> new Unwritable("a scene that was built in code", "one from a file"));
    AssetWriter assets = new AssetWriter();
    ObjectWriter objects = new ObjectWriter(assets, inside.names());
    JsonArray all = objects.all(description.nodes());
    all.add(
        objects.camera(
            description
                .viewpoint()
                .orElseThrow(() -> new Unwritable("a scene with lookingAt", "one with seenBy"))));
    String text =
        "{\n\"%s\": 1,\n\"%s\": %s,\n\"%s\": %s,\n\"%s\": %s\n}\n"
            .formatted(
                RootKeys.MAIN_CAMERA.name(),
                RootKeys.OPTIONS.name(),
                GSON.toJson(options(description, settings)),
                RootKeys.ASSETS.name(),
                lines(assets.assets()),
                RootKeys.OBJECTS.name(),
                lines(all.asList()));
    return new Parts(text.getBytes(StandardCharsets.UTF_8), assets.files());
  }

  private static String lines(Collection<? extends JsonElement> elements) {
    return elements.stream().map(GSON::toJson).collect(Collectors.joining(",\n  ", "[\n  ", "\n]"));
  }

  private static JsonObject options(SceneDescription description, RenderSettings settings) {
    JsonObject options = new JsonObject();
    for (Setting<?> setting : Setting.all()) {
      if (setting.isInScenes() && (setting != Setting.BACKPLATE || settings.isSet(setting))) {
        add(options, setting, settings);
      }
    }
    if (settings.mode() == RenderSettings.Mode.RAY) {
      antialiasing(options, settings.samples());
    }
    if (description.backplate().isPresent()) {
      if (settings.isSet(Setting.BACKPLATE)) {
        throw new Unwritable("a backplate of light or of a color", "both");
      }
      options.add(
          Setting.BACKPLATE.name(), SettingsReader.written(description.backplate().get()));
    }
    Optional<Rgb> background = background(description.nodes());
    if (settings.transparent()) {
      background.ifPresent(
          color -> {
            throw new Unwritable("a background color or a transparent background", "both");
          });
      options.addProperty(RootKeys.BACKGROUND.name(), SettingsReader.TRANSPARENT);
    } else {
      background.ifPresent(
          color ->
              options.add(RootKeys.BACKGROUND.name(), Value.COLOR.writer().apply(color)));
    }
    return options;
  }

  /** Writes the samples of ray mode if they are a power of four; others are for a flag. */
  private static void antialiasing(JsonObject to, int samples) {
    int exponent = Integer.numberOfTrailingZeros(samples);
    boolean isPower = Integer.bitCount(samples) == 1 && exponent % 2 == 0;
    if (isPower && exponent <= RootKeys.MAX_ANTIALIASING) {
      RootKeys.ANTIALIASING.put(to, exponent);
    }
  }

  private static <T> void add(JsonObject to, Setting<T> setting, RenderSettings settings) {
    SettingsReader.key(setting).put(to, settings.get(setting));
  }

  private static Optional<Rgb> background(List<SceneNode> nodes) {
    List<Rgb> all = new ArrayList<>();
    for (SceneNode node : nodes) {
      if (node instanceof SceneNode.Background background) {
        if (!background.lightGroup().isEmpty()) {
          throw new Unwritable("a background without a light group", "one in a group");
        }
        all.add(background.radiance());
      }
    }
    boolean hasSky =
        nodes.stream()
            .anyMatch(
                n -> n instanceof SceneNode.Lamp lamp && lamp.light() instanceof EnvironmentLight);
    if (all.size() > 1 || hasSky && !all.isEmpty()) {
      throw new Unwritable("one background or environment lights", "more backgrounds");
    }
    return all.stream().findFirst();
  }
}
