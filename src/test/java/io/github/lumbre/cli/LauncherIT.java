package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.testing.Folders;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.module.ModuleFinder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.assertj.core.api.InstanceOfAssertFactories;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Tests the POSIX launcher in a copy of the project whose build only copies the jar. */
@DisabledOnOs(OS.WINDOWS)
class LauncherIT {
  private static final String SHORT =
      """
      check small.txt --json
      render small.txt --size 256x192 -s 2 -o small.txt --overwrite
      render --size=256 --samples=2 small.txt -o large.txt
      render --size 64x48 -s 2 small.txt --explode 1
      render small.txt --look lines
      render large.txt --look=lines --size 2000
      """;
  private static final String LONG =
      """
      check large.txt
      check apart.gltf
      render small.txt
      render --size=256x192 --samples=16 small.txt
      render --size 640x480 --samples 1 small.txt
      render --size 99999999999x1 --samples 1 small.txt
      render --size 16x08 --samples 1 small.txt
      render --size wide --samples few small.txt
      render --size 64x48 -s 2 large.txt
      render --size 64x48 -s 2 small.txt small.txt
      render --size 64x48 -s 2 small.txt --turntable 96
      render --size 64x48 -s 2 small.txt --explode 0..1
      render --size 64x48 -s 2 small.txt --explode=0..1
      render large.txt --look clay,lines
      render large.txt --look lines -s 16
      render small.txt --look lines --checkpoint a.film
      render small.txt --look lines --turntable 9
      views --size 64x48 -s 2 small.txt
      """;

  private static final String BUILDING =
      "lumbre: building, which takes about 65 s of one processor\n";

  @TempDir private Path directory;
  private Path home;

  @BeforeEach
  void makeProject() throws IOException {
    home = Files.createDirectories(directory.resolve("home of lumbre"));
    Files.createDirectories(home.resolve("src/main/java"));
    Program.copyOptions(home);
    Files.writeString(home.resolve("pom.xml"), "");
    Files.writeString(home.resolve("src/main/java/A.java"), "");
    script(home.resolve("lumbre"), Files.readString(Path.of("lumbre")));
    script(
        home.resolve("mvnw"),
        "#!/bin/sh\necho built >> builds.txt\ncp '" + Program.JAR + "' target/\n");
  }

  private static void script(Path file, String text) throws IOException {
    Files.createDirectories(file.getParent());
    Files.writeString(file, text);
    assertThat(file.toFile().setExecutable(true)).isTrue();
  }

  private int builds() throws IOException {
    Path log = home.resolve("builds.txt");
    return Files.exists(log) ? Files.readAllLines(log).size() : 0;
  }

  private static Path jdk() {
    return Path.of(System.getProperty("java.home"));
  }

  private Process start(String name, Path launcher, Map<String, String> environment)
      throws IOException {
    return start(name, environment, launcher.toString(), "--version");
  }

  private Process start(String name, Map<String, String> environment, String... command)
      throws IOException {
    Path workplace = Files.createDirectories(directory.resolve(name));
    ProcessBuilder builder =
        new ProcessBuilder(Program.interruptible(List.of(command)))
            .directory(workplace.toFile())
            .redirectOutput(workplace.resolve("out.txt").toFile())
            .redirectError(workplace.resolve("err.txt").toFile());
    builder.environment().put("JAVA_HOME", jdk().toString());
    builder.environment().putAll(environment);
    return builder.start();
  }

  private Outcome launch(Path launcher, Map<String, String> environment)
      throws IOException, InterruptedException {
    return Program.await(directory.resolve("one"), start("one", launcher, environment));
  }

  private Outcome launch() throws IOException, InterruptedException {
    return launch(home.resolve("lumbre"), Map.of());
  }

  private Outcome run(String... arguments) throws IOException, InterruptedException {
    List<String> command = new ArrayList<>(List.of(home.resolve("lumbre").toString()));
    command.addAll(List.of(arguments));
    return Program.await(
        directory.resolve("one"), start("one", Map.of(), command.toArray(String[]::new)));
  }

  @Test
  void aFolderThatCannotBeWrittenIsNamed() throws IOException, InterruptedException {
    // Not even the superuser can create a folder in place of a file.
    Files.writeString(home.resolve("target"), "");
    Outcome outcome = launch();
    assertThat(outcome.err())
        .isEqualTo(
            "lumbre: must be built first, but %1$s/target cannot be written; make it writable,"
                    .formatted(home.toRealPath())
                + " or use a copy of %s\n".formatted(home.toRealPath()));
    assertThat(outcome.exitCode()).isEqualTo(ExitCodes.OUTPUT);
    assertThat(builds()).isZero();
  }

