package io.github.lumbre.model.format.threemf;

import static io.github.lumbre.material.MaterialParameter.BASE_COLOR;
import static io.github.lumbre.material.MaterialParameter.OPACITY;
import static io.github.lumbre.testing.Refusals.assertCancelled;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.internal.Srgb;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelFixture;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelMaterial;
import io.github.lumbre.model.internal.ModelMaterial.AlphaMode;
import io.github.lumbre.model.internal.ModelPart;
import io.github.lumbre.model.internal.ModelTexture;
import io.github.lumbre.model.internal.ModelTexture.Wrap;
import io.github.lumbre.model.internal.PlainModel;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the reading of 3MF files. */
class ThreeMfReaderTest {
  private static final byte[] PNG = Pixels.of(1, 1, 3, new byte[] {1, 2, 3}).toPng();

  private static final String BASE =
      "<basematerials id=\"2\"><base name=\"Red\" displaycolor=\"#FF0000\"/>"
          + "<base name=\"Glass\" displaycolor=\"#00FF0080\"/></basematerials>";

  private static final String COLORS =
      "<m:colorgroup id=\"3\"><m:color color=\"#FF0000\"/><m:color color=\"#00ff00FF\"/>"
          + "<m:color color=\"#0000FF80\"/></m:colorgroup>";

  private static final String TEXTURE =
      "<m:texture2d id=\"4\" path=\"/3D/Textures/A.png\" contenttype=\"image/png\""
          + " tilestyleu=\"mirror\" tilestylev=\"clamp\" filter=\"nearest\"/>"
          + "<m:texture2dgroup id=\"5\" texid=\"4\"><m:tex2coord u=\"0\" v=\"0.25\"/>"
          + "<m:tex2coord u=\"1\" v=\"1\"/></m:texture2dgroup>";

  private static String object(String attributes, String first, String second) {
    return "<object id=\"1\" " + attributes + ">" + mesh(first, second) + "</object>";
  }

  private static String mesh(String first, String second) {
    return ThreeMfSample.MESH.formatted(" " + first, " " + second);
  }

  private static Model read(String resources) throws ModelFormatException {
    return ThreeMfSample.of(resources).fixture().read();
  }

  private static Model read(String resources, String items) throws ModelFormatException {
    return ThreeMfSample.of(resources, items).fixture().read();
  }

  private static void assertNear(Vec3 found, double x, double y, double z) {
    assertThat(found.minus(new Vec3(x, y, z)).length()).isCloseTo(0, within(1e-12));
  }

  @Test
  void meshIsInMetersWithZUp() throws ModelFormatException {
    Model model = read(object("name=\"A &amp; B\"", "", ""));
    assertThat(model.warnings()).isEmpty();
    ModelPart part = model.parts().get(0);
    assertThat(part.name()).isEqualTo("A & B");
    assertThat(part.location()).isEqualTo("3D/root.model object 1");
    assertThat(part.geometry().positions()).containsExactly(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0);
    assertThat(part.geometry().indices()).containsExactly(0, 1, 2, 0, 2, 3);
    assertThat(part.material().input(BASE_COLOR).factor()).isEqualTo(Rgb.gray(PlainModel.ALBEDO));
    assertNear(ModelFixture.mapped(part, 1000, 2000, 3000), 1, 3, -2);
  }

  @Test
  void wrongColorsAreLightGray() throws ModelFormatException {
    String model =
        ThreeMfSample.model(COLORS + object("", "pid=\"3\"", ""), "<item objectid=\"1\"/>");
    Model read = new ThreeMfSample(model.replace("#FF0000", "#FF00")).fixture().read();
    float gray = (float) PlainModel.ALBEDO;
    assertThat(read.parts().get(0).geometry().colors()).startsWith(gray, gray, gray, 1);
    assertThat(read.warnings())
        .containsExactly(
            "3D/root.model line 8: expected a color such as #FF8000 in color, found \"#FF00\";"
                + " light gray is used");
  }

