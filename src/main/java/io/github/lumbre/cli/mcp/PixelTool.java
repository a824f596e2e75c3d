package io.github.lumbre.cli.mcp;

import io.github.lumbre.cli.output.PixelJson;
import io.github.lumbre.cli.output.PixelPlace;
import io.github.lumbre.cli.output.PixelReport;
import io.github.lumbre.render.PixelReplay;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.stage.Stage;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** Explains a pixel of a picture that {@link RenderTool} makes. */
record PixelTool(Studio studio) implements Tool {
  private static final int LAST = RenderTool.MOST_PIXELS - 1;

  private static final Input<Integer> X =
      Input.requiredInteger("x", 0, LAST, "Column of the pixel; 0 is the left one.");

  private static final Input<Integer> Y =
      Input.requiredInteger("y", 0, LAST, "Row of the pixel; 0 is the top one.");

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
    return "Says what is seen in a pixel of the picture that 'render' or 'section' makes with the"
        + " same arguments: the parts and materials, the position in the model's space and"
        + " the normal of the surface, and the color.";
  }

  @Override
  public List<Input<?>> inputs() {
    List<Input<?>> inputs =
        new ArrayList<>(
            List.of(
                ModelInputs.MODEL,
                X,
                Y,
                RenderTool.VIEW,
                RenderTool.WIDTH,
                RenderTool.HEIGHT,
                RenderTool.SAMPLES));
    inputs.addAll(ModelInputs.allBut(Stage.LABEL));
    return inputs;
  }

  @Override
  public Outcome call(Arguments arguments, CallProgress progress)
      throws ToolException, InterruptedException {
    int x = arguments.get(X);
    int y = arguments.get(Y);
    SceneFile file = RenderTool.scene(ModelInputs.model(studio, arguments), arguments);
    int width = file.settings().width();
    int height = file.settings().height();
    if (x >= width || y >= height) {
      throw new ToolException(
          "x, y: expected a pixel of %dx%d, found %d,%d".formatted(width, height, x, y));
    }
    PixelReplay replay = new PixelReplay(file.scene(), file.settings());
    PixelReport report = new PixelReport(file, new PixelPlace(x, y));
    Map<String, Object> values = PixelJson.values(report, replay.pixel(x, y, 1));
    return new Outcome(List.of(), values);
  }
}
