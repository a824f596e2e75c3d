package io.github.lumbre.fuzz;

import java.io.File;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.regex.Pattern;

/**
 * Lets Jazzer, which is led by the branches that inputs take, look for inputs that break what reads
 * files: for some time each, in processes of their own. Ends with 1 if one was found; it lies in
 * the folder of findings then.
 */
public final class Jazzers {
  private static final String DRIVER = "com.code_intelligence.jazzer.Jazzer";
  private static final int SEEDS = 200;
  private static final int MAX_LENGTH = 16_384;
  private static final int PATIENCE_SECONDS = 30;

  /** A film of two pixels, the second of which has no samples. */
  private static final String FILM =
      """
      LUMBRE-FILM 1
      scene-hash: ab12
      mode: path
      depth: 8
      seed: 0
      size: 2x1
      transparent: false
      sampler: owen-sobol 1
      revision: 1
      window: 0,0,2,1
      part: 0,0,2,1 first 0 fewest 0 most 1
      pixel: samples sums first-mean
      rejected: 1
      first-rejected: 0,0,0
      saturated: 2
      note software: Lumbre
      note scene: /a\\\\b\\nc.json

      \1\1\0\0\0\0\0\0\0\0\2\0\0\0\0\0\0\0\0\3\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\
      """;

  private final Path work;
  private final int seconds;
  private final PrintStream out;

  private Jazzers(Path work, int seconds, PrintStream out) {
    this.work = work;
    this.seconds = seconds;
    this.out = out;
  }

  /**
   * Runs the targets.
   *
   * @param arguments a folder to work in, seconds for each target, and a regular expression that
   *     the names of those to be run contain
   */
  public static void main(String[] arguments) throws IOException, InterruptedException {
    Path work = Files.createDirectories(Path.of(arguments[0]));
    Jazzers all = new Jazzers(work, Integer.parseInt(arguments[1]), System.out);
    Pattern include = Pattern.compile(arguments[2]);
    List<String> broken = new ArrayList<>();
    for (Class<?> target :
        List.of(SceneTarget.class, MeshTarget.class, PictureTarget.class, FilmTarget.class)) {
      if (include.matcher(target.getSimpleName()).find() && all.run(target) != 0) {
        broken.add(target.getSimpleName());
      }
    }
    System.out.println(broken.isEmpty() ? "Nothing was found." : "Found something in: " + broken);
    System.exit(broken.isEmpty() ? 0 : 1);
  }

  private int run(Class<?> target) throws IOException, InterruptedException {
    Path corpus = Files.createDirectories(work.resolve(target.getSimpleName()));
    Path findings = Files.createDirectories(work.resolve("findings"));
    writeSeeds(target, corpus);
    List<String> command =
        List.of(
            Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-Xmx1g",
            "-Djava.awt.headless=true",
            "--add-modules",
            "jdk.incubator.vector",
            "-cp",
            System.getProperty("java.class.path"),
            DRIVER,
            "--target_class=" + target.getName(),
            "--instrumentation_includes=io.github.lumbre.**",
            "--reproducer_path=" + findings,
            "-artifact_prefix=" + findings + File.separator,
            "-max_total_time=" + seconds,
            "-timeout=" + PATIENCE_SECONDS,
            "-max_len=" + MAX_LENGTH,
            "-print_final_stats=1",
            corpus.toString());
    out.println(target.getSimpleName() + ": " + seconds + " s");
    return new ProcessBuilder(command).inheritIO().start().waitFor();
  }

  /** Writes inputs to begin with, which are nearly sound. */
  private static void writeSeeds(Class<?> target, Path corpus) throws IOException {
    Path folder = Files.createTempDirectory("lumbre-seeds-");
    HostileScenes scenes = new HostileScenes(folder);
    HostilePictures pictures = new HostilePictures(folder);
    for (int seed = 0; seed < SEEDS; seed++) {
      byte[] input;
      if (target == SceneTarget.class) {
        input = scenes.text(seed);
      } else if (target == MeshTarget.class) {
        input = new MeshMutator(new Random(seed)).changed(new byte[0]);
      } else if (target == PictureTarget.class) {
        input = pictures.file(seed);
      } else {
        input = FILM.getBytes(StandardCharsets.ISO_8859_1);
      }
      Files.write(corpus.resolve("seed-" + seed), input);
    }
  }
}
