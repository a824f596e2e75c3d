package io.github.lumbre;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.lang.reflect.Method;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.spi.ToolProvider;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Every example of {@code docs/java.md}, {@code docs/java-parts.md} and {@code docs/servers.md}
 * compiles, with warnings as errors, and runs. Together they name every exported type.
 */
class JavaPageTest {
  private static final Pattern JAVA = Pattern.compile("```java\n(.*?)```", Pattern.DOTALL);

  /** A file in the working directory. Examples write to no folder, as it may be missing. */
  private static final Pattern OUTPUT = Pattern.compile("Path\\.of\\(\"([\\w.-]+)\"\\)");

  /** A parser for pictures that take little time. */
  private static final String SMALL =
      "new SceneParser().overriding(s -> s.toBuilder().size(8, 8).samples(2).build())";

  @TempDir private Path directory;

  private static List<String> blocks() throws Exception {
    return blocks("java.md");
  }

  private static List<String> blocks(String page) throws Exception {
    return JAVA.matcher(Files.readString(Path.of("docs", page)))
        .results()
        .map(block -> block.group(1))
        .toList();
  }

  private static Stream<Named<String>> examples(String page) throws Exception {
    List<String> blocks = blocks(page);
    return IntStream.range(1, blocks.size())
        .mapToObj(i -> Named.of(blocks.get(i).lines().findFirst().orElseThrow(), blocks.get(i)));
  }

  static Stream<Named<String>> examples() throws Exception {
    return examples("java.md");
  }

  static Stream<Named<String>> examplesOfParts() throws Exception {
    return examples("java-parts.md");
  }

  @ParameterizedTest
  @MethodSource("examples")
  void exampleRuns(String example) throws Exception {
    runs(blocks().get(0), example);
  }

  @ParameterizedTest
  @MethodSource("examplesOfParts")
  void exampleOfPartsRuns(String example) throws Exception {
    runs(blocks("java-parts.md").get(0), example);
  }

  @Test
  void everyExportedTypeIsInAnExample() throws Exception {
    Set<String> named = new HashSet<>();
    for (String page : List.of("java.md", "java-parts.md", "servers.md")) {
      String examples = String.join("", blocks(page)).replaceAll("//.*", "");
      Pattern.compile("\\w+").matcher(examples).results().forEach(w -> named.add(w.group()));
    }
    List<String> exported =
        Files.readAllLines(Path.of("src/test/resources/api.txt")).stream()
            .map(line -> line.substring(0, line.indexOf(':')))
            .filter(type -> !type.contains("$"))
            .map(type -> type.substring(type.lastIndexOf('.') + 1))
            .distinct()
            .toList();
    assertThat(exported).hasSizeGreaterThan(50).allMatch(named::contains);
  }

  static Stream<Named<String>> examplesOfServers() throws Exception {
    return examples("servers.md");
  }

  @ParameterizedTest
  @MethodSource("examplesOfServers")
  void exampleOfServersRuns(String example) throws Exception {
    runs(blocks("servers.md").get(0), example);
  }

  /** The page names the six imports of the first picture. */
  @Test
  void firstPictureNeedsSixImports() throws Exception {
    String page = Files.readString(Path.of("docs", "java.md"));
    String sentence =
        page.substring(page.indexOf("It needs six imports"), page.indexOf("## Build a"));
    List<String> imports =
        Pattern.compile("`([a-z.]+\\.\\*)`")
            .matcher(sentence)
            .results()
            .map(match -> "import " + match.group(1) + ";\n")
            .toList();
    assertThat(imports).hasSize(6);
    String first =
        blocks().stream().filter(b -> b.startsWith("Scene first =")).findFirst().orElseThrow();
    runs(String.join("", imports), first);
  }

  /** The first page of the Javadoc is that of the module; its examples run, on a small picture. */
  @Test
  void examplesOfTheJavadocRun() throws Exception {
    String module = Files.readString(Path.of("src/main/java/module-info.java"));
    List<String> examples =
        Pattern.compile("\\{@code\n(.*?) \\* \\}</pre>", Pattern.DOTALL)
            .matcher(module)
            .results()
            .map(found -> found.group(1).replaceAll("(?m)^ \\* ?", ""))
            .map(example -> example.replace("model.glb", "scenes/models/lantern.glb"))
            .map(example -> example.replace("new SceneParser()", SMALL))
            .toList();
    assertThat(examples).hasSize(2);
    String imports = imports(examples.get(0));
    String code = examples.get(0).substring(imports.length());
    runs(imports, code);
    String more = imports(examples.get(1));
    String arrays = "double[] positions = {0, 0, 0, 1, 0, 0, 0, 1, 0}; int[] indices = {0, 1, 2};";
    String rest = code.substring(code.indexOf("Image image"));
    runs(imports + more, arrays + examples.get(1).substring(more.length()) + rest);
  }

  private static String imports(String example) {
    return example.substring(0, example.indexOf("\n\n") + 1);
  }

  private void runs(String imports, String example) throws Exception {
    String code = OUTPUT.matcher(example).replaceAll("Path.of(\"" + directory + "/$1\")");
    Path source =
        Files.writeString(
            directory.resolve("Example.java"),
            imports
                + "public class Example { public static void main(String[] args)"
                + " throws Exception {\n"
                + code
                + "} }");
    StringWriter messages = new StringWriter();
    PrintWriter writer = new PrintWriter(messages);
    String path = System.getProperty("java.class.path");
    String[] options = {
      "-Xlint:all,-path", "-Werror", "-cp", path, "-d", "" + directory, "" + source
    };
    int failed = ToolProvider.findFirst("javac").orElseThrow().run(writer, writer, options);
    assertThat(failed).as(messages.toString()).isZero();
    try (URLClassLoader loader = new URLClassLoader(new URL[] {directory.toUri().toURL()})) {
      Method main = loader.loadClass("Example").getMethod("main", String[].class);
      main.invoke(null, (Object) new String[0]);
    }
    List<String> outputs =
        OUTPUT.matcher(example).results().map(output -> output.group(1)).toList();
    assertThat(outputs).allSatisfy(name -> assertThat(directory.resolve(name)).isNotEmptyFile());
  }

  @Test
  void thereAreExamplesOfEverythingThatThePagePromises() throws Exception {
    assertThat(String.join("", blocks()))
        .contains(
            "SceneParser",
            "Scene.builder",
            "SceneWriter.write",
            "toBuilder",
            "isCancelled",
            "Budget(",
            "ImageWriter.write")
        .contains("CheckpointFile", "FilmMerge", "PixelReplay", "Stage");
  }
}
