package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.cli.SvgFile.Line;
import io.github.lumbre.model.format.gltf.GltfFile;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.w3c.dom.Element;

/** Tests drawings of lines as vectors. The model's middle is that of the picture. */
class SvgCommandsTest extends CommandFixture {
  private SvgFile drawn(String model, String flags) throws Exception {
    Files.writeString(directory.resolve("m.obj"), model);
    runs("render T/m.obj -o T/m.svg --overwrite --size 400x300 " + flags);
    return SvgFile.of(bytes("m.svg"));
  }

  private static void assertPoints(Line line, double... expected) {
    assertThat(line.points()).hasSize(expected.length / 2);
    for (double[] point : line.points()) {
      boolean isFound = false;
      for (int i = 0; i < expected.length; i += 2) {
        isFound |= Math.hypot(point[0] - expected[i], point[1] - expected[i + 1]) < .01;
      }
      assertThat(isFound).as(point[0] + " " + point[1]).isTrue();
    }
  }

  /** Only areas of a color take memory for each pixel. */
  @Test
  void linesAloneHaveNoFilm() throws IOException {
    Files.writeString(directory.resolve("m.obj"), ObjShapes.cube("c", 0, 2, 0, false));
    runs("render T/m.obj -o T/big.svg --view front --page 4000x4000");
    String plain = runs("render T/m.obj -o T/m.svg --dry-run").out();
    assertThat(plain).contains("pixels ", "scene ").doesNotContain("samples", "film", "copy");
    String cut = runs("render T/m.obj -o T/m.svg --dry-run --section x=1").out();
    assertThat(cut).contains("film ").doesNotContain("samples", "copy", "denoise");
    String json = runs("render T/m.obj -o T/m.svg --overwrite --json").out();
    assertThat(json).contains("\"samples_per_pixel\":0,");
  }

  /** The front hides the back, and what is seen from its end is a point. */
  @Test
  void aCubeFromTheFrontIsASquare() throws Exception {
    SvgFile svg = drawn(ObjShapes.cube("c", 0, 2, 0, false), "--view front --hidden dashed");
    assertThat(svg.lines()).hasSize(1);
    Line square = svg.lines("visible").get(0);
    assertThat(square.isClosed()).isTrue();
    // 92 % of the height.
    assertPoints(square, 62, 12, 338, 12, 338, 288, 62, 288);
    assertThat(square.title()).isEqualTo("c");
    assertThat(square.part()).isEqualTo("part-1");
  }

  /** Three edges of a cube meet in its nearest corner, and three hidden ones in the farthest. */
  @Test
  void aCubeFromItsCornerHasNineEdgesAndThreeHiddenOnes() throws Exception {
    SvgFile svg = drawn(ObjShapes.cube("c", 0, 2, 0, false), "--view iso --hidden dashed");
    assertThat(svg.lines("visible").stream().mapToInt(line -> line.points().size() - 1).sum())
        .isEqualTo(9);
    assertThat(svg.lines("hidden")).hasSize(3);
    for (Line line : svg.lines("hidden")) {
      assertThat(line.points()).hasSize(2);
      assertThat(line.points()).anyMatch(p -> Math.hypot(p[0] - 200, p[1] - 150) < .01);
      assertThat(Math.hypot(line.x(0) - line.x(1), line.y(0) - line.y(1)))
          .isCloseTo(138, within(.01));
    }
    assertThat(drawn(ObjShapes.cube("c", 0, 2, 0, false), "--view iso").lines("hidden")).isEmpty();
  }

  @Test
  void aCavityIsHidden() throws Exception {
    String model = ObjShapes.cube("c", 0, 2, 0, false) + ObjShapes.cube("", .5, 1, 8, true);
    SvgFile svg = drawn(model, "--view front --hidden dashed");
    assertThat(svg.lines("visible")).hasSize(1);
    assertThat(svg.lines("hidden")).hasSize(1);
    assertThat(svg.lines("hidden").get(0).isClosed()).isTrue();
    assertPoints(svg.lines("hidden").get(0), 131, 81, 269, 81, 269, 219, 131, 219);
  }

