package io.github.lumbre.integrator.guiding;

import java.util.Arrays;

/**
 * The vertices of the paths of a pilot render, in the order of the paths. Mutable and confined to
 * one thread. It stores plain numbers, because there are hundreds of thousands.
 */
public final class GuideRecords {
  static final int STRIDE = 16;
  static final int X = 0;
  static final int U = 3;
  static final int V = 4;
  static final int PDF = 5;
  static final int DIRECT = 6;
  static final int FOUND = 7;
  static final int WEIGHT = 8;
  static final int AXIS = 9;
  static final int BSDF_PDF = 10;
  static final int NORMAL = 11;
  static final int DIFFUSE = 14;

  /** Mean density of the ways in which the directions of a cell were drawn. */
  static final int ALL_PDF = 15;

  /** All that is not set is 0. */
  private float[] numbers = new float[STRIDE * 64];

  private boolean[] continues = new boolean[64];
  private int size;

  private final int limit;

  /** Creates an empty list. */
  public GuideRecords() {
    this(Integer.MAX_VALUE / STRIDE);
  }

  /**
   * Creates an empty list that stops growing at some number of vertices.
   *
   * @param limit at least 1
   */
  public GuideRecords(int limit) {
    if (limit < 1) {
      throw new IllegalArgumentException("limit: expected at least 1, found " + limit);
    }
    this.limit = limit;
  }

  /** Returns whether the list has stopped growing. */
  public boolean isFull() {
    return size >= limit;
  }

  /**
   * Adds a vertex. The list must not be full.
   *
   * @param x position in world space, as are y and z
   * @param nx unit normal on the side of the viewer, as are ny and nz
   * @param direct the light that light sampling found here, as scattered to the viewer
   * @param diffuse part of the light that the surface scatters, if it is diffuse; 0 otherwise
   */
  public void add(
      double x,
      double y,
      double z,
      double nx,
      double ny,
      double nz,
      double direct,
      double diffuse) {
    if (continues.length == size) {
      numbers = Arrays.copyOf(numbers, 2 * numbers.length);
      continues = Arrays.copyOf(continues, 2 * size);
    }
    int at = STRIDE * size;
    numbers[at] = (float) x;
    numbers[at + 1] = (float) y;
    numbers[at + 2] = (float) z;
    numbers[at + AXIS] = Guide.axis(nx, ny, nz);
    numbers[at + DIRECT] = (float) direct;
    numbers[at + NORMAL] = (float) nx;
    numbers[at + NORMAL + 1] = (float) ny;
    numbers[at + NORMAL + 2] = (float) nz;
    numbers[at + DIFFUSE] = (float) diffuse;
    size++;
  }

  /**
   * Sets how the path left the last vertex.
   *
   * @param dx unit direction, as are dy and dz
   * @param pdf density per solid angle with which the direction was drawn; 0 of a delta lobe
   * @param bsdfPdf density with which BSDF sampling alone draws the direction; 0 of a delta lobe
   * @param found the light that the direction found before the next vertex, scattered to the viewer
   *     and divided by the density
   * @param weight of the next vertex: f·|cos θ| over the density
   * @param next whether the next vertex will be added
   */
  public void leave(
      double dx,
      double dy,
      double dz,
      double pdf,
      double bsdfPdf,
      double found,
      double weight,
      boolean next) {
    int at = STRIDE * (size - 1);
    setDirection(size - 1, dx, dy, dz, pdf, bsdfPdf);
    numbers[at + ALL_PDF] = (float) pdf;
    numbers[at + FOUND] = (float) found;
    numbers[at + WEIGHT] = (float) weight;
    continues[size - 1] = next;
  }

  private void setDirection(
      int record, double dx, double dy, double dz, double pdf, double bsdfPdf) {
    int at = STRIDE * record;
    numbers[at + U] = (float) Octahedron.u(dx, dy, dz);
    numbers[at + V] = (float) Octahedron.v(dx, dy, dz);
    numbers[at + PDF] = (float) pdf;
    numbers[at + BSDF_PDF] = (float) bsdfPdf;
  }

  /** Adds all records of another list, in their order. */
  public void addAll(GuideRecords other) {
    int needed = size + other.size;
    if (continues.length < needed) {
      reserve(Math.max(needed, 2 * continues.length));
    }
    System.arraycopy(other.numbers, 0, numbers, STRIDE * size, STRIDE * other.size);
    System.arraycopy(other.continues, 0, continues, size, other.size);
    size = needed;
  }

  /** Makes room for a number of records. */
  void reserve(int count) {
    if (continues.length < count) {
      numbers = Arrays.copyOf(numbers, STRIDE * count);
      continues = Arrays.copyOf(continues, count);
    }
  }

  /** Returns the number of vertices. */
  public int size() {
    return size;
  }

  /**
   * Sets a direction that no path took. It is no vertex; its number is beyond those of the
   * vertices, in reserved room.
   *
   * @param dx unit direction, as are dy and dz
   * @param pdf density with which a path would have drawn it
   * @param allPdf above 0
   */
  void connect(
      int record, double dx, double dy, double dz, double pdf, double bsdfPdf, double allPdf) {
    setDirection(record, dx, dy, dz, pdf, bsdfPdf);
    setAllPdf(record, allPdf);
  }

  /** Returns whether a record beyond those of the vertices was set. */
  boolean isConnected(int record) {
    return number(record, ALL_PDF) > 0;
  }

  void setAllPdf(int record, double allPdf) {
    numbers[STRIDE * record + ALL_PDF] = (float) allPdf;
  }

  boolean continues(int record) {
    return continues[record];
  }

  float number(int record, int index) {
    return numbers[STRIDE * record + index];
  }
}
