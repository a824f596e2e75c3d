package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.model.format.gltf.GltfFile;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Animations in some frames of which nothing of the model is visible. */
class EmptyFramesTest {
  private static final String RENDER =
      "render T/a.glb --animation 0 --fps 4 --background #000000 --no-denoise --size 16x12 -s 2"
          + " -o T/a.png ";

  @TempDir private Path directory;

  /** Writes a triangle that an animation of one second scales or moves, from one time to the next. */
  private void write(String camera, String path, double... values) throws IOException {
    GltfFile file = new GltfFile();
    file.add("nodes", "{'mesh': " + file.triangle("") + "}");
    file.add("cameras", "{'type': 'perspective', 'perspective': {'yfov': 1}}");
    file.add("nodes", "{" + camera + "'translation': [0.3, 0.3, 2]}");
    int count = values.length / 3;
    ByteBuffer times = ByteBuffer.allocate(4 * count).order(ByteOrder.LITTLE_ENDIAN);
    for (int i = 0; i < count; i++) {
      times.putFloat((float) i / (count - 1));
    }
    int input =
        file.add(
            "accessors",
            "{'bufferView': %d, 'componentType': 5126, 'type': 'SCALAR', 'count': %d, 'max': [1]}"
                .formatted(file.view(times.array(), ""), count));
    file.add(
        "animations",
        """
        {'channels': [{'sampler': 0, 'target': {'node': 0, 'path': '%s'}}],
         'samplers': [{'input': %d, 'output': %d, 'interpolation': 'STEP'}]}
        """
            .formatted(path, input, file.floats("VEC3", values)));
    Files.write(directory.resolve("a.glb"), file.glb());
  }

  private Outcome run(String flags) {
    return Outcome.in(directory, RENDER + flags);
  }

  /** Returns the number of pixels of a frame that show the triangle. */
  private int bright(int frame) throws IOException {
    BufferedImage picture = ImageIO.read(directory.resolve("a-00" + frame + ".png").toFile());
    int bright = 0;
    for (int i = 0; i < picture.getWidth() * picture.getHeight(); i++) {
      int rgb = picture.getRGB(i % picture.getWidth(), i / picture.getWidth());
      bright += (rgb & 0xff00) > 0x3000 ? 1 : 0;
    }
    return bright;
  }

  /** One warning names the first empty frame. */
  private void assertFrames(Outcome outcome, int empty, boolean... isShown) throws IOException {
    assertThat(outcome.exitCode()).as(outcome.err()).isEqualTo(ExitCodes.OK);
    assertThat(outcome.err()).contains("4 of 4 pictures written");
    for (int i = 0; i < isShown.length; i++) {
      assertThat(bright(i) > 0).as("frame %d", i).isEqualTo(isShown[i]);
    }
    assertThat(outcome.err())
        .containsOnlyOnce("nothing of the model is visible")
        .contains("a-00" + empty + ".png: a.glb: nothing of the model is visible in this frame");
  }

  /** A camera of the stage has in its frame what the other frames show. */
  @Test
  void theyShowTheBackground() throws IOException {
    double[] scales = {0, 0, 0, 1, 1, 1, 0, 0, 0, 1, 1, 1, 1, 1, 1};
    for (String camera : new String[] {"", "'camera': 0, "}) {
      write(camera, "scale", scales);
      assertFrames(run(""), 0, false, true, false, true);
    }
  }

  @Test
  void theyAreContinued() throws IOException {
    write("", "scale", 1, 1, 1, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1);
    assertThat(run("--labels all --ground").err())
        .contains("4 of 4 pictures written", "a-001.png: a.glb: nothing of the model is visible");
    Files.delete(directory.resolve("a-001.png"));
    Files.delete(directory.resolve("a-003.png"));
    assertThat(run("--labels all --ground --continue").err())
        .contains("2 of 4 pictures written, 2 were complete");
  }

  /** The shutter is open for half the time of a frame. */
  @Test
  void partsAppearWhileTheShutterIsOpen() throws IOException {
    write("", "scale", 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1);
    Outcome outcome = run("--shutter 1 --poses 4");
    assertThat(outcome.exitCode()).as(outcome.err()).isEqualTo(ExitCodes.OK);
    assertThat(outcome.err()).contains("4 of 4 pictures written");
  }

  @Test
  void planesMayCutAllAway() throws IOException {
    write("", "translation", 0, 0, 0, 5, 0, 0, 5, 0, 0, 0, 0, 0, 0, 0, 0);
    assertFrames(run("--section x=3"), 1, true, false, false, true);
  }

  @Test
  void oneFrameMustShowSomething() throws IOException {
    write("", "scale", 0, 0, 0, 0, 0, 0);
    run("").assertFailed(ExitCodes.ASSET, "expected at least one triangle with an area");
    write("", "translation", 0, 0, 0, 5, 0, 0);
    run("--section x=-1").assertFailed(ExitCodes.ASSET, "a plane that leaves something");
    write("", "scale", 0, 0, 0, 1, 1, 1);
    String pose = "render T/a.glb --pose 0@0.5 -o T/a.png";
    Outcome.in(directory, pose)
        .assertFailed(ExitCodes.ASSET, "expected at least one triangle with an area");
  }
}
