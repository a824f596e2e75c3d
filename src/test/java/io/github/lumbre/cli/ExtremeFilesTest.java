package io.github.lumbre.cli;

import io.github.lumbre.model.format.gltf.GltfFile;
import io.github.lumbre.model.format.ies.IesSamples;
import io.github.lumbre.testing.Effort;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Every number of every format, however large or wrong, gives a picture or a clear refusal. */
class ExtremeFilesTest {
  private static final String SMALL = " -o T/o.png --overwrite --size 4x3 -s 1";

  /** Each reads and builds more of the program than the one before. */
  private static final List<String> MODELS =
      List.of(
          "check FILE",
          "render FILE --no-denoise" + SMALL,
          "render FILE --section x=30% --ground --sky sun --no-denoise" + SMALL,
          "render FILE --look clay,lines --labels all --no-denoise" + SMALL,
          "render FILE --view iso --unit 1e-90 --section y=1e-91 --no-denoise" + SMALL,
          "render FILE --up z --unit 1e90 --background transparent --ground" + SMALL,
          "audit FILE --size 4x3");

  private static final List<String> SCENES =
      List.of("check FILE", "render FILE" + SMALL, "audit FILE --size 4x3");

  /** Numbers between the words of a text; names of things that have digits are none. */
  private static final Pattern WORDS =
      Pattern.compile("(?<=[\\s/,])-?(\\d+[.]?\\d*|[.]\\d+)(?=[\\s/,])");

  private static final Pattern JSON =
      Pattern.compile("(?<=[:,\\[] ?)-?\\d+([.]\\d+)?([eE][-+]?\\d+)?(?=[ ,\\]}\\n])");

  private static final Pattern XML = Pattern.compile("(?<=[\" ])-?\\d+([.]\\d+)?(?=[\" ])");

  /** Numbers in attributes and texts of XML; ids have no digits. */
  private static final Pattern TEXTS =
      Pattern.compile("(?<=[\"> ])-?\\d+([.]\\d+)?(?=[\"< ])");

  private static final String COLLADA =
      """
      <COLLADA version="1.4.x"><asset><unit meter="0.5"/><up_axis>Z_UP</up_axis></asset>
      <library_cameras><camera id="k"><optics><technique_common><perspective><xfov>40</xfov>
      <aspect_ratio>1.5</aspect_ratio></perspective></technique_common></optics></camera>
      </library_cameras><library_effects><effect id="e"><profile_COMMON><technique><phong>
      <emission><color>0.5 0 0 1</color></emission><diffuse><color>0.5 0.5 0 1</color></diffuse>
      <specular><color>0.5 0.5 0.5 1</color></specular><shininess><float>20</float></shininess>
      <transparent opaque="RGB_ZERO"><color>0.1 0.2 0.3 1</color></transparent><transparency>
      <float>0.5</float></transparency></phong></technique></profile_COMMON></effect>
      </library_effects><library_materials><material id="m"><instance_effect url="#e"/></material>
      </library_materials><library_geometries><geometry id="g"><mesh><source id="p">
      <float_array id="a" count="12">0 0 0 1 0 0 1 1 0 0 1 0.5</float_array><technique_common>
      <accessor source="#a" count="4" stride="3" offset="0"><param name="X"/><param name="Y"/>
      <param name="Z"/></accessor></technique_common></source><source id="n">
      <float_array count="3">0 0 1</float_array></source><source id="c"><float_array count="8">1 0 0
       1 0 0.5 1 1</float_array></source><vertices id="v"><input semantic="POSITION"
       source="#p"/></vertices><polylist count="1" material="s"><input semantic="VERTEX"
       source="#v" offset="0"/><input semantic="NORMAL" source="#n" offset="1"/><input
       semantic="COLOR" source="#c" offset="2" set="0"/><vcount>4</vcount><p>0 0 0 1 0 1 2 0 0 3 0
       1</p></polylist></mesh></geometry></library_geometries><library_visual_scenes><visual_scene
       id="x"><node id="r"><translate>1 2 3</translate><rotate>0 0 1 30</rotate><scale>1 2 1</scale>
      <skew>20 0 1 0 1 0 0</skew><node><lookat>0 0 5 0 0 0 0 1 0</lookat><instance_camera url="#k"/>
      </node><node><matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</matrix><instance_geometry url="#g">
      <bind_material><technique_common><instance_material symbol="s" target="#m"/>
      </technique_common></bind_material></instance_geometry></node></node></visual_scene>
      </library_visual_scenes><scene><instance_visual_scene url="#x"/></scene></COLLADA>
      """;

  private static final String MTL =
      """
      newmtl red
      Kd 1 0 .5
      Ks .5 .5 .5
      Ns 250
      Ni 1.5
      d .5
      map_Kd -s 2 2 1 -o .5 .5 0 a.png
      Pr .5
      Pm .25
      Pc .5
      Pcr .5
      Ps .5
      Ke 1 2 3
      map_Bump -bm .5 a.png
      newmtl glass
      Tr .125
      Tf .5 .5 .5
      illum 7
      Ni 1.5
      """;

