package io.github.lumbre.scenefile;

import static io.github.lumbre.scenefile.SceneFixture.json;
import static io.github.lumbre.scenefile.SceneFixture.png;
import static io.github.lumbre.scenefile.SceneFixture.scene;
import static io.github.lumbre.scenefile.SceneFixture.texture;
import static io.github.lumbre.testing.Near.assertNear;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.AreaLight;
import io.github.lumbre.light.DirectionalLight;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.light.Falloff;
import io.github.lumbre.light.Light;
import io.github.lumbre.light.LightSample;
import io.github.lumbre.light.PointLight;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.format.ies.IesSamples;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.texture.TexturePoint;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the reading of lights. */
class LightReaderTest {
  private static final String GLASS =
      json("{'id': 4, 'assetType': 'Material', 'materialType': 'Refractive'}");

  @TempDir private Path folder;
  private SceneFixture fixture;

  @BeforeEach
  void setUp() {
    fixture = new SceneFixture(folder);
  }

  private SceneFile parse(String light) {
    return fixture.parse(scene(json("{'type': 'Light', " + light + "}"), ""));
  }

  private Light light(String light) {
    SceneFile file = parse(light);
    assertThat(file.warnings()).isEmpty();
    assertThat(file.scene().lights()).hasSize(1);
    return file.scene().lights().get(0);
  }

  @Test
  void directionalLightShinesAlongZ() {
    DirectionalLight found =
        (DirectionalLight)
            light(
                "'lightType': 'Directional', 'intensity': 2, 'color': {'r': 1, 'g': 0.5, 'b': 0},"
                    + " 'localRotation': {'x': 90}, 'localScale': {'z': 7}");
    assertNear(found.direction(), new Vec3(0, -1, 0), 1e-14);
    assertThat(found.irradiance()).isEqualTo(new Rgb(2, 1, 0));
  }

  @Test
  void pointLightStandsWhereItsObjectDoes() {
    assertThat(
            light(
                "'lightType': 'Point', 'intensity': 3, 'localPosition': {'x': 1, 'y': 2, 'z': 3}"))
        .isEqualTo(new PointLight(new Vec3(1, 2, 3), Rgb.gray(3), Falloff.NONE));
    assertThat(light("'lightType': 'Point', 'intensity': 3, 'falloff': 'inverseSquare'"))
        .isEqualTo(new PointLight(Vec3.ZERO, Rgb.gray(3), Falloff.INVERSE_SQUARE));
  }

  private static double spotAt(Light spot, double degrees) {
    double angle = StrictMath.toRadians(degrees);
    return spot.sample(
            new Vec3(StrictMath.sin(angle), 0, StrictMath.cos(angle)), new Point2(.5, .5))
        .map(LightSample::radiance)
        .orElse(Rgb.BLACK)
        .r();
  }

  @Test
  void spotAngleIsHalfTheConeAndThePenumbraLiesInside() {
    Light sharp = light("'lightType': 'Spot', 'intensity': 3");
    assertThat(spotAt(sharp, 59.99)).isEqualTo(3);
    assertThat(spotAt(sharp, 60.01)).isZero();
    Light soft = light("'lightType': 'Spot', 'intensity': 3, 'spotAngle': 40, 'penumbra': 20");
    assertThat(spotAt(soft, 19.99)).isEqualTo(3);
    assertThat(spotAt(soft, 30)).isCloseTo(1.5, within(1e-12));
    assertThat(spotAt(soft, 40.01)).isZero();
  }

  @ParameterizedTest
  @CsvSource({
    "120, 90, 120 is treated as 90",
    "-30, 30, -30 is treated as 30",
    "-95.5, 90, -95.5 is treated as 90"
  })
  void unusualSpotAnglesActAsOthersWithAWarning(double written, double acts, String warning) {
    SceneFile file = parse("'lightType': 'Spot', 'intensity': 1, 'spotAngle': " + written);
    assertThat(file.warnings())
        .map(Object::toString)
        .containsExactly("scene.json: $.objects[1].spotAngle: " + warning);
    Light spot = file.scene().lights().get(0);
    assertThat(spotAt(spot, acts - .01)).isEqualTo(1);
    assertThat(spotAt(spot, acts + .01)).isZero();
  }

