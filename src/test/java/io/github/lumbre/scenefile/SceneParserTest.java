package io.github.lumbre.scenefile;

import static io.github.lumbre.scenefile.SceneFixture.TRIANGLE;
import static io.github.lumbre.scenefile.SceneFixture.json;
import static io.github.lumbre.scenefile.SceneFixture.mesh;
import static io.github.lumbre.scenefile.SceneFixture.png;
import static io.github.lumbre.scenefile.SceneFixture.scene;
import static io.github.lumbre.scenefile.SceneFixture.texture;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Mode;
import io.github.lumbre.scenefile.SceneFormatException.Kind;
import io.github.lumbre.scenefile.internal.SceneContents;
import io.github.lumbre.testing.Pictures;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Arrays;
import java.util.Base64;
import java.util.HexFormat;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the reading of whole scenes, their files and their errors. */
class SceneParserTest {
  private static final String SPHERE = json("{'type': 'Shape', 'shapeType': 'Sphere'}");

  @TempDir private Path folder;
  private SceneFixture fixture;

  @BeforeEach
  void setUp() {
    fixture = new SceneFixture(folder);
  }

  @Test
  void smallestSceneIsACamera() {
    SceneFile file = fixture.parse(scene("", ""));
    assertThat(file.scene().primitives()).isEmpty();
    assertThat(file.settings()).isEqualTo(RenderSettings.DEFAULT);
    assertThat(file.warnings()).isEmpty();
    assertThat(file.parsed().contents())
        .isEqualTo(new SceneContents("Pinhole", 0, 0, 0, 0, 0, 0, 0));
  }

  @Test
  void missingFilesAreInvalidScenes() {
    SceneFormatException refusal =
        catchThrowableOfType(
            SceneFormatException.class, () -> new SceneParser().parse(folder.resolve("no.json")));
    String path = folder.resolve("no.json").toString();
    assertThat(refusal).hasMessage("no.json: expected a scene file, found none at \"" + path + '"');
    assertThat(refusal.kind()).isEqualTo(Kind.INVALID);
  }

