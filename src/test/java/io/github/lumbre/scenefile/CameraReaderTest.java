package io.github.lumbre.scenefile;

import static io.github.lumbre.scenefile.SceneFixture.json;
import static io.github.lumbre.scenefile.SceneFixture.png;
import static io.github.lumbre.scenefile.SceneFixture.texture;
import static io.github.lumbre.testing.Near.assertNear;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.camera.Camera;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import io.github.lumbre.testing.Pictures;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the reading of cameras. */
class CameraReaderTest {
  @TempDir private Path folder;
  private SceneFixture fixture;

  @BeforeEach
  void setUp() {
    fixture = new SceneFixture(folder);
  }

  private static String seenBy(String camera, String assets) {
    return json(
            "{'mainCameraId': 1, 'renderOptions': {'width': 200, 'height': 100}, 'objects':"
                + " [{'type': 'Camera', 'id': 1"
                + (camera.isEmpty() ? "" : ", ")
                + camera
                + "}], 'assets': [")
        + assets
        + "]}";
  }

  private Camera camera(String camera) {
    return fixture.parse(seenBy(camera, "")).scene().camera();
  }

  private static Ray ray(Camera camera, double u, double v) {
    return camera.rayFor(new Point2(u, v), sampler(0)).orElseThrow();
  }

  private static SobolSampler sampler(int sample) {
    SobolSampler sampler = new SobolSampler(0);
    sampler.startSample(0, 0, sample);
    return sampler;
  }

  @Test
  void camerasArePinholesOf60DegreesIfNothingElseIsSaid() {
    Camera camera = camera("");
    assertThat(camera.getClass().getSimpleName()).isEqualTo("PinholeCamera");
    double tan30 = Math.sqrt(1 / 3.0);
    assertNear(ray(camera, .5, .5).direction(), Vec3.Z, 1e-13);
    assertNear(ray(camera, 0, 0).direction(), new Vec3(-2 * tan30, tan30, 1).normalized(), 1e-13);
  }

  @Test
  void aspectIsThatOfTheFinalSettings() {
    SceneParser square = new SceneParser().overriding(s -> s.toBuilder().size(50, 50).build());
    Camera camera = fixture.parse(square, seenBy("'fieldOfView': 90", "")).scene().camera();
    assertNear(ray(camera, 1, 0).direction(), new Vec3(1, 1, 1).normalized(), 1e-13);
  }

  @Test
  void camerasStandAndLookWhereTheirObjectsDo() {
    Camera camera =
        camera(
            "'fieldOfView': 90, 'localPosition': {'x': 1, 'y': 2, 'z': 3}, 'localRotation':"
                + " {'y': 90}, 'localScale': {'x': 4, 'y': -1, 'z': 9}");
    assertThat(ray(camera, .5, .5).origin()).isEqualTo(new Vec3(1, 2, 3));
    assertNear(ray(camera, .5, .5).direction(), Vec3.X, 1e-13);
    assertNear(ray(camera, .5, 0).direction(), new Vec3(1, 1, 0).normalized(), 1e-13);
    assertNear(ray(camera, .75, .5).direction(), new Vec3(1, 0, -1).normalized(), 1e-13);
  }

  @Test
  void panoramasHaveTheirKeys() {
    Camera cylinder = camera("'cameraType': 'Cylindrical', 'height': 1");
    assertThat(cylinder.getClass().getSimpleName()).isEqualTo("CylindricalCamera");
    assertNear(ray(cylinder, .75, 0).direction(), new Vec3(1, 1, 0).normalized(), 1e-13);
    Camera fishEye = camera("'cameraType': 'FishEye', 'fieldOfView': 3, 'angle': 360");
    assertThat(fishEye.getClass().getSimpleName()).isEqualTo("FishEyeCamera");
    assertNear(ray(fishEye, .5, .25).direction(), Vec3.Y, 1e-13);
    Camera sphere = camera("'cameraType': 'Spherical'");
    assertThat(sphere.getClass().getSimpleName()).isEqualTo("SphericalCamera");
    assertNear(ray(sphere, .75, .5).direction(), Vec3.X, 1e-13);
  }

