package io.github.lumbre;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.Gson;
import java.io.File;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.lang.module.ModuleDescriptor.Requires;
import java.lang.module.ModuleFinder;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.spi.ToolProvider;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Other programs can use the library with Gson as its only dependency. */
class EmbeddingIT {
  private static final Path CONSUMER = Path.of("src", "test", "resources", "consumer");

  @TempDir private Path directory;

  @Test
  void libraryWorksOnTheClassPath() throws Exception {
    compile("-cp", libraries(), source("Consumer.java"));
    runConsumer("-cp", libraries() + File.pathSeparator + directory, "consumer.Consumer");
  }

  @Test
  void libraryWorksOnTheModulePath() throws Exception {
    compile("-p", libraries(), source("module-info.java"), source("Consumer.java"));
    runConsumer(
        "-p", libraries() + File.pathSeparator + directory, "-m", "consumer/consumer.Consumer");
  }

  @Test
  void moduleNeedsGsonAlone() throws IOException, URISyntaxException {
    List<String> needed =
        ModuleFinder.of(library())
            .find("io.github.lumbre")
            .orElseThrow()
            .descriptor()
            .requires()
            .stream()
            .filter(required -> !required.modifiers().contains(Requires.Modifier.STATIC))
            .map(Requires::name)
            .sorted()
            .toList();
    assertThat(needed).containsExactly("com.google.gson", "java.base", "java.desktop");
  }

  @Test
  void libraryHoldsTheLibraryAlone() throws IOException {
    try (JarFile jar = new JarFile(library().toFile())) {
      assertThat(jar.stream().map(JarEntry::getName))
          .contains("module-info.class", "io/github/lumbre/render/PictureRenderer.class")
          .noneMatch(name -> name.matches("io/github/lumbre/(lab|cli)/.*"))
          .noneMatch(name -> name.startsWith("META-INF/native-image"));
    }
    try (JarFile jar = new JarFile("target/lumbre-all.jar")) {
      assertThat(jar.stream().map(JarEntry::getName))
          .contains("io/github/lumbre/cli/Lumbre.class", "io/github/lumbre/base/Release.class")
          .doesNotContain("module-info.class")
          .noneMatch(name -> name.startsWith("io/github/lumbre/lab/"));
    }
    try (JarFile jar = new JarFile("target/lumbre-lab.jar")) {
      assertThat(jar.stream().map(JarEntry::getName).filter(name -> name.endsWith(".class")))
          .isNotEmpty()
          .allMatch(name -> name.startsWith("io/github/lumbre/lab/"));
    }
  }

  /** The transitive dependencies of other groups are Gson alone, without its annotations. */
  @Test
  void dependenciesThatAreInheritedAreGsonAlone() throws IOException {
    String pom = Files.readString(Path.of("pom.xml"));
    String dependencies =
        pom.substring(pom.indexOf("</dependencyManagement>"), pom.indexOf("<build>"));
    List<String> inherited =
        Pattern.compile("<dependency>.*?</dependency>", Pattern.DOTALL)
            .matcher(dependencies)
            .results()
            .map(MatchResult::group)
            .filter(d -> !d.contains("<optional>true") && !d.contains("<scope>"))
            .toList();
    assertThat(inherited).hasSize(1);
    assertThat(inherited.get(0))
        .contains("<artifactId>gson</artifactId>", "<exclusion>", "error_prone_annotations");
    try (JarFile jar = new JarFile("target/lumbre-all.jar")) {
      assertThat(jar.stream().map(JarEntry::getName))
          .anyMatch(name -> name.startsWith("com/google/gson/"))
          .noneMatch(name -> name.startsWith("com/google/errorprone/"))
          .noneMatch(name -> name.startsWith("org/jspecify/"));
    }
  }

  private static String source(String name) {
    return CONSUMER.resolve(name).toString();
  }

  private static String libraries() throws IOException, URISyntaxException {
    Path gson = Path.of(Gson.class.getProtectionDomain().getCodeSource().getLocation().toURI());
    return library() + File.pathSeparator + gson;
  }

  /** Returns the thin jar, whose name contains the version. */
  private static Path library() throws IOException {
    try (Stream<Path> files = Files.list(Path.of("target").toAbsolutePath())) {
      return files
          .filter(file -> file.getFileName().toString().matches("lumbre-[\\d.]+(-SNAPSHOT)?\\.jar"))
          .findFirst()
          .orElseThrow();
    }
  }

  private void compile(String... args) {
    StringWriter messages = new StringWriter();
    PrintWriter writer = new PrintWriter(messages);
    Stream<String> options =
        Stream.of("--release", "17", "-Xlint:all", "-Werror", "-d", directory.toString());
    int result =
        ToolProvider.findFirst("javac")
            .orElseThrow()
            .run(writer, writer, Stream.concat(options, Stream.of(args)).toArray(String[]::new));
    assertThat(result).as(messages.toString()).isZero();
  }

  private void runConsumer(String... args) throws IOException, InterruptedException {
    String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
    Path picture = directory.resolve("picture.png");
    Stream<String> files = Stream.of(source("scene.json"), picture.toString());
    List<String> command =
        Stream.of(Stream.of(java), Stream.of(args), files).flatMap(s -> s).toList();
    Path output = directory.resolve("output.txt");
    Process process =
        new ProcessBuilder(command)
            .redirectErrorStream(true)
            .redirectOutput(output.toFile())
            .start();
    assertThat(process.waitFor(30, TimeUnit.SECONDS)).isTrue();
    assertThat(output).hasContent("");
    assertThat(process.exitValue()).isZero();
    assertThat(ImageIO.read(picture.toFile()).getHeight()).isEqualTo(12);
  }
}
