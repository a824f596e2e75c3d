package io.github.lumbre;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.testing.Folders;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Tests the script {@code ./test} in a copy of the project whose builds only note how they ran. */
@DisabledOnOs(OS.WINDOWS)
class TestScriptTest {
  /** What the script itself needs, and the programs of one part. */
  private static final List<String> TOOLS =
      List.of("sh", "sed", "grep", "cut", "tr", "cat", "dirname", "tar", "git");

  private static final List<String> BUILDS =
      List.of("mvnw -B install", "mvnw -B -f junit verify", "mvnw -B -f spark verify");

  @TempDir private Path directory;
  private Path home;
  private Path programs;

  private record Result(int exit, String out, String err, List<String> ran) {}

  @BeforeEach
  void makeProject() throws IOException {
    home = Files.createDirectories(directory.resolve("home of lumbre"));
    programs = Files.createDirectories(directory.resolve("bin"));
    for (String tool : TOOLS) {
      script(programs.resolve(tool), "#!/bin/sh\nexec %s \"$@\"\n".formatted(found(tool)));
    }
    script(home.resolve("test"), Files.readString(Path.of("test")));
    for (String name : List.of("mvnw", "release/reproducible", "release/dry-run")) {
      script(
          home.resolve(name),
          """
          #!/bin/sh
          echo "%1$s${*:+ $*}" >> ran.txt
          case " $* " in *"${FAILING:-nothing}"*) exit 7 ;; esac
          """
              .formatted(name));
    }
  }

  private static Path found(String tool) {
    return Stream.of("/bin", "/usr/bin")
        .map(folder -> Path.of(folder, tool))
        .filter(Files::exists)
        .findFirst()
        .orElseThrow(() -> new AssertionError(tool));
  }

  private static void script(Path file, String text) throws IOException {
    Files.createDirectories(file.getParent());
    Files.writeString(file, text);
    assertThat(file.toFile().setExecutable(true)).isTrue();
  }

  private Result run(Map<String, String> environment, String... arguments) throws Exception {
    List<String> command = new ArrayList<>(List.of(home.resolve("test").toString()));
    command.addAll(List.of(arguments));
    ProcessBuilder builder =
        new ProcessBuilder(command)
            .directory(directory.toFile())
            .redirectOutput(directory.resolve("out.txt").toFile())
            .redirectError(directory.resolve("err.txt").toFile());
    builder.environment().remove("LUMBRE_BROWSER");
    builder.environment().put("PATH", programs.toString());
    builder.environment().putAll(environment);
    Process process = builder.start();
    assertThat(process.waitFor(60, TimeUnit.SECONDS)).isTrue();
    Path ran = home.resolve("ran.txt");
    return new Result(
        process.exitValue(),
        Files.readString(directory.resolve("out.txt")),
        Files.readString(directory.resolve("err.txt")),
        Files.exists(ran) ? Files.readAllLines(ran) : List.of());
  }

  @Test
  void everythingIsTheThreeBuilds() throws Exception {
    Result result = run(Map.of());
    assertThat(result.ran()).isEqualTo(BUILDS);
    assertThat(result.exit()).isZero();
    assertThat(result.err()).endsWith("test: passed: main junit spark\n");
  }

  @Test
  void failedBuildEndsTheRun() throws Exception {
    Result result = run(Map.of("FAILING", "-f junit"), "--all");
    assertThat(result.ran()).isEqualTo(BUILDS.subList(0, 2));
    assertThat(result.exit()).isEqualTo(1);
    assertThat(result.err()).endsWith("test: passed: main; failed: junit\n");
  }