  private static final String OBJ =
      """
      mtllib a.mtl
      v 0 0 0
      v 1 0 0 1 0 .5
      v 0 1 0
      v 0 0 1 1
      vt 0 0
      vt 1 1
      vn 0 0 1
      usemtl red
      f 1/1/1 3/2/1 2/2/1
      f 1 2 4
      usemtl glass
      f 2 3 4
      f 3 1 4
      p 1 2
      """;

  private static final String STL =
      """
      solid a
      facet normal 0 0 -1
      outer loop
      vertex 0 0 0
      vertex 0 1 0
      vertex 1 0 0
      endloop
      endfacet
      facet normal 0 0 0 outer loop vertex 1 2 3 vertex 2 2 2 vertex 3 2 1 endloop endfacet
      endsolid a
      """;

  private static final String PLY =
      """
      ply
      format ascii 1.0
      element vertex 4
      property double x
      property double y
      property double z
      property float nx
      property float ny
      property float nz
      property float red
      property float green
      property float blue
      property float s
      property float t
      element face 2
      property list uchar int vertex_indices
      end_header
      0 0 0 0 0 1 .5 0 1 0 0
      1 0 0 0 1 0 0 .5 1 1 0
      0 1 0 0 0 1 0 0 .5 0 1
      0 0 1 1 0 0 1 1 1 1 1
      3 0 2 1
      4 0 1 3 2
      """;

  private static final String CLOUD =
      """
      ply
      format ascii 1.0
      element vertex 3
      property double x
      property double y
      property double z
      property uchar red
      property uchar green
      property uchar blue
      end_header
      0 0 0 1 2 3
      1 0 0 200 2 3
      0 1 0 1 200 3
      """;

  private static final String OFF =
      """
      STCNOFF 4 3 6
      0 0 0 0 0 1 255 0 0 255 0 0
      1 0 0 0 0 1 0 255 0 128 1 0
      0 1 0 0 0 1 0 0 255 255 1 1
      0 0 1 0 1 0 .5 1 0 0 1 1
      3 0 2 1
      3 0 1 3 255 0 0
      4 1 2 3 0 0.5 0.25 1 1
      """;

  private static final String THREE_MF =
      """
      <?xml version="1.0" encoding="UTF-8"?>
      <model unit="millimeter" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
       xmlns:m="http://schemas.microsoft.com/3dmanufacturing/material/2015/02"><resources>
      <basematerials id="4"><base name="x" displaycolor="#ff0000"/></basematerials>
      <m:colorgroup id="5"><m:color color="#00ff00"/></m:colorgroup>
      <object id="1" pid="4" pindex="0"><mesh><vertices><vertex x="0" y="0" z="0"/>
      <vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="0"/><vertex x="0" y="0" z="1"/></vertices>
      <triangles><triangle v1="0" v2="2" v3="1" pid="5" p1="0"/><triangle v1="0" v2="1" v3="3"/>
      <triangle v1="1" v2="2" v3="3"/><triangle v1="2" v2="0" v3="3"/></triangles></mesh></object>
      <object id="2"><components>
      <component objectid="1" transform="1e-60 0 0 0 1e-60 0 0 0 1e-60 2 0 0"/>
      </components></object></resources><build>
      <item objectid="2" transform="1 0 0 0 1 0 0 0 1 0 0 0"/><item objectid="1"/></build></model>
      """;

  private static final String RELATIONS =
      "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
          + "<Relationship Target=\"/a.model\" Id=\"r\""
          + " Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>"
          + "</Relationships>";

  @TempDir private Path folder;

  @BeforeEach
  void pictures() throws IOException {
    ModelSample.write(folder);
    Files.move(folder.resolve("paint.png"), folder.resolve("a.png"));
    Files.writeString(folder.resolve("a.mtl"), MTL);
    Files.writeString(folder.resolve("a.obj"), OBJ);
  }

  /** Runs one of the commands in turn with each text, or all in exhaustive tests. */
  private void run(List<String> texts, Extremes.Written file, List<String> commands)
      throws IOException {
    for (int i = 0; i < texts.size(); i++) {
      String path = file.with(texts.get(i)).getFileName().toString();
      for (int k = 0; k < commands.size(); k++) {
        if (Effort.isExhaustive() || k == i % commands.size()) {
          Extremes.run(Outcome.words(folder, commands.get(k).replace("FILE", "T/" + path)));
        }
      }
    }
  }

  private Extremes.Written file(String name) {
    return text -> Files.writeString(folder.resolve(name), text);
  }

  @ParameterizedTest
  @ValueSource(strings = {"a.obj", "a.stl", "a.ply", "b.ply", "a.off"})
  void models(String name) throws IOException {
    Map<String, String> texts =
        Map.of("a.obj", OBJ, "a.stl", STL, "a.ply", PLY, "b.ply", CLOUD, "a.off", OFF);
    run(Extremes.variants(texts.get(name), WORDS), file(name), MODELS);
  }

  @Test
  void materialLibraries() throws IOException {
    Extremes.Written library =
        text -> Files.writeString(folder.resolve("a.mtl"), text).resolveSibling("a.obj");
    run(Extremes.variants(MTL, WORDS), library, MODELS);
  }

