package io.github.lumbre.spark;

import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.scenefile.SceneText;
import java.io.IOException;
import java.io.Serializable;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;

/**
 * A scene with all of its files and settings, as it travels to executors.
 *
 * @param name of the scene file
 * @param text content of the scene file
 * @param assets contents of the other files, by their paths relative to the scene's folder
 * @param hash of the scene and all of its files, as {@link SceneFile#hash}
 * @param settings texts of all settings, by their names
 * @param revision {@link FilmRenderer#REVISION} of the driver
 */
record SceneBundle(
    String name,
    byte[] text,
    TreeMap<String, byte[]> assets,
    String hash,
    LinkedHashMap<String, String> settings,
    int revision)
    implements Serializable {
  /**
   * Returns the bundle of a scene.
   *
   * @param path of the scene file
   * @throws IOException if a file has changed or can no longer be read
   */
  static SceneBundle of(Path path, SceneFile scene) throws IOException {
    Path source = scene.text().map(SceneText::path).orElse(path);
    Path folder = source.toAbsolutePath().getParent();
    TreeMap<String, byte[]> assets = new TreeMap<>();
    Set<Path> files;
    try {
      files = scene.text().isPresent() ? scene.assetPaths(source) : SceneParser.files(path);
    } catch (SceneFormatException e) {
      throw new IOException(path + ": has changed since it was read", e);
    }
    for (Path file : files) {
      Path absolute = file.toAbsolutePath().normalize();
      if (scene.text().isPresent() || !absolute.equals(path.toAbsolutePath().normalize())) {
        assets.put(folder.normalize().relativize(absolute).toString(), Files.readAllBytes(file));
      }
    }
    LinkedHashMap<String, String> settings = new LinkedHashMap<>();
    Setting.all().forEach(setting -> settings.put(setting.name(), scene.settings().text(setting)));
    return new SceneBundle(
        source.getFileName().toString(),
        scene.text().isPresent() ? scene.text().get().json() : Files.readAllBytes(path),
        assets,
        scene.hash(),
        settings,
        FilmRenderer.REVISION);
  }

  /** Returns the number of bytes of all files. */
  long bytes() {
    return text.length + assets.values().stream().mapToLong(bytes -> bytes.length).sum();
  }

  /**
   * Reads the scene from a temporary copy of its files, which is deleted.
   *
   * @throws IllegalStateException if it is not bit-identical to the driver's
   */
  SceneFile read() {
    try {
      Path folder = Files.createTempDirectory("lumbre-scene-");
      try {
        for (Map.Entry<String, byte[]> asset : assets.entrySet()) {
          Path file = folder.resolve(asset.getKey()).normalize();
          if (!file.startsWith(folder)) {
            throw new IllegalStateException(asset.getKey() + ": outside the scene's folder");
          }
          Files.createDirectories(file.getParent());
          Files.write(file, asset.getValue());
        }
        SceneFile scene = read(folder.resolve(name));
        if (!scene.hash().equals(hash)) {
          throw new IllegalStateException(
              name
                  + ": the executor's scene has the hash "
                  + scene.hash()
                  + ", expected the driver's "
                  + hash
                  + "; do not change the scene's files while it renders");
        }
        return scene;
      } finally {
        delete(folder);
      }
    } catch (IOException e) {
      throw new IllegalStateException(
          name + ": the executor cannot keep the scene's files: " + e.getMessage(), e);
    }
  }

  private SceneFile read(Path file) {
    try {
      return new SceneParser()
          .lenient()
          .inMode(Setting.MODE.type().parse(settings.get(Setting.MODE.name())))
          .limitedTo(SceneParser.MAX_PIXELS_EVER)
          .overriding(inScene -> parsedSettings())
          .parse(text, file);
    } catch (SceneFormatException e) {
      throw new IllegalStateException(e.getMessage(), e);
    }
  }

  /** Returns the driver's settings, of the full frame. */
  private RenderSettings parsedSettings() {
    RenderSettings.Builder builder = new RenderSettings.Builder();
    Setting.all().forEach(setting -> set(builder, setting));
    return builder.build();
  }

  private <T> void set(RenderSettings.Builder builder, Setting<T> setting) {
    builder.set(setting, setting.type().parse(settings.get(setting.name())));
  }

  private static void delete(Path folder) throws IOException {
    try (Stream<Path> files = Files.walk(folder)) {
      for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
        Files.deleteIfExists(file);
      }
    }
  }
}
