package io.github.lumbre.cli.view;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.scenefile.internal.CameraPose;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class CameraJsonTest {
  private static byte[] scene(String camera) {
    String text = "{\"mainCameraId\": 1, \"objects\": [" + camera + "]}";
    return text.getBytes(StandardCharsets.UTF_8);
  }

  /** No other key of the camera's place remains, which would win. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "\"localRotation\": {\"x\": 5}, \"localScale\": {\"x\": 2}",
        "\"lookAt\": {\"x\": 3, \"y\": 1, \"z\": 2}, \"lookAtUp\": {\"x\": 1}",
        "\"matrix\": [0, 0, 1, 7, 0, 1, 0, 8, -1, 0, 0, 9]"
      })
  void theCameraStandsAtThePose(String place) throws Exception {
    CameraPose pose = new CameraPose(new Vec3(1, 2, 3), new Vec3(10, 20, 30));
    byte[] before =
        scene("{\"type\": \"Camera\", \"id\": 1, \"fieldOfView\": 30, " + place + "}");
    byte[] after = scene(CameraJson.of(before, pose, Optional.empty()));
    Scene scene = new SceneParser().parse(after, Path.of("a.json")).scene();
    CameraPose found = CameraPose.of(scene.camera());
    assertThat(found.position()).isEqualTo(pose.position());
    assertThat(found.rotation().minus(pose.rotation()).length()).isLessThan(1e-9);
  }
}
