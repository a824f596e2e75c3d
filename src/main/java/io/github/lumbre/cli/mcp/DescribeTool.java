package io.github.lumbre.cli.mcp;

import io.github.lumbre.cli.output.JsonSummary;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scenefile.internal.ParsedScene;
import java.util.ArrayList;
import java.util.List;

/** Lists what a model has, without rendering it. */
record DescribeTool(Studio studio) implements Tool {
  @Override
  public String name() {
    return "describe";
  }

  @Override
  public String title() {
    return "Describe a model";
  }

  @Override
  public String description() {
    return "Returns the bounds, parts, triangles, materials, cameras and animations of a 3D model,"
        + " or what a scene in JSON has, and warnings about what a picture would lack, without"
        + " rendering it.";
  }

  @Override
  public List<Input<?>> inputs() {
    List<Input<?>> inputs = new ArrayList<>(List.of(ModelInputs.MODEL_OR_SCENE));
    inputs.addAll(ModelInputs.ofReading());
    return inputs;
  }

  @Override
  public List<Output> outputs() {
    return SummaryOutputs.ofContents();
  }

  @Override
  public Outcome call(Arguments arguments, CallProgress progress) throws ToolException {
    String name = arguments.get(ModelInputs.MODEL_OR_SCENE);
    return Studio.isScene(name) ? scene(name, arguments) : model(name, arguments);
  }

  private Outcome model(String name, Arguments arguments) throws ToolException {
    Studio.Staged model = studio.model(name, ModelInputs.stage(arguments));
    ParsedScene scene = model.first().parsed();
    JsonSummary summary = model.summary(name());
    summary.putContents(scene.contents());
    summary.putModel(scene.model().orElseThrow(), model.parts());
    return new Outcome(List.of(), model.rounding().values(summary.values()));
  }

  private Outcome scene(String name, Arguments arguments) throws ToolException {
    Shot shot = RenderTool.sceneShot(studio, name, arguments);
    RenderSettings settings = shot.file().settings();
    JsonSummary summary = shot.summary(name());
    summary.put("width", settings.width());
    summary.put("height", settings.height());
    summary.put("samples_per_pixel", settings.samples());
    summary.putContents(shot.file().parsed().contents());
    summary.put("notes", shot.notes());
    return new Outcome(List.of(), summary.values());
  }
}
