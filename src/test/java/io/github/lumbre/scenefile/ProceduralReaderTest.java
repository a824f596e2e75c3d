package io.github.lumbre.scenefile;

import static io.github.lumbre.scenefile.SceneFixture.json;
import static io.github.lumbre.scenefile.SceneFixture.scene;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.material.Glass;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import io.github.lumbre.scene.Primitive;
import io.github.lumbre.texture.Texture;
import io.github.lumbre.texture.TexturePoint;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the reading of procedural textures. */
class ProceduralReaderTest {
  private static final String SPHERE =
      json("{'type': 'Shape', 'shapeType': 'Sphere', 'materialID': 2}");
  private static final TexturePoint POINT = new TexturePoint(.3, .7);
  private static final String CLOUD = "'Cloud', 'width': 60, 'height': 40, 'density': 16";

  @TempDir private Path folder;
  private SceneFixture fixture;

  @BeforeEach
  void setUp() {
    fixture = new SceneFixture(folder);
  }

  private static String texture(int id, String typeAndKeys) {
    return json("{'id': " + id + ", 'assetType': 'Texture', 'textureType': " + typeAndKeys + "}");
  }

  private static String material(String keys) {
    return json("{'id': 2, 'assetType': 'Material', " + keys + "}, ");
  }

  private static String glowing(int id, String typeAndKeys) {
    return scene(
        SPHERE,
        material("'materialType': 'Color', 'colorTextureId': " + id) + texture(id, typeAndKeys));
  }

  private static Primitive only(SceneFile file) {
    assertThat(file.warnings()).isEmpty();
    assertThat(file.scene().primitives()).hasSize(1);
    return file.scene().primitives().get(0);
  }

  private static Texture<Rgb> glow(SceneFile file) {
    return only(file).emission().orElseThrow().radiance();
  }

  private Texture<Rgb> glow(int id, String typeAndKeys) {
    return glow(fixture.parse(glowing(id, typeAndKeys)));
  }

