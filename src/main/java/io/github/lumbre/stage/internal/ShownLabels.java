package io.github.lumbre.stage.internal;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.scenefile.internal.ModelContents;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.Stage.View;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** The kinds of labels on the pictures of a model. */
public final class ShownLabels {
  static final String VIEW = "view";
  static final String AXES = "axes";
  static final String SCALE = "scale";
  static final String SIZE = "size";
  static final String BOX = "box";
  static final String PARTS = "parts";

  /** All kinds, in the order in which they take their places. */
  public static final List<String> KINDS = List.of(VIEW, AXES, SCALE, PARTS, SIZE, BOX);

  /** Names of parts have about a fifth of the width on both sides. */
  private static final double BESIDE_NAMES = .56;

  /** Dimensions have a tenth of the frame on all sides. */
  private static final double INSIDE_SIZES = .8;

  private ShownLabels() {}

  /** Returns the name of the view of a stage. */
  public static String title(Stage stage, Model model) {
    if (stage.find(Stage.EYE).isPresent()) {
      return "eye " + Stage.EYE.type().format(stage.get(Stage.EYE)).replace(",", ", ");
    }
    return stage
        .find(Stage.CAMERA)
        .or(() -> ModelContents.cameraNames(model).stream().findFirst())
        .filter(name -> !stage.isFramed())
        .map(name -> "camera " + name)
        .orElseGet(() -> title(stage.find(Stage.VIEW).orElse(View.DEFAULT)));
  }

  private static String title(View view) {
    return view.name()
        .orElseGet(
            () ->
                PrintableText.number(view.azimuth())
                    + "°, "
                    + PrintableText.number(view.elevation())
                    + "°");
  }

  /** Returns whether the box around the model must be in the frame. */
  public static boolean showBox(Set<String> kinds) {
    return kinds.contains(SIZE) || kinds.contains(BOX);
  }

  /**
   * Returns the part of the frame's width that a framed model may fill, so that labels have room.
   */
  public static double fillAcross(Set<String> kinds, double fill) {
    return kinds.contains(PARTS) ? Math.min(fill, BESIDE_NAMES) : fillUpwards(kinds, fill);
  }

  /** Returns the part of the frame's height that a framed model may fill. */
  public static double fillUpwards(Set<String> kinds, double fill) {
    return kinds.contains(SIZE) ? Math.min(fill, INSIDE_SIZES) : fill;
  }
}
