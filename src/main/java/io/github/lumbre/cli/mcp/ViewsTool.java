package io.github.lumbre.cli.mcp;

import io.github.lumbre.cli.output.JsonSummary;
import io.github.lumbre.cli.run.CleanPicture;
import io.github.lumbre.cli.run.Denoising;
import io.github.lumbre.drawing.DisplayLight;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.internal.ContactSheet;
import io.github.lumbre.image.internal.ImageFormat;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.parser.Stage.View;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** Renders a model from all sides on one sheet. */
final class ViewsTool implements Tool {
  private static final int MOST_PIXELS = 640;
  private static final int COLUMNS = 4;

  private static final Input<Integer> WIDTH =
      Input.integer("width", 16, MOST_PIXELS, 320, "Width of each picture in pixels.");

  private static final Input<Integer> HEIGHT =
      Input.integer("height", 16, MOST_PIXELS, 240, "Height of each picture in pixels.");

  private final Studio studio;

  ViewsTool(Studio studio) {
    this.studio = studio;
  }

  @Override
  public String name() {
    return "views";
  }

  @Override
  public String title() {
    return "Show a model from all sides";
  }

  @Override
  public String description() {
    return "Renders a 3D model from the front, back, left, right, top, bottom and isometrically, on"
        + " one PNG picture: four views in the upper row, three in the lower one, in this order.";
  }

  @Override
  public List<Input<?>> inputs() {
    return List.of(
        ModelInputs.MODEL,
        WIDTH,
        HEIGHT,
        ModelInputs.HIDE,
        ModelInputs.HIGHLIGHT,
        ModelInputs.LABELS,
        ModelInputs.LOOK,
        ModelInputs.Z_UP);
  }

  @Override
  public Outcome call(Arguments arguments, CallProgress progress)
      throws ToolException, InterruptedException {
    Studio.Staged model = ModelInputs.model(studio, arguments);
    int width = arguments.get(WIDTH);
    int height = arguments.get(HEIGHT);
    Map<String, View> views = View.standard();
    progress.expect((long) width * height * Denoising.VIEW_SAMPLES * views.size());
    JsonSummary summary = model.summary(name());
    List<String> notes = new ArrayList<>();
    List<DisplayLight> pictures = new ArrayList<>();
    for (Map.Entry<String, View> view : views.entrySet()) {
      SceneFile file = model.seenFrom(view.getValue(), width, height, Denoising.VIEW_SAMPLES);
      String name = view.getKey();
      pictures.add(CleanPicture.of(file, name, n -> notes.add(name + ": " + n), progress));
      model.describe(name, file, summary);
    }
    summary.put("notes", notes);
    List<Image> images = pictures.stream().map(DisplayLight::image).toList();
    Image sheet = ContactSheet.of(images, COLUMNS, Math.max(1, width / 64));
    return new Outcome(
        List.of(ImageFormat.PNG.bytes(sheet, pictures.get(0).options())), summary.values());
  }
}