  /** From the front, the nearer cube covers a quarter of the other one. */
  @Test
  void ofTwoOverlappingCubesTheFartherOneIsPartlyHidden() throws Exception {
    String model = ObjShapes.cube("far", 0, 2, 0, false) + ObjShapes.cube("near", 1, 2, 8, false);
    SvgFile svg = drawn(model, "--view front --hidden dashed");
    List<Line> visible = svg.lines("visible");
    assertThat(visible).hasSize(2);
    assertPoints(visible.get(0), 154, 104, 62, 104, 62, 288, 246, 288, 246, 196);
    assertThat(visible.get(0).title()).isEqualTo("far");
    assertPoints(visible.get(1), 154, 12, 338, 12, 338, 196, 154, 196);
    assertThat(svg.lines("hidden")).hasSize(1);
    assertPoints(svg.lines("hidden").get(0), 154, 104, 246, 104, 246, 196);
  }

  /** Each instance of a mesh is a part with its own name. */
  @Test
  void fourInstancesAreFourParts() throws Exception {
    GltfFile file = new GltfFile();
    String mesh = String.valueOf(file.triangle(""));
    for (int i = 0; i < 4; i++) {
      file.add(
          "nodes",
          "{'name': 'bolt %d', 'mesh': %s, 'translation': [%d, 0, 0]}".formatted(i, mesh, 2 * i));
    }
    Files.write(directory.resolve("bolts.glb"), file.glb());
    runs("render T/bolts.glb -o T/m.svg --view front --hidden dashed");
    List<Line> lines = SvgFile.of(bytes("m.svg")).lines();
    assertThat(lines)
        .extracting(Line::title)
        .containsExactly("bolt 0", "bolt 1", "bolt 2", "bolt 3");
    assertThat(lines).allMatch(line -> line.isClosed() && line.points().size() == 3);
    assertThat(lines)
        .extracting(Line::part)
        .containsExactly("part-1", "part-2", "part-3", "part-4");
  }

  @Test
  void aSphereIsACircle() throws Exception {
    String sphere =
        ObjShapes.grid(
            64,
            64,
            (a, b) ->
                new double[] {
                  Math.sin(b / 2) * Math.cos(a), Math.cos(b / 2), Math.sin(b / 2) * Math.sin(a)
                });
    SvgFile svg = drawn(sphere, "--view 20,10 --parallel --hidden dashed");
    Line circle = svg.lines("visible").get(0);
    assertThat(svg.lines("visible")).hasSize(1);
    assertThat(circle.isClosed()).isTrue();
    assertThat(circle.points())
        .allMatch(p -> Math.abs(Math.hypot(p[0] - 200, p[1] - 150) - 138) < 2);
  }

  /** From the side, a torus has the outline of a slot, and hides half of two circles. */
  @Test
  void aTorusIsASlotFromTheSideAndTwoCirclesFromAbove() throws Exception {
    String torus = ObjShapes.torus("t", 0, 0, 0);
    SvgFile side = drawn(torus, "--view front --hidden dashed");
    assertThat(side.lines("visible")).hasSize(1);
    assertThat(side.lines("visible").get(0).isClosed()).isTrue();
    assertThat(side.lines("hidden")).hasSize(2);
    double scale = 368 / 5.4;
    for (Line half : side.lines("hidden")) {
      double middle = half.x(0) < 200 ? 200 - 2 * scale : 200 + 2 * scale;
      assertThat(half.isClosed()).isFalse();
      assertThat(half.points())
          .allMatch(p -> Math.abs(Math.hypot(p[0] - middle, p[1] - 150) - .7 * scale) < .5)
          .allMatch(p -> Math.abs(p[0] - 200) < 2 * scale + .1);
    }
    SvgFile above = drawn(torus, "--view top --hidden dashed");
    assertThat(above.lines()).hasSize(2).allMatch(Line::isClosed);
    assertThat(above.lines("hidden")).isEmpty();
  }