  @Test
  void programIsBuiltOnceAndAgainWhenItsSourcesChange() throws IOException, InterruptedException {
    Outcome first = launch();
    assertThat(first.err()).isEqualTo(BUILDING);
    assertThat(first.out()).startsWith("Lumbre ");
    assertThat(launch().err()).isEmpty();
    assertThat(builds()).isEqualTo(1);
    Path source = home.resolve("src/main/java/A.java");
    Files.setLastModifiedTime(source, FileTime.from(Instant.now().plusSeconds(1)));
    assertThat(launch().exitCode()).isZero();
    assertThat(builds()).isEqualTo(2);
  }

  /** A line at least every ten seconds, none after the end, and nothing that holds the output. */
  @Test
  void aLongBuildIsReported() throws IOException, InterruptedException {
    script(home.resolve("mvnw"), "#!/bin/sh\nsleep 17\n" + Files.readString(home.resolve("mvnw")));
    Outcome first = launch();
    assertThat(first.err())
        .startsWith(BUILDING + "lumbre: still building, 8 s\nlumbre: still building, 16 s\n");
    Thread.sleep(9000);
    assertThat(directory.resolve("one").resolve("err.txt")).hasContent(first.err());
  }

  /** A program that is starting from the jar would lose its classes. */
  @Test
  void theOldJarStaysUntilTheBuildReplacesIt() throws IOException, InterruptedException {
    launch();
    script(
        home.resolve("mvnw"),
        "#!/bin/sh\ncmp '" + Program.JAR + "' target/lumbre-all.jar && echo kept >> kept.txt\n");
    Path source = home.resolve("src/main/java/A.java");
    Files.setLastModifiedTime(source, FileTime.from(Instant.now().plusSeconds(1)));
    assertThat(launch().exitCode()).isZero();
    assertThat(home.resolve("kept.txt")).hasContent("kept");
  }

  @Test
  void launchesAtTheSameTimeShareABuild() throws IOException, InterruptedException {
    // Longer than the launcher waits for a builder that has not written its process ID.
    script(home.resolve("mvnw"), "#!/bin/sh\nsleep 8\n" + Files.readString(home.resolve("mvnw")));
    List<Process> processes = new ArrayList<>();
    for (int i = 0; i < 4; i++) {
      processes.add(start("at once " + i, home.resolve("lumbre"), Map.of()));
    }
    for (int i = 0; i < 4; i++) {
      Outcome outcome = Program.await(directory.resolve("at once " + i), processes.get(i)).done();
      assertThat(outcome.out()).startsWith("Lumbre ");
    }
    assertThat(builds()).isEqualTo(1);
  }

  @Test
  void buildThatWasKilledDoesNotBlockTheNext() throws IOException, InterruptedException {
    Path lock = Files.createDirectories(home.resolve("target/.lumbre-build"));
    Files.writeString(lock.resolve("pid"), "99999999\n");
    assertThat(launch().exitCode()).isZero();
    assertThat(lock).doesNotExist();
    Files.delete(home.resolve("target/lumbre-all.jar"));
    Files.createDirectories(lock);
    assertThat(launch().exitCode()).isZero();
    assertThat(lock).doesNotExist();
  }

  /** Without a folder for the lock, the launcher cannot build and must not wait forever. */
  @Test
  void launcherEndsIfTheBuildFolderIsDeletedWhileItWaits()
      throws IOException, InterruptedException {
    Path lock = Files.createDirectories(home.resolve("target/.lumbre-build"));
    Files.writeString(lock.resolve("pid"), ProcessHandle.current().pid() + "\n");
    Process waiting = start("one", home.resolve("lumbre"), Map.of());
    Path errors = directory.resolve("one").resolve("err.txt");
    while (!Files.readString(errors).contains("waiting")) {
      assertThat(waiting.isAlive()).isTrue();
      Thread.sleep(10);
    }
    Files.move(home.resolve("target"), home.resolve("gone"));
    Outcome outcome = Program.await(directory.resolve("one"), waiting);
    assertThat(outcome.exitCode()).isEqualTo(ExitCodes.INTERNAL);
    assertThat(outcome.err()).contains("target was deleted; run the command again");
  }

  @Test
  void failedBuildIsToldAndTriedAgain() throws IOException, InterruptedException {
    script(home.resolve("mvnw"), "#!/bin/sh\necho broken\nexit 1\n");
    for (int i = 0; i < 2; i++) {
      Outcome outcome = launch();
      assertThat(outcome.exitCode()).isEqualTo(ExitCodes.INTERNAL);
      assertThat(outcome.out()).isEmpty();
      assertThat(outcome.err()).contains("broken", "lumbre: the build failed");
    }
  }

