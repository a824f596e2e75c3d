package io.github.lumbre.stage.drawing;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.internal.VectorPicture;
import io.github.lumbre.image.internal.VectorPicture.Group;
import io.github.lumbre.image.internal.VectorPicture.Layer;
import io.github.lumbre.image.internal.VectorPicture.Page;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scenefile.internal.PartSurface;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeSet;

/**
 * A drawing as vectors: colored surfaces, then a group of lines for each part that has some, then
 * labels. Mutable; for one thread.
 */
public final class VectorSheet {
  private final LineDrawing drawing;
  private final Scene scene;
  private final List<String> names;
  private final PartOf numbers;
  private final List<Group> groups = new ArrayList<>();

  /**
   * Creates an empty sheet.
   *
   * @param scene the scene of the drawing, from any place
   * @param names of the parts
   * @param numbers of the parts
   */
  public VectorSheet(LineDrawing drawing, Scene scene, List<String> names, PartOf numbers) {
    this.drawing = drawing;
    this.scene = scene;
    this.names = names;
    this.numbers = numbers;
  }

  /**
   * Adds the surfaces and lines of the scene.
   *
   * @param surfaces of the model, by the numbers of their primitives
   */
  public void addLines(Map<Integer, PartSurface> surfaces) {
    Optional<Sketch> found =
        drawing
            .outlines()
            .flatMap(edges -> edges.sketch(scene, drawing.settings(), numbers, true));
    if (found.isEmpty()) {
      return;
    }
    Surfaces colored = Surfaces.of(scene, drawing.settings(), surfaces, numbers);
    for (Surfaces.Fill fill : colored.fills()) {
      Layer area = new Layer("fill", fill.color(), 0, 0, 0, fill.outlines());
      String title = fill.part() < 0 ? "" : names.get(fill.part());
      groups.add(new Group("surface-" + (groups.size() + 1), title, List.of(area)));
    }
    Sketch sketch = found.get().settled();
    TreeSet<Integer> parts = new TreeSet<>(sketch.visible().keySet());
    if (drawing.hasHidden()) {
      parts.addAll(sketch.hidden().keySet());
    }
    colored.hatches().forEach(hatch -> parts.add(hatch.part()));
    for (int part : parts) {
      List<Layer> layers = layers(part, sketch, colored);
      if (!layers.isEmpty()) {
        groups.add(new Group("part-" + (part + 1), part < 0 ? "" : names.get(part), layers));
      }
    }
  }

  private List<Layer> layers(int part, Sketch sketch, Surfaces colored) {
    double width = drawing.settings().get(Setting.LINE_WIDTH);
    List<Layer> layers = new ArrayList<>();
    for (Surfaces.Lines hatch : colored.hatches()) {
      if (hatch.part() == part) {
        Pen pen = hatch.pen();
        List<double[]> paths = Polylines.joined(hatch.strokes());
        layers.add(new Layer("hatch", pen.color(), pen.width(), 0, 0, paths));
      }
    }
    List<double[]> hidden = Chains.of(sketch.hidden().getOrDefault(part, new Strokes()));
    if (drawing.hasHidden() && !hidden.isEmpty()) {
      layers.add(
          new Layer(
              "hidden",
              Rgb.BLACK,
              LineDrawing.HIDDEN_WIDTH * width,
              LineDrawing.DASH * width,
              LineDrawing.GAP * width,
              hidden));
    }
    List<double[]> visible = Chains.of(sketch.visible().getOrDefault(part, new Strokes()));
    if (!visible.isEmpty()) {
      layers.add(new Layer("visible", Rgb.BLACK, width, 0, 0, visible));
    }
    return layers;
  }

  /** Returns whether vectors show areas, which are found pixel by pixel. */
  public static boolean hasAreas(RenderSettings settings, Map<Integer, PartSurface> surfaces) {
    return !Surfaces.areNone(settings, surfaces);
  }

  /** Adds labels above everything. */
  public void addLabels(Labels labels, Rgb background) {
    List<Layer> layers = new ArrayList<>();
    labels.draw(
        (strokes, pen) ->
            layers.add(
                new Layer("label", pen.color(), pen.width(), 0, 0, Polylines.joined(strokes))),
        background);
    if (!layers.isEmpty()) {
      groups.add(new Group("labels", "", layers));
    }
  }

  /**
   * Returns the drawing.
   *
   * @param background color behind everything; empty for none
   */
  public VectorPicture picture(Page page, Optional<Rgb> background) {
    return new VectorPicture(page, background, groups);
  }
}