  /** Transforms among them whose determinant underflows although no number does. */
  @Test
  void threeMfFiles() throws IOException {
    run(
        Extremes.variants(THREE_MF.substring(THREE_MF.indexOf("<resources>")), XML),
        text -> {
          ByteArrayOutputStream bytes = new ByteArrayOutputStream();
          try (ZipOutputStream zip = new ZipOutputStream(bytes)) {
            String model = THREE_MF.substring(0, THREE_MF.indexOf("<resources>")) + text;
            Map<String, String> parts = Map.of("_rels/.rels", RELATIONS, "a.model", model);
            for (Map.Entry<String, String> part : parts.entrySet()) {
              zip.putNextEntry(new ZipEntry(part.getKey()));
              zip.write(part.getValue().getBytes(StandardCharsets.UTF_8));
            }
          }
          return Files.write(folder.resolve("a.3mf"), bytes.toByteArray());
        },
        MODELS);
  }

  @Test
  void colladaFiles() throws IOException {
    run(Extremes.variants(COLLADA, TEXTS), file("a.dae"), MODELS);
  }

  @Test
  void gltfText() throws IOException {
    List<String> commands = new ArrayList<>(MODELS);
    commands.add("render FILE --view iso --pose a@0.5 --no-denoise" + SMALL);
    for (GltfFile file : ExtremeModels.all()) {
      String text = new String(file.gltf(), StandardCharsets.UTF_8);
      run(Extremes.variants(text, JSON), file("a.gltf"), commands);
    }
  }

  @Test
  void numbersOfBuffers() throws IOException {
    float[] values = {
      Float.MIN_VALUE, -1e-38f, 1e-20f, 1e20f, -Float.MAX_VALUE, Float.NaN, Float.POSITIVE_INFINITY
    };
    for (GltfFile file : ExtremeModels.all()) {
      byte[] buffer = file.buffer();
      for (int at = 0; at < buffer.length; at += 4) {
        byte[] changed = buffer.clone();
        float value = values[at / 4 % values.length];
        ByteBuffer.wrap(changed).order(ByteOrder.LITTLE_ENDIAN).putFloat(at, value);
        String uri = "data:;base64," + Base64.getEncoder().encodeToString(changed);
        String text = new String(file.gltf(uri), StandardCharsets.UTF_8);
        run(List.of(text), file("a.gltf"), List.of(MODELS.get(at / 4 % MODELS.size())));
      }
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"thin-lens", "pinhole", "fish-eye", "cylindrical", "orthographic"})
  void scenes(String name) throws IOException {
    String resource = "/io/github/lumbre/fuzz/" + name + ".json";
    Files.copy(folder.resolve("a.png"), folder.resolve("inside.png"));
    Files.copy(folder.resolve("a.obj"), folder.resolve("inside.obj"));
    try (InputStream in = getClass().getResourceAsStream(resource)) {
      String text = new String(in.readAllBytes(), StandardCharsets.UTF_8);
      List<String> texts = Extremes.variants(text, JSON);
      List<String> some = new ArrayList<>();
      // Reading scenes is tested value by value elsewhere.
      for (int i = 0; i < texts.size(); i += Effort.isExhaustive() ? 1 : 13) {
        some.add(texts.get(i));
      }
      run(some, file("s.json"), SCENES);
    }
  }

  @ParameterizedTest(name = "{index}")
  @ValueSource(strings = {IesSamples.FULL, IesSamples.OLD})
  void profilesOfLamps(String profile) throws IOException {
    String light = "\"lightType\": \"Point\", \"intensity\": 3";
    String profiled = "\"lightType\": \"Point\", \"profile\": \"a.ies\"";
    TinyScene.write(folder, TinyScene.with(light, profiled));
    run(
        Extremes.variants(profile, WORDS),
        text -> Files.writeString(folder.resolve("a.ies"), text).resolveSibling("tiny.json"),
        SCENES);
  }

  @ParameterizedTest(name = "{index}")
  @ValueSource(
      strings = {
        "PF\n2 1\n-1.0\n",
        "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=1.0\n\n-Y 1 +X 2\n"
      })
  void pictures(String header) throws IOException {
    byte[] texels = new byte[header.startsWith("PF") ? 24 : 8];
    Arrays.fill(texels, (byte) 64);
    String suffix = header.startsWith("PF") ? ".pfm" : ".hdr";
    run(
        Extremes.variants(header, Pattern.compile("(?<=[\\n= ])-?\\d+([.]\\d+)?(?=[\\n ])")),
        text -> {
          ByteArrayOutputStream bytes = new ByteArrayOutputStream();
          bytes.write(text.getBytes(StandardCharsets.US_ASCII));
          bytes.write(texels);
          return Files.write(folder.resolve("sky" + suffix), bytes.toByteArray());
        },
        List.of(
            "render T/a.obj --sky FILE --no-denoise" + SMALL,
            "compare FILE FILE",
            "render T/a.obj --sky FILE --sky-intensity 1e150 --no-denoise" + SMALL));
  }
}
