package io.github.lumbre.scenefile;

import static io.github.lumbre.testing.Refusals.assertCancelled;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.geometry.Bvh;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.image.ImageReader;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.format.obj.ObjReader;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.StagedModel;
import io.github.lumbre.testing.Pictures;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** An interrupt of the reading thread ends each stage of reading a scene. */
class InterruptedReadingTest {
  private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

  /** The maximum processor time, in nanoseconds, until reading ends. */
  private static final long MAX_NANOS = 300_000_000;

  @TempDir private Path directory;

  @AfterEach
  void clearInterrupt() {
    Thread.interrupted();
  }

  private Path scene() throws IOException {
    return Files.writeString(directory.resolve("a.json"), "{\"objects\": []}");
  }

  @Test
  void interruptedThreadReadsNoScene() throws IOException {
    Path scene = scene();
    assertCancelled(() -> new SceneParser().parse(scene));
  }

  /** Also when the interrupt comes after the model itself is read. */
  @Test
  void interruptedThreadReadsNoModel() throws IOException {
    Path model =
        Files.writeString(directory.resolve("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3");
    byte[] bytes = Files.readAllBytes(model);
    Stage stage = Stage.DEFAULT;
    SceneParser late =
        new SceneParser()
            .overriding(
                settings -> {
                  Thread.currentThread().interrupt();
                  return settings;
                });
    for (ThrowingCallable reading :
        List.<ThrowingCallable>of(
            () -> StagedModel.read(model, stage, late),
            () -> StagedModel.read("a.obj", bytes, ModelFolder.NONE, stage, late))) {
      assertThatThrownBy(reading).isInstanceOf(CancellationException.class);
      assertThat(Thread.interrupted()).isTrue();
    }
  }

  @Test
  void readingJsonEnds() {
    byte[] text = "[1]".getBytes(java.nio.charset.StandardCharsets.US_ASCII);
    assertCancelled(() -> JsonNode.read(text, new Problems("a.json"), Limits.NONE));
  }

  @Test
  void readingMeshesEnds() {
    byte[] text = new byte[1 << 16];
    Arrays.fill(text, (byte) '\n');
    assertCancelled(() -> ObjReader.read(text));
  }

  @Test
  void decodingPicturesEnds() throws IOException {
    BufferedImage image = Pictures.of(64, 64, 0);
    for (String format : List.of("png", "jpg")) {
      byte[] file = Pictures.file(image, format);
      assertCancelled(() -> ImageReader.decode(file));
    }
  }

  @Test
  void buildingHierarchiesEnds() {
    List<Shape> spheres = new ArrayList<>();
    for (int i = 0; i < 10_000; i++) {
      spheres.add(new Sphere(Transform.translation(new Vec3(i, i * 7 % 13, i * 11 % 17)), .5));
    }
    assertCancelled(() -> Bvh.over(spheres));
  }

  /**
   * Reads a large scene repeatedly, with interrupts at five different times. Processor time is
   * measured, because the machine may be shared.
   */
  @Test
  void readingEndsSoonAfterTheInterrupt() throws IOException, InterruptedException {
    Path scene = writeLargeScene();
    for (int millis : new int[] {20, 100, 300, 500, 800}) {
      AtomicReference<Throwable> end = new AtomicReference<>();
      AtomicLong endNanos = new AtomicLong();
      Thread thread =
          new Thread(
              () -> {
                try {
                  while (true) {
                    new SceneParser().parse(scene);
                  }
                } catch (IOException | SceneFormatException | RuntimeException e) {
                  end.set(e);
                }
                endNanos.set(THREADS.getCurrentThreadCpuTime());
              });
      thread.start();
      Thread.sleep(millis);
      long nanos = THREADS.getThreadCpuTime(thread.getId());
      thread.interrupt();
      thread.join(60_000);
      assertThat(thread.isAlive()).as("after %d ms", millis).isFalse();
      assertThat(endNanos.get() - nanos).as("after %d ms", millis).isLessThan(MAX_NANOS);
      assertThat(end.get()).isInstanceOf(CancellationException.class);
    }
  }

  private Path writeLargeScene() throws IOException {
    StringBuilder obj = new StringBuilder();
    int side = 200;
    for (int i = 0; i < side * side; i++) {
      obj.append("v ").append(i / side).append(' ').append(i % 7).append(' ').append(i % side);
      obj.append('\n');
    }
    for (int i = side + 2; i <= side * side; i++) {
      obj.append("f ").append(i).append(' ').append(i - 1).append(' ').append(i - side);
      obj.append('\n');
    }
    Files.writeString(directory.resolve("large.obj"), obj);
    return Files.writeString(
        directory.resolve("large.json"),
        """
        {"mainCameraId": 1,
         "assets": [{"id": 2, "assetType": "Mesh", "file": "large.obj"},
          {"id": 3, "assetType": "Material", "materialType": "Diffuse"}],
         "objects": [{"id": 1, "type": "Camera", "cameraType": "Pinhole"},
          {"type": "Shape", "shapeType": "Mesh", "meshId": 2, "materialID": 3}]}
        """);
  }
}
