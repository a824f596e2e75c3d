package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.output.ExitCodes;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Without --size, a picture has the aspect ratio of the model's camera. */
class CameraAspectTest {
  private static final String SECOND =
      "{\"type\": \"perspective\", \"perspective\": {\"yfov\": 0.6, \"znear\": 0.1}}]";

  @TempDir private Path folder;

  /** The scene is 4:3, and so is a model whose camera states no aspect ratio. */
  @Test
  void oneNumberIsTheLongerSide() throws IOException {
    ModelSample.write(folder);
    TinyScene.write(folder, TinyScene.JSON);
    for (String scene : List.of("tiny.json", "sample.glb")) {
      String line = "render T/" + scene + " --size 24 -s 1 --no-denoise --overwrite -o T/o.png";
      assertThat(Outcome.in(folder, line).err()).contains("o.png: 24x18 pixels");
    }
    Outcome.in(folder, "render T/tiny.json --size 8 --crop 0,0,8,7 -o T/o.png --overwrite")
        .assertFailed(ExitCodes.USAGE, "--crop: expected a part of 8x6, found 0,0,8,7");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "perspective | {'yfov': 0.6, 'znear': 0.1, 'aspectRatio': 1.7777777} |  | 1024x576",
        "perspective | {'yfov': 0.6, 'znear': 0.1, 'aspectRatio': 0.5} |  | 512x1024",
        "perspective | {'yfov': 0.6, 'znear': 0.1, 'aspectRatio': 1} |  | 1024x1024",
        "perspective | {'yfov': 0.6, 'znear': 0.1, 'aspectRatio': 1e-9} |  | 1x1024",
        "perspective | {'yfov': 0.6, 'znear': 0.1, 'aspectRatio': 1e9} |  | 1024x1",
        "perspective | {'yfov': 0.6, 'znear': 0.1} |  | 1024x768",
        "orthographic | {'xmag': 2, 'ymag': 1, 'znear': 0, 'zfar': 9} |  | 1024x512",
        "orthographic | {'xmag': 1, 'ymag': 2, 'znear': 0, 'zfar': 9} |  | 512x1024",
        "perspective | {'yfov': 0.6, 'znear': 0.1, 'aspectRatio': 2} | --camera last | 1024x512",
        "perspective | {'yfov': 0.6, 'znear': 0.1, 'aspectRatio': 2} | --camera close | 1024x768",
        "perspective | {'yfov': 0.6, 'znear': 0.1, 'aspectRatio': 2} | --view front | 1024x768"
      })
  void itIsThatOfTheCamera(String type, String lens, String flags, String size) throws IOException {
    String camera = "{'name': 'last', 'type': '%s', '%1$s': %s}]".formatted(type, lens);
    boolean isNamed = flags != null;
    Path model =
        isNamed
            ? ModelSample.writeWith(folder, SECOND, camera.replace('\'', '"'))
            : ModelSample.writeWith(
                folder,
                "{\"name\": \"close\", \"type\": \"perspective\", \"perspective\": {\"yfov\": 0.6,"
                    + " \"znear\": 0.1}}",
                camera.replace('\'', '"').replace("]", ""));
    List<String> command = new ArrayList<>(List.of("check", model.toString()));
    command.addAll(isNamed ? List.of(flags.split(" ")) : List.of());
    Outcome outcome = Outcome.of(command.toArray(String[]::new));
    assertThat(outcome.out()).as(outcome.err()).contains("size       " + size + " pixels");
  }
}