  @Test
  void longPartsRunAllAndWhatIsMissingIsNamed() throws Exception {
    Result result = run(Map.of("FAILING", "-Pfuzz"), "--all");
    assertThat(result.ran())
        .startsWith(BUILDS.toArray(String[]::new))
        .contains("mvnw -B verify -Pfuzz", "mvnw -B verify -Pmutants", "release/reproducible")
        .doesNotContain("mvnw -B verify -Pbrowser", "mvnw -B verify -Pmodels", "release/dry-run");
    assertThat(result.exit()).isEqualTo(1);
    assertThat(result.err())
        .contains(
            "test: browser: not run, missing here: chromium or chromium-browser or google-chrome or"
                + " google-chrome-stable\n",
            "test: models: not run, missing here: npm pip apt-get dpkg-deb unzip\n",
            "test: release: not run, missing here: gpg jar\n")
        .endsWith("; failed: fuzz; not run, programs are missing: browser models release\n");
  }

  @Test
  void missingProgramsAreNoSuccess() throws Exception {
    Result result = run(Map.of(), "--all");
    assertThat(result.exit()).isEqualTo(3);
  }

  @Test
  void onePartRunsAlone() throws Exception {
    Result result = run(Map.of("LUMBRE_BROWSER", "/opt/browser"), "browser");
    assertThat(result.ran()).containsExactly("mvnw -B verify -Pbrowser");
    assertThat(result.exit()).isZero();
  }

  @Test
  void quickTestsLeaveOutClassesThatExist() throws Exception {
    Result result = run(Map.of(), "quick");
    String list = "src/test/slow-tests.txt";
    assertThat(result.ran()).containsExactly("mvnw -B test -Dsurefire.excludesFile=" + list);
    List<String> classes =
        Folders.below(Path.of("src/test/java"), ".java").stream()
            .map(file -> "**/" + file.getFileName())
            .toList();
    assertThat(Files.readAllLines(Path.of(list)))
        .filteredOn(line -> line.endsWith(".java"))
        .hasSizeGreaterThan(50)
        .doesNotHaveDuplicates()
        .allSatisfy(slow -> assertThat(classes).containsOnlyOnce(slow));
  }

  @Test
  void wrongCommandLinesRunNothing() throws Exception {
    for (String wrong : List.of("--al", "brow", "junit|spark", "-x")) {
      Result result = run(Map.of(), wrong);
      assertThat(result.exit()).isEqualTo(2);
      assertThat(result.err()).contains(wrong, "./test --help").hasLineCount(1);
      assertThat(result.ran()).isEmpty();
    }
    assertThat(run(Map.of(), "--all", "fuzz").exit()).isEqualTo(2);
    assertThat(run(Map.of(), "--help").out()).startsWith("Usage: ./test");
  }

  /** Every long profile of a build is a part, and the pages have the same commands. */
  @Test
  void partsAreThoseOfTheBuildsAndOfThePages() throws Exception {
    String list = run(Map.of(), "--list").out();
    Pattern profile =
        Pattern.compile("<profile>(?:\\s*<!--.*?-->)?\\s*<id>(\\w+)</id>", Pattern.DOTALL);
    List<String> profiles = new ArrayList<>();
    for (String pom : List.of("pom.xml", "junit/pom.xml", "spark/pom.xml")) {
      profile
          .matcher(Files.readString(Path.of(pom)))
          .results()
          .forEach(found -> profiles.add(found.group(1)));
    }
    assertThat(profiles).contains("exhaustive", "browser", "thousand", "cluster");
    // These build or time something, and test nothing.
    profiles.removeAll(List.of("release", "site", "jmh"));
    assertThat(profiles).allSatisfy(name -> assertThat(list).contains("-P" + name + "\n"));
    String contributing = Files.readString(Path.of("CONTRIBUTING.md"));
    list.lines()
        .map(String::strip)
        .filter(line -> line.startsWith("./mvnw ") && !line.endsWith(" install"))
        .map(line -> line.replace(" -B", ""))
        .forEach(command -> assertThat(contributing).contains("`" + command + "`"));
    assertThat(Files.readString(Path.of("README.md"))).contains("\n./test ");
    assertThat(Files.readString(Path.of(".ci/run"))).endsWith("exec ./test\n");
  }
}
