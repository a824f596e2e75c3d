package io.github.lumbre.integrator.guiding;

import java.util.Arrays;
import java.util.List;
import java.util.function.Supplier;

/**
 * Builds a {@link Guide} from {@link GuideRecords}, in the fork-join pool of the calling thread, or
 * else in the common pool. Each sum is taken by one thread in a fixed order, so that the same
 * records give the same bits. Mutable; used once.
 */
public final class GuideBuilder {
  private final GuideRecords records;
  private final Supplier<? extends Sight> sights;
  private final int limit;

  /** Whether the guide is used to learn another one, which needs all directions. */
  private final boolean isTraining;

  private final RecordOrder[] orders;
  private final RecordValues values;
  private final Connections connections;

  private GuideBuilder(
      GuideRecords records,
      Guide drawnBy,
      Supplier<? extends Sight> sights,
      int limit,
      boolean isTraining) {
    this.records = records;
    this.sights = sights;
    this.limit = limit;
    this.isTraining = isTraining;
    orders = RecordOrder.ofAxes(records);
    values = new RecordValues(records, orders);
    connections = new Connections(records, values, drawnBy);
  }

  /**
   * Returns the guide of some records; {@link Guide#NONE} if they have no light.
   *
   * @param records the builder adds to them
   * @param drawnBy the guide of {@link #train} that drew their directions, or {@link Guide#NONE}
   * @param sights returns a sight of the scene for a thread
   */
  public static Guide build(GuideRecords records, Guide drawnBy, Supplier<? extends Sight> sights) {
    return build(records, drawnBy, sights, Guide.MOST_INTS, false);
  }

  /** Returns a guide to record paths for a better one: all cells have the same mixture. */
  public static Guide train(GuideRecords records, Guide drawnBy, Supplier<? extends Sight> sights) {
    return build(records, drawnBy, sights, Guide.MOST_INTS, true);
  }

  /**
   * Returns the guide of some records.
   *
   * @param limit number of ints of all quadtrees. A cell with more than an equal share is not
   *     refined
   */
  static Guide build(
      GuideRecords records,
      Guide drawnBy,
      Supplier<? extends Sight> sights,
      int limit,
      boolean isTraining) {
    for (int i = 0; i < records.size(); i++) {
      if (records.number(i, GuideRecords.FOUND) > 0 || records.number(i, GuideRecords.DIRECT) > 0) {
        return new GuideBuilder(records, drawnBy, sights, limit, isTraining).build();
      }
    }
    return Guide.NONE;
  }

  /**
   * What the records of a cell give.
   *
   * @param squares the nodes of its quadtree
   * @param mean light that it scatters
   */
  private record Cell(int[] squares, float mean) {}

  private Guide build() {
    List<PlaceTree> trees = Arrays.stream(orders).parallel().map(PlaceTree::new).toList();
    List<RecordRange> ranges = trees.stream().flatMap(tree -> tree.leaves().stream()).toList();
    int share = limit / Math.max(1, ranges.size());
    List<Cell> cells = ranges.parallelStream().map(range -> cell(range, share)).toList();
    return guide(trees, cells);
  }

  private Cell cell(RecordRange range, int share) {
    double light = 0;
    for (int i = 0; i < range.size(); i++) {
      int record = range.record(i);
      light += values.value(record) + records.number(record, GuideRecords.DIRECT);
    }
    RecordOrder all = connections.connected(range, sights.get());
    float fraction = CellFraction.best(records, values, all);
    int[] squares =
        new SquareBuilder(records, values, share)
            .build(all, isTraining ? CellFraction.TRAINING : fraction);
    float mean = (float) Math.min(Float.MAX_VALUE, light / range.size());
    return new Cell(squares, mean);
  }

  private static Guide guide(List<PlaceTree> trees, List<Cell> cells) {
    // The index of a cell is that of the root of its quadtree.
    int[] indices = new int[cells.size()];
    int size = 0;
    for (int i = 0; i < indices.length; i++) {
      indices[i] = size;
      size += cells.get(i).squares.length;
    }
    int[] squares = new int[size];
    float[] means = new float[size / Guide.SQUARE_STRIDE];
    for (int i = 0; i < indices.length; i++) {
      SquareBuilder.copy(cells.get(i).squares, squares, indices[i]);
      means[indices[i] / Guide.SQUARE_STRIDE] = cells.get(i).mean;
    }
    int[] roots = new int[trees.size()];
    int[] places = new int[trees.stream().mapToInt(PlaceTree::size).sum()];
    int place = 0;
    int cell = 0;
    for (int axis = 0; axis < roots.length; axis++) {
      PlaceTree tree = trees.get(axis);
      int first = cell;
      roots[axis] = tree.copy(places, place, leaf -> indices[first + leaf]);
      place += tree.size();
      cell += tree.leaves().size();
    }
    return new Guide(roots, places, squares, means);
  }
}
