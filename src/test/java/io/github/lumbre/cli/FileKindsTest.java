package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.model.format.threemf.ThreeMfSample;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.Stream;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Contents decide what a file is where its ending does not, and messages name what was found. */
class FileKindsTest {
  private static final Path CASES = Path.of("src/test/resources/cases");

  @TempDir private Path folder;

  private Outcome render(Path file) {
    Path picture = folder.resolve("x.pfm");
    String[] command = {"render", file.toString(), "-o", picture.toString()};
    String[] more = {"--overwrite", "-s", "1", "--size", "8x8", "--view", "front", "--quiet"};
    return Outcome.of(Stream.of(command, more).flatMap(Arrays::stream).toArray(String[]::new));
  }

  private Path copy(String name, String to) throws IOException {
    return Files.copy(CASES.resolve(name), folder.resolve(to));
  }

  private byte[] picture() throws IOException {
    return Files.readAllBytes(folder.resolve("x.pfm"));
  }

  @ParameterizedTest
  @CsvSource({
    "rgba_MASK.glb, a.vrm",
    "rgba_MASK.glb, model",
    "q_lit.gltf, a.txt",
    "vc.obj, a.obj.bak",
    "texfile.ply, a.xyz",
    "cube.off, a.tmp",
    "terminator.glb, a.tmp"
  })
  void modelsOfUnknownEndingsAreRendered(String name, String other) throws IOException {
    for (String texture : new String[] {"quad.png", "my tex file.png"}) {
      copy(texture, texture);
    }
    assertThat(render(copy(name, name)).exitCode()).isEqualTo(ExitCodes.OK);
    byte[] expected = picture();
    Outcome outcome = render(copy(name, other));
    assertThat(outcome.exitCode()).as(outcome.err()).isEqualTo(ExitCodes.OK);
    assertThat(picture()).isEqualTo(expected);
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void stlIsRecognized(boolean isText) throws IOException {
    byte[] binary = new byte[134];
    binary[80] = 1;
    // The vertices (2, 0, 0), (0, 2, 0) and (0, 0, 0).
    binary[84 + 12 + 3] = 0x40;
    binary[84 + 12 + 12 + 4 + 3] = 0x40;
    String text =
        "solid\nfacet normal 0 0 1 outer loop vertex 2 0 0 vertex 0 2 0 vertex 0 0 0 endloop"
            + " endfacet\nendsolid\n";
    byte[] content = isText ? text.getBytes(StandardCharsets.US_ASCII) : binary;
    Outcome outcome = render(Files.write(folder.resolve("part"), content));
    assertThat(outcome.exitCode()).as(outcome.err()).isEqualTo(ExitCodes.OK);
  }

  @Test
  void archivesOfModelsAreRecognized() throws IOException {
    Path file = Files.write(folder.resolve("part"), ThreeMfSample.square());
    Outcome outcome = render(file);
    assertThat(outcome.exitCode()).as(outcome.err()).isEqualTo(ExitCodes.OK);
    Path json = Files.write(folder.resolve("a.json"), ThreeMfSample.square());
    render(json).assertFailed(ExitCodes.SCENE, "found 3MF; give its name the ending .3mf");
    byte[] start =
        "PK\3\4..........................word/document.xml".getBytes(StandardCharsets.US_ASCII);
    Path other = Files.write(folder.resolve("b.3mf"), start);
    render(other)
        .assertFailed(
            ExitCodes.ASSET, "expected a 3MF file, found ZIP; give its name the ending .zip");
  }

  @Test
  void modelsAreReadFromStandardInput() throws IOException {
    assertThat(render(copy("rgba_MASK.glb", "a.glb")).exitCode()).isEqualTo(ExitCodes.OK);
    byte[] expected = picture();
    byte[] model = Files.readAllBytes(CASES.resolve("rgba_MASK.glb"));
    String target = folder.resolve("x.pfm").toString();
    String line = "render - --overwrite -s 1 --size 8x8 --view front --quiet -o " + target;
    Outcome outcome = Outcome.onStandardInput(model, line.split(" "));
    assertThat(outcome.exitCode()).as(outcome.err()).isEqualTo(ExitCodes.OK);
    assertThat(picture()).isEqualTo(expected);
    Outcome check =
        Outcome.onStandardInput(model, "check", "-", "--sky", CASES.resolve("ref.pfm") + "");
    assertThat(check.exitCode()).as(check.err()).isEqualTo(ExitCodes.OK);
    assertThat(check.out()).contains("triangles  2\n");
    Outcome.onStandardInput("; FBX 7.3.0".getBytes(StandardCharsets.US_ASCII), "check", "-")
        .assertFailed(ExitCodes.SCENE, "stdin: expected a scene (.json) or a model", "found FBX");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      ignoreLeadingAndTrailingWhitespace = false,
      value = {
        "a.fbx|Kaydara FBX Binary  \\0|FBX; export it to GLB",
        "b.fbx|; FBX 7.3.0 project file|FBX; export it to GLB",
        "a.wrl|#VRML V2.0 utf8\\n|VRML; export it to GLB",
        "a.usdz|PK\\3\\4..........................mesh.usdc|USDZ; export it to GLB",
        "a.usda|#usda 1.0|USD; export it to GLB",
        "a.rar|Rar!....|a RAR archive; unpack it",
        "a.blend|BLENDER-v300|a Blender file; export it to GLB",
        "a.step|ISO-10303-21;|STEP; export it to GLB",
        "a.ifc|ISO-10303-21;\\nHEADER;\\nFILE_SCHEMA (('IFC4'));|IFC; export it to GLB",
        "b.ifc|<?xml version='1.0'?><ifcXML>|IFC; export it to GLB",
        "a.ifczip|PK\\3\\4......................\\5\\0..a.ifc|IFC; export it to GLB",
        "a.dxf|  0\\r\\nSECTION\\r\\n  2\\r\\nHEADER\\r\\n|DXF; export it to GLB",
        "b.dxf|999\\nby a program\\n0\\nSECTION\\n2\\nENTITIES|DXF; export it to GLB",
        "c.dxf|AutoCAD Binary DXF\\r\\n\\032\\0|DXF; export it to GLB",
        "a.dwg|AC1027\\0\\0|DWG; export it to GLB",
        "a.pcd|# .PCD v0.7 - Point Cloud Data\\nVERSION 0.7\\n|PCD; convert it to PLY",
        "b.pcd|VERSION .7\\nFIELDS x y z\\n|PCD; convert it to PLY",
        "a.las|LASF\\0\\0|LAS; convert it to PLY",
        "a.vtk|# vtk DataFile Version 3.0\\nmesh\\nASCII|VTK; export it to GLB",
        "a.vtp|<?xml version='1.0'?><VTKFile type='PolyData'>|VTK; export it to GLB",
        "a.amf|<?xml version='1.0'?>\\n<amf unit='inch'>|AMF; export it to GLB",
        "b.amf|PK\\3\\4......................\\5\\0..a.amf|AMF; export it to GLB",
        "a.b3dm|b3dm\\1\\0\\0\\0|B3DM; export it to GLB",
        "a.pnts|pnts\\1\\0\\0\\0|PNTS; convert it to PLY",
        "a.gz|\\037\\213\\10\\0|a gzip archive; unpack it",
        "a.mtl|# Blender\\nnewmtl red\\n|MTL, the materials of an OBJ file; name that file",
        "a.glb.html|<!DOCTYPE html><html>|an HTML page; download the file itself",
        "a.tga|\\0\\0\\2........|another kind of file",
        "b.tga|\\0\\0\\2\\0\\0\\0\\0\\0..|a TGA picture; name the scene or model that uses it",
        "c.tga|\\0\\0\\n\\0\\0\\0\\0\\0..|a TGA picture; name the scene or model that uses it",
        "a.dds|DDS ...|a DDS picture; name the scene or model that uses it",
        "a.gif|GIF89a|a GIF picture; name the scene or model that uses it",
        "a.tif|MM\\0*..|a TIFF picture; name the scene or model that uses it",
        "a.txt|hello|another kind of file",
        "a.json|# by hand\\nCOFF\\n3 1 0\\n|OFF; give its name the ending .off",
        "a.json|<?xml version='1.0'?><COLLADA>|COLLADA; give its name the ending .dae",
        "b.json|\\377\\376<\\0C\\0O\\0L\\0L\\0A\\0D\\0A\\0|COLLADA; give its name the ending .dae",
        "a.json|glTF\\2|GLB; give its name the ending .glb",
        "b.json|{\"asset\": {\"version\": \"2.0\"}}|glTF; give its name the ending .gltf",
        "a.exr|v/1\\1\\2...|an OpenEXR picture; name the scene or model that uses it"
      })
  void otherFilesAreNamed(String name, String content, String found) throws IOException {
    Path file = folder.resolve(name);
    Files.write(file, content.translateEscapes().getBytes(StandardCharsets.ISO_8859_1));
    String message =
        "expected a scene (.json) or a model (.gltf, .glb, .obj, .ply, .stl, .off, .3mf, .dae,"
            + " .zip), found ";
    render(file).assertFailed(ExitCodes.SCENE, name + ": " + message + found);
    Outcome.of("check", file.toString())
        .assertFailed(ExitCodes.SCENE, name + ": " + message + found);
  }

  @Test
  void aCompressedBlenderFileIsNamed() throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try (OutputStream packed = new GZIPOutputStream(out)) {
      packed.write("BLENDER-v279".getBytes(StandardCharsets.US_ASCII));
      packed.write(new byte[100_000]);
    }
    render(Files.write(folder.resolve("a.blend"), out.toByteArray()))
        .assertFailed(ExitCodes.SCENE, "found a compressed Blender file; export it to GLB");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "glb|a glTF file",
        "gltf|a glTF file",
        "obj|an OBJ file",
        "ply|a PLY file",
        "stl|an STL file",
        "off|an OFF file",
        "3mf|a 3MF file",
        "dae|a COLLADA file"
      })
  void modelsOfWrongContentsAreNamed(String ending, String title) throws IOException {
    for (String[] kind :
        new String[][] {
          {"Kaydara FBX Binary  \0", "FBX; export it to GLB"},
          {"xof 0303txt 0032\n", "a DirectX model; export it to GLB"},
          {"\u0089PNG\r\n\u001a\n....", "a PNG picture"},
          {"<!DOCTYPE html><html>", "an HTML page"}
        }) {
      Path file = folder.resolve("a." + ending);
      Files.write(file, kind[0].getBytes(StandardCharsets.ISO_8859_1));
      render(file).assertFailed(ExitCodes.ASSET, "expected " + title + ", found " + kind[1]);
    }
  }
}
