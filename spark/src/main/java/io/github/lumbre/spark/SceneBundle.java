package io.github.lumbre.spark;

import io.github.lumbre.math.internal.Sha256;
import io.github.lumbre.model.program.ImportProgram.Imported;
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
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;

/**
 * A scene with all of its files and settings, as it travels to executors.
 *
 * @param name of the scene file, relative to a folder that contains all files
 * @param text content of the scene file
 * @param assets contents of the other files, by their paths relative to that folder
 * @param converted the model for which the scene stands, if a program has converted it: one at most
 * @param hash of the scene and all of its files, as {@link SceneFile#hash}
 * @param settings texts of all settings, by their names
 * @param revision {@link FilmRenderer#REVISION} of the driver
 */
record SceneBundle(
    String name,
    byte[] text,
    TreeMap<String, byte[]> assets,
    List<Imported> converted,
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
    Path scenePath = scenePath(path, scene);
    List<Path> files = files(path, scene);
    Path root = commonFolder(scenePath.getParent(), files);
    TreeMap<String, byte[]> assets = new TreeMap<>();
    for (Path file : files) {
      assets.put(root.relativize(file).toString(), Files.readAllBytes(file));
    }
    LinkedHashMap<String, String> settings = new LinkedHashMap<>();
    Setting.all().forEach(setting -> settings.put(setting.name(), scene.settings().text(setting)));
    return new SceneBundle(
        root.relativize(scenePath).toString(),
        scene.text().isPresent() ? scene.text().get().json() : Files.readAllBytes(path),
        assets,
        scene.parsed().imported().stream().toList(),
        scene.hash(),
        settings,
        FilmRenderer.REVISION);
  }

  /** Returns the path where the names of assets start; links are resolved as in their paths. */
  private static Path scenePath(Path path, SceneFile scene) throws IOException {
    if (scene.text().isPresent()) {
      return scene.text().get().path().toAbsolutePath().normalize();
    }
    Path absolute = path.toAbsolutePath().normalize();
    return absolute.getParent().toRealPath().resolve(absolute.getFileName());
  }

  /** Returns the files that executors need besides the text: not what a program has read. */
  private static List<Path> files(Path path, SceneFile scene) throws IOException {
    boolean isScene = scene.text().isEmpty();
    Path scenePath = scenePath(path, scene);
    boolean isImported = scene.parsed().imported().isPresent();
    Path source = path.toAbsolutePath().normalize();
    try {
      Set<Path> all = isScene ? SceneParser.files(path) : scene.assetPaths(scenePath);
      return all.stream()
          .map(file -> file.toAbsolutePath().normalize())
          .filter(file -> !(isScene && file.equals(scenePath)))
          .filter(file -> !(isImported && file.equals(source)))
          .toList();
    } catch (SceneFormatException e) {
      throw new IOException(path + ": has changed since it was read", e);
    }
  }

  /** Returns a folder, or one above it, that contains all files; {@code --assets} names others. */
  private static Path commonFolder(Path folder, List<Path> files) {
    Path common = folder;
    for (Path file : files) {
      while (common.getParent() != null && !file.startsWith(common)) {
        common = common.getParent();
      }
    }
    return common;
  }

  /** Returns the number of bytes of all files. */
  long bytes() {
    long others = assets.values().stream().mapToLong(bytes -> bytes.length).sum();
    return text.length + others + converted.stream().mapToLong(model -> model.glb().length).sum();
  }

  /**
   * Returns what differs between any two bundles that render different samples. A program may
   * convert the same model differently.
   */
  String identity() {
    return hash + converted.stream().map(Imported::hash).toList() + settings;
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
        for (Imported model : converted) {
          requireSame("converted model", Sha256.of(model.glb()), model.hash());
        }
        Path file = folder.resolve(name);
        Files.createDirectories(file.getParent());
        SceneFile scene = read(file, foldersBeside(file, folder));
        requireSame("scene", scene.hash(), hash);
        return scene;
      } finally {
        delete(folder);
      }
    } catch (IOException e) {
      throw new IllegalStateException(
          name + ": the executor cannot keep the scene's files: " + e.getMessage(), e);
    }
  }

  private void requireSame(String what, String found, String expected) {
    if (!found.equals(expected)) {
      throw new IllegalStateException(
          "%s: the executor's %s has the hash %s, expected the driver's %s"
                  .formatted(name, what, found, expected)
              + "; do not change the scene's files while it renders");
    }
  }

  /** Returns the folders of assets that are outside the scene's folder. */
  private List<Path> foldersBeside(Path file, Path folder) {
    return assets.keySet().stream()
        .map(asset -> folder.resolve(asset).getParent())
        .filter(of -> !of.startsWith(file.getParent()))
        .distinct()
        .toList();
  }

  private SceneFile read(Path file, List<Path> further) {
    try {
      SceneParser parser =
          new SceneParser()
              .lenient()
              .inMode(Setting.MODE.type().parse(settings.get(Setting.MODE.name())))
              .limitedTo(SceneParser.MAX_PIXELS_EVER)
              .withAssets(further)
              .overriding(inScene -> parsedSettings());
      return converted.isEmpty()
          ? parser.parse(text, file)
          : parser
              .ofModels()
              .parse(new SceneText(text, file), converted.get(0));
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
