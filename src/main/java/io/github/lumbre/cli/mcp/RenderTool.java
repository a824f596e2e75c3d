package io.github.lumbre.cli.mcp;

import io.github.lumbre.cli.output.JsonSummary;
import io.github.lumbre.cli.run.CleanPicture;
import io.github.lumbre.cli.run.Denoising;
import io.github.lumbre.image.internal.ImageFormat;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.stage.drawing.DisplayLight;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Renders a model from one direction, whole or cut open.
 *
 * @param isCut whether planes cut the models
 */
record RenderTool(Studio studio, boolean isCut) implements Tool {
  static final int MOST_PIXELS = 1024;
  private static final int MOST_SAMPLES = 64;
  private static final String DEFAULT_VIEW = "30,20";

  static final Input<Optional<String>> VIEW =
      Input.text(
          "view",
          "front, back, left, right, top, bottom, iso, or AZIMUTH,ELEVATION in degrees, such as"
              + " 30,20 (the default).");

  static final Input<Integer> WIDTH =
      Input.integer("width", 16, MOST_PIXELS, 512, "Width of the picture in pixels.");

  static final Input<Integer> HEIGHT =
      Input.integer("height", 16, MOST_PIXELS, 384, "Height of the picture in pixels.");

  static final Input<Integer> SAMPLES =
      Input.integer(
          "samples",
          1,
          MOST_SAMPLES,
          Denoising.MODEL_SAMPLES,
          "Samples per pixel: more are cleaner, and take longer.");

  @Override
  public String name() {
    return isCut ? "section" : "render";
  }

  @Override
  public String title() {
    return isCut ? "Cut a model open" : "Render a model";
  }

  @Override
  public String description() {
    return isCut
        ? "Renders a 3D model that planes cut open, from one direction, as a clean PNG picture."
            + " Where the planes cut closed parts, the cut is hatched."
        : "Renders a 3D model from one direction, as a clean PNG picture, and returns which parts"
            + " are seen where, and the matrix that maps points of the model to pixels.";
  }

  @Override
  public List<Input<?>> inputs() {
    List<Input<?>> inputs =
        new ArrayList<>(List.of(ModelInputs.MODEL, VIEW, WIDTH, HEIGHT, SAMPLES));
    if (isCut) {
      inputs.add(1, ModelInputs.of(ModelOption.SECTION));
    }
    inputs.addAll(ModelInputs.allBut(ModelOption.SECTION));
    return inputs;
  }

  @Override
  public Outcome call(Arguments arguments, CallProgress progress)
      throws ToolException, InterruptedException {
    Studio.Staged model = ModelInputs.model(studio, arguments);
    SceneFile file = scene(model, arguments);
    progress.expect(file.settings().window().pixels() * file.settings().samples());
    String view = arguments.get(VIEW).orElse(DEFAULT_VIEW);
    List<String> notes = new ArrayList<>();
    DisplayLight picture = CleanPicture.of(file, view, notes::add, progress);
    JsonSummary summary = model.summary(name());
    model.describe(view, file, summary);
    summary.put("notes", notes);
    return new Outcome(
        List.of(ImageFormat.PNG.bytes(picture.image(), picture.options())), summary.values());
  }

  /** Returns the scene that the arguments {@link #inputs} ask for. */
  static SceneFile scene(Studio.Staged model, Arguments arguments) throws ToolException {
    String view = arguments.get(VIEW).orElse(DEFAULT_VIEW);
    return model.seenFrom(
        ModelInputs.view(view),
        arguments.get(WIDTH),
        arguments.get(HEIGHT),
        arguments.get(SAMPLES));
  }
}