  @Test
  void symbolicLinksLeadHome() throws IOException, InterruptedException {
    Path link = Files.createSymbolicLink(directory.resolve("link"), home.resolve("lumbre"));
    Path linkToLink = Files.createSymbolicLink(directory.resolve("link2"), Path.of("link"));
    assertThat(launch(link, Map.of()).out()).startsWith("Lumbre ");
    assertThat(launch(linkToLink, Map.of()).out()).startsWith("Lumbre ");
  }

  @Test
  void missingAndOldJavaAreNamed() throws IOException, InterruptedException {
    Path none = directory.resolve("none");
    assertThat(launch(home.resolve("lumbre"), Map.of("JAVA_HOME", "" + none)).err())
        .contains("JAVA_HOME is " + none, "JDK 17 or newer")
        .hasLineCount(1);
    Path old = directory.resolve("old");
    script(old.resolve("bin/java"), "#!/bin/sh\necho 'java version \"1.8.0_402\"' >&2\n");
    assertThat(launch(home.resolve("lumbre"), Map.of("JAVA_HOME", "" + old)).err())
        .contains("found Java 1.8.0_402", "JDK 17 or newer")
        .hasLineCount(1);
    Path tools = toolsWithoutJava();
    assertThat(
            launch(home.resolve("lumbre"), Map.of("JAVA_HOME", "", "PATH", tools.toString())).err())
        .contains("found no Java")
        .hasLineCount(1);
  }

  /** Returns a directory with the tools that the launcher needs before it searches for Java. */
  private Path toolsWithoutJava() throws IOException {
    Path tools = Files.createDirectories(directory.resolve("tools"));
    for (String tool : List.of("dirname", "readlink", "sed")) {
      Path found =
          Stream.of("/usr/bin", "/bin")
              .map(folder -> Path.of(folder, tool))
              .filter(Files::exists)
              .findFirst()
              .orElseThrow();
      script(tools.resolve(tool), "#!/bin/sh\nexec " + found + " \"$@\"\n");
    }
    return tools;
  }

  @Test
  void javaWithoutCompilerRunsButDoesNotBuild() throws IOException, InterruptedException {
    Path jre = directory.resolve("jre");
    script(jre.resolve("bin/java"), "#!/bin/sh\nexec '" + Program.java("java") + "' \"$@\"\n");
    Map<String, String> environment = Map.of("JAVA_HOME", jre.toString());
    assertThat(launch(home.resolve("lumbre"), environment).err())
        .contains("no compiler", "JDK 17 or newer")
        .hasLineCount(1);
    assertThat(launch().exitCode()).isZero();
    assertThat(launch(home.resolve("lumbre"), environment).out()).startsWith("Lumbre ");
  }

  @Test
  void vectorsAreSwitchedOnWithoutAWarning() throws IOException, InterruptedException {
    assumeTrue(ModuleFinder.ofSystem().find("jdk.incubator.vector").isPresent());
    launch();
    Outcome outcome = launch();
    // That option would be the reason for missing vectors.
    assertThat(outcome.out()).contains("Kernel: ").doesNotContain("--add-modules");
    assertThat(outcome.err()).isEmpty();
  }

  @Test
  void versionIsTheSameWithAndWithoutTheModuleOfVectors() throws IOException, InterruptedException {
    for (String option : List.of("-Dkey=value", "-XX:UseAVX=1")) {
      assumeTrue(option.startsWith("-D") || System.getProperty("os.arch").equals("amd64"));
      Outcome quick = launch(home.resolve("lumbre"), Map.of("JDK_JAVA_OPTIONS", option));
      Outcome full = launch(home.resolve("lumbre"), Map.of("LUMBRE_JAVA_OPTS", option));
      assertThat(quick.out()).as(option).isEqualTo(full.out()).contains("Kernel: ");
    }
  }

  @Test
  void errorsStandInOrderInAFileThatOthersWriteToAsWell() throws IOException, InterruptedException {
    Path log = directory.resolve("log.txt");
    String commands =
        "{ echo before; '%s' help nothing; echo after; } >'%s' 2>&1"
            .formatted(home.resolve("lumbre"), log);
    ProcessBuilder builder = new ProcessBuilder("sh", "-c", commands);
    builder.environment().put("JAVA_HOME", jdk().toString());
    launch();
    assertThat(builder.start().waitFor()).isZero();
    assertThat(Files.readAllLines(log))
        .hasSize(3)
        .startsWith("before")
        .endsWith("after")
        .element(1, InstanceOfAssertFactories.STRING)
        .contains("nothing");
  }

