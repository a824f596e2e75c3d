package io.github.lumbre.spark;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Pictures from a standalone cluster of a master, two workers and a driver, each a process of its
 * own, on one machine. Executors, workers and drivers are killed at random moments.
 */
class ClusterTest {
  private static final Path HOME = Path.of(System.getProperty("lumbre.spark.home"));
  private static final Path JAR = Path.of(System.getProperty("lumbre.spark.jar"));
  private static final String SCENE = Path.of("..", "scenes", "cornell-box.json").toString();
  private static final int PORT = 7177;
  private static final String MASTER = "spark://127.0.0.1:" + PORT;

  /** Renders in which executors are killed. */
  private static final int RUNS = 20;

  private final List<Process> started = new ArrayList<>();
  private final Random random = new Random(2026);

  @TempDir private Path directory;

  @AfterEach
  void stopAll() throws InterruptedException {
    for (Process process : started) {
      process.descendants().forEach(ProcessHandle::destroyForcibly);
      process.destroyForcibly().waitFor();
    }
  }

  private Process java(String name, List<String> options, String... args) throws IOException {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.add("-Xmx512m");
    for (String opened :
        List.of(
            "java.lang",
            "java.lang.invoke",
            "java.lang.reflect",
            "java.io",
            "java.net",
            "java.nio",
            "java.util",
            "java.util.concurrent",
            "java.util.concurrent.atomic",
            "jdk.internal.ref",
            "sun.nio.ch",
            "sun.nio.cs",
            "sun.security.action",
            "sun.util.calendar")) {
      command.add("--add-opens=java.base/" + opened + "=ALL-UNNAMED");
    }
    command.addAll(options);
    command.addAll(List.of("-cp", JAR + ":" + HOME.resolve("jars") + "/*"));
    command.addAll(List.of(args));
    ProcessBuilder builder = new ProcessBuilder(command);
    builder.environment().put("SPARK_HOME", HOME.toString());
    builder.environment().put("SPARK_LOCAL_IP", "127.0.0.1");
    builder.environment().put("SPARK_SCALA_VERSION", "2.13");
    builder.redirectErrorStream(true).redirectOutput(directory.resolve(name + ".txt").toFile());
    Process process = builder.start();
    started.add(process);
    return process;
  }

  private Process worker(int number) throws IOException {
    return java(
        "worker-" + number,
        List.of(),
        "org.apache.spark.deploy.worker.Worker",
        "--host",
        "127.0.0.1",
        "--cores",
        "1",
        "--memory",
        "1g",
        "--webui-port",
        "0",
        "--work-dir",
        directory.resolve("work-" + number).toString(),
        MASTER);
  }

  private void startCluster() throws IOException, InterruptedException {
    java(
        "master",
        List.of(),
        "org.apache.spark.deploy.master.Master",
        "--host",
        "127.0.0.1",
        "--port",
        "" + PORT,
        "--webui-port",
        "0");
    Thread.sleep(3000);
    worker(1);
    worker(2);
  }

  private Process driver(String name, String... args) throws IOException {
    List<String> options =
        List.of(
            "-Dspark.master=" + MASTER,
            "-Dspark.jars=" + JAR,
            "-Dspark.executor.memory=700m",
            "-Dspark.executor.cores=1",
            "-Dspark.ui.enabled=false",
            "-Dspark.driver.host=127.0.0.1",
            // Killed executors are no faults of their tasks; let any number be lost.
            "-Dspark.deploy.maxExecutorRetries=-1",
            "-Dspark.task.maxFailures=100");
    List<String> command = new ArrayList<>(List.of("io.github.lumbre.spark.RenderOnSpark"));
    command.addAll(List.of(args));
    return java(name, options, command.toArray(String[]::new));
  }

  private static List<ProcessHandle> executors() {
    return ProcessHandle.allProcesses()
        .filter(
            process ->
                Stream.of(process.info().arguments().orElse(new String[0]))
                    .anyMatch(arg -> arg.endsWith("CoarseGrainedExecutorBackend")))
        .toList();
  }

  private byte[] bytes(String name) throws IOException {
    return Files.readAllBytes(directory.resolve(name));
  }

  private String[] args(String samples, String picture) {
    return new String[] {
      SCENE, "-s", samples, "--size", "240x240", "--unit", "1s", "-o", path(picture)
    };
  }

  private String path(String name) {
    return directory.resolve(name).toString();
  }

  private void assertDone(Process driver, String name) throws InterruptedException, IOException {
    assertThat(driver.waitFor(5, TimeUnit.MINUTES)).as(log(name)).isTrue();
    assertThat(driver.exitValue()).as(log(name)).isZero();
  }

  private String log(String name) throws IOException {
    return Files.readString(directory.resolve(name + ".txt"));
  }

  private void renderHere(String samples, String picture) {
    renderHere(SCENE, "-s", samples, "--size", "240x240", "-o", path(picture));
  }

  private static void renderHere(String... args) {
    String[] command = Stream.concat(Stream.of("render"), Stream.of(args)).toArray(String[]::new);
    int code =
        io.github.lumbre.cli.Lumbre.run(
            command,
            new java.io.PrintWriter(System.out, true),
            new java.io.PrintWriter(System.out, true),
            io.github.lumbre.cli.run.Engine.LOCAL);
    assertThat(code).isZero();
  }

  @Test
  void twoWorkersMakeThePictureOfOneMachine() throws IOException, InterruptedException {
    startCluster();
    renderHere("24", "here.pfm");
    assertDone(driver("driver", args("24", "spark.pfm")), "driver");
    assertThat(bytes("spark.pfm")).isEqualTo(bytes("here.pfm"));
  }

