package io.github.lumbre.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.camera.CameraRay;
import io.github.lumbre.camera.Lens;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.Integrator;
import io.github.lumbre.integrator.RenderContext;
import io.github.lumbre.integrator.path.PathVertex;
import io.github.lumbre.integrator.path.PathVertex.Contribution;
import io.github.lumbre.integrator.path.PathVertex.End;
import io.github.lumbre.integrator.path.PathVertex.Scattering;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Mode;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneParser;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests that replayed samples are bit-identical to those of a render. */
class PixelReplayTest {
  private static final int WIDTH = 24;
  private static final int HEIGHT = 16;

  private static SceneFile scene(String name, Mode mode) throws Exception {
    return new SceneParser()
        .inMode(mode)
        .overriding(s -> s.toBuilder().size(WIDTH, HEIGHT).samples(3).seed(11).build())
        .parse(Path.of("scenes", name + ".json"));
  }

  @Test
  void noSamplesNeedBeShown() throws Exception {
    SceneFile file = scene("cornell-box", Mode.PATH);
    PixelReplay replay = new PixelReplay(file.scene(), file.settings());
    assertThat(replay.pixel(9, 9, 0).brightest()).isEmpty();
    assertThat(replay.pixel(9, 9, 0).mean()).isEqualTo(replay.pixel(9, 9, 1).mean());
  }

  /** Recording a path does not change it: the result is bit-identical to that of a render. */
  @ParameterizedTest
  @CsvSource({
    "cornell-box, PATH, 1",
    "cornell-box, PATH, 3",
    "cornell-box-dome, PATH, 1",
    "cornell-box-dome, PATH, 2",
    "cornell-box, RAY, 1",
    "glass-and-mirror, PATH, 1",
    "glass-and-mirror, PATH, 4",
    "glass-and-mirror, RAY, 1",
    "camera-fisheye, PATH, 1",
    "table-13-voronoi, PATH, 1"
  })
  void replayedSamplesHaveTheBitsOfTheRender(String name, Mode mode, int split) throws Exception {
    SceneFile file = scene(name, mode);
    RenderSettings settings = file.settings().toBuilder().split(split).build();
    Image image = new PictureRenderer(settings).render(file.scene());
    Integrator integrator = Integrator.of(file.scene(), settings);
    PixelReplay replay = new PixelReplay(file.scene(), settings);
    Sampler sampler = new SobolSampler(settings.seed());
    RenderContext scratch = new RenderContext();
    CameraRay ray = new CameraRay();
    for (int y = 0; y < HEIGHT; y += 3) {
      for (int x = 0; x < WIDTH; x++) {
        if (!file.scene().camera().leavesBlanks()) {
          assertThat(replay.pixel(x, y, 2).mean()).isEqualTo(image.pixel(x, y));
        }
        for (int sample = 0; sample < settings.samples(); sample++) {
          boolean isImaged =
              CameraSamples.start(file.scene(), settings, sampler, x, y, sample, ray);
          Rgb expected = isImaged ? integrator.radiance(ray, sampler, scratch) : Rgb.BLACK;
          PixelReplay.Sample replayed = replay.sample(x, y, sample);
          assertThat(replayed.film()).isEqualTo(expected);
          assertAddsUp(replayed);
        }
      }
    }
  }

  /** The contributions, added in their order, are the sample's radiance. */
  private static void assertAddsUp(PixelReplay.Sample sample) {
    Rgb sum = Rgb.BLACK;
    for (PathVertex vertex : sample.vertices()) {
      for (Contribution contribution : vertex.contributions()) {
        sum = sum.plus(contribution.amount());
        assertExplained(vertex, contribution);
      }
    }
    assertThat(sum).isEqualTo(sample.radiance());
  }

  /** A contribution is the throughput times the weighted light. */
  private static void assertExplained(PathVertex vertex, Contribution contribution) {
    double light = contribution.lights().stream().mapToDouble(l -> l.weighted().g()).sum();
    double expected = vertex.throughput().g() * light;
    assertThat(contribution.amount().g()).isCloseTo(expected, within(1e-12 * (1 + expected)));
  }

  @Test
  void pathsAreRecordedToTheirEnd() throws Exception {
    SceneFile file = scene("cornell-box", Mode.PATH);
    PixelReplay replay = new PixelReplay(file.scene(), file.settings());
    for (int x = 0; x < WIDTH; x++) {
      List<PathVertex> vertices = replay.sample(x, 9, 1).vertices();
      for (int i = 0; i < vertices.size(); i++) {
        PathVertex vertex = vertices.get(i);
        boolean isLast = i == vertices.size() - 1;
        assertThat(vertex.end() != End.CONTINUES).isEqualTo(isLast);
        assertThat(vertex.hit().isPresent()).isEqualTo(vertex.end() != End.ESCAPED);
        if (!isLast) {
          PathVertex next = vertices.get(i + 1);
          Scattering scattering = vertex.scattered().get(0);
          assertThat(next.ray().direction()).isEqualTo(scattering.wi());
          Rgb carried =
              vertex.throughput().times(scattering.weight()).times(1 / scattering.survival());
          assertThat(next.throughput()).isEqualTo(carried);
        }
      }
    }
  }

