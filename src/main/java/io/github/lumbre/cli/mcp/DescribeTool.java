package io.github.lumbre.cli.mcp;

import io.github.lumbre.cli.output.JsonSummary;
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
        + " and warnings about what a picture would lack, without rendering it.";
  }

  @Override
  public List<Input<?>> inputs() {
    List<Input<?>> inputs = new ArrayList<>(List.of(ModelInputs.MODEL));
    inputs.addAll(ModelInputs.ofReading());
    return inputs;
  }

  @Override
  public Outcome call(Arguments arguments, CallProgress progress) throws ToolException {
    Studio.Staged model = ModelInputs.model(studio, arguments);
    ParsedScene scene = model.first().parsed();
    JsonSummary summary = model.summary(name());
    summary.putContents(scene.contents());
    summary.putModel(scene.model().orElseThrow(), model.parts());
    return new Outcome(List.of(), model.rounding().values(summary.values()));
  }
}
