package io.github.lumbre.scenefile;

import static io.github.lumbre.scenefile.SceneFixture.json;
import static io.github.lumbre.scenefile.SceneFixture.mesh;
import static io.github.lumbre.scenefile.SceneFixture.png;
import static io.github.lumbre.scenefile.SceneFixture.scene;
import static io.github.lumbre.scenefile.SceneFixture.texture;
import static io.github.lumbre.testing.Near.assertNear;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.geometry.Box;
import io.github.lumbre.geometry.Mesh;
import io.github.lumbre.geometry.MeshInstance;
import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.Plane;
import io.github.lumbre.geometry.Rectangle;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.Emission;
import io.github.lumbre.material.CookTorrance;
import io.github.lumbre.material.Glass;
import io.github.lumbre.material.Matte;
import io.github.lumbre.material.Mirror;
import io.github.lumbre.material.Phong;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.Primitive;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.texture.ScalarTexture;
import io.github.lumbre.texture.TexturePoint;
import java.nio.file.Path;
import java.util.concurrent.atomic.LongAdder;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the reading of materials and textures. */
class MaterialReaderTest {
  private static final TexturePoint LEFT = new TexturePoint(.25, .5);
  private static final TexturePoint RIGHT = new TexturePoint(.75, .5);

  @TempDir private Path folder;
  private SceneFixture fixture;

  @BeforeEach
  void setUp() {
    fixture = new SceneFixture(folder);
  }

  private SceneFile parse(String material) {
    return fixture.parse(withMaterial(material));
  }

  private static String withMaterial(String material) {
    String assets =
        json("{'id': 2, 'assetType': 'Material', " + material + "},")
            + texture(3, png(0xff8000, 0x0080ff), "")
            + ","
            + texture(4, png(0xff8000, 0x0080ff), json(", 'filter': 'bilinear'"))
            + ","
            + texture(5, png(0x808080, 0x334455), "");
    return scene(json("{'type': 'Shape', 'shapeType': 'Sphere', 'materialID': 2}"), json(assets));
  }

  private static Primitive only(SceneFile file) {
    assertThat(file.scene().primitives()).hasSize(1);
    return file.scene().primitives().get(0);
  }

  @Test
  void texturesAreCountedAndFilteredAsTheCallerWants() {
    LongAdder lookUps = new LongAdder();
    SceneParser parser = new SceneParser().interpolatingTextures(true).counting(lookUps);
    String text = withMaterial("'materialType': 'Color', 'colorTextureId': 3");
    Emission emission = only(fixture.parse(parser, text)).emission().orElseThrow();
    long before = lookUps.sum();
    // Halfway between two texels, the picture's own filter would return one of them.
    assertNear(
        emission.radiance().at(new TexturePoint(.5, .5)),
        new Rgb(.5, .21586050011389926, .5),
        1e-12);
    assertThat(lookUps.sum()).isEqualTo(before + 1);
    assertThat(fixture.parse(text).scene().primitives()).hasSize(1);
    assertThat(lookUps.sum()).isEqualTo(before + 1);
  }

  @Test
  void surfacesWithoutMaterialAreGray() {
    assertThat(only(parse("'materialType': 'None'")).material()).isSameAs(Matte.GRAY);
    assertThat(only(parse("'materialType': 'Diffuse'")).material()).isInstanceOf(Matte.class);
  }

  @Test
  void coloredSurfacesGlowFromEverySide() {
    SceneFile file = parse("'materialType': 'Color', 'color': {'r': 3, 'g': 2, 'b': 0.5}");
    Emission emission = only(file).emission().orElseThrow();
    assertThat(emission.twoSided()).isTrue();
    assertThat(emission.radiance().at(LEFT)).isEqualTo(new Rgb(3, 2, .5));
    assertThat(file.scene().lights()).isEmpty();
    assertThat(file.scene().emitters()).hasSize(1);
    assertThat(file.warnings()).isEmpty();
  }

  @Test
  void channelsAreConstantTimesTextureOfLinearLight() {
    Emission emission =
        only(parse("'materialType': 'Color', 'color': {'r': 2}, 'colorTextureId': 3"))
            .emission()
            .orElseThrow();
    // sRGB 128 is 0.2158605 in linear RGB.
    assertNear(emission.radiance().at(LEFT), new Rgb(2, .21586050011389926, 0), 1e-12);
    assertNear(emission.radiance().at(RIGHT), new Rgb(0, .21586050011389926, 1), 1e-12);
  }