  /** The film value equals that of a render, also for clamped and rejected samples. */
  @Test
  void clampedSamplesAreReplayedAsTheFilmReceivesThem() throws Exception {
    SceneFile file = scene("glass-and-mirror", Mode.PATH);
    RenderSettings settings = file.settings().toBuilder().clamp(.5).build();
    Image image = new PictureRenderer(settings).render(file.scene());
    PixelReplay replay = new PixelReplay(file.scene(), settings);
    int clamped = 0;
    for (int y = 0; y < HEIGHT; y++) {
      for (int x = 0; x < WIDTH; x++) {
        assertThat(replay.pixel(x, y, 1).mean()).isEqualTo(image.pixel(x, y));
        PixelReplay.Sample sample = replay.sample(x, y, 0);
        clamped += sample.clamped() ? 1 : 0;
        assertThat(sample.clamped()).isEqualTo(!sample.film().equals(sample.radiance()));
        assertThat(sample.film().max()).isLessThanOrEqualTo(.5 + 1e-15);
      }
    }
    assertThat(clamped).isPositive();
  }

  @Test
  void varianceIsThatOfTheSamples() throws Exception {
    SceneFile file = scene("cornell-box", Mode.PATH);
    PixelReplay replay = new PixelReplay(file.scene(), file.settings());
    PixelReplay.Pixel pixel = replay.pixel(12, 8, 2);
    ToDoubleFunction<Integer> red = n -> replay.sample(12, 8, n).film().r();
    double mean = (red.applyAsDouble(0) + red.applyAsDouble(1) + red.applyAsDouble(2)) / 3;
    double squares = 0;
    for (int n = 0; n < 3; n++) {
      squares += Math.pow(red.applyAsDouble(n) - mean, 2);
    }
    assertThat(pixel.variance().r()).isCloseTo(squares / 2, within(1e-12));
    assertThat(pixel.brightest()).hasSize(2);
    assertThat(pixel.brightest().get(0).film().max())
        .isGreaterThanOrEqualTo(pixel.brightest().get(1).film().max());
  }

  /** With a background that is invalid in one channel, all samples are rejected. */
  @Test
  void rejectedSamplesAreCountedAndTheFirstShown() {
    for (double bad : new double[] {Double.NaN, Double.POSITIVE_INFINITY, -1}) {
      for (int channel = 0; channel < 3; channel++) {
        Rgb radiance =
            new Rgb(channel == 0 ? bad : 1, channel == 1 ? bad : 1, channel == 2 ? bad : 1);
        Scene scene =
            Scene.builder()
                .seenBy(Lens.pinhole(60).camera(Vec3.ZERO, Frame.WORLD, 1))
                .addBackground(radiance)
                .build();
        RenderSettings settings = new RenderSettings.Builder().size(4, 4).samples(7).build();
        PixelReplay.Pixel pixel = new PixelReplay(scene, settings).pixel(1, 2, 3);
        assertThat(pixel.samples()).isEqualTo(7);
        assertThat(pixel.rejected()).isEqualTo(7);
        assertThat(pixel.mean()).isEqualTo(Rgb.BLACK);
        assertThat(pixel.variance()).isEqualTo(Rgb.BLACK);
        assertThat(pixel.firstRejected())
            .extracting(PixelReplay.Sample::number)
            .containsExactly(0, 1, 2);
        assertThat(pixel.firstRejected()).allMatch(PixelReplay.Sample::rejected);
        assertThat(pixel.firstRejected()).allMatch(sample -> sample.film().isBlack());
        assertThat(pixel.firstRejected().get(0).radiance()).isEqualTo(radiance);
      }
    }
  }

  @Test
  void brightestSamplesAreTheBrightestOfAll() throws Exception {
    SceneFile file = scene("cornell-box", Mode.PATH);
    RenderSettings settings = file.settings().toBuilder().samples(20).build();
    PixelReplay replay = new PixelReplay(file.scene(), settings);
    List<Double> all =
        IntStream.range(0, 20)
            .mapToObj(number -> replay.sample(12, 8, number).film().max())
            .sorted(Comparator.reverseOrder())
            .toList();
    for (int shown = 1; shown <= 25; shown++) {
      PixelReplay.Pixel pixel = replay.pixel(12, 8, shown);
      assertThat(pixel.rejected()).isZero();
      assertThat(pixel.firstRejected()).isEmpty();
      assertThat(pixel.brightest())
          .extracting(sample -> sample.film().max())
          .isEqualTo(all.subList(0, Math.min(shown, 20)));
    }
  }

  @Test
  void samplesThatTheCameraDoesNotImageAreBlack() {
    Scene scene =
        Scene.builder()
            .seenBy(Lens.fishEye(180).camera(Vec3.ZERO, Frame.WORLD, 1))
            .addBackground(Rgb.WHITE)
            .build();
    RenderSettings settings = new RenderSettings.Builder().size(20, 20).samples(4).build();
    PixelReplay.Sample corner = new PixelReplay(scene, settings).sample(0, 0, 3);
    assertThat(corner)
        .isEqualTo(new PixelReplay.Sample(3, List.of(), Rgb.BLACK, Rgb.BLACK, false, false));
    PixelReplay.Sample middle = new PixelReplay(scene, settings).sample(10, 10, 3);
    assertThat(middle.film()).isEqualTo(Rgb.WHITE);
    assertThat(middle.vertices()).isNotEmpty();
  }
}
