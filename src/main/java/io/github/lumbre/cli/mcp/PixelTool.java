package io.github.lumbre.cli.mcp;

import io.github.lumbre.cli.output.JsonText;
import io.github.lumbre.cli.output.PixelJson;
import io.github.lumbre.cli.output.PixelPlace;
import io.github.lumbre.cli.output.PixelReport;
import io.github.lumbre.image.internal.DisplayRows;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.render.PixelReplay;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.stage.drawing.DisplayLight;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Explains a pixel of a picture that {@link RenderTool} makes. */
record PixelTool(Studio studio) implements Tool {
  private static final int LAST = RenderTool.MOST_PIXELS - 1;

  private static final Input<Integer> X =
      Input.requiredInteger("x", 0, LAST, "Column of the pixel; 0 is the left one.");

  private static final Input<Integer> Y =
      Input.requiredInteger("y", 0, LAST, "Row of the pixel; 0 is the top one.");

  private static final Input<Boolean> PATHS =
      Input.flag(
          "paths",
          "Whether to return the samples, too, and the path of the brightest one, in the scene's"
              + " left-handed space: z is reversed.");

  private static final String NONE = "none";

  private static final int OPAQUE = 255;

  private static final int OPAQUE_BANDS = 3;

  @Override
  public String name() {
    return "pixel";
  }

  @Override
  public String title() {
    return "Explain a pixel";
  }

  @Override
  public String description() {
    return "Says what is seen in the center of a pixel of the picture that 'render' or 'section'"
        + " makes with the same arguments, in five lines: the part, the position and the normal of"
        + " its surface in the space of the bounds, the color in the picture, and the depth.";
  }

  @Override
  public List<Input<?>> inputs() {
    List<Input<?>> inputs =
        new ArrayList<>(
            List.of(
                ModelInputs.MODEL_OR_SCENE,
                X,
                Y,
                RenderTool.WIDTH,
                RenderTool.HEIGHT,
                RenderTool.SAMPLES,
                RenderTool.CROP,
                PATHS));
    inputs.addAll(ModelInputs.allBut());
    return inputs;
  }

  @Override
  public List<Output> outputs() {
    String none = "; missing if no surface is seen.";
    return List.of(
        Output.count("x", "Column of the pixel."),
        Output.count("y", "Row of the pixel."),
        Output.text("part", "Name of the part or object" + none).optional(),
        Output.text("material", "Name of its material; missing if it has none.").optional(),
        Output.numbers("position", 3, "In the space of the bounds" + none).optional(),
        Output.numbers("normal", 3, "Unit vector towards the viewer's side" + none).optional(),
        Output.number("depth", "Distance along the direction of the camera" + none).optional(),
        Output.text("color", "In the picture: #rrggbb, or #rrggbbaa if it is transparent."),
        Output.open("paths", "Samples of the pixel; only if asked for.").optional());
  }

  @Override
  public Outcome call(Arguments arguments, CallProgress progress)
      throws ToolException, InterruptedException {
    Shot shot = RenderTool.shot(studio, arguments);
    Crop window = shot.file().settings().window();
    int x = arguments.get(X);
    int y = arguments.get(Y);
    if (x >= window.width() || y >= window.height()) {
      throw new ToolException(
          "x, y: expected a pixel of %dx%d, found %d,%d"
              .formatted(window.width(), window.height(), x, y));
    }
    progress.expect(window.pixels() * shot.file().settings().samples());
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("x", x);
    values.put("y", y);
    Optional<PixelPoint> seen = PixelPoint.of(shot, window.x() + x, window.y() + y);
    seen.ifPresent(point -> put(point, values));
    values.put("color", color(studio.picture(shot, progress).picture(), x, y));
    if (arguments.get(PATHS)) {
      values.put("paths", paths(shot, window.x() + x, window.y() + y));
    }
    Map<String, Object> rounded = shot.rounding().values(values);
    return new Outcome(List.of(), rounded, Optional.of(text(rounded)));
  }

  private static void put(PixelPoint point, Map<String, Object> values) {
    values.put("part", point.part());
    if (!point.material().isEmpty()) {
      values.put("material", point.material());
    }
    values.put("position", vector(point.position()));
    values.put("normal", vector(point.normal()));
    values.put("depth", point.depth());
  }

  private static List<Double> vector(Vec3 v) {
    return List.of(v.x(), v.y(), v.z());
  }

  /** Returns the sRGB color of a pixel as CSS writes it, with alpha if it is not opaque. */
  private static String color(DisplayLight picture, int x, int y) {
    DisplayRows rows = DisplayRows.of(picture.image(), picture.options(), Byte.SIZE, true);
    int[] row = new int[rows.bands() * rows.width()];
    rows.read(y, row);
    StringBuilder color = new StringBuilder("#");
    for (int band = 0; band < rows.bands(); band++) {
      int value = row[rows.bands() * x + band];
      if (band < OPAQUE_BANDS || value < OPAQUE) {
        color.append(HexFormat.of().toHexDigits((byte) value));
      }
    }
    return color.toString();
  }

  private static Map<String, Object> paths(Shot shot, int x, int y) {
    PixelReplay replay = new PixelReplay(shot.file().scene(), shot.file().settings());
    PixelReport report = new PixelReport(shot.file(), new PixelPlace(x, y));
    return PixelJson.values(report, replay.pixel(x, y, 1));
  }

  /** Returns the lines that say what is seen, and the paths, if they are there. */
  private static String text(Map<String, Object> values) {
    String material = values.containsKey("material") ? ", material " + values.get("material") : "";
    String text =
        "part: %s\nposition: %s\nnormal: %s\ncolor: %s\ndepth: %s"
            .formatted(
                values.getOrDefault("part", NONE) + material,
                line(values.get("position")),
                line(values.get("normal")),
                values.get("color"),
                line(values.get("depth")));
    return values.containsKey("paths")
        ? text + "\npaths: " + JsonText.line(values.get("paths"))
        : text;
  }

  private static String line(Object value) {
    return value == null
        ? NONE
        : JsonText.line(value).replaceAll("[\\[\\]]", "").replace(",", ", ");
  }
}
