package io.github.lumbre.model.format.dae;

import static io.github.lumbre.model.format.dae.DaeSample.fixture;
import static io.github.lumbre.model.format.dae.DaeSample.source;
import static io.github.lumbre.model.internal.ModelFixture.mapped;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.ModelOptions.Up;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelCamera;
import io.github.lumbre.model.internal.ModelCamera.Parallel;
import io.github.lumbre.model.internal.ModelCamera.Perspective;
import io.github.lumbre.model.internal.ModelFixture;
import io.github.lumbre.model.internal.ModelPart;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the nodes, instances, axes and cameras of COLLADA files. */
class DaeSceneTest {
  private static final String INSTANCE = "<instance_geometry url=\"#g\"/>";

  private static final String SQUARE = DaeSample.square().replace(" material=\"m\"", "");

  private static Vec3 vector(String text) {
    String[] words = text.strip().split("\\s+");
    return new Vec3(
        Double.parseDouble(words[0]), Double.parseDouble(words[1]), Double.parseDouble(words[2]));
  }

  private static Vec3 point(ModelPart part, String point) {
    return part.toWorld().point(vector(point));
  }

  private static void assertNear(Vec3 found, String expected) {
    assertThat(found.minus(vector(expected)).maxAbs()).as(found.toString()).isLessThan(1e-12);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<matrix>1 2 3 4 0 5 6 7 0 0 8 9 0 0 0 1</matrix>|1 1 1|10 18 17",
        "<translate>1 2 3</translate>|1 1 1|2 3 4",
        "<scale>2 3 -4</scale>|1 1 1|2 3 -4",
        "<rotate>0 0 5 90</rotate>|1 2 3|-2 1 3",
        "<rotate>1 1 1 120</rotate>|1 2 3|3 1 2",
        "<translate>1 0 0</translate><scale>2 2 2</scale>|1 1 1|3 2 2",
        "<scale>2 2 2</scale><translate>1 0 0</translate>|1 1 1|4 2 2",
        // Sheared along x, by the tangent of 45 degrees times y.
        "<skew>45 0 1 0 1 0 0</skew>|1 2 3|3 2 3",
        // From 45 degrees above x to 90 degrees less 45: the axis itself is the limit.
        "<skew>-45 1 1 0 1 0 0</skew>|1 1 0|0 1 0",
        // At (0, 0, 5), looking to the origin: -z of the node is -z of the world.
        "<lookat>0 0 5 0 0 0 0 1 0</lookat>|1 2 -3|1 2 2",
        "<lookat>5 0 0 0 0 0 0 1 0</lookat>|1 2 -3|2 2 -1"
      })
  void nodesHaveTransforms(String transforms, String point, String expected)
      throws ModelFormatException {
    ModelPart part = fixture(DaeSample.file(SQUARE, transforms + INSTANCE)).part();
    assertNear(point(part, point), expected);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<matrix>1 0 0</matrix>|expected 16 finite numbers in <matrix>, found \"1 0 0\"",
        "<translate>1 x 0</translate>|expected 3 finite numbers in <translate>",
        "<rotate>0 0 0 90</rotate>|expected axes that differ in <rotate>",
        "<lookat>0 0 0 0 0 0 0 1 0</lookat>|expected axes that differ in <lookat>",
        "<skew>45 1 0 0 1 0 0</skew>|expected axes that differ in <skew>"
      })
  void wrongTransformsAreIgnored(String transform, String warning) throws ModelFormatException {
    Model read = fixture(DaeSample.file(SQUARE, transform + INSTANCE)).read();
    assertNear(point(read.parts().get(0), "1 2 3"), "1 2 3");
    assertThat(read.warnings()).hasSize(1);
    assertThat(read.warnings().get(0)).contains(warning).endsWith("it is ignored");
  }

  @Test
  void rotationsByNothingNeedNoAxis() throws ModelFormatException {
    Model read = fixture(DaeSample.file(SQUARE, "<rotate>0 0 0 0</rotate>" + INSTANCE)).read();
    assertThat(read.warnings()).isEmpty();
  }

  @ParameterizedTest
  @CsvSource({"<scale>1 0 1</scale>", "<scale>1e150 1e150 1e150</scale>"})
  void nodesThatCannotBeShownAreLeftOut(String transform) throws ModelFormatException {
    String nodes = "<node>" + INSTANCE + "</node><node>" + transform + INSTANCE + "</node>";
    Model read = fixture(DaeSample.ofNodes("", SQUARE, nodes)).read();
    assertThat(read.parts()).hasSize(1);
    assertThat(read.warnings()).hasSize(1);
    assertThat(read.warnings().get(0)).contains("left out");
  }

  @Test
  void nodesAreNestedAndInstanced() throws ModelFormatException {
    String library =
        "<library_nodes><node id=\"l\" name=\"wheel\"><translate>0 1 0</translate>"
            + INSTANCE
            + "</node></library_nodes>";
    String nodes =
        """
        <node id="a" name="car"><translate>10 0 0</translate>
          <node id="b"><scale>2 2 2</scale><instance_node url="#l"/></node>
          <instance_node url="#l"/>
        </node>
        """;
    Model read = fixture(DaeSample.ofNodes("", SQUARE + library, nodes)).read();
    assertThat(read.parts()).hasSize(2);
    ModelPart first = read.parts().get(0);
    ModelPart second = read.parts().get(1);
    assertThat(first.geometry()).isSameAs(second.geometry());
    assertNear(point(first, "1 0 0"), "12 2 0");
    assertNear(point(second, "1 0 0"), "11 1 0");
    assertThat(first.node().label()).isEqualTo("wheel");
    assertThat(first.node().parent().orElseThrow().label()).isEqualTo("b");
    assertThat(first.node().matches("car"::equals)).isTrue();
  }

  @ParameterizedTest
  @CsvSource({
    "<instance_geometry url=\"other.dae#g\"/>",
    "<instance_node url=\"file:///etc/x.dae#n\"/>",
    "<instance_controller url=\"./other.dae#c\"/>"
  })
  void referencesToOtherFilesAreLeftOut(String reference) throws ModelFormatException {
    Model read = fixture(DaeSample.file(SQUARE, INSTANCE + reference)).read();
    assertThat(read.parts()).hasSize(1);
    assertThat(read.warnings()).hasSize(1);
    assertThat(read.warnings().get(0))
        .startsWith("line 8: a reference to another file is left out: ");
  }

  @Test
  void fileWithoutSceneShowsWhatItHas() throws ModelFormatException {
    String text = DaeSample.file(SQUARE, INSTANCE);
    String noScene = text.replaceFirst("(?s)<scene>.*</scene>", "");
    assertThat(fixture(noScene).read().warnings().get(0))
        .contains("expected a <scene>").endsWith("the first scene of the file is shown");
    String noNodes = noScene.replaceFirst("(?s)<library_visual.*</library_visual_scenes>", "");
    Model read = fixture(noNodes).read();
    assertThat(read.parts()).hasSize(1);
    assertThat(read.warnings().get(0)).endsWith("all geometries of the file are shown");
  }

  private static Vec3 upright(String asset, ModelOptions options) throws ModelFormatException {
    ModelFixture file = fixture(DaeSample.file(asset, SQUARE, INSTANCE)).with(options);
    return mapped(file.part(), 1, 2, 3);
  }

  @Test
  void axesAndUnitAreThoseOfTheFile() throws ModelFormatException {
    ModelOptions none = ModelOptions.DEFAULT;
    assertNear(upright("", none), "1 2 3");
    assertNear(upright("<up_axis>Z_UP</up_axis>", none), "1 3 -2");
    assertNear(upright("<up_axis>X_UP</up_axis>", none), "-2 1 3");
    assertNear(upright("<unit meter=\"0.01\"/>", none), ".01 .02 .03");
    assertNear(upright("<unit meter=\"0,5\"/><up_axis> Z_UP </up_axis>", none), ".5 1.5 -1");
    ModelOptions other = none.with(ModelOption.UP, Up.Y).with(ModelOption.UNIT, 2.);
    assertNear(upright("<unit meter=\"0.01\"/><up_axis>Z_UP</up_axis>", other), "2 4 6");
    assertNear(upright("<up_axis>X_UP</up_axis>", other), "2 4 6");
    ModelFixture file =
        fixture(DaeSample.file("<unit meter=\"0.0254\"/><up_axis>U</up_axis>", SQUARE, INSTANCE));
    assertThat(file.read().unit()).isEqualTo("inch");
    assertThat(file.read().warnings().get(0)).contains("found \"U\"; Y_UP is used");
    for (String wrong : new String[] {"0", "-1", "x", "1e200", "1e-200"}) {
      ModelFixture odd =
          fixture(DaeSample.file("<unit meter=\"" + wrong + "\"/>", SQUARE, INSTANCE));
      assertNear(mapped(odd.part(), 1, 2, 3), "1 2 3");
      assertThat(odd.read().warnings().get(0)).endsWith("1 is used");
    }
  }

  @Test
  void camerasAreThereByName() throws ModelFormatException {
    String cameras =
        """
        <library_cameras><camera id="p" name="eye"><optics><technique_common><perspective>
        <xfov>90</xfov><aspect_ratio>2</aspect_ratio></perspective></technique_common></optics>
        </camera><camera id="o"><optics><technique_common><orthographic><xmag>3</xmag>
        <ymag>2</ymag></orthographic></technique_common></optics></camera>
        <camera id="x"><optics><technique_common><perspective><yfov>180</yfov></perspective>
        </technique_common></optics></camera></library_cameras>
        """;
    String nodes =
        """
        <node><instance_geometry url="#g"/></node>
        <node name="side"><lookat>500 0 0 0 0 0 0 1 0</lookat><scale>3 3 3</scale>
          <instance_camera url="#p"/></node>
        <node><instance_camera url="#o"/></node><node><instance_camera url="#x"/></node>
        """;
    Model read =
        fixture(DaeSample.ofNodes("<unit meter=\"0.01\"/>", SQUARE + cameras, nodes)).read();
    assertThat(read.cameras()).hasSize(2).allMatch(ModelCamera::onlyByName);
    ModelCamera eye = read.cameras().get(0);
    assertThat(eye.name()).isEqualTo("side");
    Perspective lens = (Perspective) eye.lens();
    // tan(y / 2) = tan(45 degrees) / 2
    assertThat(lens.verticalFov()).isCloseTo(2 * Math.atan(.5), within(1e-12));
    assertThat(lens.aspect()).hasValue(2);
    assertNear(eye.toWorld().point(new Vec3(0, 0, -1)), "4 0 0");
    Parallel parallel = (Parallel) read.cameras().get(1).lens();
    assertThat(parallel).isEqualTo(new Parallel(.03, .02));
    assertThat(read.warnings()).hasSize(1);
    assertThat(read.warnings().get(0)).contains("it is left out");
  }

  @Test
  void lightsAndAnimationsAreLeftOut() throws ModelFormatException {
    String libraries =
        "<library_animations/><library_animations><animation id=\"x\"/></library_animations>"
            + "<library_lights><light id=\"l\"/></library_lights>";
    Model read =
        fixture(DaeSample.file(SQUARE + libraries, INSTANCE + "<instance_light url=\"#l\"/>"))
            .read();
    assertThat(read.warnings())
        .containsExactly("line 7: animations are left out", "line 8: lights are left out");
    String empty = DaeSample.file(SQUARE + "<library_animations/>", INSTANCE);
    assertThat(fixture(empty).read().warnings()).isEmpty();
  }

  /** A square that is bound one unit higher, to a bone that has moved with the whole scene. */
  private static String skinned(String bone, String inverse) {
    String controller =
        """
        <library_controllers><controller id="c"><skin source="#g">
        <bind_shape_matrix>1 0 0 0 0 1 0 1 0 0 1 0 0 0 0 1</bind_shape_matrix>
        <source id="j"><Name_array id="ja" count="2">root tip</Name_array></source>
        %s
        <joints><input semantic="JOINT" source="#j"/>
        <input semantic="INV_BIND_MATRIX" source="#b"/></joints>
        <vertex_weights count="4"><vcount>1 1 1 1</vcount><v>0 0 0 0 0 0 0 0</v></vertex_weights>
        </skin></controller></library_controllers>
        """
            .formatted(source("b", "M", inverse));
    String nodes =
        """
        <node id="skeleton"><translate>100 0 0</translate><node id="r" sid="root" type="JOINT">
        %s</node></node>
        <node><translate>0 0 77</translate><instance_controller url="#c">
        <skeleton>#skeleton</skeleton></instance_controller></node>
        """
            .formatted(bone);
    return DaeSample.ofNodes("", SQUARE + controller, nodes);
  }

  @Test
  void skinsHaveTheirBindPose() throws ModelFormatException {
    String inverse = "1 0 0 0 0 1 0 -5 0 0 1 0 0 0 0 1 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1";
    Model read = fixture(skinned("<translate>0 5 0</translate>", inverse)).read();
    assertThat(read.warnings()).isEmpty();
    // The bone is where it was bound, 100 to the right; the node of the instance has no effect.
    assertNear(point(read.parts().get(0), "1 0 0"), "101 1 0");
    Model broken = fixture(skinned("<translate>0 5 0</translate>", "1 nan 3")).read();
    assertNear(point(broken.parts().get(0), "1 0 0"), "1 1 0");
  }

  @Test
  void morphsHaveTheShapeOfTheirBase() throws ModelFormatException {
    String controller =
        "<library_controllers><controller id=\"c\"><morph source=\"#g\"/></controller>"
            + "</library_controllers>";
    Model read =
        fixture(
                DaeSample.file(
                    SQUARE + controller,
                    "<translate>1 0 0</translate><instance_controller url=\"#c\"/>"))
            .read();
    assertNear(point(read.parts().get(0), "1 0 0"), "2 0 0");
    assertThat(read.warnings()).containsExactly("line 7: other shapes of morphs are left out");
  }

  @ParameterizedTest
  @CsvSource({"UTF-16LE,\ufeff", "UTF-16BE,\ufeff", "UTF-16LE,''", "UTF-8,\ufeff"})
  void textsMayBeInUtf16(String charset, String mark) throws ModelFormatException {
    String text = mark + DaeSample.file(SQUARE, INSTANCE).replace("part", "W\u00fcrfel");
    byte[] bytes = text.getBytes(Charset.forName(charset));
    Model read = new ModelFixture("a.dae", bytes).read();
    assertThat(read.parts().get(0).name()).isEqualTo("W\u00fcrfel");
    assertThat(read.warnings()).isEmpty();
    if (!mark.isEmpty()) {
      assertThat(DaeReader.startsIn(bytes, bytes.length)).isTrue();
    }
  }

  @Test
  void declaredEncodingsAreObeyed() throws ModelFormatException {
    String text = DaeSample.file(SQUARE, INSTANCE).replace("part", "W\u00fcrfel");
    byte[] latin =
        text.replace("utf-8", "ISO-8859-1").getBytes(StandardCharsets.ISO_8859_1);
    assertThat(new ModelFixture("a.dae", latin).part().name()).isEqualTo("W\u00fcrfel");
    // Some programs state UTF-16, and write UTF-8; an unknown encoding is taken for UTF-8.
    for (String stated : new String[] {"utf-16", "x-unknown"}) {
      assertThat(fixture(text.replace("utf-8", stated)).part().name()).isEqualTo("W\u00fcrfel");
    }
  }

  @Test
  void otherVersionsAreNamed() throws ModelFormatException {
    Model read = fixture(DaeSample.file(SQUARE, INSTANCE).replace("1.4.1", "1.3.1")).read();
    assertThat(read.warnings().get(0)).contains("found \"1.3.1\"; parts may be missing");
  }
}
