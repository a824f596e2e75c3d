import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.spi.ToolProvider;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Builds the runtime image of the platform it runs on: Java, the command-line jar, a launcher and
 * what makes it start fast. {@code java release/image/BuildImage.java JAR IMAGE}, in the
 * repository's folder, with the JDK that the image is to contain; {@code JAR} is {@code
 * target/lumbre-all.jar}. An existing image is replaced.
 */
final class BuildImage {
  private static final String MAIN = "io.github.lumbre.cli.Lumbre";
  private static final String VECTORS = "jdk.incubator.vector";
  private static final List<String> VERSION_OPTIONS =
      List.of(
          "-XX:+UseSerialGC",
          "-XX:TieredStopAtLevel=1",
          "-Dlumbre.kernel.deferred=true",
          "-Djava.awt.headless=true");

  /** Windows, sound and the archive for heaps of 32 GB and more, without which Java starts too. */
  private static final List<String> UNUSED =
      List.of(
          "server/classes_nocoops.jsa",
          "libawt_xawt.so",
          "libjawt.so",
          "libjsound.so",
          "libsplashscreen.so",
          "jrt-fs.jar",
          "classlist");

  private static final boolean IS_WINDOWS = File.separatorChar == '\\';

  private final Path image;
  private final Path runtime;
  private final Path app;
  private final Path share;

  private BuildImage(Path image) {
    this.image = image;
    runtime = image.resolve("lib/runtime");
    app = image.resolve("lib/app");
    share = image.resolve("share");
  }

  public static void main(String[] args) throws Exception {
    if (args.length != 2 || !Files.isRegularFile(Path.of(args[0]))) {
      System.err.println("usage: java release/image/BuildImage.java target/lumbre-all.jar IMAGE");
      System.exit(2);
    }
    new BuildImage(Path.of(args[1]).toAbsolutePath()).build(Path.of(args[0]));
  }

  private void build(Path jar) throws IOException, InterruptedException {
    if (Files.exists(image) && !Files.isDirectory(runtime)) {
      throw new IOException(image + " exists and is no runtime image; it is left alone");
    }
    delete(image);
    Files.createDirectories(app);
    Files.createDirectories(image.resolve("bin"));
    link(modules(jar));
    copyProgram(jar);
    writeLauncher();
    archiveVersion();
    archiveRender();
    writeCompanions();
    printSizes();
  }

  /** Returns the jar of the lab, beside the program's own. */
  private static Path lab(Path jar) {
    return jar.resolveSibling("lumbre-lab.jar");
  }

  /** Returns the modules that the jars need. Gson uses java.sql only where it is present. */
  private static TreeSet<String> modules(Path jar) {
    TreeSet<String> modules =
        new TreeSet<>(
            List.of(
                run(
                        "jdeps",
                        "--multi-release",
                        "17",
                        "--ignore-missing-deps",
                        "--print-module-deps",
                        jar.toString(),
                        lab(jar).toString())
                    .strip()
                    .split(",")));
    modules.remove("java.sql");
    modules.addAll(List.of(VECTORS, "java.logging"));
    return modules;
  }

  private void link(TreeSet<String> modules) throws IOException {
    boolean isNew = Runtime.version().feature() >= 21;
    List<String> arguments =
        new ArrayList<>(
            List.of(
                "--add-modules",
                String.join(",", modules),
                "--strip-debug",
                "--no-header-files",
                "--no-man-pages",
                isNew ? "--compress=zip-6" : "--compress=2",
                "--output",
                runtime.toString()));
    if (isNew) {
      arguments.add("--generate-cds-archive");
    }
    run("jlink", arguments.toArray(String[]::new));
    for (String name : UNUSED) {
      Files.deleteIfExists(runtime.resolve("lib").resolve(name));
    }
  }

  private void copyProgram(Path jar) throws IOException {
    Path copy = app.resolve("lumbre.jar");
    Files.copy(jar, copy);
    // The archives hold this time. Archivers and file systems keep whole seconds, some only even
    // ones.
    Files.setLastModifiedTime(copy, FileTime.fromMillis(1_700_000_000_000L));
    Files.copy(lab(jar), app.resolve("lumbre-lab.jar"));
    String options = Files.readString(Path.of("src/main/jvm/options"));
    Files.writeString(
        app.resolve("options"),
        options + "\n--add-modules=" + VECTORS + "\n--add-opens=java.base/java.io=ALL-UNNAMED\n");
    for (String name : List.of("short.sh", "short-options", "check-options")) {
      Files.copy(Path.of("src/main/jvm", name), app.resolve(name));
    }
    Files.write(app.resolve("version.options"), VERSION_OPTIONS);
    Path scenes = share.resolve("lumbre/scenes");
    Files.createDirectories(scenes);
    Files.copy(Path.of("scenes/cornell-box.json"), scenes.resolve("cornell-box.json"));
    for (String file : List.of("LICENSE", "NOTICE")) {
      Files.copy(Path.of(file), share.resolve("lumbre").resolve(file));
    }
  }