  @Test
  void whatTheVirtualMachineSaysIsPassedOn() throws IOException, InterruptedException {
    Map<String, String> options = Map.of("LUMBRE_JAVA_OPTS", "-Xmxmuch");
    Outcome outcome = launch(home.resolve("lumbre"), options);
    assertThat(outcome.exitCode()).isEqualTo(ExitCodes.USAGE);
    assertThat(outcome.err())
        .contains("Invalid maximum heap size: -Xmxmuch")
        .contains("lumbre: LUMBRE_JAVA_OPTS: Java does not start with '-Xmxmuch'");
  }

  @Test
  void optionsThatJavaRefusesAreAWrongCommandLine() throws IOException, InterruptedException {
    for (String options : List.of("-Xfoo", "-XX:+UseSerialGC", "-Xmx200m -XX:NoSuchFlag=1")) {
      Outcome outcome = launch(home.resolve("lumbre"), Map.of("LUMBRE_JAVA_OPTS", options));
      assertThat(outcome.exitCode()).as(options).isEqualTo(ExitCodes.USAGE);
      assertThat(outcome.out()).isEmpty();
      assertThat(outcome.err()).contains("LUMBRE_JAVA_OPTS: Java does not start with '" + options);
    }
  }

  @Test
  void optionsThatMakeJavaDoSomethingElseAreAWrongCommandLine()
      throws IOException, InterruptedException {
    launch();
    for (String options : List.of("-version", "--help", "-Xmx200m --dry-run", "--list-modules")) {
      Outcome outcome = launch(home.resolve("lumbre"), Map.of("LUMBRE_JAVA_OPTS", options));
      assertThat(outcome.exitCode()).as(options).isEqualTo(ExitCodes.USAGE);
      assertThat(outcome.out()).isEmpty();
      assertThat(outcome.err())
          .isEqualTo("lumbre: LUMBRE_JAVA_OPTS: Java does not run Lumbre with '" + options + "'\n");
    }
  }

  @Test
  void optionsForTheVirtualMachineArePassedOn() throws IOException, InterruptedException {
    Map<String, String> options = Map.of("LUMBRE_JAVA_OPTS", "-Xmx200m -Dos.name=Elsewhere");
    assertThat(launch(home.resolve("lumbre"), options).out()).contains("OS: Elsewhere");
  }

  private Path archive() throws IOException {
    try (Stream<Path> files = Files.list(home.resolve("target"))) {
      return files.filter(file -> file.toString().endsWith(".jsa")).findFirst().orElseThrow();
    }
  }

  /** Moves the project to where JDK 17 archives classes: a path without spaces. */
  private void moveToPlainPath() throws IOException {
    home = Files.move(home, directory.resolve("home"));
    copy("src/main/jvm/rehearsal.gltf");
  }

  private void copyScenes() throws IOException {
    Files.createDirectories(home.resolve("scenes/models"));
    copy("scenes/cornell-box.json");
    copy("scenes/models/lantern.glb");
  }

  private void copy(String file) throws IOException {
    Files.copy(Path.of(file), home.resolve(file));
  }

  @Test
  void classesAreReadFromAnArchiveOfThisJavaAndThisJar() throws IOException, InterruptedException {
    moveToPlainPath();
    copyScenes();
    launch();
    assertThat(Files.size(archive())).isGreaterThan(1_000_000);
    Map<String, String> options = Map.of("LUMBRE_JAVA_OPTS", "-Xlog:class+load");
    assertThat(launch(home.resolve("lumbre"), options).out())
        .contains("io.github.lumbre.cli.Main source: shared objects file");

    assertThat(archive().toFile().setWritable(true)).isTrue();
    Files.writeString(archive(), "damaged");
    Outcome damaged = launch();
    assertThat(damaged.out()).startsWith("Lumbre ");
    assertThat(damaged.err()).isEmpty();
    assertThat(archive()).hasContent("damaged");
  }

  /** The build makes no archive here, as if another Java had built the jar. */
  @Test
  void theArchiveOfAnotherJavaIsMadeAfterTheFirstRenderAlone()
      throws IOException, InterruptedException {
    moveToPlainPath();
    launch();
    Files.delete(archive());
    copyScenes();
    String scene = home.resolve("scenes/cornell-box.json").toString();
    assertThat(run("check", scene).exitCode()).isZero();
    assertThat(run("help", "check").exitCode()).isZero();
    assertThat(Folders.names(home.resolve("target"))).containsExactly("lumbre-all.jar");
    assertThat(run("render", scene, "-s", "1", "--size", "32").exitCode()).isZero();
    while (Folders.names(home.resolve("target")).size() != 2 || Files.size(archive()) == 0) {
      Thread.sleep(50);
    }
    assertThat(Files.size(archive())).isGreaterThan(1_000_000);
    assertThat(run("check", scene).err()).isEmpty();
  }

