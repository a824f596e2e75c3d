package io.github.lumbre.render;

import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.image.Image;
import io.github.lumbre.math.internal.FusedMultiplyAdd;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneParser;
import java.nio.file.Path;
import java.util.Arrays;

/**
 * A long render in a JVM of its own, without the vector module: it prints the reason why the kernel
 * does not change, whether it might still try, and a hash of its picture.
 */
final class WithoutVectors {
  private WithoutVectors() {}

  public static void main(String[] args) throws Exception {
    SceneFile file = new SceneParser().parse(Path.of("scenes/torus-knot.json"));
    Scene scene = file.scene();
    RenderSettings settings = settings(file);
    FilmRenderer renderer = new FilmRenderer(settings, scene);
    Film film = renderer.newFilm();
    for (int samples = 2; samples <= settings.samples(); samples += 2) {
      renderer.addSamples(film, samples, Progress.NONE);
      KernelUpgrade.passed(scene, 8.1, 8.1, () -> 100);
      for (Thread thread : Thread.getAllStackTraces().keySet()) {
        if (thread.getName().equals("lumbre-kernel")) {
          thread.join();
        }
      }
    }
    System.out.println(Kernel.vectorObstacle().orElse("none"));
    System.out.println(Kernel.moduleObstacle().isPresent() == FusedMultiplyAdd.isFast());
    System.out.println(scene.mayChangeKernel());
    System.out.println(hash(film.develop()));
  }

  static RenderSettings settings(SceneFile file) {
    return file.settings().toBuilder().size(64, 48).samples(4).threads(2).build();
  }

  static int hash(Image image) {
    return Arrays.hashCode(image.rgb());
  }
}
