package io.github.lumbre.integrator.guiding;

import java.util.Arrays;

/**
 * Directions from vertices to bright places, in addition to those that their paths took. A small
 * bright place, such as the inside of a lamp shade, is met so rarely by scattered rays that a cell
 * of a guide would not learn where it is.
 *
 * <p>Each vertex is connected to one other vertex of the pilot, chosen by the power of the place
 * around it: mean light times area. The other vertex is a virtual light (Keller 1997, "Instant
 * Radiosity"). Only diffuse surfaces are connected, because only their BSDF is known here. Both
 * kinds of directions are weighted by the balance heuristic, so that each counts as if it were
 * drawn with the mean of both densities, {@link GuideRecords#ALL_PDF}. An error of the values
 * changes the noise of guided paths and not their mean. Mutable; several threads may connect the
 * records of different cells at once.
 */
final class Connections {
  /** Successive multiples of it, without their integers, are spread evenly over [0,1). */
  private static final double GOLDEN_RATIO = .6180339887498949;

  /** Difference of two coordinates of equal directions, at most. */
  private static final double SAME = 1e-3;

  private final GuideRecords records;
  private final RecordValues values;
  private final Guide drawnBy;

  /**
   * Number of the records of paths. The connection that starts at record i has number i + count.
   */
  private final int count;

  /** Sum of the powers of a record and those before it. */
  private final double[] powers;

  private final double power;

  /**
   * Prepares the connections of some records.
   *
   * @param drawnBy the guide that drew their directions
   */
  Connections(GuideRecords records, RecordValues values, Guide drawnBy) {
    this.records = records;
    this.values = values;
    this.drawnBy = drawnBy;
    count = records.size();
    records.reserve(2 * count);
    powers = new double[count];
    double sum = 0;
    for (int i = 0; i < count; i++) {
      sum += values.mean(i) * values.area(i);
      powers[i] = sum;
    }
    power = sum;
  }

  /**
   * Weights the records of a range, and returns them and their connections.
   *
   * @param sight of the calling thread
   */
  RecordOrder connected(RecordRange range, Sight sight) {
    int[] all = new int[2 * range.size()];
    int size = 0;
    for (int i = 0; i < range.size(); i++) {
      int record = range.record(i);
      double pdf = records.number(record, GuideRecords.PDF);
      double allPdf = .5 * pdf + .5 * pdf(record);
      records.setAllPdf(record, allPdf);
      values.set(record, (allPdf > 0 ? pdf / allPdf : 2) * values.value(record));
      all[size++] = record;
    }
    for (int i = 0; i < range.size(); i++) {
      double chosen = i * GOLDEN_RATIO;
      if (connect(range.record(i), chosen - Math.floor(chosen), sight)) {
        all[size++] = range.record(i) + count;
      }
    }
    return new RecordOrder(records, Arrays.copyOf(all, size));
  }

  /** Returns the density per solid angle of connecting a record to the next vertex of its path. */
  private double pdf(int record) {
    if (!records.continues(record) || records.number(record, GuideRecords.DIFFUSE) == 0) {
      return 0;
    }
    Way way = new Way(records, record, record + 1);
    boolean isStraight =
        Math.abs(Octahedron.u(way.x, way.y, way.z) - records.number(record, GuideRecords.U)) < SAME
            && Math.abs(Octahedron.v(way.x, way.y, way.z) - records.number(record, GuideRecords.V))
                < SAME;
    return isStraight && way.isFacing() ? pdf(way, record + 1) : 0;
  }

  /** Returns the density per solid angle of a way to a record; 0 if it is never chosen. */
  private double pdf(Way way, int to) {
    double pdf = values.mean(to) / power * way.square / way.cosineThere;
    return values.area(to) > 0 && pdf < Double.POSITIVE_INFINITY ? pdf : 0;
  }

  /**
   * Adds a connection from a record, if it sees the chosen place; returns whether it does.
   *
   * @param chosen part of the power, in [0,1), up to the chosen record
   */
  private boolean connect(int from, double chosen, Sight sight) {
    double albedo = records.number(from, GuideRecords.DIFFUSE);
    if (albedo == 0) {
      return false;
    }
    int to = record(chosen);
    Way way = new Way(records, from, to);
    double pdf = pdf(way, to);
    if (!way.isFacing() || !(pdf > 0) || !way.isClear(sight)) {
      return false;
    }
    double bsdfPdf = way.cosineHere / Math.PI;
    double pathPdf = pathPdf(from, way, bsdfPdf);
    double allPdf = .5 * pathPdf + .5 * pdf;
    records.connect(from + count, way.x, way.y, way.z, pathPdf, bsdfPdf, allPdf);
    values.set(from + count, albedo * bsdfPdf * values.mean(to) / allPdf);
    return records.isConnected(from + count);
  }

  /** Returns the first record up to which the power exceeds a part of the whole. */
  private int record(double part) {
    int low = 0;
    int high = count - 1;
    while (low < high) {
      int middle = (low + high) >>> 1;
      if (powers[middle] <= part * power) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }

  /** Returns the density with which the path of a record would have drawn a direction. */
  private double pathPdf(int from, Way way, double bsdfPdf) {
    int cell =
        drawnBy.cell(
            records.number(from, GuideRecords.X),
            records.number(from, GuideRecords.X + 1),
            records.number(from, GuideRecords.X + 2),
            records.number(from, GuideRecords.NORMAL),
            records.number(from, GuideRecords.NORMAL + 1),
            records.number(from, GuideRecords.NORMAL + 2));
    if (cell == Guide.NO_CELL) {
      return bsdfPdf;
    }
    double fraction = drawnBy.fraction(cell);
    return fraction * drawnBy.pdf(cell, way.x, way.y, way.z) + (1 - fraction) * bsdfPdf;
  }

  /** The straight way between two records. */
  private static final class Way {
    private final float fromX, fromY, fromZ;

    /** Squared length. */
    private final double square;

    private final double length;

    /** Unit direction. */
    private final double x, y, z;

    private final double cosineHere, cosineThere;

    Way(GuideRecords records, int from, int to) {
      fromX = records.number(from, GuideRecords.X);
      fromY = records.number(from, GuideRecords.X + 1);
      fromZ = records.number(from, GuideRecords.X + 2);
      double dx = (double) records.number(to, GuideRecords.X) - fromX;
      double dy = (double) records.number(to, GuideRecords.X + 1) - fromY;
      double dz = (double) records.number(to, GuideRecords.X + 2) - fromZ;
      square = dx * dx + dy * dy + dz * dz;
      length = Math.sqrt(square);
      x = dx / length;
      y = dy / length;
      z = dz / length;
      cosineHere = cosine(records, from);
      cosineThere = -cosine(records, to);
    }

    private double cosine(GuideRecords records, int record) {
      return x * records.number(record, GuideRecords.NORMAL)
          + y * records.number(record, GuideRecords.NORMAL + 1)
          + z * records.number(record, GuideRecords.NORMAL + 2);
    }

    boolean isClear(Sight sight) {
      return sight.isClear(fromX, fromY, fromZ, length * x, length * y, length * z);
    }

    /** Returns whether both sides face each other; false if the way has no length. */
    boolean isFacing() {
      return cosineHere > 0 && cosineThere > 0;
    }
  }
}
