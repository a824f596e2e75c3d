package io.github.lumbre.render.stopping;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.camera.Lens;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.compare.PictureError;
import io.github.lumbre.material.Matte;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.PassListener;
import io.github.lumbre.render.PassLoop;
import io.github.lumbre.render.PictureRenderer;
import io.github.lumbre.render.Progress;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.testing.Effort;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * The noise of a picture of a moving object is what its halves say: the difference between poses is
 * no noise, and a sample of a pose that is missing is none.
 *
 * <p>With 100 seeds and a true coverage of 95 %, 14 or more failures have a probability of 4e-4. A
 * coverage of 75 % is detected with a probability of 0.998. The quick form with 12 seeds detects a
 * coverage of 30 % with a probability of 0.998.
 */
class MotionCoverageTest {
  private static final int SIDE = 16;
  private static final int POSES = 8;
  private static final double CONFIDENCE = .95;

  /** A ball that crosses most of the picture, from dark to light. */
  private static Scene ball(int pose) {
    double x = -1 + 2 * (pose + .5) / POSES;
    return Scene.builder()
        .seenBy(Lens.pinhole(60).camera(new Vec3(0, 0, -4), Frame.WORLD, 1))
        .add(new Sphere(Transform.translation(new Vec3(x, 0, 0)), .8), Matte.GRAY)
        .addBackground(Rgb.gray(.2 + pose))
        .build();
  }

  private static Scene moving() {
    return Scene.inMotion(IntStream.range(0, POSES).mapToObj(MotionCoverageTest::ball).toList());
  }

  private static RenderSettings settings(int samples, long seed) {
    return RenderSettings.builder().size(SIDE, SIDE).samples(samples).threads(1).seed(seed).build();
  }

  private static Image meanOfPoses() throws InterruptedException {
    float[] mean = new float[3 * SIDE * SIDE];
    for (int pose = 0; pose < POSES; pose++) {
      RenderSettings settings = settings(Effort.count(512, 4096), -1 - pose);
      float[] rgb = new PictureRenderer(settings).render(ball(pose)).rgb();
      for (int i = 0; i < mean.length; i++) {
        mean[i] += rgb[i] / POSES;
      }
    }
    return new Image(SIDE, SIDE, mean, new float[0]);
  }

  @ParameterizedTest
  @CsvSource({".02, false", ".02, true"})
  void errorsAreAtMostWhatIsClaimed(double target, boolean adaptive) throws Exception {
    Scene scene = moving();
    Image reference = meanOfPoses();
    int seeds = Effort.count(12, 100);
    int failures = 0;
    double squares = 0;
    double estimates = 0;
    for (int i = 0; i < seeds; i++) {
      RenderSettings own =
          settings(1 << 14, Effort.seed(7000 + i)).toBuilder().adaptive(adaptive).build();
      FilmRenderer renderer = new FilmRenderer(own, scene);
      Film film = renderer.newFilm();
      BudgetWatch watch =
          new BudgetWatch(new Budget(1 << 14, OptionalDouble.of(target), CONFIDENCE));
      new PassLoop(renderer, film).run(watch, PassListener.NONE, Progress.NONE);
      NoiseEstimate noise = watch.estimate(film).orElseThrow();
      double error = PictureError.of(film.develop(), reference).relativeMse();
      failures += error > noise.upperRelativeMse() ? 1 : 0;
      squares += error;
      estimates += noise.relativeMse();
      assertThat(watch.isMet()).isTrue();
    }
    double ratio = Math.sqrt(estimates / squares);
    String told =
        String.format(
            Locale.ROOT, "%d of %d beyond the bound, estimate/error %.2f", failures, seeds, ratio);
    if (Effort.isExhaustive()) {
      System.out.println(told);
    }
    assertThat(failures).as(told).isLessThan(Effort.count(8, 14));
    assertThat(ratio).as(told).isBetween(.7, 1.6);
  }

  /** Passes are longer than without poses, so that there are fewer checks. */
  @Test
  void resumedRendersCountTheSameChecks() throws Exception {
    List<Scene> poses =
        Collections.nCopies(16, moving().poses()).stream().flatMap(List::stream).toList();
    FilmRenderer renderer = new FilmRenderer(settings(3 * 128, 0), Scene.inMotion(poses));
    Film film = renderer.newFilm();
    Budget budget = new Budget(1 << 14, OptionalDouble.of(1e-4), CONFIDENCE);
    BudgetWatch watch = new BudgetWatch(budget);
    new PassLoop(renderer, film).run(watch, PassListener.NONE, Progress.NONE);
    BudgetWatch resumed = new BudgetWatch(budget);
    resumed.resume(film);
    assertThat(resumed.estimate(film)).isEqualTo(watch.estimate(film)).isPresent();
  }

  /** Halves with other poses would differ by the motion, which is no noise. */
  @Test
  void noiseIsKnownFromTwoSamplesOfEachPoseOn() throws Exception {
    RenderSettings settings =
        settings(64, 0).toBuilder().set(Setting.LAYERS, Layer.FOR_DENOISING).build();
    FilmRenderer renderer = new FilmRenderer(settings, moving());
    Film film = renderer.newFilm();
    renderer.addSamples(film, 1, Progress.NONE);
    assertThat(film.fewestSamples()).isEqualTo(POSES);
    assertThat(film.halves(8, 8)).isEmpty();
    assertThat(NoiseEstimate.of(film, CONFIDENCE)).isEmpty();
    assertThat(film.developNoise()).containsOnly(Float.NaN);
    assertThat(film.developNoise(Layer.DENOISING_NORMAL)).containsOnly(Float.NaN);
    renderer.addSamples(film, 3 * POSES, Progress.NONE);
    assertThat(film.halves(8, 8).orElseThrow().firstCount()).isEqualTo(2 * POSES);
    assertThat(NoiseEstimate.of(film, CONFIDENCE)).isPresent();
  }
}
