package io.github.lumbre.cli;

import io.github.lumbre.lab.Csv;
import io.github.lumbre.lab.SceneFolder;
import io.github.lumbre.render.PictureRenderer;
import io.github.lumbre.render.Progress;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Mode;
import io.github.lumbre.scene.SettingType;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * The work for a small picture of a scene, which does not depend on the machine.
 *
 * @param scene the name of its file, without the extension
 * @param mode as on the command line
 * @param samples the number of samples over all pixels
 * @param rays the number of rays traced to their nearest hit
 * @param shadowRays the number of rays tested for occlusion
 */
record WorkCounters(String scene, String mode, long samples, long rays, long shadowRays) {
  static final String HEADER = "scene,mode,samples,rays,shadow_rays";

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

  /** Returns the counters of some of the scenes in a folder. */
  static List<WorkCounters> ofScenes(Path folder)
      throws SceneFormatException, IOException, InterruptedException {
    List<WorkCounters> counters = new ArrayList<>();
    for (String scene : SCENES) {
      counters.add(of(folder, scene, Mode.PATH));
    }
    counters.add(of(folder, "glass-and-mirror", Mode.RAY));
    return counters;
  }

  private static WorkCounters of(Path folder, String scene, Mode mode)
      throws SceneFormatException, IOException, InterruptedException {
    SceneFile file =
        new SceneParser()
            .inMode(mode)
            .overriding(WorkCounters::small)
            .parse(new SceneFolder(folder).file(scene));
    RenderStatistics statistics =
        new PictureRenderer(file.settings()).render(file.scene(), Progress.NONE).statistics();
    return new WorkCounters(
        scene,
        SettingType.nameOf(mode),
        statistics.samples(),
        statistics.rays(),
        statistics.shadowRays());
  }

  private static RenderSettings small(RenderSettings inScene) {
    return inScene.toBuilder().size(WIDTH, HEIGHT).samples(SAMPLES).threads(1).build();
  }

  /** Returns the counters as a line of a file that begins with {@link #HEADER}. */
  String line() {
    return Csv.line(List.of(scene, mode, samples, rays, shadowRays));
  }

  /** Returns the counters of a line from {@link #line}. */
  static WorkCounters parse(String line) {
    List<String> values = Csv.values(line);
    return new WorkCounters(
        values.get(0),
        values.get(1),
        Long.parseLong(values.get(2)),
        Long.parseLong(values.get(3)),
        Long.parseLong(values.get(4)));
  }

  /** Returns whether both are counters of the same picture. */
  boolean isOfSame(WorkCounters o) {
    return scene.equals(o.scene) && mode.equals(o.mode);
  }
}
