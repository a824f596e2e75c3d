package io.github.lumbre.scenefile.audit;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.scenefile.audit.Finding.Severity;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.StagedModel;
import io.github.lumbre.testing.Pictures;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests each kind of finding with one scene that has it and one that does not. */
class SceneAuditTest {
  private static final String CAMERA =
      "{\"id\": 1, \"type\": \"Camera\", \"localPosition\": {\"x\": 0, \"y\": 1, \"z\": -4}}";
  private static final String FLOOR =
      "{\"type\": \"Shape\", \"shapeType\": \"Plane\", \"finite\": true, \"width\": 20,"
          + " \"height\": 20}";
  private static final String LAMP =
      "{\"type\": \"Light\", \"lightType\": \"Sphere\", \"unit\": \"radiance\","
          + " \"intensity\": 20, \"radius\": 0.5, \"localPosition\": {\"x\": 0, \"y\": 4,"
          + " \"z\": -2}}";

  @TempDir private Path directory;

  private List<Finding> audit(String options, String assets, String... objects) throws Exception {
    String json =
        "{\"mainCameraId\": 1, \"renderOptions\": {\"width\": 32, \"height\": 24, \"samples\": 4, "
            + options
            + "}, \"assets\": ["
            + assets
            + "], \"objects\": ["
            + CAMERA
            + ", "
            + String.join(", ", objects)
            + "]}";
    return SceneAudit.of(new SceneParser().parse(Files.writeString(scene(), json)));
  }

  private Path scene() {
    return directory.resolve("scene.json");
  }

  private List<Finding> auditOf(String assets, String... objects) throws Exception {
    String[] all = new String[objects.length + 2];
    all[0] = FLOOR;
    all[1] = LAMP;
    System.arraycopy(objects, 0, all, 2, objects.length);
    return audit("\"maxTraceDepth\": 50", assets, all);
  }

  private static String material(String type, String keys) {
    return "{\"id\": 1, \"assetType\": \"Material\", \"materialType\": \""
        + type
        + "\", "
        + keys
        + "}";
  }

  private static String sphere(double x, double y, double radius) {
    return "{\"type\": \"Shape\", \"shapeType\": \"Sphere\", \"materialID\": 1, \"radius\": "
        + radius
        + ", \"localPosition\": {\"x\": "
        + x
        + ", \"y\": "
        + y
        + ", \"z\": 0}}";
  }

  private static void assertFinds(
      List<Finding> findings, String law, Severity severity, String path, String found) {
    assertThat(findings)
        .filteredOn(f -> f.law().equals(law) && f.severity() == severity)
        .anySatisfy(
            f -> {
              assertThat(f.path()).isEqualTo(path);
              assertThat(f.found()).contains(found);
            });
  }

  private static void assertSilent(List<Finding> findings, String law) {
    assertThat(findings).filteredOn(f -> f.law().equals(law)).isEmpty();
  }

  private static final String GRAY = "\"color\": {\"r\": 0.5, \"g\": 0.5, \"b\": 0.5}";
  private static final String GLASS = "\"ior\": 1.5";

  @Test
  void soundSceneHasNoFindings() throws Exception {
    assertThat(auditOf(material("Diffuse", GRAY), sphere(0, 1, 1))).isEmpty();
  }

  @Test
  void warningsOfTheParserAreFindings() throws Exception {
    List<Finding> findings =
        auditOf(material("Diffuse", GRAY + ", \"colour\": 1"), sphere(0, 1, 1));
    assertFinds(findings, "format", Severity.WARNING, "$.assets[0].colour", "unknown key");
  }

  @Test
  void reflectancesAboveOneAreToldWithTheirEffect() throws Exception {
    String much = "\"color\": {\"r\": 0.9, \"g\": 0.9, \"b\": 0.9}, \"specularColor\": ";
    List<Finding> findings =
        auditOf(material("Phong", much + "{\"r\": 0.6, \"g\": 0.6, \"b\": 0.6}"), sphere(0, 1, 1));
    assertFinds(
        findings,
        "reflectance",
        Severity.WARNING,
        "$.assets[0]",
        "exceeds 1 on 100 % of the surface");
    assertThat(findings).anyMatch(f -> f.means().contains("33.3 %"));
    assertSilent(
        auditOf(material("Phong", much + "{\"r\": 0.1, \"g\": 0.1, \"b\": 0.1}"), sphere(0, 1, 1)),
        "reflectance");
  }