  @Test
  void foldersCannotBeRead() {
    assertThatThrownBy(() -> new SceneParser().parse(folder)).isInstanceOf(IOException.class);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "``|expected an object, found an empty file",
        "[]|expected an object, found an array",
        "{}|$.mainCameraId: expected the id of a camera, found nothing; none exists",
        "{'mainCameraId': null}"
            + "|$.mainCameraId: expected the id of a camera, found nothing; none exists",
        "{'mainCameraId': '1'}|$.mainCameraId: expected an integer, found '1'",
        "{'mainCameraId': 7, 'objects': [{'type': 'Camera', 'id': 9}, {'id': 7, 'children':"
            + " [{'type': 'Camera', 'id': 3}]}]}"
            + "|$.mainCameraId: expected the id of a camera, found 7; existing ids: 3, 9",
      })
  void sceneMustBeSeenByACamera(String text, String message) {
    SceneFormatException refusal = fixture.refusal(json(text));
    assertThat(refusal).hasMessage("scene.json: " + json(message));
    assertThat(refusal.kind()).isEqualTo(Kind.INVALID);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "'type': 'Shape', 'shapeType': 'Sphere', 'radius': -1"
            + "|.radius: expected a finite number > 0, found -1",
        "'type': 'Shape', 'shapeType': 'Sphere', 'radius': 1e400"
            + "|.radius: expected a finite number, found 1e400",
        "'type': 'Shape', 'shapeType': 'Cube', 'depth': 0"
            + "|.depth: expected a finite number > 0, found 0",
        "'type': 'Shape', 'shapeType': 'Plane', 'finite': true, 'height': 1e200"
            + "|.height: expected a number <= 1e150, found 1e200",
        "'type': 'Shape', 'shapeType': 'Plane', 'finite': 'true'"
            + "|.finite: expected true or false, found 'true'",
        "'type': 'Shape', 'shapeType': 'Ball'"
            + "|.shapeType: expected one of Sphere, Plane, Cube, Mesh, found 'Ball'",
        "'type': 'Shape'" + "|.shapeType: expected one of Sphere, Plane, Cube, Mesh, found nothing",
        "'type': 'Thing'|.type: expected one of None, Camera, Shape, Model, Light, found 'Thing'",
        "'type': 'Light', 'intensity': 1, 'lightType': 'Sun'"
            + "|.lightType: expected one of Directional, Point, Spot, Ambient, Rectangle, Sphere,"
            + " Dome, found 'Sun'",
        "'type': 'Light', 'lightType': 'Point', 'intensity': -1"
            + "|.intensity: expected a finite number >= 0, found -1",
        "'type': 'Light', 'lightType': 'Point', 'intensity': 1e300, 'color': {'r': 1e300}"
            + "|.intensity: expected a finite product with the color, found an infinite one",
        "'type': 'Light', 'lightType': 'Spot', 'intensity': 1, 'spotAngle': 0"
            + "|.spotAngle: expected an angle other than 0, found 0",
        "'type': 'Light', 'lightType': 'Spot', 'intensity': 1, 'penumbra': 61"
            + "|.penumbra: expected a number from 0 to 60, found 61",
        "'localScale': {'x': 0}"
            + "|: singular transform: combined with those of its parents, it has no finite inverse",
        "'localScale': {'x': 0, 'y': 0, 'z': 0}"
            + "|: singular transform: combined with those of its parents, it has no finite inverse",
        "'type': 'Shape', 'shapeType': 'Sphere', 'radius': 1e308"
            + "|.radius: expected a number <= 1e150, found 1e308",
        "'localPosition': {'x': 1e300}, 'type': 'Shape', 'shapeType': 'Sphere'"
            + "|: expected a shape within 1e150 of the origin, found one that extends beyond",
        "'localPosition': [1, 2, 3]|.localPosition: expected an object such as"
            + " {'x': 1, 'y': 2, 'z': 3}, found an array",
        "'children': {}|.children: expected an array, found an object",
        "'type': 'Shape', 'shapeType': 'Sphere', 'materialID': 99"
            + "|.materialID: expected the id of a Material, found 99; existing ids: 2, 5",
        "'type': 'Shape', 'shapeType': 'Sphere', 'materialID': 4"
            + "|.materialID: expected the id of a Material, found 4; existing ids: 2, 5",
        "'type': 'Shape', 'shapeType': 'Mesh', 'meshId': 2"
            + "|.meshId: expected the id of a Mesh, found 2; none exists",
        "'type': 'Light', 'lightType': 'Dome', 'intensity': 1, 'textureId': 3"
            + "|.textureId: expected the id of a Texture, found 3; existing id: 4",
        "'id': 1|.id: expected the main camera's id once, found 1 again",
      })
  void errorsInObjectsSayWhereAndWhat(String object, String message) {
    String assets =
        json(
            "{'id': 5, 'assetType': 'Material', 'materialType': 'None'},"
                + "{'id': 2, 'assetType': 'Material', 'materialType': 'None'},"
                + "{'id': 4, 'assetType': 'Texture'}");
    String quoted = message.contains("camera's") ? message : json(message);
    assertThat(fixture.refusal(scene(json("{" + object + "}"), assets)))
        .hasMessage("scene.json: $.objects[1]" + quoted);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "{'id': 1, 'assetType': 'Thing'}"
            + "|[0].assetType: expected one of Material, Texture, Mesh, found 'Thing'",
        "{'id': 1}|[0].assetType: expected one of Material, Texture, Mesh, found nothing",
        "{'assetType': 'Mesh'}|[0].id: expected an integer, found nothing",
        "{'id': 1.5, 'assetType': 'Mesh'}|[0].id: expected an integer, found 1.5",
        "{'id': 1, 'assetType': 'Mesh'}, {'id': 1, 'assetType': 'Texture'}"
            + "|[1].id: expected each id once, found 1, also at $.assets[0].id",
        "3|[0]: expected an object, found 3"
      })
  void errorsInAssetsSayWhereAndWhat(String assets, String message) {
    assertThat(fixture.refusal(scene("", json(assets))))
        .hasMessage("scene.json: $.assets" + json(message));
  }

  @Test
  void everyErrorIsToldUpToTwenty() {
    String bad = json("{'type': 'Shape', 'shapeType': 'Sphere', 'radius': 0}");
    assertThat(fixture.refusal(scene(bad + "," + bad, "")).problems())
        .map(Object::toString)
        .containsExactly(
            "scene.json: $.objects[1].radius: expected a finite number > 0, found 0",
            "scene.json: $.objects[2].radius: expected a finite number > 0, found 0");
    assertThat(fixture.refusal(scene((bad + ",").repeat(30) + bad, "")).problems()).hasSize(20);
  }

  @Test
  void lenientParsersWarnOfDanglingReferences() {
    String objects =
        json(
            "{'type': 'Shape', 'shapeType': 'Sphere', 'materialID': 99},"
                + "{'type': 'Shape', 'shapeType': 'Mesh', 'meshId': 98}");
    assertThat(fixture.refusal(scene(objects, "")).problems()).hasSize(2);
    SceneFile file = fixture.parse(new SceneParser().lenient(), scene(objects, ""));
    assertThat(file.scene().primitives()).hasSize(1);
    assertThat(file.warnings())
        .map(Object::toString)
        .containsExactly(
            "scene.json: $.objects[2].meshId: expected the id of a Mesh, found 98; none exists",
            "scene.json: $.objects[1].materialID: expected the id of a Material, found 99;"
                + " none exists",
            "scene.json: $.objects[2].meshId: names no mesh; the object is not rendered");
  }

  @Test
  void minusOneAndNullReferToNothing() {
    String objects =
        json(
            "{'type': 'Shape', 'shapeType': 'Sphere', 'materialID': -1},"
                + "{'type': 'Shape', 'shapeType': 'Sphere', 'materialID': null}");
    SceneFile file = fixture.parse(scene(objects, ""));
    assertThat(file.scene().primitives()).hasSize(2);
    assertThat(file.warnings()).isEmpty();
  }

  @Test
  void duplicateObjectIdsAreWarnedOf() {
    SceneFile file = fixture.parse(scene(json("{'id': 5}, {'children': [{'id': 5}]}"), ""));
    assertThat(file.warnings())
        .map(Object::toString)
        .containsExactly(
            "scene.json: $.objects[2].children[0].id: object id 5 is also at $.objects[1].id");
  }

  @Test
  void onlyKeysThatNobodyKnowsAreWarnedOf() {
    String objects =
        json(
            "{'type': 'Shape', 'shapeType': 'Sphere', 'name': 'a', 'width': 3, 'raduis': 2},"
                + "{'type': 'Camera', 'cameraType': 'FishEye', 'fieldOfView': 60, 'radius': 1},"
                + "{'shapeType': 'Sphere', 'localPosition': {'w': 1}}");
    String assets =
        json(
            "{'id': 1, 'assetType': 'Texture', 'textureType': 'Marble', 'samples': 3,"
                + " 'base64PNG': ''},"
                + "{'id': 2, 'assetType': 'Material', 'materialType': 'Phong',"
                + " 'distribution': 'ggx', 'normalStrenght': 1}");
    assertThat(fixture.parse(scene(objects, assets)).warnings())
        .map(Object::toString)
        .containsExactlyInAnyOrder(
            "scene.json: $.objects[1].raduis: unknown key; did you mean radius?",
            "scene.json: $.objects[2].radius: unknown key",
            "scene.json: $.objects[3].shapeType: unknown key",
            "scene.json: $.objects[3].localPosition.w: unknown key; did you mean x?",
            "scene.json: $.assets[1].normalStrenght: unknown key; did you mean normalStrength?");
  }

  @Test
  void twoThousandObjectsWithinEachOtherAreFineAndMoreAreNot() {
    assertThat(fixture.parse(nested(2000)).scene().primitives()).hasSize(1);
    SceneFormatException refusal = fixture.refusal(nested(2001));
    assertThat(refusal.kind()).isEqualTo(Kind.LIMIT);
    assertThat(refusal).hasMessageEndingWith("expected at most 2000 nested objects, found more");
    assertThat(fixture.refusal(nested(100_000)).kind()).isEqualTo(Kind.LIMIT);
  }

  private static String nested(int depth) {
    return scene("{\"children\": [".repeat(depth - 1) + SPHERE + "]}".repeat(depth - 1), "");
  }

  @Test
  void chosenModeAndChangesComeBeforeTheFile() {
    String text =
        json("{'mainCameraId': 1, 'renderOptions': {'mode': 'path', 'antialiasing': 3},")
            + json("'objects': [{'type': 'Camera', 'id': 1}]}");
    SceneFile file =
        fixture.parse(
            new SceneParser()
                .inMode(Mode.RAY)
                .overriding(s -> s.toBuilder().size(s.samples(), 8).build()),
            text);
    assertThat(file.settings().mode()).isEqualTo(Mode.RAY);
    assertThat(file.settings().width()).isEqualTo(16);
    assertThat(file.settings().height()).isEqualTo(8);
  }

  @Test
  void errorsOfTheCallersChangesAreTheCallers() {
    SceneParser parser = new SceneParser().overriding(s -> s.toBuilder().samples(0).build());
    Path file = fixture.write(scene("", ""));
    assertThatThrownBy(() -> parser.parse(file))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith("samples");
  }

  @Test
  void picturesAreLimitedInAllTheirPixels() {
    String text =
        json("{'mainCameraId': 1, 'renderOptions': {'width': 65535, 'height': 4097},")
            + json("'objects': [{'type': 'Camera', 'id': 1}]}");
    SceneFormatException refusal = fixture.refusal(text);
    assertThat(refusal.kind()).isEqualTo(Kind.LIMIT);
    assertThat(refusal)
        .hasMessage(
            "scene.json: $.renderOptions: expected width x height <= 268435456, found 65535x4097");
    assertThat(
            fixture
                .parse(new SceneParser().overriding(s -> s.toBuilder().size(10, 10).build()), text)
                .settings()
                .width())
        .isEqualTo(10);
  }

  @Test
  void hashCoversTheSceneAndItsFiles() throws IOException, NoSuchAlgorithmException {
    Files.writeString(folder.resolve("a.obj"), TRIANGLE);
    Files.writeString(folder.resolve("unused.obj"), "nonsense");
    String text =
        scene(
            json("{'type': 'Shape', 'shapeType': 'Mesh', 'meshId': 2}"),
            json(
                "{'id': 3, 'assetType': 'Mesh', 'file': 'unused.obj'},"
                    + "{'id': 2, 'assetType': 'Mesh', 'file': 'a.obj'}"));
    MessageDigest digest = MessageDigest.getInstance("SHA-256");
    digest.update(text.getBytes(StandardCharsets.UTF_8));
    digest.update(TRIANGLE.getBytes(StandardCharsets.UTF_8));
    assertThat(fixture.parse(text).hash()).isEqualTo(HexFormat.of().formatHex(digest.digest()));
  }

  @Test
  void unusedAssetsAreNotDecoded() throws IOException {
    Files.writeString(folder.resolve("unused.obj"), "nonsense");
    Files.writeString(folder.resolve("unused.png"), "nonsense");
    String text =
        scene(
            "",
            json(
                "{'id': 2, 'assetType': 'Mesh', 'file': 'unused.obj'},"
                    + "{'id': 3, 'assetType': 'Texture', 'file': 'unused.png'}"));
    assertThat(fixture.parse(text).parsed().origins().unused()).hasSize(2);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "../a.obj",
        "/etc/passwd",
        "http://example.org/a.obj",
        "file:a.obj",
        "sub/../../a.obj",
        "\\\\\\\\host\\\\a.obj",
        "C:\\\\a.obj",
        "",
        "\\u0000"
      })
  void filesOutsideTheFolderAreOutOfReach(String name) throws IOException {
    Path inside = Files.createDirectory(folder.resolve("inside"));
    Files.writeString(folder.resolve("a.obj"), TRIANGLE);
    Files.createDirectory(inside.resolve("sub"));
    SceneFormatException refusal = new SceneFixture(inside).refusal(sceneWithMeshFile(name));
    assertThat(refusal.kind()).isEqualTo(Kind.INVALID);
    assertThat(refusal)
        .hasMessageStartingWith(
            "scene.json: $.assets[0].file: expected a relative path inside the scene's folder,"
                + " found \"");
  }

  @ParameterizedTest
  @ValueSource(strings = {"sub/a.obj", "./sub/../sub/a.obj", "link/a.obj"})
  void filesInsideTheFolderAreRead(String name) throws IOException {
    Path sub = Files.createDirectory(folder.resolve("sub"));
    Files.createSymbolicLink(folder.resolve("link"), sub);
    Files.writeString(sub.resolve("a.obj"), TRIANGLE);
    assertThat(fixture.parse(sceneWithMeshFile(name)).parsed().contents().triangles())
        .isEqualTo(1);
  }

  @Test
  void filesThatAreMissingAreAssetsThatCannotBeDecoded() {
    SceneFormatException refusal = fixture.refusal(sceneWithMeshFile("no.obj"));
    assertThat(refusal.kind()).isEqualTo(Kind.ASSET);
    assertThat(refusal)
        .hasMessage("scene.json: $.assets[0].file: expected a file, found none at \"no.obj\"");
  }

  private static String sceneWithMeshFile(String name) {
    return scene(
        json("{'type': 'Shape', 'shapeType': 'Mesh', 'meshId': 2}"),
        json("{'id': 2, 'assetType': 'Mesh', 'file': '") + name + "\"}");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "QUJDR|expected base64, found truncated text",
        "''|expected base64, found truncated text",
        "QU%D|expected base64, found invalid characters",
        "QÜJD|expected base64, found invalid characters",
        "Zg==|line 1: expected at least 3 corners per face, found 0"
      })
  void assetsThatCannotBeDecodedAreTold(String base64, String message) {
    SceneFormatException refusal =
        fixture.refusal(
            scene(
                json("{'type': 'Shape', 'shapeType': 'Mesh', 'meshId': 2}"),
                json("{'id': 2, 'assetType': 'Mesh', 'base64OBJ': '" + base64 + "'}")));
    assertThat(refusal).hasMessage("scene.json: $.assets[0].base64OBJ: " + message);
    assertThat(refusal.kind()).isEqualTo(Kind.ASSET);
  }

  @Test
  void base64MayHaveLineBreaks() {
    String lines =
        Base64.getMimeEncoder(8, new byte[] {'\r', '\n'})
            .encodeToString(TRIANGLE.getBytes(StandardCharsets.UTF_8))
            .replace("\r\n", "\\r\\n");
    assertThat(lines).contains("\\r\\n");
    SceneFile file =
        fixture.parse(
            scene(
                json("{'type': 'Shape', 'shapeType': 'Mesh', 'meshId': 2}"),
                json("{'id': 2, 'assetType': 'Mesh', 'base64OBJ': '" + lines + "'}")));
    assertThat(file.parsed().contents().triangles()).isEqualTo(1);
  }

  @Test
  void meshesThatLackAssetsDataAreTold() {
    SceneFormatException refusal =
        fixture.refusal(
            scene(
                json("{'type': 'Shape', 'shapeType': 'Mesh', 'meshId': 2}"),
                json("{'id': 2, 'assetType': 'Mesh'}")));
    assertThat(refusal.kind()).isEqualTo(Kind.INVALID);
    assertThat(refusal)
        .hasMessage("scene.json: $.assets[0].base64OBJ: expected base64OBJ or file, found neither");
  }

  @Test
  void picturesThatLieAboutTheirSizeAreRefusedWithoutBeingDecoded() {
    byte[] lying = png(0xffffff);
    lying[16] = 0x7f;
    SceneFormatException refusal = fixture.refusal(sceneWithTexture(lying));
    assertThat(refusal.kind()).isIn(Kind.ASSET, Kind.LIMIT);
    assertThat(refusal).hasMessageStartingWith("scene.json: $.assets[0].base64PNG: ");
    byte[] large = png(0xffffff);
    large[18] = 0x20;
    assertThat(fixture.refusal(sceneWithTexture(large)).kind()).isIn(Kind.ASSET, Kind.LIMIT);
  }

  @Test
  void picturesThatEndEarlyAreRefused() {
    byte[] whole = png(0xffffff, 0, 0x123456);
    byte[] half = Arrays.copyOf(whole, whole.length / 2);
    SceneFormatException refusal = fixture.refusal(sceneWithTexture(half));
    assertThat(refusal.kind()).isEqualTo(Kind.ASSET);
    assertThat(refusal).hasMessageStartingWith("scene.json: $.assets[0].base64PNG: ");
  }

  private static String sceneWithTexture(byte[] picture) {
    return scene(
        json("{'type': 'Shape', 'shapeType': 'Sphere', 'materialID': 3}"),
        texture(2, picture, "")
            + ","
            + json(
                "{'id': 3, 'assetType': 'Material', 'materialType': 'Diffuse',"
                    + " 'colorTextureId': 2}"));
  }

  @Test
  void assetsNobodyUsesAreNotDecoded() {
    String assets =
        json(
            "{'id': 2, 'assetType': 'Mesh', 'base64OBJ': '!'},"
                + "{'id': 3, 'assetType': 'Texture', 'base64PNG': '!'},"
                + "{'id': 4, 'assetType': 'Material', 'materialType': 'CookTorrance'},"
                + "{'id': 5, 'assetType': 'Texture', 'textureType': 'Wood', 'width': -1}");
    assertThat(fixture.parse(scene(SPHERE, assets)).warnings()).isEmpty();
  }

  @Test
  void pictureOfFewBytesAndManyTexelsIsSuspicious() {
    byte[] bomb =
        Pictures.file(new BufferedImage(1024, 1024, BufferedImage.TYPE_BYTE_BINARY), "png");
    String objects = json("{'type': 'Shape', 'shapeType': 'Sphere', 'materialID': 3}");
    String assets =
        texture(5, bomb, "")
            + json(",{'id': 3, 'assetType': 'Material', 'materialType': 'Diffuse',")
            + json(" 'colorTextureId': 5}");
    assertThat(fixture.parse(scene(objects, assets)).warnings())
        .map(Object::toString)
        .containsExactly(
            "scene.json: $.assets[0].base64PNG: "
                + bomb.length
                + " bytes decode to 1024x1024 pixels");
  }

  @Test
  void contentsCountWhatIsUsed() {
    String objects =
        json(
            "{'type': 'Shape', 'shapeType': 'Mesh', 'meshId': 2, 'materialID': 3},"
                + "{'type': 'Shape', 'shapeType': 'Mesh', 'meshId': 2, 'materialID': 3},"
                + "{'type': 'Shape', 'shapeType': 'Cube', 'materialID': 4},"
                + "{'type': 'Light', 'lightType': 'Ambient', 'intensity': 1}");
    String assets =
        mesh(2, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 1 1\n")
            + ","
            + texture(5, png(0xff0000), "")
            + json(
                ",{'id': 3, 'assetType': 'Material', 'materialType': 'Diffuse',"
                    + " 'colorTextureId': 5},"
                    + "{'id': 4, 'assetType': 'Material', 'materialType': 'None'},"
                    + "{'id': 6, 'assetType': 'Material', 'materialType': 'None'}");
    SceneFile file = fixture.parse(scene(objects, assets));
    assertThat(file.parsed().contents())
        .isEqualTo(new SceneContents("Pinhole", 3, 1, 4, 0, 1, 2, 1));
    assertThat(file.warnings())
        .map(Object::toString)
        .containsExactly("scene.json: $.assets[0].base64OBJ: dropped triangles of zero area: 1");
    assertThat(file.scene().primitives()).hasSize(3);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "'materialType': 'Velvet'|.materialType: expected one of Diffuse, Color, AreaLight,"
            + " Reflective, Refractive, None, Phong, CookTorrance, ShadowCatcher,"
            + " MetallicRoughness, found 'Velvet'",
        "'materialType': 'Phong', 'exponent': -1"
            + "|.exponent: expected a finite number >= 0, found -1",
        "'materialType': 'CookTorrance', 'roughness': 1.5"
            + "|.roughness: expected a number from 0 to 1, found 1.5",
        "'materialType': 'CookTorrance', 'distribution': 'phong'"
            + "|.distribution: expected one of beckmann, ggx, found 'phong'",
        "'materialType': 'Diffuse', 'normalTextureId': 7"
            + "|.normalTextureId: expected the id of a Texture, found 7; existing id: 3",
        "'materialType': 'Refractive', 'ior': 0"
            + "|.ior: expected a number in (0, 1000000], found 0",
        "'materialType': 'Refractive', 'ior': -1.5"
            + "|.ior: expected a number in (0, 1000000], found -1.5",
        "'materialType': 'Refractive', 'roughness': 2"
            + "|.roughness: expected a number from 0 to 1, found 2",
        "'materialType': 'Diffuse', 'colorTextureId': 9"
            + "|.colorTextureId: expected the id of a Texture, found 9; existing id: 3",
        "'materialType': 'Diffuse', 'colorScale': 2"
            + "|.colorScale: expected an object such as {'x': 1, 'y': 1, 'z': 1}, found 2",
      })
  void errorsInMaterialsInUseSayWhereAndWhat(String material, String message) {
    String assets =
        json("{'id': 2, 'assetType': 'Material', " + material + "},")
            + texture(3, png(0xffffff), "");
    assertThat(
            fixture.refusal(
                scene(json("{'type': 'Shape', 'shapeType': 'Sphere', 'materialID': 2}"), assets)))
        .hasMessage("scene.json: $.assets[0]" + json(message));
  }
}