  @Test
  void namesAreTextWhateverTheyAre() throws Exception {
    List<String> names =
        List.of("</title></g><script>alert(1)</script>", "\"'&<!ENTITY x>", "é ☃ 🦔", "a]]>b");
    StringBuilder model = new StringBuilder();
    for (int i = 0; i < names.size(); i++) {
      model.append(ObjShapes.cube(names.get(i), 3 * i, 2, 8 * i, false));
    }
    SvgFile svg = drawn(model.toString(), "--view front --labels parts");
    assertThat(svg.lines("visible")).extracting(Line::title).containsExactlyElementsOf(names);
    assertThat(SvgFile.elements(svg.root(), "*"))
        .extracting(Element::getTagName)
        .containsOnly("rect", "g", "title", "path");
    assertThat(new String(bytes("m.svg"), StandardCharsets.UTF_8)).doesNotContain("<!", "<?");
  }

  @Test
  void manyPartsAreGroupsOfWhatIsSeen() throws Exception {
    StringBuilder model = new StringBuilder();
    int count = 2000;
    for (int i = 0; i < count; i++) {
      int x = i % 50;
      int y = i / 50;
      model.append("o p%d\nv %d %d 0\nv %2$d.5 %3$d 0\nv %2$d %3$d.5 0\n".formatted(i, x, y));
      model.append("f -3 -2 -1\n");
    }
    SvgFile svg = drawn(model.toString(), "--view front");
    assertThat(svg.lines().stream().map(Line::part).distinct()).hasSize(count);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "--look clay", "--look clay,lines", "--sky studio", "--ground", "-s 4", "--denoise",
        "--samples 2", "--background sky", "--exposure 1", "--layers all", "--target-error 2%"
      })
  void flagsOfLightAreRefused(String flag) throws IOException {
    Files.writeString(directory.resolve("m.obj"), ObjShapes.cube("c", 0, 2, 0, false));
    Outcome outcome = run("render T/m.obj -o T/m.svg " + flag);
    assertThat(outcome.exitCode()).isEqualTo(2);
    String name = flag.split(" ")[0].replaceFirst("^-s$", "--samples");
    assertThat(outcome.err()).contains(name + ": ");
    assertThat(directory.resolve("m.svg")).doesNotExist();
  }

  @ParameterizedTest
  @CsvSource({"render T/tiny.json -o T/a.svg, tiny.json", "develop T/a.film -o T/a.svg, a.svg"})
  void whatIsNoModelIsRefused(String line, String name) {
    Outcome outcome = withScene("{}", line);
    assertThat(outcome.exitCode()).isEqualTo(2);
    assertThat(outcome.err()).contains(name);
  }

  /** Lines alone take no samples: the same bytes whatever the flags of sampling are. */
  @Test
  void samplingChangesNothingInLinesAlone() throws IOException {
    Files.writeString(directory.resolve("m.obj"), ObjShapes.cube("c", 0, 2, 0, false));
    String line = "render T/m.obj --look lines --hidden dashed --size 60x40 --json -o T/";
    Outcome outcome = runs(line + "a.png");
    assertThat(outcome.out()).contains("\"samples\":0");
    runs(line + "b.png -s 64 --denoise --seed 3 --threads 1 --mode ray --time 1s");
    assertSame("a.png", "b.png");
    Outcome film = runs("render T/m.obj --look lines -s 2 --checkpoint T/c.film -o T/c.png");
    assertThat(film.err()).contains("2 samples per pixel");
  }

  @Test
  void aDrawingReplacesADrawingAndNothingElse() throws Exception {
    Files.writeString(directory.resolve("m.svg"), "a text");
    Files.writeString(directory.resolve("m.obj"), ObjShapes.cube("c", 0, 2, 0, false));
    assertThat(run("render T/m.obj -o T/m.svg").exitCode()).isEqualTo(6);
    runs("render T/m.obj -o T/n.svg --size 80x60");
    runs("render T/m.obj -o T/n.svg --view front --size 40x30 --crop 0,0,20,30");
    assertThat(SvgFile.of(bytes("n.svg")).root().getAttribute("viewBox")).isEqualTo("0 0 20 30");
  }

  @Test
  void turntablesAndFoldersAreDrawnToo() throws Exception {
    Files.writeString(directory.resolve("m.obj"), ObjShapes.cube("c", 0, 2, 0, false));
    runs("render T/m.obj -o T/t.svg --turntable 2 --size 40x30");
    assertThat(SvgFile.of(bytes("t-001.svg")).lines("visible")).isNotEmpty();
    runs("render T/m.obj -o T/folder --format svg --background transparent --size 40x30");
    SvgFile clear = SvgFile.of(bytes("folder/m.svg"));
    assertThat(SvgFile.elements(clear.root(), "rect")).isEmpty();
    assertThat(SvgFile.elements(clear.root(), "path"))
        .anyMatch(path -> path.getAttribute("fill").equals("#ffffff"));
  }

  @Test
  void threadsChangeNothing() throws Exception {
    String model = ObjShapes.cube("c", 0, 2, 0, false) + ObjShapes.cube("d", 1.5, 2, 8, false);
    String flags = "--view 30,20 --hidden dashed --section z=1.7 --highlight c --labels all ";
    drawn(model, flags + "--threads 1");
    byte[] one = bytes("m.svg");
    drawn(model, flags + "--threads 3");
    assertThat(bytes("m.svg")).isEqualTo(one);
  }

  /** The front half is cut away: a square of hatch lines, with dimensions around what is left. */
  @Test
  void sectionsAreHatched() throws Exception {
    String flags = "--view front --section z=0.5 --labels size --highlight c";
    SvgFile svg = drawn(ObjShapes.cube("c", 0, 2, 0, false), flags);
    List<Line> hatch = svg.lines("hatch");
    Line square = svg.lines("visible").get(0);
    double left = square.points().stream().mapToDouble(p -> p[0]).min().orElseThrow();
    double right = square.points().stream().mapToDouble(p -> p[0]).max().orElseThrow();
    double top = square.points().stream().mapToDouble(p -> p[1]).min().orElseThrow();
    assertThat(hatch).hasSizeGreaterThan(10);
    for (Line line : hatch) {
      assertThat(line.points()).hasSize(2);
      assertThat(line.x(0) - line.x(1)).isCloseTo(line.y(1) - line.y(0), within(.01));
      assertThat(line.points()).allMatch(p -> p[0] > left - .01 && p[0] < right + .01);
    }
    Element fill =
        SvgFile.elements(svg.root(), "path").stream()
            .filter(path -> path.getAttribute("class").equals("fill"))
            .findFirst()
            .orElseThrow();
    assertThat(fill.getAttribute("fill")).matches("#[0-9a-f]{6}").isNotEqualTo("#ffffff");
    // The depth that is left is seen from above, not the whole.
    SvgFile above = drawn(ObjShapes.cube("c", 0, 2, 0, false), flags.replace("front", "top"));
    double nearest =
        above.lines("visible").get(0).points().stream().mapToDouble(p -> p[1]).max().orElseThrow();
    assertThat(above.lines("label").stream().flatMap(line -> line.points().stream()))
        .noneMatch(p -> p[1] > nearest + 60);
    assertThat(top).isGreaterThan(0);
  }

  @Test
  void scalesAreMillimetersOnPaper() throws Exception {
    Files.writeString(directory.resolve("m.obj"), ObjShapes.cube("c", 0, 100, 0, false));
    runs("render T/m.obj -o T/m.svg --view front --scale 1:2 --page a4");
    SvgFile svg = SvgFile.of(bytes("m.svg"));
    assertThat(svg.root().getAttribute("width")).isEqualTo("210mm");
    assertThat(svg.root().getAttribute("viewBox")).isEqualTo("0 0 210 297");
    assertPoints(svg.lines().get(0), 80, 123.5, 130, 123.5, 130, 173.5, 80, 173.5);
    Outcome large = run("render T/m.obj -o T/n.svg --view front --scale 3:1 --page a4");
    assertThat(large.exitCode()).isEqualTo(2);
    assertThat(large.err()).contains("scale: ", "does not fit");
    Outcome perspective = run("render T/m.obj -o T/n.svg --scale 1:2");
    assertThat(perspective.exitCode()).isEqualTo(2);
    assertThat(perspective.err()).contains("scale: ", "parallel");
  }

  @Test
  void metersOfFilesAreConverted() throws Exception {
    Files.write(directory.resolve("m.glb"), GltfFile.ofTriangle().glb());
    runs("render T/m.glb -o T/m.svg --view front --scale 1:10");
    Line triangle = SvgFile.of(bytes("m.svg")).lines().get(0);
    assertThat(triangle.points().stream().mapToDouble(p -> p[0]).max().orElseThrow())
        .isCloseTo(
            100 + triangle.points().stream().mapToDouble(p -> p[0]).min().orElseThrow(),
            within(.01));
    assertThat(run("render T/m.glb -o T/n.svg --page a4 --size 100x100").exitCode()).isEqualTo(2);
    assertThat(run("render T/m.glb -o T/n.svg --page a9").err()).contains("a0 to a5", "a9");
    assertThat(run("render T/m.glb -o T/n.svg --scale 0:1").err()).contains("--scale: ", "0:1");
  }

  /** The top is above the front, and the right side at its right, in one scale. */
  @Test
  void viewsAreASheetInProjection() throws Exception {
    Files.writeString(
        directory.resolve("m.obj"),
        ObjShapes.cube("c", 0, 2, 0, false)
            .replace("v 2.0", "v 4.0")
            .replaceAll("2\\.0\n", "1.0\n"));
    runs("views T/m.obj -o T/v.svg --size 200x100");
    SvgFile svg = SvgFile.of(bytes("v.svg"));
    assertThat(svg.root().getAttribute("viewBox")).isEqualTo("0 0 800 300");
    // From the corner, the box is highest: 4, 2 and 1 along axes at 120 degrees.
    double scale = .92 * 100 / ((4 + 1) * Math.sqrt(1. / 6) + 2 * Math.sqrt(2. / 3));
    assertBox(svg, "front", 300, 150, 4 * scale, 2 * scale);
    assertBox(svg, "top", 300, 50, 4 * scale, scale);
    assertBox(svg, "bottom", 300, 250, 4 * scale, scale);
    assertBox(svg, "left", 100, 150, scale, 2 * scale);
    assertBox(svg, "right", 500, 150, scale, 2 * scale);
    assertBox(svg, "back", 700, 150, 4 * scale, 2 * scale);
    assertThat(svg.lines().stream().map(Line::part)).contains("iso-part-1");
    assertThat(run("views T/m.obj -o T/w.svg -s 2").exitCode()).isEqualTo(2);
  }

  private static void assertBox(
      SvgFile svg, String view, double x, double y, double width, double height) {
    List<Line> lines =
        svg.lines().stream().filter(line -> line.part().equals(view + "-part-1")).toList();
    assertThat(lines).hasSize(1);
    assertPoints(
        lines.get(0),
        x - width / 2,
        y - height / 2,
        x + width / 2,
        y - height / 2,
        x + width / 2,
        y + height / 2,
        x - width / 2,
        y + height / 2);
  }
}