  @Test
  void assetsThatNothingUsesAreTold() throws Exception {
    String unused =
        "{\"id\": 7, \"name\": \"old\", \"assetType\": \"Texture\", \"textureType\": \"Marble\"}";
    List<Finding> findings = auditOf(material("Diffuse", GRAY) + ", " + unused, sphere(0, 1, 1));
    assertFinds(findings, "unused", Severity.NOTE, "$.assets[1]", "texture is not used by any");
    assertThat(findings.get(0).name()).isEqualTo("old");
  }

  @Test
  void glassNeedsAnInside() throws Exception {
    String pane =
        "{\"type\": \"Shape\", \"shapeType\": \"Plane\", \"finite\": true, \"materialID\": 1,"
            + " \"localPosition\": {\"x\": 0, \"y\": 1, \"z\": 0}}";
    assertFinds(
        auditOf(material("Refractive", GLASS), pane),
        "glass",
        Severity.WARNING,
        "$.objects[3]",
        "is not closed");
    assertSilent(auditOf(material("Refractive", "\"ior\": 1"), pane), "glass");
    assertSilent(auditOf(material("Refractive", GLASS), sphere(0, 1, 1)), "glass");
  }

  @Test
  void openMeshesOfGlassAreFound() throws Exception {
    String corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
    String three = "f 1 3 2\nf 1 2 4\nf 1 4 3\n";
    String mesh =
        "{\"type\": \"Shape\", \"shapeType\": \"Mesh\", \"meshId\": 2, \"materialID\": 1}";
    assertFinds(
        auditOf(material("Refractive", GLASS) + ", " + obj(corners + three), mesh),
        "glass",
        Severity.WARNING,
        "$.objects[3]",
        "is not closed");
    String closed = obj(corners + three + "f 2 3 4\n");
    assertSilent(auditOf(material("Refractive", GLASS) + ", " + closed, mesh), "glass");
  }

  /** Models have glass as metallic-roughness materials that are boundaries of volumes. */
  @Test
  void openGlassOfModelsIsFound() throws Exception {
    String open = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nusemtl a\nf 1 3 2\nf 1 2 4\nf 1 4 3\n";
    String advice = "close the mesh, or make it thin";
    assertFinds(
        auditOfModel(open, "illum 7"),
        "glass",
        Severity.WARNING,
        "line 7",
        "glass on a surface that is not closed");
    assertThat(auditOfModel(open, "illum 7"))
        .anyMatch(finding -> finding.advice().startsWith(advice));
    assertSilent(auditOfModel(open + "f 2 3 4\n", "illum 7"), "glass");
    assertSilent(auditOfModel(open, "illum 7\nNi 1"), "glass");
    assertSilent(auditOfModel(open, "illum 2\nd 0.5"), "glass");
    String pane =
        "{\"type\": \"Shape\", \"shapeType\": \"Plane\", \"finite\": true, \"materialID\": 1}";
    String keys = "\"metallic\": 0, \"transmission\": 1";
    assertSilent(auditOf(material("MetallicRoughness", keys), pane), "glass");
    assertFinds(
        auditOf(material("MetallicRoughness", keys + ", \"attenuationDistance\": 2"), pane),
        "glass",
        Severity.WARNING,
        "$.objects[3]",
        "is not closed");
  }

  private List<Finding> auditOfModel(String text, String material) throws Exception {
    Files.writeString(directory.resolve("a.mtl"), "newmtl a\n" + material + "\n");
    Path model = Files.writeString(directory.resolve("a.obj"), "mtllib a.mtl\n" + text);
    return SceneAudit.of(StagedModel.read(model, Stage.DEFAULT, new SceneParser()).scene());
  }

