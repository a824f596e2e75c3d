package io.github.lumbre.model.format.dae;

import static io.github.lumbre.model.format.dae.DaeSample.source;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelPart;
import io.github.lumbre.model.internal.ModelReader;
import io.github.lumbre.testing.FileMutator;
import io.github.lumbre.testing.Mutants;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Every changed COLLADA file is read as a consistent model, or is refused with a reason. */
class DaeMutationTest {
  private static final int QUICK = 1000;
  private static final int LONGEST_LINE = 700;
  private static final byte[] PNG = Pixels.of(1, 1, 4, new byte[] {1, 2, 3, 4}).toPng();

  private static final String MESH =
      source("p", "X Y Z", " 0 0 0 4 0 0 4 4 0 0 4 0 1 1 0 2 1 0 2 2 0 1 2 5 ")
          + source("n", "X Y Z", " 0 0 1 0 1 0 ")
          + source("t", "S T", " 0 0 1 0 1 1 0 1 ")
          + source("c", "R G B A", " 1 0 0 1 0 1 0 .5 ")
          + """
          <vertices id="v" > <input semantic="POSITION" source="#p" /> </vertices>
          <triangles count="2" material="m" > <input semantic="VERTEX" source="#v" offset="0" />
          <input semantic="NORMAL" source="#n" offset="1" /> <input semantic="TEXCOORD" source="#t"
           offset="2" set="1" /> <p> 0 0 0 1 0 1 2 1 2 0 0 0 2 1 2 3 0 3 </p> </triangles>
          <polylist count="2" material="o" > <input semantic="VERTEX" source="#v" offset="0" />
          <input semantic="COLOR" source="#c" offset="1" /> <vcount> 4 5 </vcount> <p> 0 0 1 1 2 0
           3 1 0 0 1 0 2 1 7 1 3 0 </p> </polylist>
          <polygons count="2" > <input semantic="VERTEX" source="#v" offset="0" /> <ph> <p> 0 1 2 3
           </p> <h> 4 5 6 </h> </ph> <p> 4 7 5 6 </p> </polygons>
          <tristrips > <input semantic="VERTEX" source="#v" offset="0" /> <p> 0 1 3 2 </p> <p> 4 5
           7 </p> </tristrips> <trifans > <input semantic="VERTEX" source="#v" offset="0" /> <p> 0
           1 2 3 7 </p> </trifans> <lines > <input semantic="VERTEX" source="#v" offset="0" />
          <p> 0 1 </p> </lines>
          """;

  private static final String LIBRARIES =
      DaeSample.geometry(MESH)
          + """
          <library_images> <image id="i" > <init_from> t.png </init_from> </image> </library_images>
          <library_effects> <effect id="a-fx" > <profile_COMMON> <newparam sid="s" > <surface >
          <init_from> i </init_from> </surface> </newparam> <newparam sid="q" > <sampler2D >
          <source> s </source> <wrap_s> MIRROR </wrap_s> </sampler2D> </newparam> <technique >
          <phong> <emission> <color> 0 0 0 1 </color> </emission> <diffuse> <texture texture="q"
           texcoord="UV" /> </diffuse> <specular> <color> .5 .5 .5 1 </color> </specular>
          <shininess> <float> 20 </float> </shininess> <transparent opaque="RGB_ZERO" > <texture
           texture="i" texcoord="UV" /> </transparent> <transparency> <float> .5 </float>
          </transparency> </phong> <extra> <technique > <bump> <texture texture="q" texcoord="UV" />
          </bump> <double_sided> 0 </double_sided> </technique> </extra> </technique>
          </profile_COMMON> </effect> </library_effects> <library_materials> <material id="a" >
          <instance_effect url="#a-fx" /> </material> </library_materials> <library_cameras> <camera
           id="k" > <optics> <technique_common> <perspective> <xfov> 40 </xfov> <aspect_ratio> 1.5
          </aspect_ratio> </perspective> </technique_common> </optics> </camera> </library_cameras>
          <library_nodes> <node id="l" > <rotate> 0 0 1 90 </rotate> <instance_geometry url="#g" />
          </node> </library_nodes> <library_controllers> <controller id="c1" > <skin source="#g" >
          <bind_shape_matrix> 1 0 0 0 0 1 0 1 0 0 1 0 0 0 0 1 </bind_shape_matrix> <source id="j" >
          <Name_array > root </Name_array> </source> <source id="b" > <float_array count="16" > 1 0
           0 0 0 1 0 0 0 0 1 0 0 0 0 1 </float_array> </source> <joints> <input semantic="JOINT"
           source="#j" /> <input semantic="INV_BIND_MATRIX" source="#b" /> </joints> </skin>
          </controller> </library_controllers>
          """;

