package io.github.lumbre.cli;

import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.parser.SceneFormatException;
import io.github.lumbre.parser.SceneParser;
import io.github.lumbre.render.Progress;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Mode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

/**
 * The work that a small picture of a scene takes, which does not depend on the machine.
 *
 * @param scene its file's name, without the ending
 * @param mode as on the command line
 * @param samples taken over all pixels
 * @param rays followed to what they meet
 * @param shadowRays followed to see whether they meet anything
 * @param bytesPerRay allocated, by code that does as its source says: see {@link #main}
 */
record WorkCounters(
    String scene, String mode, long samples, long rays, long shadowRays, long bytesPerRay) {
  static final String HEADER = "scene,mode,samples,rays,shadow_rays,bytes_per_ray";

  private static final int WIDTH = 64;
  private static final int HEIGHT = 48;
  private static final int SAMPLES = 2;

  private static final List<String> SCENES =
      List.of(
          "camera-thin-lens",
          "cornell-box",
          "cornell-box-dome",
          "glass-and-mirror",
          "table-04-armoured-figure",
          "table-14-procedurals",
          "torus-knot");

  /**
   * Prints the counters of some scenes, a line each. Run it without the compiler that removes
   * allocations when it sees fit: then their number is that of the source, and repeats.
   *
   * @param args the folder of the scenes
   */
  public static void main(String[] args)
      throws SceneFormatException, IOException, InterruptedException {
    Path folder = Path.of(args[0]);
    for (String scene : SCENES) {
      System.out.println(of(folder, scene, Mode.PATH).line());
    }
    System.out.println(of(folder, "glass-and-mirror", Mode.RAY).line());
  }

  private static WorkCounters of(Path folder, String scene, Mode mode)
      throws SceneFormatException, IOException, InterruptedException {
    SceneFile file =
        new SceneParser()
            .inMode(mode)
            .overriding(WorkCounters::small)
            .parse(new SceneFolder(folder).file(scene));
    // The first render also allocates what is made once: linked call sites, filled caches.
    TimedRender.of(file.scene(), file.settings(), Progress.NONE);
    TimedRender render = TimedRender.of(file.scene(), file.settings(), Progress.NONE);
    RenderStatistics statistics = render.result().statistics();
    long rays = statistics.rays() + statistics.shadowRays();
    return new WorkCounters(
        scene,
        FlagConverters.lower(mode),
        statistics.samples(),
        statistics.rays(),
        statistics.shadowRays(),
        Math.round((double) render.allocatedBytes() / rays));
  }

  private static RenderSettings small(RenderSettings inScene) {
    return inScene.toBuilder().size(WIDTH, HEIGHT).samples(SAMPLES).threads(1).build();
  }

  /** Returns them as a line of a file that begins with {@link #HEADER}. */
  String line() {
    return Csv.line(List.of(scene, mode, samples, rays, shadowRays, bytesPerRay));
  }

  /** Returns the counters of such a line. */
  static WorkCounters parse(String line) {
    List<String> values = Csv.values(line);
    return new WorkCounters(
        values.get(0),
        values.get(1),
        Long.parseLong(values.get(2)),
        Long.parseLong(values.get(3)),
        Long.parseLong(values.get(4)),
        Long.parseLong(values.get(5)));
  }

  /** Tells whether both are of the same picture. */
  boolean isOfSame(WorkCounters o) {
    return scene.equals(o.scene) && mode.equals(o.mode);
  }
}
