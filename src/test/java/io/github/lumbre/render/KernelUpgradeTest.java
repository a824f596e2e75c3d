package io.github.lumbre.render;

import static io.github.lumbre.testing.Renders.film;
import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import io.github.lumbre.geometry.CompiledVectors;
import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.geometry.internal.CompiledKernel;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneParser;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** When a render changes the traversal kernel. */
class KernelUpgradeTest {
  private SceneFile file;
  private Scene scene;

  @BeforeEach
  void readScene() throws Exception {
    assumeTrue(Kernel.vectorObstacle().isEmpty(), () -> Kernel.vectorObstacle().orElseThrow());
    CompiledVectors.forget();
    CompiledKernel.spent(-CompiledKernel.spent(0));
    file = new SceneParser().parse(Path.of("scenes/torus-knot.json"));
    scene = file.scene();
    assertThat(scene.mayChangeKernel()).isTrue();
  }

  @AfterEach
  void forget() throws InterruptedException {
    CompiledVectors.forget();
  }

  /** The time that is spent before it counts is at most 8 s. */
  @Test
  void shortRendersKeepTheirKernel() {
    KernelUpgrade.passed(scene, 0, 0, () -> 100);
    KernelUpgrade.passed(scene, 0, 7.9, () -> 100);
    assertThat(scene.mayChangeKernel()).isTrue();
  }

  @Test
  void longRendersChangeIt() throws InterruptedException {
    CompiledKernel.begin();
    KernelUpgrade.passed(scene, 3.1, 8.1, () -> 100);
    CompiledVectors.forget();
    CompiledKernel.end();
    assertThat(scene.mayChangeKernel()).isFalse();
  }

  @Test
  void manyShortRendersChangeIt() throws InterruptedException {
    CompiledKernel.begin();
    KernelUpgrade.passed(scene, 8.1, 0, () -> 100);
    CompiledVectors.forget();
    CompiledKernel.end();
    assertThat(scene.mayChangeKernel()).isFalse();
  }

  /** A change that was stopped after half a second needs two more seconds, not eight. */
  @Test
  void stoppedChangeGoesOnWhenItsTimeIsEarned() throws InterruptedException {
    KernelUpgrade.stopped(.5);
    CompiledKernel.begin();
    KernelUpgrade.passed(scene, 1.9, 0, () -> 100);
    assertThat(scene.mayChangeKernel()).isTrue();
    KernelUpgrade.passed(scene, .2, 0, () -> 100);
    CompiledVectors.forget();
    CompiledKernel.end();
    assertThat(scene.mayChangeKernel()).isFalse();
  }

  @Test
  void pauseStopsTheChangeAndTheNextRenderGoesOn() throws InterruptedException {
    Thread.sleep(2100);
    KernelUpgrade.passed(scene, 8.1, 0, () -> 100);
    CompiledVectors.forget();
    assertThat(scene.mayChangeKernel()).isTrue();
    CompiledKernel.begin();
    KernelUpgrade.passed(scene, 7.9, 0, () -> 100);
    CompiledVectors.forget();
    CompiledKernel.end();
    assertThat(scene.mayChangeKernel()).isFalse();
  }

  /** The threads waited for processors: 8.1 seconds of threads took 2.9 processor seconds. */
  @Test
  void shortRendersOnABusyMachineKeepTheirKernel() {
    KernelUpgrade.passed(scene, 8.1, 8.1, () -> 2.9);
    assertThat(scene.mayChangeKernel()).isTrue();
  }

  @Test
  void changesStopSoonAfterTheLastPass() throws InterruptedException {
    CompiledKernel.begin();
    CompiledKernel.begin();
    CompiledKernel.end();
    Thread.sleep(2100);
    assertThat(CompiledKernel.isRendering()).isTrue();
    CompiledKernel.end();
    assertThat(CompiledKernel.isRendering()).isTrue();
    Thread.sleep(2100);
    assertThat(CompiledKernel.isRendering()).isFalse();
  }

  @Test
  void samplesBeforeAndAfterTheChangeHaveTheSameBits() throws InterruptedException {
    RenderSettings settings =
        file.settings().toBuilder().size(64, 48).samples(4).threads(2).build();
    Film expected = film(settings, scene.searchedBy(Kernel.SCALAR));
    FilmRenderer renderer = new FilmRenderer(settings, scene);
    Film film = renderer.newFilm();
    renderer.addSamples(film, 2, Progress.NONE);
    scene.changeKernel(() -> true);
    renderer.addSamples(film, 4, Progress.NONE);
    assertThat(film.develop().rgb()).isEqualTo(expected.develop().rgb());
  }

  @Test
  void withoutTheVectorModuleLongRendersKeepTheirKernelAndBits(@TempDir Path directory)
      throws IOException, InterruptedException {
    String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
    String classes = System.getProperty("java.class.path");
    Path out = directory.resolve("out.txt");
    Process process =
        new ProcessBuilder(java, "-cp", classes, WithoutVectors.class.getName())
            .redirectOutput(out.toFile())
            .redirectError(ProcessBuilder.Redirect.INHERIT)
            .start();
    assertThat(process.waitFor(60, TimeUnit.SECONDS)).isTrue();
    Film expected = film(WithoutVectors.settings(file), scene.searchedBy(Kernel.SCALAR));
    assertThat(Files.readAllLines(out))
        .containsExactly(
            "Java runs without --add-modules jdk.incubator.vector",
            "true",
            "false",
            String.valueOf(WithoutVectors.hash(expected.develop())));
  }
}
