package io.github.lumbre.stage.internal;

import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scenefile.internal.DrawingSheet;
import io.github.lumbre.scenefile.internal.DrawingSheet.Paper;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.internal.StageTypes.PageType;
import io.github.lumbre.stage.internal.StageTypes.ScaleType;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Stream;

/** The paper of a stage's pictures. Stateless. */
public final class StagedSheet {
  private static final double MILLIMETERS_PER_METER = 1000;

  private StagedSheet() {}

  /** Returns how a stage draws lines. */
  public static DrawingSheet of(Stage stage) {
    Optional<Paper> paper = paper(stage);
    boolean isLit =
        Stream.of(Stage.SKY, Stage.SKY_INTENSITY, Stage.SKY_ROTATION)
            .anyMatch(option -> !stage.find(option).equals(option.defaultValue()));
    boolean isOnColor = stage.transparent() || stage.background().isPresent();
    return new DrawingSheet(
        Look.of(stage.find(Stage.LOOK)).isDrawing() && !isLit && isOnColor,
        stage.get(Stage.HIDDEN),
        paper.isPresent() || stage.find(Stage.SCALE).isPresent(),
        paper);
  }

  private static Optional<Paper> paper(Stage stage) {
    return stage.find(Stage.PAGE).map(PageType::paper);
  }

  /** Returns a size in pixels, or that of the stage's paper. */
  static RenderSettings.Builder sized(RenderSettings.Builder to, Stage stage, int width, int height) {
    Optional<Paper> paper = paper(stage);
    return to.size(
        paper.map(Paper::columns).orElse(width), paper.map(Paper::rows).orElse(height));
  }

  /**
   * Returns the height of a parallel camera's film in the model's world space, which the scale of a
   * stage asks for; empty without a scale.
   *
   * @param rows the height of the picture in pixels
   */
  static OptionalDouble film(Stage stage, Model model, int rows) {
    double unit =
        model.unit().isEmpty()
            ? 1 / model.fromFile().vector(Vec3.X).length()
            : MILLIMETERS_PER_METER;
    return stage
        .find(Stage.SCALE)
        .map(scale -> rows * DrawingSheet.PIXEL / (ScaleType.factor(scale) * unit))
        .map(OptionalDouble::of)
        .orElse(OptionalDouble.empty());
  }
}