  private static final String NODES =
      """
      <node id="r" sid="root" > <translate> 1 2 3 </translate> <scale> 1 1 2 </scale> <skew> 20 0 1
       0 1 0 0 </skew> <instance_node url="#l" /> <instance_controller url="#c1" > <skeleton> #r
      </skeleton> </instance_controller> <node id="x" > <lookat> 0 0 5 0 0 0 0 1 0 </lookat>
      <instance_camera url="#k" /> <instance_node url="#l" /> </node> <node id="y" > <matrix> 1 0 0
       0 0 1 0 0 0 0 1 0 0 0 0 1 </matrix> <instance_geometry url="#g" > <bind_material>
      <technique_common> <instance_material symbol="m" target="#a" > <bind_vertex_input
       semantic="UV" input_semantic="TEXCOORD" input_set="1" /> </instance_material>
      </technique_common> </bind_material> </instance_geometry> </node> </node>
      """;

  private static final String FILE =
      DaeSample.ofNodes("<unit meter=\"0.5\" /> <up_axis> Z_UP </up_axis> ", LIBRARIES, NODES);

  private static final String[] WORDS = {
    "<node",
    "</node>",
    "<mesh>",
    "</mesh>",
    "<p>",
    "</p>",
    "/>",
    ">",
    "<",
    "\"",
    "<!--",
    "-->",
    "<![CDATA[",
    "]]>",
    "<!DOCTYPE",
    "&#x41;",
    "id=\"v\"",
    "id=\"l\"",
    "url=\"#l\"",
    "url=\"#r\"",
    "url=\"#c1\"",
    "url=\"#g\"",
    "source=\"#p\"",
    "source=\"#c1\"",
    "offset=\"999\"",
    "offset=\"99999999\"",
    "set=\"2\"",
    "stride=\"0\"",
    "stride=\"2147483647\"",
    "count=\"999999999\"",
    "semantic=\"TEXCOORD\"",
    "opaque=\"A_ZERO\"",
    "texture=\"i\"",
    "<instance_node url=\"#r\" />",
    "<extra>",
    "<float_array"
  };

  private static byte[] changed(long seed) {
    return new FileMutator(new Random(seed)).changedWords(FILE, WORDS);
  }

  private static boolean isRead(byte[] file) throws IOException {
    ModelOptions options = ModelOptions.DEFAULT.limitedTo(Limits.UPLOADS);
    try {
      check(ModelReader.read("a.dae", file, ModelFolder.of(Map.of("t.png", PNG)), options));
      return true;
    } catch (ModelFormatException e) {
      Mutants.assertPrintable(e.getMessage(), LONGEST_LINE);
      return false;
    }
  }

  private static void check(Model model) {
    assertThat(model.parts()).isNotEmpty();
    model.warnings().forEach(warning -> Mutants.assertPrintable(warning, LONGEST_LINE));
    for (ModelPart part : model.parts()) {
      ModelGeometry mesh = part.geometry();
      TriangleMesh built =
          TriangleMesh.of(mesh.positions(), mesh.normals(), mesh.uv0(), mesh.indices());
      assertThat(built.triangleCount()).isPositive();
      assertThat(mesh.uv1().length).isIn(0, 2 * mesh.vertexCount());
      assertThat(mesh.colors().length).isIn(0, 4 * mesh.vertexCount());
      for (float color : mesh.colors()) {
        assertThat(color).isBetween(0f, 1f);
      }
      assertThat(part.toWorld().isInvertible()).isTrue();
      Mutants.assertPrintable(part.location(), LONGEST_LINE);
    }
  }

  @Test
  void unchangedFileIsRead() throws Exception {
    byte[] file = FILE.getBytes(StandardCharsets.UTF_8);
    Model model =
        ModelReader.read(
            "a.dae", file, ModelFolder.of(Map.of("t.png", PNG)), ModelOptions.DEFAULT);
    check(model);
    // Four times a geometry of three surfaces: with textures, with colors, and plain.
    assertThat(model.parts()).hasSize(12);
    assertThat(model.cameras()).hasSize(1);
  }

  @Test
  void changedFilesAreReadOrRefused() {
    Mutants.few(QUICK, seed -> isRead(changed(seed)));
  }

  @Test
  @Tag("fuzz")
  void manyChangedFilesAreReadOrRefused() {
    Mutants.many(seed -> isRead(changed(seed)));
  }
}