  private static void assertSame(Texture<Rgb> a, Texture<Rgb> b) {
    for (int i = 0; i < 100; i++) {
      TexturePoint p = new TexturePoint(i * .137, i * .071);
      assertThat(a.at(p)).isEqualTo(b.at(p));
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "'Wood'|'Wood', 'width': 1000, 'height': 1000, 'rings': 10",
        "'Marble'|'Marble', 'width': 1000, 'height': 1000",
        "'Cloud'|'Cloud', 'width': 1000, 'height': 1000, 'density': 128",
        "'Voronoi'|'Voronoi', 'width': 1000, 'height': 1000, 'samples': 10,"
            + " 'blackAndWhite': false",
        "'Marble'|'Marble', 'samples': 'many', 'density': 0, 'rings': -1, 'base64PNG': '?'",
        "'Wood'|'Wood', 'samples': 0, 'blackAndWhite': 3, 'file': '../x.png', 'rings': null",
      })
  void missingKeysHaveDefaultsAndForeignOnesAreSilent(String few, String many) {
    assertSame(glow(3, few), glow(3, many));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "'Wood'|'Wood', 'rings': 6.5",
        "'Wood'|'Wood', 'width': 500",
        "'Marble'|'Marble', 'height': 500.0",
        "'Cloud'|'Cloud', 'density': 77",
        "'Voronoi'|'Voronoi', 'samples': 1000000",
        "'Voronoi'|'Voronoi', 'blackAndWhite': true",
        "'Cloud'|'Cloud', 'filter': 'bilinear'",
      })
  void everyKeyCounts(String one, String other) {
    assertThat(glow(3, one).at(POINT)).isNotEqualTo(glow(3, other).at(POINT));
  }

  @Test
  void texturesOfOneSceneDifferByTheirIds() {
    assertThat(glow(3, CLOUD).at(POINT)).isNotEqualTo(glow(4, CLOUD).at(POINT));
    assertThat(glow(3, CLOUD).at(POINT)).isNotEqualTo(glow(-3, CLOUD).at(POINT));
  }

  @Test
  void theSeedThatIsUsedCounts() {
    String text = glowing(3, CLOUD);
    String seeded = text.replaceFirst("\\{", json("{'renderOptions': {'seed': 5}, "));
    SceneParser overriding = new SceneParser().overriding(s -> s.toBuilder().seed(5).build());
    Texture<Rgb> inFile = glow(fixture.parse(seeded));
    assertSame(inFile, glow(fixture.parse(overriding, text)));
    assertThat(inFile.at(POINT)).isNotEqualTo(glow(fixture.parse(text)).at(POINT));
  }

  @Test
  void seedAndIdGiveTheSameValuesOnEveryMachine() {
    assertThat(glow(3, CLOUD).at(POINT).r()).isEqualTo(.3333172997598704);
  }

  @Test
  void colorsAreTintedAndMapped() {
    Texture<Rgb> plain = glow(3, CLOUD);
    Texture<Rgb> tinted =
        glow(
            fixture.parse(
                scene(
                    SPHERE,
                    material(
                            "'materialType': 'Color', 'color': {'r': 0.5, 'g': 2, 'b': 0},"
                                + " 'colorTextureId': 3, 'colorScale': {'y': -1},"
                                + " 'colorOffset': {'x': 0.25, 'y': 1}")
                        + texture(3, CLOUD))));
    Rgb value = plain.at(new TexturePoint(.125 + .25, 1 - .375));
    assertThat(tinted.at(new TexturePoint(.125, .375)))
        .isEqualTo(new Rgb(.5 * value.r(), 2 * value.g(), 0));
  }

  @Test
  void numbersTakeTheRedComponent() {
    String glass =
        material("'materialType': 'Refractive', 'ior': 4, 'iorTextureId': 3") + texture(3, CLOUD);
    Glass made = (Glass) only(fixture.parse(scene(SPHERE, glass))).material();
    double red = glow(3, CLOUD).at(POINT).r();
    assertThat(made.ior().at(POINT)).isEqualTo(Math.max(1, 4 * red));
  }

  @ParameterizedTest
  @CsvSource({"60, 40", "4096, 64", "16384, 1"})
  void domesShowTextures(int width, int height) {
    String size = "'Cloud', 'width': " + width + ", 'height': " + height;
    String dome = json("{'type': 'Light', 'lightType': 'Dome', 'intensity': 2, 'textureId': 3}");
    EnvironmentLight light =
        (EnvironmentLight) fixture.parse(scene(dome, texture(3, size))).scene().lights().get(0);
    Texture<Rgb> sky = glow(3, size);
    // Straight ahead is the center of the texture.
    assertThat(light.from(new Vec3(0, 0, 1))).isEqualTo(sky.at(new TexturePoint(.5, .5)).times(2));
    assertThat(light.pdf(new Vec3(0, .6, .8))).isPositive();
  }

  @Test
  void masksAreWhereTexturesAreWhite() {
    String text =
        json(
                "{'mainCameraId': 1, 'objects': [{'type': 'Camera', 'id': 1, 'cameraType':"
                    + " 'ThinLens', 'aperture': 1, 'bokehTextureId': 3}], 'assets': [")
            + texture(3, "'Voronoi', 'width': 64, 'height': 64, 'blackAndWhite': true")
            + "]}";
    SceneFile file = fixture.parse(text);
    assertThat(file.warnings())
        .map(Object::toString)
        .containsExactly(
            "scene.json: $.objects[0].bokehTextureId: the mask is not black and white; values"
                + " from 0.5 up count as white");
    Texture<Rgb> mask = glow(3, "'Voronoi', 'width': 64, 'height': 64, 'blackAndWhite': true");
    SobolSampler sampler = new SobolSampler(1);
    for (int i = 0; i < 256; i++) {
      sampler.startSample(0, 0, i);
      Vec3 lens = file.scene().camera().rayFor(new Point2(.5, .5), sampler).orElseThrow().origin();
      assertThat(mask.at(new TexturePoint(lens.x() + .5, lens.y() + .5)).r())
          .isGreaterThanOrEqualTo(.5);
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "'Wood', 'width': 0|.width: expected an integer from 1 to 16384, found 0",
        "'Marble', 'width': 20000|.width: expected an integer from 1 to 16384, found 20000",
        "'Cloud', 'height': -1|.height: expected an integer from 1 to 16384, found -1",
        "'Voronoi', 'height': 8.5|.height: expected an integer from 1 to 16384, found 8.5",
        "'Cloud', 'density': 0|.density: expected a finite number >= 1, found 0",
        "'Cloud', 'density': 0.99|.density: expected a finite number >= 1, found 0.99",
        "'Cloud', 'density': '8'|.density: expected a finite number >= 1, found '8'",
        "'Wood', 'rings': -1|.rings: expected a finite number >= 0, found -1",
        "'Voronoi', 'samples': 0|.samples: expected an integer from 1 to 1000000, found 0",
        "'Voronoi', 'samples': 1000001"
            + "|.samples: expected an integer from 1 to 1000000, found 1000001",
        "'Voronoi', 'blackAndWhite': 1|.blackAndWhite: expected true or false, found 1",
        "'Clouds'|.textureType: expected one of Image, Wood, Marble, Cloud, Voronoi, found"
            + " 'Clouds'",
        "'Wood', 'filter': 'cubic'|.filter: expected one of nearest, bilinear, found 'cubic'",
      })
  void errorsSayWhereAndWhat(String texture, String message) {
    assertThat(fixture.refusal(glowing(3, texture)))
        .hasMessage("scene.json: $.assets[1]" + json(message));
  }

  @Test
  void texturesThatNobodyUsesAreNotLookedAt() {
    assertThat(fixture.parse(scene("", texture(3, "'Cloud', 'density': 0"))).warnings()).isEmpty();
  }
}
