package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Pictures of models in which a culled or transparent surface coincides with a wall: they are those
 * of the wall alone, bit for bit.
 */
class CoincidingModelsTest extends CommandFixture {
  private static final Path CASES = Path.of("src/test/resources/cases");
  private static final List<String> VIEWS = List.of("front", "back", "25,10", "-130,30");
  private static final String ONE_SIDED = "'doubleSided': false";
  private static final String FAINT = "'doubleSided': true, 'alphaMode': 'BLEND'";
  private static final String CUT = "'doubleSided': true, 'alphaMode': 'MASK'";

  private static final Quad WALL = new Quad(1, true, "'doubleSided': true", .8, 1);

  /** The pictures of walls alone, by the content of their file and the view. */
  private static final Map<String, int[]> ALONE = new HashMap<>();

  /** Renders a file and returns its picture, with alpha. */
  private int[] render(Path file, String view) {
    String flags = " -s 4 --size 48x48 --sky white --background transparent --quiet --overwrite";
    runs("render " + file + " --view=" + view + flags + " -o T/picture.png");
    return pixels("picture.png");
  }

  private static boolean isInside(int[] pixels, int i) {
    return IntStream.of(-49, -48, -47, -1, 0, 1, 47, 48, 49)
        .map(step -> i + step)
        .allMatch(k -> k >= 0 && k < pixels.length && pixels[k] >>> 24 != 0);
  }

  private void assertSamePictures(Path file, Path wall, List<String> views) throws IOException {
    for (String view : views) {
      int[] found = render(file, view);
      String key = view + " " + Files.readString(wall, StandardCharsets.ISO_8859_1);
      if (!ALONE.containsKey(key)) {
        ALONE.put(key, render(wall, view));
      }
      assertThat(found).as("%s from %s", file, view).isEqualTo(ALONE.get(key));
      int[] inside = IntStream.range(0, found.length).filter(i -> isInside(found, i)).toArray();
      assertThat(inside).hasSizeGreaterThan(200);
      assertThat(IntStream.of(inside).map(i -> found[i] >>> 24)).containsOnly(255);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"twoprims.glb", "decal_mask0.glb", "decal_mask0_o.glb"})
  void casesShowTheWallAlone(String name) throws IOException {
    Path wall = gltf("wall", List.of(WALL), true);
    List<String> views = List.of("front", "25,10");
    assertSamePictures(CASES.resolve(name), wall, views);
  }

  static Stream<Arguments> twins() {
    return Stream.of(
            List.of(WALL, new Quad(.8f, true, FAINT, .1, 0)),
            List.of(WALL, new Quad(1, false, FAINT, .1, 0)),
            List.of(WALL, new Quad(.7f, false, CUT, .1, .4)),
            List.of(WALL, new Quad(.9f, true, FAINT, .1, 0), new Quad(.6f, false, CUT, .1, 0)))
        .flatMap(quads -> Stream.of(quads, reversed(quads)))
        .flatMap(quads -> Stream.of(Arguments.of(quads, true), Arguments.of(quads, false)));
  }

  /** Each side of a card is the front of one of two surfaces. */
  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void cardsOfTwoOneSidedSurfacesShowTheFrontOfEach(boolean isOneMesh) throws IOException {
    List<Quad> sides =
        List.of(new Quad(1, true, ONE_SIDED, .8, 1), new Quad(1, false, ONE_SIDED, .8, 1));
    Path front = gltf("front", sides.subList(0, 1), true);
    Path back = gltf("back", sides.subList(1, 2), true);
    for (List<Quad> ordered : List.of(sides, reversed(sides))) {
      Path card = gltf("card", ordered, isOneMesh);
      assertSamePictures(card, front, List.of("front", "25,10"));
      assertSamePictures(card, back, List.of("back", "-130,30"));
    }
  }

  private static List<Quad> reversed(List<Quad> quads) {
    List<Quad> result = new ArrayList<>(quads);
    Collections.reverse(result);
    return result;
  }