  @Test
  void channelsMapTheirTextures() {
    Emission emission =
        only(parse(
                "'materialType': 'Color', 'colorTextureId': 3, 'colorOffset': {'x': 0.5},"
                    + " 'colorScale': {'x': 2}"))
            .emission()
            .orElseThrow();
    assertThat(emission.radiance().at(new TexturePoint(.1, 0)).b()).isEqualTo(1);
    assertThat(emission.radiance().at(new TexturePoint(.3, 0)).r()).isEqualTo(1);
  }

  @Test
  void texturesMayBeFiltered() {
    Emission emission =
        only(parse("'materialType': 'Color', 'colorTextureId': 4")).emission().orElseThrow();
    assertNear(
        emission.radiance().at(new TexturePoint(.5, .5)),
        new Rgb(.5, .21586050011389926, .5),
        1e-12);
  }

  @Test
  void mirrorsReflectNoMoreThanTheyGet() {
    SceneFile file =
        parse("'materialType': 'Reflective', 'reflectivityColor': {'r': 1.5, 'g': 0.5, 'b': 1}");
    assertThat(((Mirror) only(file).material()).reflectance().at(LEFT))
        .isEqualTo(new Rgb(1, .5, 1));
    assertThat(file.warnings())
        .map(Object::toString)
        .containsExactly(
            "scene.json: $.assets[0].reflectivityColor: the reflectance exceeds 1; it is"
                + " clamped to 1");
  }

  @ParameterizedTest
  @CsvSource({
    "Diffuse, color",
    "Phong, color",
    "Phong, specularColor",
    "CookTorrance, color",
    "CookTorrance, specularColor",
    "Reflective, reflectivityColor",
    "Refractive, refractionColor",
    "MetallicRoughness, baseColor",
    "MetallicRoughness, sheenColor"
  })
  void aWrongColorIsReportedOnce(String type, String key) {
    String material = "'materialType': '" + type + "', '" + key + "': {'r': -1}";
    assertThat(fixture.refusal(withMaterial(material)).problems())
        .map(Object::toString)
        .containsExactly(
            "scene.json: $.assets[0]." + key + ".r: expected a finite number >= 0, found -1");
  }

  @Test
  void glassWarnsOnceHoweverManyOfItsColorsExceedOne() {
    SceneFile file =
        parse(
            "'materialType': 'Refractive', 'ior': 1.5, 'refractionColor': {'r': 2},"
                + " 'reflectivityColor': {'r': 2}");
    Glass glass = (Glass) only(file).material();
    assertThat(glass.ior().at(LEFT)).isEqualTo(1.5);
    assertThat(glass.transmittance().at(LEFT)).isEqualTo(Rgb.WHITE);
    assertThat(file.warnings()).hasSize(1);
  }

  @Test
  void texturedIorIsDataAndAtLeastOne() {
    SceneFile file = parse("'materialType': 'Refractive', 'ior': 2, 'iorTextureId': 3");
    Glass glass = (Glass) only(file).material();
    assertThat(glass.ior().at(LEFT)).isEqualTo(2);
    assertThat(glass.ior().at(RIGHT)).isEqualTo(1);
  }

  @Test
  void texturesOfNumbersAreTakenAsTheyAre() {
    SceneFile rough =
        parse("'materialType': 'CookTorrance', 'roughness': 0.5, 'roughnessTextureId': 5");
    ScalarTexture roughness = ((CookTorrance) only(rough).material()).roughness();
    assertThat(roughness.at(LEFT)).isEqualTo(.5 * (128 / 255.0));
    assertThat(roughness.at(RIGHT)).isEqualTo(.5 * (51 / 255.0));
    SceneFile sharp = parse("'materialType': 'Phong', 'exponent': 100, 'exponentTextureId': 5");
    ScalarTexture exponent = ((Phong) only(sharp).material()).exponent();
    assertThat(exponent.at(LEFT)).isEqualTo(100 * (128 / 255.0));
  }

