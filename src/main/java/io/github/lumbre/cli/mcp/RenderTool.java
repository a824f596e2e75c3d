package io.github.lumbre.cli.mcp;

import io.github.lumbre.cli.mcp.Studio.Frame;
import io.github.lumbre.cli.output.JsonSummary;
import io.github.lumbre.cli.run.Denoising;
import io.github.lumbre.image.internal.ImageFormat;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.stage.Stage;
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

  static final Input<Optional<String>> CROP =
      Input.text(
          "crop",
          "Part to show alone, as 'describe' lists it, with * for any text: the picture is the"
              + " rectangle of width x height in which the part is seen.");

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
        : "Renders a 3D model from one direction, or a scene in JSON by its camera, as a clean PNG"
            + " picture, and returns which parts are seen where, and the matrix that maps points of"
            + " the model to pixels.";
  }

  @Override
  public List<Input<?>> inputs() {
    List<Input<?>> inputs =
        new ArrayList<>(List.of(ModelInputs.MODEL_OR_SCENE, WIDTH, HEIGHT, SAMPLES, CROP));
    if (isCut) {
      inputs.add(1, ModelInputs.of(ModelOption.SECTION));
    }
    inputs.addAll(ModelInputs.allBut(ModelOption.SECTION));
    return inputs;
  }

  @Override
  public List<Output> outputs() {
    return SummaryOutputs.ofPictures();
  }

  @Override
  public Outcome call(Arguments arguments, CallProgress progress)
      throws ToolException, InterruptedException {
    Shot shot = shot(studio, arguments);
    RenderSettings settings = shot.file().settings();
    progress.expect(settings.window().pixels() * settings.samples());
    Studio.Finished made = studio.picture(shot, progress);
    JsonSummary summary = shot.summary(name());
    shot.describe(summary);
    summary.put("notes", made.notes());
    return new Outcome(
        List.of(ImageFormat.PNG.bytes(made.picture().image(), made.picture().options())),
        shot.rounding().values(summary.values()));
  }

  /** Returns what the arguments {@link #inputs} ask for. */
  static Shot shot(Studio studio, Arguments arguments) throws ToolException {
    Shot whole = wholeShot(studio, arguments);
    Optional<String> crop = arguments.get(CROP);
    return crop.isPresent() ? PartCrop.of(whole, crop.get()) : whole;
  }

  private static Shot wholeShot(Studio studio, Arguments arguments) throws ToolException {
    String name = arguments.get(ModelInputs.MODEL_OR_SCENE);
    if (Studio.isScene(name)) {
      return sceneShot(studio, name, arguments);
    }
    Stage stage = ModelInputs.stage(arguments);
    return studio
        .model(name, stage)
        .shot(stage, ModelInputs.title(arguments), frame(arguments));
  }

  /** Returns the size of a picture of a model. */
  static Frame frame(Arguments arguments) {
    return new Frame(arguments.get(WIDTH), arguments.get(HEIGHT), arguments.get(SAMPLES));
  }

  /** Returns what a scene in JSON shows, in a frame of a size that the arguments may state. */
  static Shot sceneShot(Studio studio, String name, Arguments arguments) throws ToolException {
    ModelInputs.requireNone(arguments);
    SceneFrame frame =
        new SceneFrame(
            arguments.given(WIDTH),
            arguments.given(HEIGHT),
            arguments.given(SAMPLES),
            MOST_PIXELS,
            MOST_SAMPLES);
    return studio.scene(name, frame);
  }
}