  @ParameterizedTest
  @MethodSource("twins")
  void gltfTwinsShowTheWallAlone(List<Quad> quads, boolean isOneMesh) throws IOException {
    Path wall = gltf("wall", List.of(WALL), true);
    assertSamePictures(gltf("twins", quads, isOneMesh), wall, VIEWS);
  }

  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void objTwinsShowTheWallAlone(boolean isReversed) throws IOException {
    String colors = "newmtl wall\nKd .8 .8 .8\nnewmtl decal\nKd .1 .1 .1\nd 0\n";
    Files.writeString(directory.resolve("twins.mtl"), colors);
    String points =
        "mtllib twins.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n"
            + "v -.8 -.8 0\nv .8 -.8 0\nv .8 .8 0\nv -.8 .8 0\n";
    String wall = "usemtl wall\nf 1 2 3 4\n";
    String decal = "usemtl decal\nf 5 6 7 8\nf 1 4 3 2\n";
    Path alone = Files.writeString(directory.resolve("alone.obj"), points + wall);
    Path twins = directory.resolve("twins.obj");
    Files.writeString(twins, points + (isReversed ? decal + wall : wall + decal));
    assertSamePictures(twins, alone, VIEWS);
  }

  /**
   * A square in the plane z = 0.
   *
   * @param isFront whether its front is seen from the front
   * @param more members of its material
   */
  private record Quad(float half, boolean isFront, String more, double gray, double alpha) {
    String material() {
      return "{'pbrMetallicRoughness':{'metallicFactor':0,'baseColorFactor':[%s,%s,%s,%s]},%s}"
          .formatted(gray, gray, gray, alpha, more);
    }

    void put(ByteBuffer data) {
      for (int corner : isFront ? new int[] {0, 1, 2, 0, 2, 3} : new int[] {0, 2, 1, 0, 3, 2}) {
        data.putFloat(corner % 3 == 0 ? -half : half);
        data.putFloat(corner < 2 ? -half : half);
        data.putFloat(0);
      }
    }
  }

  /** Writes a glTF file of squares, which are primitives of one mesh or have a node each. */
  private Path gltf(String name, List<Quad> quads, boolean isOneMesh) throws IOException {
    int size = 72 * quads.size();
    ByteBuffer data = ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN);
    quads.forEach(quad -> quad.put(data));
    List<String> primitives =
        each(quads, i -> "{'attributes':{'POSITION':" + i + "},'material':" + i + "}");
    List<String> meshes = isOneMesh ? List.of(String.join(",", primitives)) : primitives;
    Map<String, List<String>> lists = new LinkedHashMap<>();
    lists.put("meshes", each(meshes, i -> "{'primitives':[" + meshes.get(i) + "]}"));
    lists.put("nodes", each(meshes, i -> "{'mesh':" + i + "}"));
    lists.put("materials", each(quads, i -> quads.get(i).material()));
    lists.put(
        "accessors",
        each(
            quads,
            i ->
                "{'bufferView':0,'byteOffset':%d,'componentType':5126,'type':'VEC3','count':6}"
                    .formatted(72 * i)));
    lists.put("bufferViews", List.of("{'buffer':0,'byteLength':" + size + "}"));
    String uri =
        "data:application/octet-stream;base64," + Base64.getEncoder().encodeToString(data.array());
    lists.put("buffers", List.of("{'byteLength':" + size + ",'uri':'" + uri + "'}"));
    String json =
        lists.entrySet().stream()
            .map(list -> ",'" + list.getKey() + "':[" + String.join(",", list.getValue()) + "]")
            .collect(Collectors.joining("", "{'asset':{'version':'2.0'}", "}"));
    return Files.writeString(directory.resolve(name + ".gltf"), json.replace('\'', '"'));
  }

  private static List<String> each(List<?> items, IntFunction<String> json) {
    return IntStream.range(0, items.size()).mapToObj(json).toList();
  }
}