  @Test
  void roughMaterialsMayScatterRepeatedly() {
    String rough = "'materialType': 'Refractive', 'roughness': 0.5, 'multipleScattering': ";
    assertThat(((Glass) only(parse(rough + true)).material()).multipleScattering()).isTrue();
    assertThat(((Glass) only(parse(rough + false)).material()).multipleScattering()).isFalse();
    assertThat(parse(rough + true).warnings()).isEmpty();
    SceneFile metal =
        parse(
            "'materialType': 'CookTorrance', 'color': {'r': 0, 'g': 0, 'b': 0},"
                + " 'distribution': 'ggx', 'multipleScattering': true");
    assertThat(((CookTorrance) only(metal).material()).multipleScattering()).isTrue();
    assertThat(metal.warnings()).isEmpty();
  }

  @Test
  void beckmannFacetsDoNotScatterRepeatedly() {
    String material = "'materialType': 'CookTorrance', 'multipleScattering': true";
    assertThat(fixture.refusal(withMaterial(material)))
        .hasMessageContaining(
            "$.assets[0].multipleScattering: expected false with the distribution beckmann, found"
                + " true; add \"distribution\": \"ggx\"");
  }

  private Scene shapes(String objects, String assets) {
    return fixture.parse(scene(json(objects), assets)).scene();
  }

  private static Shape shape(Scene scene, int number) {
    return scene.primitives().get(number).shape();
  }

  private static void assertReaches(Shape shape, Vec3 min, Vec3 max) {
    Bounds3 bounds = shape.bounds();
    assertThat(bounds.min().minus(min).length()).isLessThan(1e-12);
    assertThat(bounds.max().minus(max).length()).isLessThan(1e-12);
  }

  @Test
  void shapesHaveTheirTypesAndSizes() {
    Scene scene =
        shapes(
            "{'type': 'Shape', 'shapeType': 'Sphere', 'radius': 2, 'localPosition': {'x': 1}},"
                + "{'type': 'Shape', 'shapeType': 'Plane', 'finite': true, 'width': 2,"
                + " 'height': 6},"
                + "{'type': 'Shape', 'shapeType': 'Cube', 'width': 2, 'height': 4, 'depth': 6},"
                + "{'type': 'Shape', 'shapeType': 'Plane'}",
            "");
    assertThat(shape(scene, 0)).isInstanceOf(Sphere.class);
    assertReaches(shape(scene, 0), new Vec3(-1, -2, -2), new Vec3(3, 2, 2));
    assertThat(shape(scene, 1)).isInstanceOf(Rectangle.class);
    assertReaches(shape(scene, 1), new Vec3(-1, 0, -3), new Vec3(1, 0, 3));
    assertThat(shape(scene, 2)).isInstanceOf(Box.class);
    assertReaches(shape(scene, 2), new Vec3(-1, -2, -3), new Vec3(1, 2, 3));
    assertThat(shape(scene, 3)).isInstanceOf(Plane.class);
  }

  @Test
  void planesAreSeenFromAboveOnlyUnlessTheyAreSolid() {
    Ray up = new Ray(new Vec3(0, -1, 0), Vec3.Y);
    String plane = "{'type': 'Shape', 'shapeType': 'Plane'";
    assertThat(shapes(plane + "}", "").intersect(up, new NearestHit())).isFalse();
    assertThat(shapes(plane + ", 'twoSided': true}", "").intersect(up, new NearestHit())).isTrue();
    assertThat(
            shapes(plane + ", 'finite': true, 'twoSided': true}", "")
                .intersect(up, new NearestHit()))
        .isTrue();
  }

  @Test
  void meshesAreBakedWhenPlacedOnceAndSharedWhenPlacedOften() {
    String one =
        "{'type': 'Shape', 'shapeType': 'Mesh', 'meshId': 2, 'localPosition': {'x': 5},"
            + " 'localScale': {'y': 3}}";
    String asset = mesh(2, SceneFixture.TRIANGLE);
    Scene once = shapes(one, asset);
    assertThat(shape(once, 0)).isInstanceOf(Mesh.class);
    Scene twice = shapes(one + ", {'type': 'Shape', 'shapeType': 'Mesh', 'meshId': 2}", asset);
    assertThat(shape(twice, 0)).isInstanceOf(MeshInstance.class);
    assertThat(shape(twice, 1)).isInstanceOf(MeshInstance.class);
    for (Scene scene : new Scene[] {once, twice}) {
      assertReaches(shape(scene, 0), new Vec3(5, 0, 0), new Vec3(6, 3, 0));
    }
  }
}
