package io.github.lumbre.guiding;

import java.util.Arrays;
import java.util.Objects;

/**
 * Builds a {@link Guide} from {@link GuideRecords}. All sums are taken in the order of the records,
 * so that the same records give the same bits. Mutable; used once.
 */
public final class GuideBuilder {
  /** The largest number of records in a cell, unless they cannot be divided. */
  static final int MOST_RECORDS = 1600;

  /** The smallest number of records in a cell. */
  static final int LEAST_RECORDS = 100;

  /** A cell is halved in space, unless one half would have less than this part of the records. */
  private static final int LEAST_PART = 8;

  private final GuideRecords records;
  private final RecordValues values;
  private final RecordOrder[] orders = new RecordOrder[Guide.AXES];
  private final Connections connections;
  private final SquareBuilder squares;
  private int[] places = new int[1024];
  private int size;
  private float[] means = new float[64];
  private float[] fractions = new float[64];

  /** The cell of each record. */
  private final int[] cells;

  /** Whether the guide is used to learn another one, which needs all directions. */
  private final boolean isTraining;

  /**
   * A guide and its use.
   *
   * @param gain the second moment of what directions give, without the guide, in that with it: the
   *     larger, the more it lowers noise; 1 if nothing was learned
   */
  public record Built(Guide guide, double gain) {
    private static final Built NONE = new Built(Guide.NONE, 1);
  }

  private GuideBuilder(
      GuideRecords records, Guide drawnBy, Sight sight, int limit, boolean isTraining) {
    this.records = Objects.requireNonNull(records, "records");
    this.isTraining = isTraining;
    cells = new int[records.size()];
    Arrays.fill(cells, Guide.NO_CELL);
    for (int axis = 0; axis < orders.length; axis++) {
      orders[axis] = new RecordOrder(records, axis);
    }
    values = new RecordValues(records, orders);
    connections = new Connections(records, values, drawnBy, sight);
    squares = new SquareBuilder(records, values, limit);
  }

  /**
   * Returns the guide of some records; {@link Guide#NONE} if they have no light.
   *
   * @param records the builder adds to them
   * @param drawnBy the guide of {@link #train} that drew their directions, or {@link Guide#NONE}
   * @param sight of the scene
   */
  public static Built build(GuideRecords records, Guide drawnBy, Sight sight) {
    return build(records, drawnBy, sight, Guide.MOST_INTS, false);
  }

  /**
   * Returns a guide to record paths for a better one: all cells have the same mixture. The
   * parameters are those of {@link #build}.
   */
  public static Built train(GuideRecords records, Guide drawnBy, Sight sight) {
    return build(records, drawnBy, sight, Guide.MOST_INTS, true);
  }

  /**
   * Returns the guide of some records.
   *
   * @param limit number of ints of all quadtrees beyond which they are not refined
   */
  static Built build(
      GuideRecords records, Guide drawnBy, Sight sight, int limit, boolean isTraining) {
    for (int i = 0; i < records.size(); i++) {
      if (records.number(i, GuideRecords.FOUND) > 0 || records.number(i, GuideRecords.DIRECT) > 0) {
        return new GuideBuilder(records, drawnBy, sight, limit, isTraining).build();
      }
    }
    return Built.NONE;
  }

  private Built build() {
    int[] roots = new int[Guide.AXES];
    for (int axis = 0; axis < roots.length; axis++) {
      int count = orders[axis].size();
      roots[axis] = count < LEAST_RECORDS ? Guide.NO_CELL : place(orders[axis], 0, count);
    }
    int[] nodes = squares.squares();
    Guide guide =
        new Guide(
            roots,
            Arrays.copyOf(places, size),
            nodes,
            Arrays.copyOf(means, nodes.length / Guide.SQUARE_STRIDE));
    return new Built(guide, GuideGain.of(records, values, connections, cells, means, fractions));
  }

  /** Adds the binary tree of a range of records; returns its root, or a cell. */
  private int place(RecordOrder order, int from, int to) {
    int count = to - from;
    if (count <= MOST_RECORDS) {
      return cell(order, from, to);
    }
    int axis = order.widest(from, to);
    float limit = order.center(from, to, axis);
    int middle = order.divide(from, to, axis, limit);
    if (Math.min(middle - from, to - middle) < count / LEAST_PART) {
      limit = order.median(from, to, axis);
      middle = order.divide(from, to, axis, limit);
    }
    if (Math.min(middle - from, to - middle) < LEAST_RECORDS) {
      return cell(order, from, to);
    }
    int node = size;
    size += Guide.PLACE_STRIDE;
    if (places.length < size) {
      places = Arrays.copyOf(places, 2 * places.length);
    }
    places[node] = axis;
    places[node + 1] = Float.floatToRawIntBits(limit);
    int low = place(order, from, middle);
    int high = place(order, middle, to);
    places[node + 2] = low;
    places[node + 3] = high;
    return node;
  }

  private int cell(RecordOrder order, int from, int to) {
    double light = 0;
    for (int i = from; i < to; i++) {
      int record = order.record(i);
      light += values.value(record) + records.number(record, GuideRecords.DIRECT);
    }
    RecordOrder all = connections.connected(order, from, to);
    float fraction = CellFraction.best(records, values, all);
    int cell = squares.add(all, isTraining ? CellFraction.TRAINING : fraction);
    int number = cell / Guide.SQUARE_STRIDE;
    if (means.length <= number) {
      means = Arrays.copyOf(means, 2 * number);
      fractions = Arrays.copyOf(fractions, 2 * number);
    }
    fractions[number] = fraction;
    for (int i = from; i < to; i++) {
      cells[order.record(i)] = cell;
    }
    means[number] = (float) Math.min(Float.MAX_VALUE, light / (to - from));
    return Guide.leaf(cell);
  }
}