  private static String obj(String text) {
    String base64 = Base64.getEncoder().encodeToString(text.getBytes(StandardCharsets.US_ASCII));
    return "{\"id\": 2, \"assetType\": \"Mesh\", \"base64OBJ\": \"" + base64 + "\"}";
  }

  @Test
  void glassThatReachesIntoGlassIsFound() throws Exception {
    String glass = material("Refractive", GLASS);
    assertFinds(
        auditOf(glass, sphere(0, 1, 1), sphere(1, 1, 1)),
        "glass",
        Severity.WARNING,
        "$.objects[3]",
        "overlaps the glass of $.objects[4]");
    assertFinds(
        auditOf(glass, sphere(0, 1, 1), sphere(0, 1, .5)),
        "glass",
        Severity.NOTE,
        "$.objects[4]",
        "entirely inside");
    assertSilent(auditOf(glass, sphere(-1.1, 1, 1), sphere(1.1, 1, 1)), "glass");
  }

  @Test
  void ratiosBeyondTheEnvelopeAreFound() throws Exception {
    String gray = material("Diffuse", GRAY);
    assertFinds(
        auditOf(gray, sphere(0, 1, 1e-9)),
        "scale",
        Severity.WARNING,
        "$.objects[3]",
        "1 to 2.89e+09");
    assertSilent(auditOf(gray, sphere(0, 1, 1e-8)), "scale");
  }

  @Test
  void picturesThatAreNoNormalMapsAreFound() throws Exception {
    String bump = material("Diffuse", GRAY + ", \"normalTextureId\": 3");
    assertFinds(
        auditOf(bump + ", " + png(8, 8, 0x96643c), sphere(0, 1, 1)),
        "normal-map",
        Severity.WARNING,
        "$.assets[0]",
        "mean z of the normal map is -0.54");
    assertSilent(auditOf(bump + ", " + png(8, 8, 0x8080ff), sphere(0, 1, 1)), "normal-map");
  }

  private static String png(int width, int height, int rgb) throws IOException {
    String base64 = Base64.getEncoder().encodeToString(Pictures.png(width, height, rgb));
    return "{\"id\": 3, \"assetType\": \"Texture\", \"base64PNG\": \"" + base64 + "\"}";
  }

  @Test
  void texturesLargerThanCanBeSeenAreFound() throws Exception {
    String assets =
        material("Diffuse", GRAY + ", \"colorTextureId\": 3") + ", " + png(2048, 1024, 0x808080);
    assertFinds(
        auditOf(assets, sphere(0, 1, 1)),
        "texture-size",
        Severity.NOTE,
        "$.assets[1]",
        "2048x1024 texels as color of $.assets[0]");
    String json =
        Files.readString(scene())
            .replace("\"width\": 32, \"height\": 24", "\"width\": 4000, \"height\": 3000");
    Files.writeString(scene(), json);
    assertSilent(SceneAudit.of(new SceneParser().parse(scene())), "texture-size");
  }

  @Test
  void lightsThatSendNothingAreFound() throws Exception {
    List<Finding> dark = audit("\"maxTraceDepth\": 50", "", FLOOR);
    assertFinds(dark, "light", Severity.WARNING, "$.objects", "has no light");
    String away =
        "{\"type\": \"Light\", \"lightType\": \"Rectangle\", \"unit\": \"radiance\","
            + " \"intensity\": 20, \"localPosition\": {\"x\": 0, \"y\": 3, \"z\": 0},"
            + " \"localRotation\": {\"x\": -90, \"y\": 0, \"z\": 0}}";
    List<Finding> findings = auditOf("", away);
    assertFinds(findings, "light", Severity.NOTE, "$.objects[3]", "pilot paths found its light");
    assertFinds(findings, "light", Severity.NOTE, "$.objects[2]", "100 % of the image's light");
    String sky = "\"background\": {\"r\": 1, \"g\": 1, \"b\": 1}, \"maxTraceDepth\": 50";
    String ofSky = "of the image's light";
    assertFinds(
        audit(sky, "", FLOOR, LAMP), "light", Severity.NOTE, "$.renderOptions.background", ofSky);
    String towards = away.replace("-90", "90");
    assertThat(auditOf("", towards)).noneMatch(f -> f.found().contains("found its light"));
  }