  @Test
  @Tag("cluster")
  void killedExecutorsChangeNothing() throws IOException, InterruptedException {
    startCluster();
    renderHere("48", "here.pfm");
    int kills = 0;
    for (int run = 0; run < RUNS; run++) {
      String name = "driver-" + run;
      Process driver = driver(name, args("48", "spark.pfm"));
      int before = kills;
      while (!driver.waitFor(500 + random.nextInt(3000), TimeUnit.MILLISECONDS)) {
        List<ProcessHandle> alive = executors();
        if (kills < before + 2 && !alive.isEmpty()) {
          alive.get(random.nextInt(alive.size())).destroyForcibly();
          kills++;
        }
      }
      assertDone(driver, name);
      assertThat(kills).as("killed in run " + run).isGreaterThan(before);
      assertThat(bytes("spark.pfm")).isEqualTo(bytes("here.pfm"));
      Files.delete(directory.resolve("spark.pfm"));
    }
    System.out.println(kills + " executors killed in " + RUNS + " renders");
  }

  /** An executor is killed while the third of six frames renders; each frame is a scene. */
  @ParameterizedTest
  @ValueSource(strings = {"--turntable 6", "--animation lift --fps 6"})
  @Tag("cluster")
  void aKilledExecutorChangesNoFrame(String motion) throws IOException, InterruptedException {
    startCluster();
    GlbSample.write(directory.resolve("sheet.glb"));
    List<String> args = new ArrayList<>(List.of(path("sheet.glb"), "-s", "150"));
    args.addAll(List.of("--size", "60x50"));
    args.addAll(List.of(motion.split(" ")));
    args.add("-o");
    List<String> here = new ArrayList<>(args);
    here.add(path("here.pfm"));
    renderHere(here.toArray(String[]::new));
    args.addAll(List.of(path("spark.pfm"), "--unit", "1s"));
    Process driver = driver("driver", args.toArray(String[]::new));
    int killed = 0;
    while (!driver.waitFor(20, TimeUnit.MILLISECONDS)) {
      if (killed == 0 && Files.exists(directory.resolve("spark-001.pfm"))) {
        List<ProcessHandle> alive = executors();
        assertThat(alive).isNotEmpty();
        assertThat(directory.resolve("spark-005.pfm")).doesNotExist();
        alive.get(random.nextInt(alive.size())).destroyForcibly();
        killed++;
      }
    }
    assertDone(driver, "driver");
    assertThat(killed).isEqualTo(1);
    for (int frame = 0; frame < 6; frame++) {
      String end = "-%03d.pfm".formatted(frame);
      assertThat(bytes("spark" + end)).as(end).isEqualTo(bytes("here" + end));
    }
  }

  /** The program and the model are gone when the executors begin. */
  @Test
  @Tag("cluster")
  @DisabledOnOs(OS.WINDOWS)
  void executorsNeedNoProgramThatConverts() throws IOException, InterruptedException {
    startCluster();
    GlbSample.write(directory.resolve("sheet.glb"));
    Files.writeString(directory.resolve("a.fbx"), "a model");
    Path tool = directory.resolve("tool");
    String script = "#!/bin/sh\ncp '%s' \"$2\"\nrm \"$0\" \"$1\"\n";
    Files.writeString(tool, script.formatted(path("sheet.glb")));
    Files.setPosixFilePermissions(tool, PosixFilePermissions.fromString("rwxr-xr-x"));
    String[] size = {"-s", "24", "--size", "60x50"};
    List<String> args = new ArrayList<>(List.of(path("a.fbx"), "-o", path("spark.pfm")));
    args.addAll(List.of("--import-with", tool + " {in} {out}", "--unit", "1s"));
    args.addAll(List.of(size));
    assertDone(driver("driver", args.toArray(String[]::new)), "driver");
    assertThat(directory.resolve("a.fbx")).doesNotExist();
    List<String> here = new ArrayList<>(List.of(path("sheet.glb"), "-o", path("here.pfm")));
    here.addAll(List.of(size));
    renderHere(here.toArray(String[]::new));
    assertThat(bytes("spark.pfm")).isEqualTo(bytes("here.pfm"));
  }

  @Test
  @Tag("cluster")
  void aLostWorkerChangesNothing() throws IOException, InterruptedException {
    startCluster();
    renderHere("64", "here.pfm");
    Process driver = driver("driver", args("64", "spark.pfm"));
    Thread.sleep(9000);
    started.get(1).descendants().forEach(ProcessHandle::destroyForcibly);
    started.get(1).destroyForcibly();
    assertDone(driver, "driver");
    assertThat(bytes("spark.pfm")).isEqualTo(bytes("here.pfm"));
  }

  @Test
  @Tag("cluster")
  void aLostDriverLosesOnlyWhatItsCheckpointLacks() throws IOException, InterruptedException {
    startCluster();
    renderHere("96", "here.pfm");
    List<String> first = new ArrayList<>(List.of(args("96", "spark.pfm")));
    first.addAll(List.of("--checkpoint", path("a.film"), "--checkpoint-interval", "1s"));
    Process driver = driver("driver", first.toArray(String[]::new));
    for (int i = 0; i < 600 && !Files.exists(directory.resolve("a.film")); i++) {
      Thread.sleep(100);
    }
    Thread.sleep(2000);
    driver.destroyForcibly().waitFor();
    Process second = driver("second", "resume", path("a.film"), "--unit", "1s");
    assertDone(second, "second");
    assertThat(bytes("spark.pfm")).isEqualTo(bytes("here.pfm"));
  }
}
