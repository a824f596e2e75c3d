package io.github.lumbre.cli;

import io.github.lumbre.image.internal.VectorPicture;
import io.github.lumbre.image.internal.VectorPicture.Group;
import io.github.lumbre.image.internal.VectorPicture.Layer;
import io.github.lumbre.image.internal.VectorPicture.Page;
import io.github.lumbre.scenefile.internal.DrawingSheet.Paper;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.internal.StageTypes.PageType;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A sheet of the standard views as vectors, placed as the sides of an unfolded box (third-angle
 * projection): the top above the front, the right side at its right. Stateless.
 */
final class VectorViews {
  static final int COLUMNS = 4;
  static final int ROWS = 3;

  /** Column and row of each view. */
  private static final Map<String, int[]> PLACES =
      Map.of(
          "front", new int[] {1, 1},
          "back", new int[] {3, 1},
          "left", new int[] {0, 1},
          "right", new int[] {2, 1},
          "top", new int[] {1, 0},
          "bottom", new int[] {1, 2},
          "iso", new int[] {3, 0});

  private VectorViews() {}

  /** Returns a stage whose page is that of one view, if it has a page, which is the sheet. */
  static Stage inCells(Stage stage) {
    Optional<Paper> sheet = stage.find(Stage.PAGE).map(PageType::paper);
    return sheet.isEmpty()
        ? stage
        : stage.with(
            Stage.PAGE, sheet.get().width() / COLUMNS + "x" + sheet.get().height() / ROWS);
  }

  /**
   * Returns the sheet.
   *
   * @param names of the views
   * @param views of equal size
   */
  static VectorPicture sheet(List<String> names, List<VectorPicture> views) {
    Page cell = views.get(0).page();
    List<Group> groups = new ArrayList<>();
    for (int i = 0; i < views.size(); i++) {
      String name = names.get(i);
      double x = PLACES.get(name)[0] * cell.width() / cell.pixel();
      double y = PLACES.get(name)[1] * cell.height() / cell.pixel();
      views.get(i).groups().forEach(group -> groups.add(moved(group, name, x, y)));
    }
    Page page =
        new Page(
            COLUMNS * cell.width(),
            ROWS * cell.height(),
            cell.left(),
            cell.top(),
            cell.pixel(),
            cell.unit());
    return new VectorPicture(page, views.get(0).background(), groups);
  }

  private static Group moved(Group group, String view, double x, double y) {
    List<Layer> layers = group.layers().stream().map(layer -> moved(layer, x, y)).toList();
    return new Group(view + "-" + group.id(), group.title(), layers);
  }

  private static Layer moved(Layer layer, double x, double y) {
    List<double[]> paths =
        layer.paths().stream()
            .map(
                path -> {
                  double[] moved = path.clone();
                  Arrays.setAll(moved, i -> path[i] + (i % 2 == 0 ? x : y));
                  return moved;
                })
            .toList();
    return new Layer(layer.kind(), layer.color(), layer.width(), layer.dash(), layer.gap(), paths);
  }
}
