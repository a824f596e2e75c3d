package io.github.lumbre.stage.drawing;

import static io.github.lumbre.stage.drawing.CanvasTest.white;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.camera.Camera;
import io.github.lumbre.camera.Lens;
import io.github.lumbre.camera.internal.Projection;
import io.github.lumbre.image.Image;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Sha256;
import io.github.lumbre.stage.drawing.LabelSheet.Text;
import io.github.lumbre.stage.drawing.LabelSheet.Tone;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests where labels are, on random models, cameras and sizes of pictures. */
class LabelsTest {
  private static final int TRIALS = 300;
  private static final Transform FLIPPED = Transform.scale(new Vec3(1, 1, -1));

  /** The labels of a picture, and what they are about. */
  private record Trial(int width, int height, LabeledModel model, PartMap map, Labels labels) {
    static Trial of(long seed) {
      Random random = new Random(seed);
      int width = 64 + random.nextInt(700);
      int height = 64 + random.nextInt(500);
      LabeledModel model = randomModel(random, width, height, random.nextBoolean());
      PartMap map = randomMap(random, width, height);
      Labels labels = new Labels(width, height);
      labels.addTitle("iso");
      labels.addAxes(model);
      labels.addScale(model);
      labels.addParts(map);
      labels.addSizes(model);
      labels.addBox(model);
      return new Trial(width, height, model, map, labels);
    }
  }