  /** PrusaSlicer and its descendants paint triangles with attributes of their own. */
  @ParameterizedTest
  @ValueSource(strings = {"slic3rpe:mmu_segmentation", "paint_color"})
  void paintOfSlicersGivesOneWarning(String attribute) throws ModelFormatException {
    String object = "<object id=\"1\">" + ThreeMfSample.MESH + "</object>";
    String paint = " " + attribute + "=\"4\"";
    assertThat(read(object.formatted(paint, paint)).warnings())
        .containsExactly(
            "3D/root.model line 10: left out the colors of triangles painted in a slicer: 2");
    String other = " " + attribute + "=\"\"";
    assertThat(read(object.formatted(other, " paint_seam=\"4\"")).warnings()).isEmpty();
  }

  @ParameterizedTest
  @CsvSource({
    "micron, 0.000001",
    "millimeter, 0.001",
    "centimeter, 0.01",
    "inch, 0.0254",
    "foot, 0.3048",
    "meter, 1"
  })
  void unitsAreConverted(String unit, double meters) throws ModelFormatException {
    String model =
        ThreeMfSample.model(object("", "", ""), "<item objectid=\"1\"/>")
            .replace("unit=\"millimeter\"", "unit=\"" + unit + "\"");
    ModelPart part = new ThreeMfSample(model).fixture().part();
    assertNear(ModelFixture.mapped(part, 1, 0, 0), meters, 0, 0);
    assertThat(new ThreeMfSample(model).fixture().read().unit()).isEqualTo(unit);
    assertNear(ModelFixture.mapped(part, 0, 0, 1), 0, meters, 0);
  }

  @Test
  void optionsCorrectTheUnitAndTheAxis() throws ModelFormatException {
    ThreeMfSample sample = ThreeMfSample.of(object("", "", ""));
    ModelOptions inch = ModelOptions.DEFAULT.oriented(Optional.empty(), OptionalDouble.of(.0254));
    Model model = sample.fixture().with(inch).read();
    assertThat(model.unit()).isEqualTo("inch");
    assertNear(ModelFixture.mapped(model.parts().get(0), 1, 2, 3), .0254, .0762, -.0508);
    assertNear(model.fromFile().point(new Vec3(1, 2, 3)), .0254, .0762, -.0508);
    ModelOptions lying =
        ModelOptions.DEFAULT.oriented(Optional.of(ModelOptions.Up.Y), OptionalDouble.empty());
    model = sample.fixture().with(lying).read();
    assertThat(model.unit()).isEqualTo("millimeter");
    assertNear(ModelFixture.mapped(model.parts().get(0), 1, 2, 3), .001, .002, .003);
  }

  @Test
  void transformsHaveTheImagesOfAxesAsRows() throws ModelFormatException {
    String components =
        "<object id=\"2\"><components><component objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1"
            + " 10 20 30\"/><component objectid=\"1\"/></components></object>";
    String item = "<item objectid=\"2\" transform=\"0 2 0 -2 0 0 0 0 2 1000 0 0\"/>";
    Model model = read(object("", "", "") + components, item);
    assertThat(model.parts()).hasSize(2);
    ModelPart moved = model.parts().get(0);
    // (1, 2, 3) is moved to (11, 22, 33), then turned and doubled to (-44, 22, 66), then moved.
    assertNear(ModelFixture.mapped(moved, 1, 2, 3), .956, .066, -.022);
    assertThat(model.parts().get(1).geometry()).isSameAs(moved.geometry());
  }

  @Test
  void itemsAndComponentsAreParts() throws ModelFormatException {
    String lid =
        "<object id=\"2\" name=\"lid\"><components><component objectid=\"1\"/></components>"
            + "</object>";
    String items = "<item objectid=\"2\"/><item objectid=\"1\"/><item objectid=\"1\"/>";
    Model model = read(object("name=\"plate\"", "", "") + lid, items);
    assertThat(model.parts()).extracting(ModelPart::name).containsOnly("plate").hasSize(3);
    assertThat(model.parts().stream().map(ModelPart::node).distinct()).hasSize(3);
    assertThat(model.parts())
        .extracting(part -> part.node().matches("lid"::equals))
        .containsExactly(true, false, false);
  }

  @Test
  void colorsOfCornersAreInterpolated() throws ModelFormatException {
    Model model =
        read(COLORS + object("pid=\"3\" pindex=\"1\"", "pid=\"3\" p1=\"0\" p2=\"1\" p3=\"2\"", ""));
    ModelPart part = model.parts().get(0);
    ModelGeometry mesh = part.geometry();
    assertThat(mesh.indices()).containsExactly(0, 1, 2, 3, 4, 5);
    float half = (float) (128 / 255.);
    assertThat(mesh.colors())
        .startsWith(1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, half)
        .endsWith(0, 1, 0, 1, 0, 1, 0, 1);
    assertThat(part.material().alphaMode()).isEqualTo(AlphaMode.BLEND);
  }

