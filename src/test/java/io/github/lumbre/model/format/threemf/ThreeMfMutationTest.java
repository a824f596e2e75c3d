package io.github.lumbre.model.format.threemf;

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
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Every changed 3MF file is read as a consistent model, or is refused with a reason. */
class ThreeMfMutationTest {
  private static final int QUICK = 1000;
  private static final int LONGEST_LINE = 700;
  private static final byte[] PNG = Pixels.of(1, 1, 3, new byte[] {1, 2, 3}).toPng();

  private static final String ROOT =
      ThreeMfSample.model(
          """
          <basematerials id="1" > <base name="a" displaycolor="#102030" /> <base name="b"
           displaycolor="#10203040" /> </basematerials>
          <m:colorgroup id="2" > <m:color color="#FF0000" /> <m:color color="#00FF00" />
          </m:colorgroup> <m:texture2d id="3" path="/t.png" contenttype="image/png" />
          <m:texture2dgroup id="4" texid="3" > <m:tex2coord u=" 0 " v=" 1 " /> <m:tex2coord u="1"
           v="0.5" /> </m:texture2dgroup>
          <m:compositematerials id="5" matid="1" matindices="0 1" > <m:composite
           values=" 0.5 0.5 " /> </m:compositematerials>
          <m:multiproperties id="6" pids="1 4" > <m:multi pindices="0 1" /> </m:multiproperties>
          <object id="7" name="n" type="model" pid="1" pindex="0" > <mesh > <vertices >
          <vertex x="0" y="0" z=" 0 " /> <vertex x=" 10 " y="0" z="0" /> <vertex x="0" y=" 10 "
           z="0" /> <vertex x="0" y="0" z=" 1e1 " /> </vertices> <triangles > <triangle v1="0"
           v2="1" v3="2" pid="2" p1="0" p2="1" p3="0" /> <triangle v1="0" v2="1" v3="3" pid="4"
           p1="1" p2="0" p3="1" /> <triangle v1="1" v2="2" v3="3" pid="5" p1="0" /> <triangle
           v1="0" v2="2" v3="3" pid="6" p1="0" /> </triangles> </mesh> </object>
          <object id="8" type="support" > <components > <component objectid="7" transform=" 1 0 0
           0 1 0 0 0 1 0 0 5 " /> <component objectid="7" p:path="/o.model" /> </components>
          </object> <object id="9" > <components > <component objectid="7" /> </components>
          </object>
          """,
          "<item objectid=\"7\" /> <item objectid=\"9\" /> <item objectid=\"8\" /> ");

  private static final String OTHER = ROOT.replace("p:path=\"/o.model\"", "");

  private static final String[] WORDS = {
    "<object",
    "</object>",
    "<mesh",
    "</mesh>",
    "/>",
    ">",
    "<",
    "\"",
    "'",
    "<!--",
    "-->",
    "<![CDATA[",
    "<!DOCTYPE",
    "&#x41;",
    "&lt;",
    "id=\"1\"",
    "id=\"9\"",
    "objectid=\"8\"",
    "pid=\"2\"",
    "pid=\"6\"",
    "p1=\"9\"",
    "v1=\"3\"",
    "xmlns=\"\"",
    "xmlns:m=\"x\"",
    "p:path=\"/3D/root.model\"",
    "type=\"other\"",
    "requiredextensions=\"x\"",
    "#FF"
  };

  private static byte[] changedInside(long seed) {
    FileMutator mutator = new FileMutator(new Random(seed));
    return new ThreeMfSample("")
        .with("3D/root.model", mutator.changedWords(ROOT, WORDS))
        .with("o.model", OTHER)
        .with("t.png", PNG)
        .bytes();
  }

  private static byte[] changedOutside(long seed) {
    byte[] file = new ThreeMfSample(ROOT).with("o.model", OTHER).with("t.png", PNG).bytes();
    byte[] turned = turned(file);
    return turned(new FileMutator(new Random(seed)).changed(turned, 400));
  }

  /** Returns the bytes in the opposite order: the mutator favors beginnings, and ZIP the end. */
  private static byte[] turned(byte... file) {
    byte[] turned = new byte[file.length];
    for (int i = 0; i < file.length; i++) {
      turned[i] = file[file.length - 1 - i];
    }
    return turned;
  }

  private static boolean isRead(byte[] file) throws IOException {
    ModelOptions options = ModelOptions.DEFAULT.limitedTo(Limits.UPLOADS);
    try {
      check(ModelReader.read("a.3mf", file, ModelFolder.NONE, options));
      return true;
    } catch (ModelFormatException e) {
      checkPrintable(e.getMessage());
      return false;
    }
  }

  private static void check(Model model) {
    assertThat(model.parts()).isNotEmpty();
    model.warnings().forEach(ThreeMfMutationTest::checkPrintable);
    for (ModelPart part : model.parts()) {
      ModelGeometry mesh = part.geometry();
      TriangleMesh built =
          TriangleMesh.of(mesh.positions(), mesh.normals(), mesh.uv0(), mesh.indices());
      assertThat(built.triangleCount()).isPositive();
      assertThat(mesh.colors().length).isIn(0, 4 * mesh.vertexCount());
      assertThat(mesh.uv0().length).isIn(0, 2 * mesh.vertexCount());
      for (float color : mesh.colors()) {
        assertThat(color).isBetween(0f, 1f);
      }
      assertThat(part.toWorld().isInvertible()).isTrue();
      checkPrintable(part.location());
    }
  }

  private static void checkPrintable(String text) {
    Mutants.assertPrintable(text, LONGEST_LINE);
  }

  @Test
  void unchangedFileIsRead() throws Exception {
    byte[] file = new ThreeMfSample(ROOT).with("o.model", OTHER).with("t.png", PNG).bytes();
    Model model = ModelReader.read("a.3mf", file, ModelFolder.NONE, ModelOptions.DEFAULT);
    check(model);
    assertThat(model.parts()).hasSize(8);
  }

  @Test
  void changedFilesAreReadOrRefused() {
    Mutants.few(QUICK / 2, seed -> isRead(changedInside(seed)));
    Mutants.few(QUICK / 2, seed -> isRead(changedOutside(seed)));
  }

  @Test
  @Tag("fuzz")
  void manyChangedFilesAreReadOrRefused() {
    Mutants.many(seed -> isRead(changedInside(seed)));
    Mutants.many(seed -> isRead(changedOutside(seed)));
  }
}
