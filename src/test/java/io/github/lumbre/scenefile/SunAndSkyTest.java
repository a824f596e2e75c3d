package io.github.lumbre.scenefile;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.light.LightSample;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.Stage.Sky;
import io.github.lumbre.stage.Stage.View;
import io.github.lumbre.stage.StagedModel;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the two lights of a clear day. */
class SunAndSkyTest {
  private static final Path MODEL = Path.of("src/test/resources/cases/twoprims.glb");
  private static final View PLACE = new View(70, 25);
  private static final double RADIUS = .266272;

  @TempDir private Path folder;

  private static SceneFile file;
  private static EnvironmentLight sky;
  private static EnvironmentLight sun;

  @BeforeAll
  static void read() throws IOException, SceneFormatException {
    Stage stage = Stage.DEFAULT.under(new Sky("sun", 1, 0, PLACE)).seenFrom(PLACE);
    file = StagedModel.read(MODEL, stage, new SceneParser()).scene();
    sky = file.scene().environments().get(0);
    sun = file.scene().environments().get(1);
  }

  /** Returns the direction to the sun: the camera has the same view. */
  private static Vec3 toSun() {
    return file.scene().camera().axes().normal().negated();
  }

  private static Vec3 aside(double degrees, double around) {
    Vec3 across =
        file.scene()
            .camera()
            .axes()
            .tangent()
            .times(Math.cos(around))
            .plus(file.scene().camera().axes().bitangent().times(Math.sin(around)));
    double angle = Math.toRadians(degrees);
    return toSun().times(Math.cos(angle)).plus(across.times(Math.sin(angle)));
  }

  @Test
  void theSunIsADiskOfHalfADegree() {
    for (int i = 0; i < 100; i++) {
      assertThat(sun.from(aside(RADIUS * (1 - 1e-3), i)).isBlack()).isFalse();
      assertThat(sun.from(aside(RADIUS * (1 + 1e-3), i)).isBlack()).isTrue();
    }
  }

  /** Samples have the density that the light states, and all of them are on the disk. */
  @Test
  void theSunIsSampledOnItsDisk() {
    LightSample sample = new LightSample();
    Random random = new Random(1);
    double sum = 0;
    int count = 20000;
    for (int i = 0; i < count; i++) {
      sun.sample(0, 0, 0, random.nextDouble(), random.nextDouble(), sample);
      assertThat(sample.wi().dot(toSun())).isGreaterThan(Math.cos(Math.toRadians(RADIUS + 1e-4)));
      assertThat(sun.pdf(sample.wi()) / sample.pdf()).isCloseTo(1, within(1e-4));
      sum += sample.g() / sample.pdf();
    }
    double solidAngle = 2 * Math.PI * (1 - Math.cos(Math.toRadians(RADIUS)));
    // Weights vary by 20 %: 5 standard errors of the mean.
    assertThat(sum / count / (sun.from(toSun()).g() * solidAngle)).isCloseTo(1, within(.007));
  }

  /** Light samples and even directions agree on the irradiance of the ground from the sky. */
  @Test
  void theSkyIsSampledWithoutBias() {
    LightSample sample = new LightSample();
    Random random = new Random(2);
    double bySamples = 0;
    double byDirections = 0;
    int count = 100000;
    for (int i = 0; i < count; i++) {
      double u = random.nextDouble();
      double v = random.nextDouble();
      sky.sample(0, 0, 0, u, v, sample);
      bySamples += Math.max(0, sample.wi().y()) * sample.g() / sample.pdf();
      double across = Math.sqrt(u);
      Vec3 even =
          new Vec3(
              across * Math.cos(2 * Math.PI * v),
              Math.sqrt(1 - u),
              across * Math.sin(2 * Math.PI * v));
      byDirections += Math.PI * sky.from(even).g();
    }
    // Either mean has a standard error of at most 0.4 %.
    assertThat(bySamples / byDirections).isCloseTo(1, within(.02));
  }