  @Test
  void planesThatGlowWithoutEndAreFound() throws Exception {
    String ceiling =
        "{\"type\": \"Shape\", \"shapeType\": \"Plane\", \"materialID\": 1, \"localPosition\":"
            + " {\"x\": 0, \"y\": 9, \"z\": 0}, \"localRotation\": {\"x\": 180, \"y\": 0,"
            + " \"z\": 0}}";
    List<Finding> findings = auditOf(material("Color", GRAY), ceiling);
    assertFinds(findings, "light", Severity.NOTE, "$.objects[3]", "an infinite plane that emits");
  }

  @Test
  void lightBeyondTheDepthIsMeasured() throws Exception {
    String room =
        "{\"type\": \"Shape\", \"shapeType\": \"Sphere\", \"materialID\": 1, \"radius\": 12}";
    String white = material("Diffuse", "\"color\": {\"r\": 0.8, \"g\": 0.8, \"b\": 0.8}");
    List<Finding> shallow = audit("\"maxTraceDepth\": 1", white, LAMP, room);
    // Each bounce keeps 0.8 of the light, so direct light is a fifth of the total.
    assertFinds(shallow, "depth", Severity.WARNING, "$.renderOptions.maxTraceDepth", "about ");
    assertThat(shallow)
        .anyMatch(f -> f.law().equals("depth") && f.found().matches("about (7|8).*"));
    assertSilent(audit("\"maxTraceDepth\": 60", white, LAMP, room), "depth");
  }

  @Test
  void objectsThatNothingMeetsAreFound() throws Exception {
    String gray = material("Diffuse", GRAY);
    assertFinds(
        auditOf(gray, sphere(0, -3, 1)),
        "unseen",
        Severity.NOTE,
        "$.objects[3]",
        "pilot paths hit it");
    assertSilent(auditOf(gray, sphere(0, 1, 1)), "unseen");
  }

  @Test
  void cameraThatSeesNothingComesFirst() throws Exception {
    String behind =
        "{\"type\": \"Shape\", \"shapeType\": \"Sphere\", \"colour\": 1,"
            + " \"localPosition\": {\"x\": 0, \"y\": 1, \"z\": -40}}";
    List<Finding> findings = audit("\"maxTraceDepth\": 5", "", behind, LAMP);
    assertThat(findings.get(0).found()).startsWith("the camera sees no object: none of ");
    assertThat(findings.get(0).severity()).isEqualTo(Severity.WARNING);
    assertThat(findings).filteredOn(f -> f.law().equals("unseen")).hasSize(1);
  }

  @Test
  void sharesOfLightsComeLast() throws Exception {
    String lamp = LAMP.replace("\"x\": 0", "\"x\": 2");
    String unused = material("Diffuse", GRAY).replace("\"id\": 1", "\"id\": 7");
    List<Finding> findings =
        auditOf(material("Diffuse", GRAY) + "," + unused, sphere(0, -3, 1), lamp);
    assertThat(findings)
        .extracting(Finding::law)
        .containsExactly("unseen", "unused", "light", "light");
    assertThat(findings)
        .extracting(f -> f.advice().isEmpty())
        .containsExactly(false, false, true, true);
  }

  @Test
  void samplesThatAreNoRadianceAreCounted() throws Exception {
    String blinding =
        "{\"type\": \"Light\", \"lightType\": \"Directional\", \"intensity\": 1.7e308,"
            + " \"localRotation\": {\"x\": 60, \"y\": 0, \"z\": 0}}";
    String[] many = new String[16];
    Arrays.fill(many, blinding);
    assertFinds(auditOf("", many), "radiance", Severity.WARNING, "$", "pilot paths are negative");
  }
}