  @Test
  void lensHasRadiusApertureAndKeepsThePlaneOfFocusSharp() {
    Camera camera =
        camera("'cameraType': 'ThinLens', 'fieldOfView': 90, 'focusDistance': 3, 'aperture': 2");
    double farthest = 0;
    for (int i = 0; i < 256; i++) {
      Ray ray = camera.rayFor(new Point2(.75, .5), sampler(i)).orElseThrow();
      Vec3 inFocus = ray.origin().plus(3 / ray.direction().z(), ray.direction());
      assertNear(inFocus, new Vec3(3, 0, 3), 1e-13);
      farthest = Math.max(farthest, ray.origin().length());
    }
    assertThat(farthest).isBetween(1.8, 2.0);
  }

  @Test
  void masksAreAsWideAsTheApertureAndStandUpright() {
    // White in the upper right corner only.
    byte[] mask = Pictures.png(2, 2, 0, 0xffffff, 0, 0);
    SceneFile file =
        fixture.parse(
            seenBy(
                "'cameraType': 'ThinLens', 'aperture': 2, 'bokehTextureId': 5",
                texture(5, mask, "")));
    assertThat(file.warnings()).isEmpty();
    for (int i = 0; i < 64; i++) {
      Vec3 origin =
          file.scene().camera().rayFor(new Point2(.5, .5), sampler(i)).orElseThrow().origin();
      assertThat(origin.x()).isBetween(0.0, 1.0);
      assertThat(origin.y()).isBetween(0.0, 1.0);
    }
  }

  @Test
  void grayMasksAreWarnedOfAndBlackOnesRefused() {
    String camera = "'cameraType': 'ThinLens', 'bokehTextureId': 5";
    assertThat(fixture.parse(seenBy(camera, texture(5, png(0x808080, 0), ""))).warnings())
        .map(Object::toString)
        .containsExactly(
            "scene.json: $.objects[0].bokehTextureId: the mask is not black and white; values"
                + " from 0.5 up count as white");
    assertThat(fixture.refusal(seenBy(camera, texture(5, png(0, 0), ""))))
        .hasMessage(
            "scene.json: $.objects[0].bokehTextureId: expected a mask with white pixels, found"
                + " none");
  }

  @Test
  void masksOfCamerasThatAreNotTheMainOneAreNotRead() {
    String text =
        json(
            "{'mainCameraId': 1, 'objects': [{'type': 'Camera', 'id': 1}, {'type': 'Camera',"
                + " 'id': 2, 'cameraType': 'ThinLens', 'bokehTextureId': 77}]}");
    assertThat(fixture.parse(text).warnings()).isEmpty();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "'fieldOfView': 0|.fieldOfView: expected a number in (0, 180), found 0",
        "'fieldOfView': 180|.fieldOfView: expected a number in (0, 180), found 180",
        "'fieldOfView': -5|.fieldOfView: expected a number in (0, 180), found -5",
        "'fieldOfView': 360|.fieldOfView: expected a number in (0, 180), found 360",
        "'cameraType': 'ThinLens', 'focusDistance': -1"
            + "|.focusDistance: expected a finite number > 0, found -1",
        "'cameraType': 'ThinLens', 'focusDistance': 1e400"
            + "|.focusDistance: expected a finite number, found 1e400",
        "'cameraType': 'Cylindrical', 'height': -1"
            + "|.height: expected a number from 0 to 1e150, found -1",
        "'cameraType': 'ThinLens', 'focusDistance': 0"
            + "|.focusDistance: expected a finite number > 0, found 0",
        "'cameraType': 'ThinLens', 'aperture': -1"
            + "|.aperture: expected a finite number >= 0, found -1",
        "'cameraType': 'Cylindrical', 'height': 1e200"
            + "|.height: expected a number from 0 to 1e150, found 1e200",
        "'cameraType': 'FishEye', 'angle': 361"
            + "|.angle: expected a number in (0, 360], found 361",
        "'cameraType': 'Box'|.cameraType: expected one of Pinhole, ThinLens, Orthographic,"
            + " Cylindrical, Spherical, FishEye, found 'Box'"
      })
  void errorsInCamerasSayWhereAndWhat(String camera, String message) {
    assertThat(fixture.refusal(seenBy(camera, "")))
        .hasMessage("scene.json: $.objects[0]" + json(message));
  }
}