  @Test
  void colorsAreEncoded() throws ModelFormatException {
    String gray = COLORS.replace("#FF0000", "#808080");
    ModelGeometry mesh = read(gray + object("pid=\"3\"", "", "")).parts().get(0).geometry();
    assertThat(mesh.colors()[0]).isEqualTo((float) Srgb.decode(128 / 255.));
  }

  @Test
  void eachBaseMaterialIsAPart() throws ModelFormatException {
    Model model =
        read(BASE + object("pid=\"2\" pindex=\"0\"", "", "pid=\"2\" p1=\"1\" p2=\"0\" p3=\"0\""));
    assertThat(model.parts()).hasSize(2);
    ModelMaterial red = model.parts().get(0).material();
    assertThat(red.name()).isEqualTo("Red");
    assertThat(red.input(BASE_COLOR).factor()).isEqualTo(new Rgb(1, 0, 0));
    assertThat(red.alphaMode()).isEqualTo(AlphaMode.OPAQUE);
    ModelMaterial glass = model.parts().get(1).material();
    assertThat(glass.input(OPACITY).number()).isEqualTo(128 / 255.);
    assertThat(glass.alphaMode()).isEqualTo(AlphaMode.BLEND);
    assertThat(model.parts().get(1).geometry().vertexCount()).isEqualTo(3);
  }

  @Test
  void trianglesWithAPropertyAndNoGroupUseTheObjects() throws ModelFormatException {
    Model model = read(BASE + object("pid=\"2\" pindex=\"1\"", "p1=\"0\"", ""));
    assertThat(model.parts()).extracting(p -> p.material().name()).containsExactly("Red", "Glass");
  }

  @Test
  void texturesHaveCoordinatesFromTheLowerEdge() throws ModelFormatException {
    String resources = TEXTURE + object("pid=\"5\"", "pid=\"5\" p1=\"0\" p2=\"1\" p3=\"1\"", "");
    Model model = ThreeMfSample.of(resources).with("3D/textures/a.png", PNG).fixture().read();
    assertThat(model.warnings()).isEmpty();
    ModelPart part = model.parts().get(0);
    assertThat(part.geometry().uv0()).startsWith(0, .25, 1, 1, 1, 1, 0, .25);
    ModelTexture texture = part.material().input(BASE_COLOR).texture().orElseThrow();
    assertThat(texture.image().encoded()).isEqualTo(PNG);
    assertThat(texture.wrapU()).isEqualTo(Wrap.MIRROR);
    assertThat(texture.wrapV()).isEqualTo(Wrap.CLAMP);
    assertThat(texture.nearest()).isTrue();
  }

  @Test
  void missingPicturesAreLeftOut() throws ModelFormatException {
    Model model = read(TEXTURE + object("pid=\"5\"", "", ""));
    assertThat(model.parts().get(0).material().input(BASE_COLOR).texture()).isEmpty();
    assertThat(model.warnings())
        .containsExactly(
            "3D/root.model line 8: expected a part of the archive, found no \"3D/Textures/A.png\";"
                + " the picture is left out");
  }

  @Test
  void compositesAreMixedInLinearLight() throws ModelFormatException {
    String composites =
        "<m:compositematerials id=\"6\" matid=\"2\" matindices=\"0 1\"><m:composite"
            + " values=\"1 0.25\"/></m:compositematerials>";
    Model model = read(BASE + composites + object("pid=\"6\"", "", ""));
    assertThat(model.parts().get(0).geometry().colors()).startsWith(.8f, .2f, 0);
    assertThat(model.warnings())
        .containsExactly("3D/root.model line 8: composite materials are shown as mixed colors");
  }