  @Test
  void anArchiveThatIsInterruptedLeavesTheBuiltProgram() throws IOException, InterruptedException {
    moveToPlainPath();
    copyScenes();
    Process first = start("one", home.resolve("lumbre"), Map.of());
    Path target = home.resolve("target");
    while (!Files.exists(target) || Folders.names(target).stream().noneMatch(this::isArchive)) {
      assertThat(first.isAlive()).isTrue();
      Thread.sleep(5);
    }
    // First the launcher, which would go on without an archive.
    List<ProcessHandle> below = first.descendants().toList();
    first.destroy();
    below.forEach(ProcessHandle::destroy);
    assertThat(first.waitFor()).isEqualTo(143);
    assertThat(Folders.names(target)).containsExactly("lumbre-all.jar");
    assertThat(launch().err()).isEmpty();
    assertThat(builds()).isEqualTo(1);
  }

  private boolean isArchive(String name) {
    return name.endsWith(".jsa");
  }

  /** What is longer would be slower with the fast compiler alone. */
  @Test
  void shortCommandsUseTheFastCompilerAlone() throws IOException, InterruptedException {
    Path workplace = Files.createDirectory(directory.resolve("one"));
    Files.writeString(workplace.resolve("small.txt"), "no scene");
    Files.write(workplace.resolve("large.txt"), new byte[8_000_001]);
    Files.writeString(workplace.resolve("apart.gltf"), "{}");
    Files.write(workplace.resolve("apart.bin"), new byte[8_000_001]);
    launch();
    script(home.resolve("java/bin/java"), "#!/bin/sh\necho \"$@\"\n");
    Files.writeString(home.resolve("java/release"), "JAVA_VERSION=\"17.0.1\"\n");
    assertThat(SHORT.lines()).map(this::options).first().isEqualTo("check-options");
    assertThat(SHORT.lines().skip(1)).map(this::options).containsOnly("short-options");
    assertThat(LONG.lines()).map(this::options).containsOnly("");
  }

  /** Whoever captures the output of the first render reads it to its end. */
  @Test
  void nobodyWaitsForTheArchive() throws IOException, InterruptedException {
    launch();
    Path go = home.resolve("go");
    String wait = "while [ ! -e '" + go + "' ]; do sleep .1; done";
    script(
        home.resolve("java/bin/java"),
        "#!/bin/sh\ncase $* in *DumpLoadedClassList*) " + wait + " ;; *) echo done ;; esac\n");
    Files.writeString(home.resolve("java/release"), "JAVA_VERSION=\"17.0.1\"\n");
    ProcessBuilder builder = new ProcessBuilder(home.resolve("lumbre").toString(), "render", "a");
    builder.environment().put("JAVA_HOME", home.resolve("java").toString());
    Process process = builder.start();
    try {
      assertThat(CompletableFuture.supplyAsync(() -> text(process)))
          .succeedsWithin(20, TimeUnit.SECONDS)
          .isEqualTo("done\n");
    } finally {
      Files.createFile(go);
    }
  }

  private static String text(Process process) {
    try {
      return new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Returns the name of the further options that Java gets for some arguments. */
  private String options(String arguments) {
    List<String> command = new ArrayList<>(List.of(home.resolve("lumbre").toString()));
    command.addAll(List.of(arguments.split(" ")));
    Map<String, String> echo = Map.of("JAVA_HOME", home.resolve("java").toString());
    try {
      Process process = start("one", echo, command.toArray(String[]::new));
      Outcome outcome = Program.await(directory.resolve("one"), process);
      assertThat(outcome.err()).isEmpty();
      assertThat(outcome.out()).endsWith(".jar " + arguments + "\n");
      return Stream.of("check-options", "short-options")
          .filter(outcome.out()::contains)
          .collect(Collectors.joining(" "));
    } catch (IOException | InterruptedException e) {
      throw new AssertionError(arguments, e);
    }
  }

  @Test
  void startsWithoutAnArchiveIfItCannotBeMade() throws IOException, InterruptedException {
    assertThat(launch().out()).startsWith("Lumbre ");
    assertThat(archive()).isEmptyFile();
    assertThat(launch().err()).isEmpty();
    assertThat(Folders.names(home.resolve("target")))
        .containsExactlyInAnyOrder("lumbre-all.jar", archive().getFileName().toString());
  }
}