  /** A scene file, such as a film holds, has the same lights. */
  @Test
  void aSceneFileHasTheSameLights() throws IOException, SceneFormatException {
    Stage stage = Stage.DEFAULT.under(new Sky("sun", 2, 30, PLACE));
    SceneFile staged = StagedModel.read(MODEL, stage, new SceneParser()).scene();
    SceneFile read = new SceneParser().parse(staged.text().orElseThrow());
    assertThat(read.hash()).isEqualTo(staged.hash());
    List<EnvironmentLight> expected = staged.scene().environments();
    Scene scene = read.scene();
    assertThat(scene.environments()).hasSize(2);
    for (int i = 0; i < 2; i++) {
      LightSample one = expected.get(i).sample(Vec3.ZERO, new Point2(.3, .6)).orElseThrow();
      LightSample other =
          scene.environments().get(i).sample(Vec3.ZERO, new Point2(.3, .6)).orElseThrow();
      assertThat(other.wi()).isEqualTo(one.wi());
      assertThat(other.radiance()).isEqualTo(one.radiance());
    }
  }

  /** North is at -z and east at +x; a sky that is turned by 90 degrees has its north at -x. */
  @Test
  void theFrontViewLooksNorth() throws IOException, SceneFormatException {
    Instant morning = Instant.parse("2026-03-20T06:02:00Z");
    View east = Sky.sunAt(0, 0, morning);
    assertThat(Math.abs(east.elevation())).isLessThan(2);
    View place = new View(east.azimuth(), 0);
    assertThat(Sky.sunAt(80, 0, morning.plusSeconds(6 * 3600)).azimuth()).isBetween(-2., 2.);
    for (int turn : new int[] {0, 90}) {
      Stage stage = Stage.DEFAULT.under(new Sky("sun", 1, turn, place));
      SceneFile staged = StagedModel.read(MODEL, stage, new SceneParser()).scene();
      EnvironmentLight light = staged.scene().environments().get(1);
      LightSample sample = light.sample(Vec3.ZERO, new Point2(.5, .999)).orElseThrow();
      assertThat(sample.wi().dot(turn == 0 ? Vec3.X : Vec3.Z.negated())).isGreaterThan(.999);
    }
  }

  @Test
  void aSunBelowTheHorizonIsRefused() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new Sky("sun", 1, 0, new View(0, -4)))
        .withMessage("sun: expected an elevation from 0 to 90, found -4.0");
  }

  /** The lights do not know where the sun is, so that no file could have them. */
  @Test
  void theSceneWriterRefusesThem() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> written(sky))
        .withMessage("expected an environment light without besideSun, found one with it");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> written(sun))
        .withMessage("expected a constant, a picture or a texture of the format, found SunDisk");
  }

  private static SceneFile written(EnvironmentLight light) {
    Scene scene = Scene.builder().lookingAt(Vec3.Z, Vec3.ZERO, 40).add(light).build();
    return SceneWriter.file(scene, RenderSettings.DEFAULT);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "'sky': 'sun', 'sunElevation': -1 | sunElevation: expected",
        "'sky': 'sun', 'sunElevation': 91 | sunElevation: expected",
        "'sky': 'clear', 'sunElevation': 'noon' | sunElevation: expected",
        "'sky': 'sunny' | sky: expected"
      })
  void wrongSkiesAreRefused(String keys, String message) {
    SceneFixture fixture = new SceneFixture(folder);
    String light = SceneFixture.json("{'type': 'Light', 'lightType': 'Dome', " + keys + "}");
    assertThat(fixture.refusal(SceneFixture.scene(light, ""))).hasMessageContaining(message);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "'sunAzimuth': 3 | true",
        "'sky': 'studio', 'sunElevation': 3 | true",
        "'sky': 'clear', 'sunAzimuth': 3 | false"
      })
  void aSunThatIsIgnoredIsSaid(String keys, boolean isIgnored) {
    SceneFixture fixture = new SceneFixture(folder);
    String light = SceneFixture.json("{'type': 'Light', 'lightType': 'Dome', " + keys + "}");
    String warnings = fixture.parse(SceneFixture.scene(light, "")).warnings().toString();
    assertThat(warnings.contains("is ignored, because only clear and sun")).isEqualTo(isIgnored);
  }

  /** The sky and the sun are two lights of the scene, and one sky of the stage. */
  @Test
  void aDarkSkyIsReportedOnce() throws Exception {
    Stage dark = Stage.DEFAULT.under(new Sky("sun", 0, 0, PLACE));
    assertThat(StagedModel.read(MODEL, dark, new SceneParser()).scene().warnings())
        .extracting(Problem::path)
        .containsExactly("sky");
  }
}