  @ParameterizedTest
  @CsvSource({"-1 x, 0, 0", "2 NaN, 1, 0"})
  void wrongSharesOfCompositesAreReplaced(String values, int first, int second)
      throws ModelFormatException {
    String composites =
        "<m:compositematerials id=\"6\" matid=\"2\" matindices=\"0 1\"><m:composite values=\"%s\"/>"
            + "</m:compositematerials>";
    Model model = read(BASE + composites.formatted(values) + object("pid=\"6\"", "", ""));
    Model same =
        read(BASE + composites.formatted(first + " " + second) + object("pid=\"6\"", "", ""));
    assertThat(model.parts().get(0).geometry().colors())
        .isEqualTo(same.parts().get(0).geometry().colors());
    String wrong =
        "3D/root.model line 8: expected shares from 0 to 1 in values, found \"%s\"; %d is used";
    assertThat(model.warnings())
        .contains(
            wrong.formatted(values.split(" ")[0], first),
            wrong.formatted(values.split(" ")[1], second))
        .hasSize(3);
  }

  @Test
  void topLayerIsShown() throws ModelFormatException {
    String layers =
        "<m:multiproperties id=\"7\" pids=\"2 3\"><m:multi pindices=\"1\"/>"
            + "<m:multi pindices=\"0 1\"/></m:multiproperties>";
    Model model = read(BASE + COLORS + layers + object("pid=\"7\" pindex=\"1\"", "", ""));
    assertThat(model.parts().get(0).geometry().colors()).startsWith(0, 1, 0, 1);
    assertThat(model.warnings())
        .containsExactly(
            "3D/root.model line 8: of several layers of properties, the top one is shown");
  }

  /** As in samples of the 3MF consortium. */
  @Test
  void prefixesOfPropertiesMayBeMissing() throws ModelFormatException {
    String layers =
        "<m:multiproperties id=\"7\" pids=\"2 3\"><multi pindices=\"1\"/>"
            + "<multi pindices=\"0 1\"/></m:multiproperties>";
    String mixed =
        "<compositematerials id=\"6\" matid=\"2\" matindices=\"0 1\"><composite"
            + " values=\"1 0.25\"/></compositematerials>";
    String colors = COLORS.replace("<m:", "<").replace("</m:", "</");
    Model model = read(BASE + colors + layers + object("pid=\"7\" pindex=\"1\"", "", ""));
    assertThat(model.parts().get(0).geometry().colors()).startsWith(0, 1, 0, 1);
    model = read(BASE + mixed + object("pid=\"6\"", "", ""));
    assertThat(model.parts().get(0).geometry().colors()).startsWith(.8f, .2f, 0);
  }

  @Test
  void partsOfTheProductionExtensionAreRead() throws ModelFormatException {
    String other = ThreeMfSample.model(BASE + object("pid=\"2\"", "", ""), "");
    String root =
        "<object id=\"8\" name=\"Whole\"><components><component p:path=\"/3D/Objects/o.model\""
            + " objectid=\"1\"/></components></object>";
    Model model =
        ThreeMfSample.of(
                root,
                "<item objectid=\"8\"/><item p:path=\"/3D/Objects/o.model\"" + " objectid=\"1\"/>")
            .with("3D/Objects/o.model", other)
            .fixture()
            .read();
    assertThat(model.parts()).extracting(ModelPart::name).containsExactly("Whole", "");
    assertThat(model.parts().get(0).location()).isEqualTo("3D/Objects/o.model object 1");
    assertThat(model.parts().get(0).geometry()).isSameAs(model.parts().get(1).geometry());
  }

  @ParameterizedTest
  @CsvSource({"support", "solidsupport", "other"})
  void whatIsNotTheModelIsLeftOut(String type) throws ModelFormatException {
    String support = "<object id=\"9\" type=\"" + type + "\">" + mesh("", "") + "</object>";
    Model model =
        read(object("", "", "") + support, "<item objectid=\"1\"/><item objectid=\"9\"/>");
    assertThat(model.parts()).hasSize(1);
    assertThat(model.warnings())
        .containsExactly("3D/root.model object 9: an object of type " + type + " is left out");
  }

  @Test
  void whatIsNotReadIsReportedOnce() throws ModelFormatException {
    String more =
        "<x:thing/><x:other><x:deep/></x:other><m:pbmetallicdisplayproperties id=\"9\"/>"
            + "<object id=\"2\"><mesh><vertices/><triangles/><b:beamlattice/></mesh></object>";
    Model model = read(object("pid=\"77\"", "", "") + more);
    assertThat(model.warnings())
        .containsExactly(
            "3D/root.model line 12: elements of the extension http://example.com/x are left out",
            "3D/root.model line 12: pbmetallicdisplayproperties has no effect on the picture",
            "3D/root.model line 12: beam lattices are left out",
            "3D/root.model line 10: ignored properties of groups that are not known: 2");
  }