  @Test
  void ambientLightAddsUp() {
    String one = json("{'type': 'Light', 'lightType': 'Ambient', 'intensity': 0.25}");
    SceneFile file = fixture.parse(scene(one + "," + one, ""));
    assertThat(file.scene().ambient()).isEqualTo(Rgb.gray(.5));
    assertThat(file.parsed().contents().lights()).isEqualTo(2);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "'lightType': 'Rectangle', 'width': 2, 'height': 3|0.6666666666666666",
        "'lightType': 'Rectangle', 'width': 0.5, 'height': 0.5|4",
        "'lightType': 'Rectangle', 'width': 2, 'height': 3, 'localScale': {'x': 9}"
            + "|0.6666666666666666",
        "'lightType': 'Rectangle', 'width': 2, 'height': 3, 'unit': 'radiance'|4",
        "'lightType': 'Rectangle', 'width': 2, 'height': 3, 'unit': 'power',"
            + " 'localScale': {'x': 4, 'y': 5, 'z': 6}|0.01061032953945969",
        "'lightType': 'Sphere'|0.3183098861837907",
        "'lightType': 'Sphere', 'radius': 0.1|4",
        "'lightType': 'Sphere', 'radius': 2, 'unit': 'radiance'|4",
        "'lightType': 'Sphere', 'radius': 0.5, 'unit': 'power',"
            + " 'localScale': {'x': 4, 'y': 4, 'z': 4}|0.025330295910584444"
      })
  void areaLightsHaveTheRadianceOfTheirUnit(String lamp, double radiance) {
    AreaLight found = (AreaLight) light(lamp + ", 'intensity': 4");
    assertThat(found.emission().twoSided()).isFalse();
    assertThat(found.emission().radiance().at(new TexturePoint(0, 0)).g())
        .isCloseTo(radiance, within(1e-12 * radiance));
  }

  private static boolean isHit(Scene scene, Vec3 origin, Vec3 direction) {
    return scene.intersect(new Ray(origin, direction), new NearestHit());
  }

  private void writeLamp(String text) throws IOException {
    Files.write(folder.resolve("lamp.ies"), IesSamples.bytes(text));
  }

  @Test
  void pointLightMayHaveTheProfileOfALamp() throws IOException {
    writeLamp(IesSamples.OLD);
    Light lamp = light("'lightType': 'Point', 'profile': 'lamp.ies', 'localRotation': {'x': 90}");
    // It shines down, with 25 cd at 0 degrees, 20 at 90 and 15 at 180, at distance 2.
    double[] expected = {25, 20, 15};
    for (int i = 0; i < 3; i++) {
      Vec3 point = new Vec3(0, 2 * (i - 1), i == 1 ? 2 : 0);
      assertThat(lamp.sample(point, new Point2(.5, .5)).orElseThrow().radiance().r())
          .isCloseTo(expected[i] / 4, within(1e-14));
    }
    Light half =
        light("'lightType': 'Point', 'profile': 'lamp.ies', 'intensity': 0.5, 'color': {'g': 0}");
    assertNear(
        half.sample(new Vec3(0, 0, 1), new Point2(.5, .5)).orElseThrow().radiance(),
        new Rgb(12.5, 0, 12.5),
        1e-14);
  }

  @Test
  void filesOfProfilesAreFilesOfTheScene() throws IOException, SceneFormatException {
    writeLamp(IesSamples.OLD);
    String lamp = json("{'type': 'Light', 'lightType': 'Point', 'profile': 'lamp.ies'}");
    String two = scene(lamp + ", " + lamp, "");
    SceneFile file = fixture.parse(two);
    assertThat(file.scene().lights()).hasSize(2);
    assertThat(file.parsed().files().assets()).containsOnlyKeys("lamp.ies");
    assertThat(SceneParser.files(folder.resolve("scene.json")))
        .containsExactly(folder.toRealPath().resolve("lamp.ies"));
    // The file is read once.
    SceneParser limited =
        new SceneParser().limitedTo(Limits.NONE.withBytes(two.length() + IesSamples.OLD.length()));
    assertThat(fixture.parse(limited, two).scene().lights()).hasSize(2);
    String before = file.hash();
    writeLamp(IesSamples.OLD.replace("100", "101"));
    assertThat(fixture.parse(two).hash()).isNotEqualTo(before);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "| 'falloff': 'none' | .falloff: expected \"inverseSquare\", which profiles need, found"
            + " \"none\"",
        "60 | x | .profile: lamp.ies: line 10: expected a finite number, found \"x\"",
        "100, | -1 | .profile: lamp.ies: line 9: expected candelas of at least 0, found \"-1\"",
        "| 'profile': 'none.ies' | .profile: expected a file, found none at \"none.ies\"",
        "| 'profile': '../lamp.ies' | .profile: expected a relative path inside the scene's folder,"
            + " found \"../lamp.ies\"",
        "| 'profile': 3 | .profile: expected a string, found 3"
      })
  void profilesThatCannotBeUsedAreErrors(String from, String to, String message)
      throws IOException {
    writeLamp(from == null ? IesSamples.OLD : IesSamples.OLD.replace(from, to));
    String keys = from != null ? "" : ", " + to;
    String profile = to.contains("profile") ? "" : ", 'profile': 'lamp.ies'";
    String lamp = json("{'type': 'Light', 'lightType': 'Point'" + profile + keys + "}");
    assertThat(fixture.refusal(scene(lamp, "")).problems())
        .map(Object::toString)
        .containsExactly("scene.json: $.objects[1]" + message);
  }

  @Test
  void warningsOfProfilesNameTheFile() throws IOException {
    writeLamp(IesSamples.FULL);
    assertThat(parse("'lightType': 'Point', 'profile': 'lamp.ies'").warnings())
        .map(Object::toString)
        .containsExactly(
            "scene.json: $.objects[1].profile: lamp.ies: line 5: the tilts are ignored, so that a"
                + " tilted lamp is as bright as an upright one, found TILT=\"INCLUDE\"");
    assertThat(parse("'lightType': 'Spot', 'profile': 'lamp.ies'").warnings())
        .map(Object::toString)
        .containsExactly(
            "scene.json: $.objects[1].profile: is ignored, because only Point lights have one");
  }

  @Test
  void rectangleLightLiesInXyAndShinesAlongZ() {
    Scene scene =
        parse("'lightType': 'Rectangle', 'width': 2, 'height': 6, 'intensity': 1").scene();
    Vec3 back = Vec3.Z.negated();
    assertThat(isHit(scene, new Vec3(.9, 2.9, 5), back)).isTrue();
    assertThat(isHit(scene, new Vec3(1.1, 0, 5), back)).isFalse();
    assertThat(isHit(scene, new Vec3(0, 3.1, 5), back)).isFalse();
    assertThat(isHit(scene, new Vec3(0, 0, -5), Vec3.Z)).isFalse();
    Ray ray = new Ray(new Vec3(0, 0, 5), back);
    NearestHit hit = new NearestHit();
    assertThat(scene.intersect(ray, hit)).isTrue();
    assertNear(scene.surfaceAt(hit).geometricNormal(), Vec3.Z, 1e-14);
    assertThat(scene.primitiveAt(hit).emission()).isPresent();
  }

  @Test
  void domeShowsItsImageTurned() {
    // Longitudes from -180° to 180° in four columns: +z lies between the second and third.
    String dome =
        json(
            "{'type': 'Light', 'lightType': 'Dome', 'intensity': 2, 'textureId': 5,"
                + " 'localScale': {'x': -1}, 'localRotation': {'y': 90}}");
    byte[] image = png(0xff0000, 0x00ff00, 0x0000ff, 0xffffff);
    Scene scene = fixture.parse(scene(dome, texture(5, image, ""))).scene();
    // Without rotation, the four columns from longitude -180° on are red, green, blue and white.
    Vec3 littleLeft = new Vec3(-.1, 0, 1).normalized();
    Vec3 turned = new Vec3(littleLeft.z(), 0, -littleLeft.x());
    assertNear(scene.background(turned), new Rgb(0, 2, 0), 1e-14);
    Vec3 littleRight = new Vec3(.1, 0, 1).normalized();
    assertNear(
        scene.background(new Vec3(littleRight.z(), 0, -littleRight.x())), new Rgb(0, 0, 2), 1e-14);
  }

  @Test
  void domesAddUp() {
    String one = json("{'type': 'Light', 'lightType': 'Dome', 'intensity': 0.25}");
    Scene scene = fixture.parse(scene(one + "," + one, "")).scene();
    assertThat(scene.background(Vec3.X)).isEqualTo(Rgb.gray(.5));
    assertThat(scene.lights()).hasSize(2).allMatch(EnvironmentLight.class::isInstance);
  }

  @Test
  void backgroundLightsUnlessThereIsADome() {
    String options = json(", 'renderOptions': {'background': {'r': 0.5, 'g': 0.25, 'b': 0}}}");
    String plain = scene("", "");
    SceneFile alone = fixture.parse(plain.substring(0, plain.length() - 1) + options);
    assertThat(alone.scene().background(Vec3.X)).isEqualTo(new Rgb(.5, .25, 0));
    assertThat(alone.scene().lights()).isEmpty();
    String dome = scene(json("{'type': 'Light', 'lightType': 'Dome', 'intensity': 1}"), "");
    SceneFile both = fixture.parse(dome.substring(0, dome.length() - 1) + options);
    assertThat(both.scene().background(Vec3.X)).isEqualTo(Rgb.WHITE);
    assertThat(both.warnings())
        .map(Object::toString)
        .containsExactly(
            "scene.json: $.renderOptions.background: is ignored, because the scene has a Dome");
  }

  @ParameterizedTest
  @CsvSource({"Directional", "Point", "Spot", "Ambient", "Rectangle", "Sphere", "Dome"})
  void lightsThatEmitNothingAreWarnedOf(String type) {
    SceneFile file = parse("'lightType': '" + type + "'");
    assertThat(file.warnings())
        .map(Object::toString)
        .containsExactly("scene.json: $.objects[1].intensity: the light emits nothing");
    assertThat(file.scene().lights()).isEmpty();
  }

  @Test
  void glassAndLightsOfNoSizeAreWarnedOfOnce() {
    String glass = json("{'type': 'Shape', 'shapeType': 'Sphere', 'materialID': 4}");
    String point = json("{'type': 'Light', 'lightType': 'Point', 'intensity': 1}");
    String dome = json("{'type': 'Light', 'lightType': 'Dome', 'intensity': 1}");
    assertThat(fixture.parse(scene(point + "," + point + "," + glass, GLASS)).warnings())
        .map(Object::toString)
        .containsExactly(
            "scene.json: $.objects[1].lightType: the scene has glass, which blocks light"
                + " from Directional, Point and Spot lights");
    assertThat(fixture.parse(scene(dome + "," + glass, GLASS)).warnings()).isEmpty();
    assertThat(fixture.parse(scene(point, GLASS)).warnings()).isEmpty();
  }
}