  /** Returns a model that fills about half of a picture. */
  private static LabeledModel randomModel(
      Random random, int width, int height, boolean isParallel) {
    double scale = Math.pow(10, random.nextInt(13) - 6);
    double[] size = random.doubles(3, .2 * scale, scale).toArray();
    Vec3 min = new Vec3(random.nextDouble(), random.nextDouble(), random.nextDouble()).times(scale);
    Vec3 max = min.plus(new Vec3(size[0], size[1], size[2]));
    Vec3 middle = FLIPPED.point(min.times(.5).plus(.5, max));
    Vec3 from =
        new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).normalized();
    Vec3 eye = middle.plus(4 * scale, from);
    Frame axes = Frame.lookingAt(eye, middle, Vec3.Y);
    double aspect = (double) width / height;
    Camera camera =
        isParallel
            ? Lens.orthographic(3 * scale).camera(eye, axes, aspect)
            : Lens.pinhole(40).camera(eye, axes, aspect);
    Projection projection = Projection.of(camera, width, height).orElseThrow().from(FLIPPED);
    List<Vec3> seen =
        Stream.of(Vec3.X, Vec3.Y, Vec3.Z).map(a -> axes.toLocal(FLIPPED.vector(a))).toList();
    return new LabeledModel(projection, seen, min, max, "millimeter");
  }

  /** Returns rectangles of parts, over each other. */
  private static PartMap randomMap(Random random, int width, int height) {
    int[] parts = new int[width * height];
    Arrays.fill(parts, -1);
    List<String> names = new ArrayList<>();
    int count = random.nextInt(30);
    for (int part = 0; part < count; part++) {
      names.add("part " + "x".repeat(random.nextInt(12)) + part);
      int left = random.nextInt(width);
      int top = random.nextInt(height);
      int right = Math.min(width, left + 1 + random.nextInt(width / 3));
      int bottom = Math.min(height, top + 1 + random.nextInt(height / 3));
      for (int y = top; y < bottom; y++) {
        Arrays.fill(parts, y * width + left, y * width + right, part);
      }
    }
    return new PartMap(names, width, parts);
  }

  private static Image drawn(Labels labels, int width, int height) {
    Image picture = white(width, height);
    Canvas canvas = new Canvas(picture);
    labels.draw(canvas, picture);
    return canvas.image();
  }

  @Test
  void textsLieInThePictureAndApart() {
    int texts = 0;
    for (int seed = 0; seed < TRIALS; seed++) {
      Trial trial = Trial.of(seed);
      List<Text> placed = trial.labels.sheet().texts();
      Rect frame = new Rect(0, 0, trial.width, trial.height);
      for (int i = 0; i < placed.size(); i++) {
        assertThat(placed.get(i).box().isInside(frame)).as(seed + ": " + placed.get(i)).isTrue();
        for (Text other : placed.subList(0, i)) {
          assertThat(placed.get(i).box().overlaps(other.box()))
              .as(seed + ": " + placed.get(i) + other)
              .isFalse();
        }
      }
      texts += placed.size();
    }
    assertThat(texts).isGreaterThan(6 * TRIALS);
  }

  @ParameterizedTest
  @ValueSource(ints = {60, 400, 1500})
  void textsLieInTheirBoxes(int height) {
    int width = 2 * height;
    LabelSheet sheet = new LabelSheet(width, height);
    String text = height < 100 ? "ÄgjQ|" : "ÄÖgjpqQ|@{}_Ø!";
    assertThat(sheet.write(text, .5 * width, .5 * height, sheet.capital(), Tone.INK)).isTrue();
    float[] gray = new float[3 * width * height];
    Arrays.fill(gray, .5f);
    Canvas canvas = new Canvas(new Image(width, height, gray, new float[0]));
    sheet.draw(canvas, false);
    Rect box = sheet.texts().get(0).box();
    Image image = canvas.image();
    int changed = 0;
    for (int y = 0; y < height; y++) {
      for (int x = 0; x < width; x++) {
        if (image.pixel(x, y).g() != .5) {
          // A pixel at the border of the box may be partly outside.
          assertThat(new Rect(x + 1, y + 1, x, y).isInside(box)).as(x + ", " + y).isTrue();
          changed++;
        }
      }
    }
    assertThat(changed).isGreaterThan(100);
  }

  @Test
  void linesEndInTheirPartsAndDoNotCross() {
    int lines = 0;
    for (int seed = 0; seed < TRIALS; seed++) {
      Trial trial = Trial.of(seed);
      List<List<Rect>> leaders = trial.labels.sheet().leaders();
      List<String> names =
          trial.labels.sheet().texts().stream()
              .map(Text::text)
              .filter(text -> text.startsWith("part"))
              .toList();
      assertThat(leaders).hasSize(2 * names.size());
      for (int i = 0; i < names.size(); i++) {
        Rect end = last(leaders.get(2 * i + 1));
        String shown = trial.map.nameAt((int) end.left(), (int) end.top()).orElseThrow();
        assertThat(shown).startsWith(names.get(i).replace("...", ""));
        for (int j = 0; j < i; j++) {
          assertThat(cross(leaders.get(2 * i + 1), leaders.get(2 * j + 1)))
              .as(seed + ": " + names.get(i) + ", " + names.get(j))
              .isFalse();
        }
      }
      lines += names.size();
    }
    assertThat(lines).isGreaterThan(4 * TRIALS);
  }

  private static Rect last(List<Rect> points) {
    return points.get(points.size() - 1);
  }

  /** Returns whether two segments have a point inside of both. */
  private static boolean cross(List<Rect> a, List<Rect> b) {
    return side(a, b.get(0)) * side(a, last(b)) < 0 && side(b, a.get(0)) * side(b, last(a)) < 0;
  }

  private static double side(List<Rect> line, Rect point) {
    Rect from = line.get(0);
    Rect to = last(line);
    return Math.signum(
        (to.left() - from.left()) * (point.top() - from.top())
            - (to.top() - from.top()) * (point.left() - from.left()));
  }

  @Test
  void linesLeadToPixelsThatAreFarthestFromOtherParts() {
    for (int seed = 0; seed < 20; seed++) {
      int width = 25;
      int height = 19;
      PartMap map = randomMap(new Random(seed), width, height);
      for (Optional<PartMap.Visible> found : map.visible(0, width)) {
        PartMap.Visible part = found.orElseThrow();
        int best =
            IntStream.range(0, width * height)
                .filter(i -> is(map, part.name(), i % width, i / width))
                .map(i -> distance(map, part.name(), i % width, i / width))
                .max()
                .orElseThrow();
        assertThat(is(map, part.name(), part.x(), part.y())).isTrue();
        assertThat(distance(map, part.name(), part.x(), part.y())).isEqualTo(best);
      }
    }
  }

  private static boolean is(PartMap map, String name, int x, int y) {
    return map.nameAt(x, y).equals(Optional.of(name));
  }

  /** Returns the half side of the smallest square around a pixel with a pixel of another part. */
  private static int distance(PartMap map, String name, int x, int y) {
    int radius = 0;
    while (isAll(map, name, x, y, radius)) {
      radius++;
    }
    return radius;
  }

  private static boolean isAll(PartMap map, String name, int x, int y, int radius) {
    for (int row = y - radius; row <= y + radius; row++) {
      for (int column = x - radius; column <= x + radius; column++) {
        if (!is(map, name, column, row)) {
          return false;
        }
      }
    }
    return true;
  }

  @Test
  void dimensionsAreThoseOfTheBox() {
    int numbers = 0;
    for (int seed = 0; seed < TRIALS; seed++) {
      Random random = new Random(seed);
      LabeledModel model = randomModel(random, 800, 600, random.nextBoolean());
      Labels labels = new Labels(800, 600);
      labels.addSizes(model);
      List<Double> sizes =
          IntStream.range(0, 3)
              .mapToObj(axis -> model.max().get(axis) - model.min().get(axis))
              .toList();
      for (Text text : labels.sheet().texts()) {
        assertThat(text.text()).endsWith(" mm");
        double shown = Double.parseDouble(text.text().replace(" mm", ""));
        double nearest =
            sizes.stream().min(Comparator.comparingDouble(s -> Math.abs(s - shown))).orElseThrow();
        // Four significant digits: half a unit of the last one, of at least 1000.
        assertThat(shown).isCloseTo(nearest, within(5e-4 * nearest));
        numbers++;
      }
      assertThat(labels.leftOut()).as("seed " + seed).isEmpty();
    }
    assertThat(numbers).isGreaterThan(2 * TRIALS);
  }

  /** The bar is measured by its ticks, above the line. */
  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void scaleBarsHaveTheLengthThatTheyState(boolean isParallel) {
    for (int seed = 0; seed < 20; seed++) {
      LabeledModel model = randomModel(new Random(seed), 800, 600, isParallel);
      Labels labels = new Labels(800, 600);
      labels.addScale(model);
      String text = labels.sheet().texts().get(0).text();
      double length = Double.parseDouble(text.replace(" mm", ""));
      // In the file's space, a step to the right of the camera, at the middle of the box.
      Vec3 middle = model.min().times(.5).plus(.5, model.max());
      Vec3 right =
          new Vec3(model.axes().get(0).x(), model.axes().get(1).x(), model.axes().get(2).x());
      double expected =
          model.projection().pixel(middle.plus(length, right)).x()
              - model.projection().pixel(middle).x();
      Image image = drawn(labels, 800, 600);
      int row = (int) (600 - 1.6 * labels.sheet().capital() - .3 * labels.sheet().capital());
      double[] ends = darkColumns(image, row);
      assertThat(ends[1] - ends[0]).as(text).isCloseTo(expected, within(.5));
      assertThat(ends[1] - ends[0]).isBetween(79., 201.);
    }
  }

  /** Returns the middles of the left and the right dark area of a row. */
  private static double[] darkColumns(Image image, int row) {
    double[] weights = new double[2];
    double[] sums = new double[2];
    int first = -1;
    for (int x = 0; x < image.width(); x++) {
      double dark = 1 - image.pixel(x, row).g();
      if (dark > 0) {
        first = first < 0 ? x : first;
        int end = x - first < 10 ? 0 : 1;
        weights[end] += dark;
        sums[end] += dark * (x + .5);
      }
    }
    return new double[] {sums[0] / weights[0], sums[1] / weights[1]};
  }

  @Test
  void lettersStandAtTheEndsOfTheirAxes() {
    for (int seed = 0; seed < TRIALS; seed++) {
      LabeledModel model = randomModel(new Random(seed), 800, 600, true);
      Labels labels = new Labels(800, 600);
      labels.addAxes(model);
      assertThat(labels.sheet().texts()).hasSize(3);
      double reach = 5.8 * labels.sheet().capital();
      for (Text letter : labels.sheet().texts()) {
        Vec3 axis = model.axes().get("XYZ".indexOf(letter.text()));
        double x = .5 * (letter.box().left() + letter.box().right()) - reach;
        double y = 600 - reach - .5 * (letter.box().top() + letter.box().bottom());
        double seen = Math.sqrt(axis.x() * axis.x() + axis.y() * axis.y());
        if (seen > .6) {
          // The letter is 1.5 capitals from the end; its box is not quite symmetric.
          double length = 3 * labels.sheet().capital();
          double offX = x - length * axis.x();
          double offY = y - length * axis.y();
          assertThat(Math.sqrt(offX * offX + offY * offY))
              .as(seed + letter.text())
              .isBetween(1.4 * labels.sheet().capital(), 1.6 * labels.sheet().capital());
        }
      }
    }
  }

  @Test
  void darkPicturesHaveBrightLabels() {
    Labels labels = new Labels(400, 300);
    labels.addTitle("front");
    Image black = Image.black(400, 300);
    Canvas canvas = new Canvas(black);
    labels.draw(canvas, black);
    Image image = canvas.image();
    assertThat(brightest(image)).isGreaterThan(.9f);
    assertThat(brightest(drawn(labels, 400, 300))).isEqualTo(1);
    float[] rgb = drawn(labels, 400, 300).rgb();
    assertThat(IntStream.range(0, rgb.length).mapToDouble(i -> rgb[i]).min().orElseThrow())
        .isLessThan(.1);
  }

  private static float brightest(Image image) {
    float brightest = 0;
    for (float value : image.rgb()) {
      brightest = Math.max(brightest, value);
    }
    return brightest;
  }

  @Test
  void labelsOnTransparentPicturesAreOpaque() {
    Labels labels = new Labels(400, 300);
    labels.addTitle("front");
    Image clear = new Image(400, 300, new float[3 * 400 * 300], new float[400 * 300]);
    Canvas canvas = new Canvas(clear);
    labels.draw(canvas, clear);
    Image image = canvas.image();
    long opaque =
        IntStream.range(0, 400 * 300).filter(i -> image.alpha(i % 400, i / 400) == 1).count();
    assertThat(opaque).isGreaterThan(200);
  }

  @Test
  void smallPicturesLeaveOutWhatHasNoRoom() {
    LabeledModel model = randomModel(new Random(1), 64, 64, true);
    Labels labels = new Labels(64, 64);
    labels.addTitle("iso");
    labels.addAxes(model);
    labels.addScale(model);
    labels.addParts(new PartMap(List.of("a long name"), 64, new int[64 * 64]));
    labels.addSizes(model);
    assertThat(String.join("; ", labels.leftOut()))
        .startsWith("no room for the axes")
        .contains("the dimensions");
    assertThat(labels.sheet().texts()).extracting(Text::text).contains("iso");
  }

  /** The labels have the same bits on every machine. */
  @Test
  void pictureIsThatOfAllMachines() {
    Trial trial = Trial.of(5);
    Image image = drawn(trial.labels, trial.width, trial.height);
    ByteBuffer bytes = ByteBuffer.allocate(Float.BYTES * image.rgb().length);
    bytes.asFloatBuffer().put(image.rgb());
    assertThat(HexFormat.of().formatHex(Sha256.digest().digest(bytes.array())))
        .isEqualTo("2777a7b36fdf97a25441d935ea0e0392f696d6c6e6bff3a95870dadf61e0e0c4");
  }
}