  @Test
  void brokenAndFlatTrianglesAreLeftOut() throws ModelFormatException {
    String mesh =
        mesh("", "")
            .replace("</triangles>", "<triangle v1=\"0\" v2=\"0\" v3=\"1\"/></triangles>")
            .replace("<vertex x=\"0\" y=\"1\"", "<vertex x=\"NaN\" y=\"1\"");
    Model model = read("<object id=\"1\">" + mesh + "</object>");
    assertThat(model.parts().get(0).geometry().indices()).containsExactly(0, 1, 2);
    assertThat(model.parts().get(0).geometry().positions()).endsWith(0, 1, 0);
    assertThat(model.warnings())
        .containsExactly(
            "3D/root.model line 10: left out faces with a vertex that is not a finite number: 1",
            "3D/root.model line 10: dropped triangles of zero area: 1");
  }

  @Test
  void singularTransformsAreLeftOut() throws ModelFormatException {
    String items =
        "<item objectid=\"1\"/><item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 0 0 0 0\"/>";
    assertThat(read(object("", "", ""), items).warnings())
        .containsExactly(
            "3D/root.model line 13: its transform is not invertible; its content is left out");
  }

  /** Each transform is invertible, and their product is to a human eye; its determinant is 0. */
  @Test
  void partsWhoseDeterminantVanishesAreRefused() throws ModelFormatException {
    String tiny = "transform=\"1e-60 0 0 0 1e-60 0 0 0 1e-60 0 0 0\"";
    String component =
        "<object id=\"2\"><components><component objectid=\"1\" %s/></components></object>"
            .formatted(tiny);
    String item = "<item objectid=\"2\" " + tiny + "/>";
    assertThat(ThreeMfSample.of(object("", "", "") + component, item).fixture().refusal())
        .startsWith("MALFORMED 3D/root.model object 1: expected an invertible transform, found");
  }