  private void writeLauncher() throws IOException {
    String name = IS_WINDOWS ? "lumbre.cmd" : "lumbre";
    Path target = image.resolve("bin").resolve(name);
    Files.copy(Path.of("release/image", name), target);
    if (!IS_WINDOWS) {
      Files.setPosixFilePermissions(target, PosixFilePermissions.fromString("rwxr-xr-x"));
    }
    // An archive that does not fit, because of other options, is no news to the user.
    String since25 = Runtime.version().feature() >= 25 ? "-Xlog:aot*=off\n" : "";
    Files.writeString(app.resolve("cache.options"), "-Xlog:cds*=off\n" + since25);
  }

  private void archiveVersion() throws IOException, InterruptedException {
    List<String> options = new ArrayList<>(VERSION_OPTIONS);
    options.add("-XX:ArchiveClassesAtExit=" + app.resolve("version.jsa"));
    java(options, "--version");
  }

  private void archiveRender() throws IOException, InterruptedException {
    Path pictures = Files.createTempDirectory("lumbre");
    String[] render = {
      "render",
      "scenes/cornell-box.json",
      "scenes/models/lantern.glb",
      "src/main/jvm/rehearsal.gltf",
      "--size",
      "16x12",
      "--samples",
      "2",
      "--output",
      pictures.toString(),
      "--overwrite",
      "--progress",
      "none"
    };
    String options = "@" + app.resolve("options");
    Path classes = Files.createTempFile("lumbre", ".classes");
    try {
      java(List.of(options, "-XX:DumpLoadedClassList=" + classes), render);
      java(
          List.of(
              options,
              "-Xshare:dump",
              "-XX:SharedClassListFile=" + classes,
              "-XX:SharedArchiveFile=" + app.resolve("lumbre.jsa")));
    } finally {
      Files.delete(classes);
      delete(pictures);
    }
  }

  /** Writes what shells, manuals and desktops look for, at the places where they do. */
  private void writeCompanions() throws IOException, InterruptedException {
    write("bash-completion/completions/lumbre", java(List.of(), "completion"));
    write(
        "fish/vendor_completions.d/lumbre.fish", java(List.of(), "completion", "--shell", "fish"));
    write("lumbre/lumbre.ps1", java(List.of(), "completion", "--shell", "powershell"));
    String manual = java(List.of(), "man");
    write("man/man1/lumbre.1", manual);
    Matcher command = Pattern.compile("lumbre\\\\-(\\w+)\\\\fR\\(1\\)").matcher(manual);
    while (command.find()) {
      String name = command.group(1);
      write("man/man1/lumbre-" + name + ".1", java(List.of(), "man", name));
    }
    for (String file : List.of("thumbnailers/lumbre.thumbnailer", "mime/packages/lumbre.xml")) {
      write(file, Files.readString(Path.of("release/image", file)));
    }
  }

  private void write(String file, String text) throws IOException {
    Path target = share.resolve(file);
    Files.createDirectories(target.getParent());
    Files.writeString(target, text);
  }

  /** Runs the program in the image and returns what it prints. */
  private String java(List<String> options, String... arguments)
      throws IOException, InterruptedException {
    List<String> command = new ArrayList<>();
    command.add(runtime.resolve("bin/java" + (IS_WINDOWS ? ".exe" : "")).toString());
    command.addAll(options);
    command.addAll(List.of("-cp", app.resolve("lumbre.jar").toString()));
    if (arguments.length > 0) {
      command.add(MAIN);
      command.addAll(Arrays.asList(arguments));
    }
    Path out = Files.createTempFile("lumbre", ".out");
    Path err = Files.createTempFile("lumbre", ".err");
    try {
      int code =
          new ProcessBuilder(command)
              .redirectOutput(out.toFile())
              .redirectError(err.toFile())
              .start()
              .waitFor();
      if (code != 0) {
        throw new IOException(String.join(" ", command) + " failed:\n" + Files.readString(err));
      }
      return Files.readString(out);
    } finally {
      Files.delete(out);
      Files.delete(err);
    }
  }

  private static String run(String tool, String... arguments) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    PrintStream out = new PrintStream(bytes, true, StandardCharsets.UTF_8);
    ToolProvider provider =
        ToolProvider.findFirst(tool)
            .orElseThrow(() -> new IllegalStateException("this Java has no " + tool));
    int code = provider.run(out, out, arguments);
    String text = bytes.toString(StandardCharsets.UTF_8);
    if (code != 0) {
      throw new IllegalStateException(tool + " failed:\n" + text);
    }
    return text;
  }

  private void printSizes() throws IOException {
    try (Stream<Path> parts = Stream.of(runtime, app, image)) {
      System.out.println(
          parts
              .map(part -> image.getParent().relativize(part) + ": " + size(part) + " bytes")
              .collect(Collectors.joining("\n")));
    }
  }

  private static long size(Path folder) {
    try (Stream<Path> files = Files.walk(folder)) {
      return files.filter(Files::isRegularFile).mapToLong(file -> file.toFile().length()).sum();
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }

  private static void delete(Path folder) throws IOException {
    if (Files.exists(folder)) {
      try (Stream<Path> files = Files.walk(folder)) {
        for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
          Files.delete(file);
        }
      }
    }
  }
}
