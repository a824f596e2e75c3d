package io.github.lumbre.scenefile;

import static io.github.lumbre.scenefile.SceneFixture.TRIANGLE;
import static io.github.lumbre.scenefile.SceneFixture.json;
import static io.github.lumbre.scenefile.SceneFixture.mesh;
import static io.github.lumbre.scenefile.SceneFixture.png;
import static io.github.lumbre.scenefile.SceneFixture.texture;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.fail;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Every mutated scene text is read, or rejected with a reason. */
class MutatedSceneTest {
  private static final int COUNT = 2000;
  private static final Pattern VALUE = Pattern.compile("(?<=: )(-?\\d+|\"[A-Za-z0-9+/=]*\"|true)");
  private static final Pattern TOKEN = Pattern.compile("[\\[\\]{},:]|\"[A-Za-z0-9]*\"");
  private static final String[] REPLACEMENTS = {
    "0",
    "-0",
    "1",
    "-1",
    "1e-320",
    "1e308",
    "-1e308",
    "1e400",
    "99999999999999999999",
    "2.5",
    "90",
    "null",
    "true",
    "{}",
    "[]",
    "\"\"",
    "\"None\"",
    "\"Image\"",
    "\"Dome\"",
    "\"Color\"",
    "\"Spherical\"",
    "\"Mesh\"",
    "[{}]",
    "{\"x\": 0}",
    "{\"r\": 1e300}",
    "NaN",
    "3",
    "4",
    "5",
    "0.25",
    "1e-9"
  };

  @TempDir private Path folder;

  private static String seedScene() {
    return json(
            """
            {'mainCameraId': 1, 'renderOptions': {'width': 20, 'height': 10, 'antialiasing': 3,
              'threads': 1, 'bucketSize': 8, 'maxTraceDepth': 3, 'mode': 'path', 'samples': 4,
              'seed': 5, 'exposure': 1, 'toneMap': 'aces', 'background': {'r': 1, 'g': 1, 'b': 0}},
             'objects': [
              {'type': 'Camera', 'id': 1, 'cameraType': 'ThinLens', 'fieldOfView': 60, 'height': 2,
               'focusDistance': 5, 'aperture': 1, 'bokehTextureId': 6, 'angle': 180},
              {'type': 'None', 'localScale': {'x': 1, 'y': 2, 'z': 1},
               'localRotation': {'x': 10, 'y': 20, 'z': 30}, 'localPosition': {'x': 1, 'y': 2},
               'children': [
                {'type': 'Shape', 'shapeType': 'Sphere', 'radius': 2, 'materialID': 2, 'id': 9},
                {'type': 'Shape', 'shapeType': 'Cube', 'width': 2, 'depth': 3, 'materialID': 3},
                {'type': 'Shape', 'shapeType': 'Plane', 'finite': true, 'width': 9,
                 'materialID': 4},
                {'type': 'Shape', 'shapeType': 'Mesh', 'meshId': 5, 'materialID': 7},
                {'type': 'Shape', 'shapeType': 'Mesh', 'meshId': 5}]},
              {'type': 'Light', 'lightType': 'Spot', 'intensity': 2, 'spotAngle': 30,
               'penumbra': 10, 'falloff': 'none'},
              {'type': 'Light', 'lightType': 'Rectangle', 'intensity': 2, 'width': 2, 'height': 3,
               'unit': 'power', 'localScale': {'x': 2, 'y': 2, 'z': 2}},
              {'type': 'Light', 'lightType': 'Sphere', 'intensity': 2, 'radius': 3,
               'unit': 'radiance', 'localScale': {'x': 2, 'y': 3, 'z': 2}},
              {'type': 'Light', 'lightType': 'Dome', 'intensity': 2, 'textureId': 6}],
             'assets': [
              {'id': 2, 'assetType': 'Material', 'materialType': 'Diffuse', 'colorTextureId': 6,
               'colorScale': {'x': 2, 'y': 2}},
              {'id': 3, 'assetType': 'Material', 'materialType': 'Refractive', 'ior': 2,
               'iorTextureId': 6, 'refractionColor': {'r': 1, 'g': 0, 'b': 1}},
              {'id': 4, 'assetType': 'Material', 'materialType': 'Reflective',
               'reflectivityColor': {'r': 1}},
              {'id': 7, 'assetType': 'Material', 'materialType': 'Color', 'color': {'r': 2}},
            """)
        + mesh(5, TRIANGLE)
        + ","
        + texture(6, png(0xffffff, 0), "")
        + "]}";
  }

  private static String mutated(String text, Random random) {
    String result = text;
    for (int n = 1 + random.nextInt(3); n > 0; n--) {
      Pattern what = random.nextInt(10) == 0 ? TOKEN : VALUE;
      List<MatchResult> places = what.matcher(result).results().toList();
      MatchResult place = places.get(random.nextInt(places.size()));
      String with = REPLACEMENTS[random.nextInt(REPLACEMENTS.length)];
      result = result.substring(0, place.start()) + with + result.substring(place.end());
    }
    return result;
  }

  @Test
  void anyTextEndsInASceneOrARefusal() throws IOException {
    String seed = seedScene();
    int scenes = 0;
    for (int i = 0; i < COUNT; i++) {
      Random random = new Random(i);
      String text = i == 0 ? seed : mutated(seed, random);
      // A new file each time, because truncating an old one is slow on some file systems.
      Path file = Files.writeString(folder.resolve(i + ".json"), text);
      try {
        new SceneParser().parse(file);
        scenes++;
      } catch (SceneFormatException e) {
        assertThat(e.problems())
            .map(Object::toString)
            .hasSizeBetween(1, 20)
            .allMatch(p -> p.matches("(?s)\\d+\\.json: (\\$[^ ]*: )?\\S.*"));
      } catch (RuntimeException | StackOverflowError e) {
        fail("seed " + i + ": " + text, e);
      }
    }
    assertThat(scenes).isBetween(COUNT / 20, COUNT * 19 / 20);
  }
}