  @Test
  void requiredExtensionsAreKnown() throws ModelFormatException {
    String model = ThreeMfSample.model(object("", "", ""), "<item objectid=\"1\"/>");
    String known = model.replace("unit=", "requiredextensions=\"p m b\" unit=");
    assertThat(new ThreeMfSample(known).fixture().read().warnings()).isEmpty();
    String unknown = model.replace("unit=", "requiredextensions=\"p x\" unit=");
    assertThat(new ThreeMfSample(unknown).fixture().refusal())
        .isEqualTo(
            "UNSUPPORTED 3D/root.model line 2: the extension http://example.com/x is required;"
                + " export the model without it, or to GLB");
    String undeclared = model.replace("unit=", "requiredextensions=\"q\" unit=");
    assertThat(new ThreeMfSample(undeclared).fixture().refusal())
        .contains("the extension \"q\" is required");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "v1=\"0\"|v1=\"4\"|line 10: expected an integer from 0 to 3 in v1, found \"4\"",
        "v1=\"0\"|v1=\"-1\"|line 10: expected an integer from 0 to 3 in v1, found \"-1\"",
        "v1=\"0\"|v1=\"\"|line 10: expected an integer from 0 to 3 in v1, found \"\"",
        "v1=\"0\"|w=\"0\"|line 10: expected the attribute v1 of <triangle>, found none",
        "x=\"0\"|x=\"1,5\"|line 8: expected a finite number, found \"1,5\"",
        "x=\"0\"|x=\"\"|line 8: expected a number in x, found none",
        "pid=\"3\"|pid=\"3\" p1=\"3\"|line 10: expected an integer from 0 to 2 in p1, found \"3\"",
        "colorgroup id=\"3\"|colorgroup id=\"x\"|line 8: expected an integer from 0 to 2147483647"
            + " in id, found \"x\"",
        "item objectid=\"1\"|item objectid=\"8\"|line 13: expected an object that is defined"
            + " before, found objectid 8",
        "item |item transform=\"1 0\" |line 13: expected 12 numbers in transform, found fewer",
        "millimeter|furlong|line 2: expected micron, millimeter, centimeter, inch, foot or meter,"
            + " found unit \"furlong\"",
        "</mesh>|</mash>|line 11: expected </mesh>, found </mash>",
        "<model|<modell|line 2: expected a <model> of 3MF, found something else"
      })
  void errorsNameThePlace(String text, String by, String message) {
    String model =
        ThreeMfSample.model(COLORS + object("", "pid=\"3\"", ""), "<item objectid=\"1\"/>");
    assertThat(model).contains(text);
    assertThat(new ThreeMfSample(model.replace(text, by)).fixture().refusal())
        .isEqualTo("MALFORMED 3D/root.model " + message);
  }

  @Test
  void objectsCannotContainThemselves() {
    String cycle = "<object id=\"1\"><components><component objectid=\"1\"/></components></object>";
    assertThat(ThreeMfSample.of(cycle).fixture().refusal())
        .contains("expected an object that is defined before, found objectid 1");
    String other =
        ThreeMfSample.model(
            "<object id=\"1\"><components><component p:path=\"/3D/root.model\" objectid=\"1\"/>"
                + "</components></object>",
            "");
    assertThat(
            ThreeMfSample.of("", "<item p:path=\"/b.model\" objectid=\"1\"/>")
                .with("b.model", other)
                .fixture()
                .refusal())
        .isEqualTo(
            "UNSUPPORTED b.model line 8: expected a path to another part in the root part only,"
                + " found \"/3D/root.model\"");
  }

  /** Returns objects 2 to n, each with the one before it as components. */
  private static String tower(int levels, int copies) {
    StringBuilder text = new StringBuilder();
    for (int i = 2; i <= levels; i++) {
      String component = "<component objectid=\"" + (i - 1) + "\"/>";
      text.append("<object id=\"" + i + "\"><components>")
          .append(component.repeat(copies))
          .append("</components></object>");
    }
    return text.toString();
  }

  @Test
  void componentsAreBounded() throws ModelFormatException {
    String square = object("", "", "");
    assertThat(read(square + tower(101, 1), "<item objectid=\"101\"/>").parts()).hasSize(1);
    assertThat(ThreeMfSample.of(square + tower(102, 1), "").fixture().refusal())
        .isEqualTo(
            "TOO_LARGE 3D/root.model object 102: expected at most 100 levels of components, found"
                + " 101");
    assertThat(ThreeMfSample.of(square + tower(20, 2), "").fixture().refusal())
        .isEqualTo("TOO_LARGE 3D/root.model object 15: expected at most 10000 parts, found 16384");
    String nothing = "<object id=\"1\"/>";
    assertThat(
            ThreeMfSample.of(nothing + tower(90, 2), "<item objectid=\"90\"/>").fixture().refusal())
        .isEqualTo("MALFORMED expected at least one triangle with an area, found none");
  }

  @Test
  void relationsNameTheModel() throws ModelFormatException {
    String model = ThreeMfSample.model(object("", "", ""), "<item objectid=\"1\"/>");
    ThreeMfSample usual = new ThreeMfSample("").without("_rels/.rels").without("3D/root.model");
    assertThat(usual.fixture().refusal())
        .isEqualTo("MALFORMED expected an archive with a 3D model, found one without");
    assertThat(usual.with("3D/3dmodel.model", model).fixture().read().parts()).hasSize(1);
    assertThat(new ThreeMfSample("").without("3D/root.model").fixture().refusal())
        .isEqualTo("ASSET expected a part of the archive, found no \"/3D/root.model\"");
  }

  @Test
  void memoryIsLimited() {
    ModelOptions options = ModelOptions.DEFAULT.limitedTo(Limits.NONE.withMemory(1000));
    String vertices = "<vertex x=\"0\" y=\"0\" z=\"0\"/>".repeat(1000);
    String object = object("", "", "").replace("<vertices>", "<vertices>" + vertices);
    assertThat(ThreeMfSample.of(object).fixture().with(options).refusal())
        .startsWith("TOO_LARGE 3D/root.model line 8: expected at most 1000 bytes of memory");
  }

  @Test
  void interruptEndsTheReading() {
    ModelFixture model = ThreeMfSample.of(object("", "", "")).fixture();
    assertCancelled(model::read);
  }
}
