package io.github.lumbre.cli.mcp;

import io.github.lumbre.cli.output.JsonSummary;
import io.github.lumbre.cli.run.Denoising;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.internal.ImageFormat;
import io.github.lumbre.parser.SceneFile;
import java.util.List;
import java.util.Optional;

/** Renders a model from one direction. */
final class RenderTool implements Tool {
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

  private final Studio studio;

  RenderTool(Studio studio) {
    this.studio = studio;
  }

  @Override
  public String name() {
    return "render";
  }

  @Override
  public String title() {
    return "Render a model";
  }

  @Override
  public String description() {
    return "Renders a 3D model from one direction, as a clean PNG picture.";
  }

  @Override
  public List<Input<?>> inputs() {
    return List.of(ModelInputs.MODEL, VIEW, WIDTH, HEIGHT, SAMPLES, ModelInputs.Z_UP);
  }

  @Override
  public Outcome call(Arguments arguments, CallProgress progress)
      throws ToolException, InterruptedException {
    Studio.Staged model = ModelInputs.model(studio, arguments);
    SceneFile file = scene(model, arguments);
    progress.expect(file.settings().window().pixels() * file.settings().samples());
    Image picture = studio.picture(file, progress);
    JsonSummary summary = model.summary(name());
    model.describe(arguments.get(VIEW).orElse(DEFAULT_VIEW), file, summary);
    return new Outcome(
        List.of(ImageFormat.PNG.bytes(picture, file.settings().development())), summary.values());
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
