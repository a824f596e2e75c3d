package io.github.lumbre.model.format.ply;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.image.internal.Srgb;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelLimits;
import io.github.lumbre.model.internal.Tally;
import io.github.lumbre.model.internal.TriangleList;
import io.github.lumbre.model.internal.Warnings;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** The vertices of a PLY file: reads the element of that name. Mutable. */
final class PlyVertices {
  private static final int NONE = -1;
  private static final int NORMAL = 3;
  private static final int UV = 6;
  private static final int COLOR = 8;
  private static final int ALPHA = 11;

  /** The names of each attribute's property; tools disagree about some. */
  private static final List<List<String>> NAMES =
      List.of(
          List.of("x"),
          List.of("y"),
          List.of("z"),
          List.of("nx"),
          List.of("ny"),
          List.of("nz"),
          List.of("s", "u", "texture_u"),
          List.of("t", "v", "texture_v"),
          List.of("red", "diffuse_red", "r"),
          List.of("green", "diffuse_green", "g"),
          List.of("blue", "diffuse_blue", "b"),
          List.of("alpha", "diffuse_alpha", "a"));

  /** The largest absolute value of a coordinate: products of two must not overflow. */
  private static final double MAX_NUMBER = 1e150;

  /** Larger components of colors are not 1, rounded. */
  private static final double MAX_FRACTION = 1.001;

  private static final String BEYOND = "clamped components of colors to the range 0 to 1";
  private static final String NOT_FINITE =
      "ignored texture coordinates and colors that are not finite";

  private final PlyElement element;
  private final Tally tally;

  /** The attribute of each property, as an index into NAMES; NONE if the property is ignored. */
  private final int[] attributes;

  private double[] positions;
  private double[] normals;
  private double[] uvs;
  private float[] colors;

  /**
   * @param tally receives values that are not finite
   * @throws ModelFormatException if the element has no positions, or too many vertices
   */
  PlyVertices(PlyElement element, Limits limits, Warnings warnings, Tally tally)
      throws ModelFormatException {
    this.element = element;
    this.tally = tally;
    attributes = new int[element.properties().size()];
    Arrays.fill(attributes, NONE);
    boolean[] has = new boolean[NAMES.size()];
    for (int attribute = 0; attribute < has.length; attribute++) {
      has[attribute] = assign(attribute);
    }
    if (!has[0] || !has[1] || !has[2]) {
      throw error("expected the properties x, y and z");
    }
    int count = element.count();
    long perVertex =
        24 + (has[NORMAL] ? 24 : 0) + (has[UV] ? 16 : 0) + (has[COLOR] || has[ALPHA] ? 16 : 0);
    ModelLimits.requireMemory("element vertex", perVertex * count, limits);
    positions = new double[3 * count];
    normals = new double[has[NORMAL] && has[NORMAL + 1] && has[NORMAL + 2] ? 3 * count : 0];
    uvs = new double[has[UV] && has[UV + 1] ? 2 * count : 0];
    boolean hasColors = has[COLOR] && has[COLOR + 1] && has[COLOR + 2];
    // Java arrays hold at most 2^31 - 1 items, and four colors are more than three coordinates.
    colors = new float[hasColors ? colorLength(count) : 0];
    Arrays.fill(colors, 1);
    ignoreIncomplete();
    warnIgnored(warnings);
  }

  private int colorLength(int count) throws ModelFormatException {
    ModelLimits.require("element vertex", "vertices", Integer.MAX_VALUE / 4 - 8, count);
    return 4 * count;
  }

  private boolean assign(int attribute) throws ModelFormatException {
    for (String name : NAMES.get(attribute)) {
      for (int i = 0; i < attributes.length; i++) {
        PlyProperty property = element.properties().get(i);
        if (property.name().equals(name) && !property.isList()) {
          attributes[i] = attribute;
          requireOnce(name);
          return true;
        }
      }
    }
    return false;
  }

  private void requireOnce(String name) throws ModelFormatException {
    if (element.properties().stream().filter(p -> p.name().equals(name)).count() > 1) {
      throw error("expected one property " + name + ", found several");
    }
  }

  private void ignoreIncomplete() {
    for (int i = 0; i < attributes.length; i++) {
      int attribute = attributes[i];
      boolean unused =
          attribute >= COLOR
              ? colors.length == 0
              : attribute >= UV ? uvs.length == 0 : attribute >= NORMAL && normals.length == 0;
      attributes[i] = unused ? NONE : attribute;
    }
  }

  private void warnIgnored(Warnings warnings) {
    List<String> ignored = new ArrayList<>();
    for (int i = 0; i < attributes.length; i++) {
      if (attributes[i] == NONE) {
        ignored.add(element.properties().get(i).name());
      }
    }
    PlyReader.warnIgnored(element, ignored, warnings);
  }

  void read(PlyBody body) throws ModelFormatException {
    List<PlyProperty> properties = element.properties();
    for (int i = 0; i < element.count(); i++) {
      if ((i & ModelLimits.INTERRUPT_MASK) == 0) {
        Interrupts.check();
      }
      body.beginItem(element, i);
      for (int k = 0; k < attributes.length; k++) {
        PlyProperty property = properties.get(k);
        if (property.isList()) {
          PlyReader.skipList(property, body);
        } else {
          put(i, k, body.number(property), body);
        }
      }
      body.endItem();
    }
  }

  private void put(int vertex, int property, double value, PlyBody body)
      throws ModelFormatException {
    int attribute = attributes[property];
    if (attribute == NONE) {
      return;
    }
    if (!Double.isFinite(value) || attribute >= COLOR && Math.abs(value) > MAX_NUMBER) {
      putNan(vertex, attribute, body);
      return;
    }
    if (Math.abs(value) > MAX_NUMBER) {
      throw body.error(
          "expected a number of at most 1e150 for %s, found %s"
              .formatted(NAMES.get(attribute).get(0), value));
    }
    if (attribute < NORMAL) {
      positions[3 * vertex + attribute] = value;
    } else if (attribute < UV) {
      normals[3 * vertex + attribute - NORMAL] = value;
    } else if (attribute < COLOR) {
      uvs[2 * vertex + attribute - UV] = value;
    } else {
      PlyType type = element.properties().get(property).type();
      count(value, type, body, tally);
      colors[4 * vertex + attribute - COLOR] = (float) color(value, type, attribute == ALPHA);
    }
  }

  /** Marks a position or a normal as broken; {@link #repair} follows. */
  private void putNan(int vertex, int attribute, PlyBody body) {
    if (attribute < NORMAL) {
      positions[3 * vertex + attribute] = Double.NaN;
    } else if (attribute < UV) {
      normals[3 * vertex + attribute - NORMAL] = Double.NaN;
    } else {
      tally.add(NOT_FINITE, body.location());
    }
  }

  /**
   * Removes numbers that are not finite: unused positions become 0, and if a normal of a triangle
   * is broken, all normals are ignored.
   *
   * @param areReported whether a warning already names the broken positions
   */
  void repair(TriangleList triangles, boolean areReported, Warnings warnings) {
    int broken = 0;
    for (int i = 0; i < positions.length; i += 3) {
      if (Double.isNaN(positions[i] + positions[i + 1] + positions[i + 2])) {
        Arrays.fill(positions, i, i + 3, 0);
        broken++;
      }
    }
    if (broken > 0 && !areReported) {
      warnings.add("element vertex", "ignored vertices that are not finite: " + broken);
    }
    boolean hasBroken = false;
    for (int i = 0; normals.length > 0 && i < 3 * triangles.count(); i++) {
      int at = 3 * triangles.vertex(i);
      hasBroken |= Double.isNaN(normals[at] + normals[at + 1] + normals[at + 2]);
    }
    if (hasBroken) {
      warnings.add("element vertex", "ignored the normals, because some are not finite");
      normals = new double[0];
    }
    for (int i = 0; i < normals.length; i++) {
      normals[i] = Double.isNaN(normals[i]) ? 0 : normals[i];
    }
  }

  /** Returns linear light of an sRGB-encoded integer or of a linear float; alpha is linear. */
  static double color(double value, PlyType type, boolean isAlpha) {
    double limited = Math.max(0, Math.min(type.isInteger() ? value / type.max() : value, 1));
    return type.isInteger() && !isAlpha ? Srgb.decode(limited) : limited;
  }

  /** Counts a component of a color if {@link #color} changes it by more than rounding. */
  static void count(double value, PlyType type, PlyBody body, Tally tally) {
    double share = type.isInteger() ? value / type.max() : value;
    if (!(share >= 0 && share <= MAX_FRACTION)) {
      tally.add(Double.isFinite(share) ? BEYOND : NOT_FINITE, body.location());
    }
  }

  boolean hasColors() {
    return colors.length > 0;
  }

  /**
   * Gives each triangle vertices of its own, with the data of its face.
   *
   * @param corners three vertices per triangle
   */
  void separate(int[] corners, PlyFaceData faces) {
    positions = gathered(positions, 3, corners);
    normals = gathered(normals, 3, corners);
    double[] own = faces.uvs();
    uvs = own.length > 0 ? Arrays.copyOf(own, 2 * corners.length) : gathered(uvs, 2, corners);
    float[] painted = faces.colors();
    float[] all = new float[painted.length + colors.length == 0 ? 0 : 4 * corners.length];
    for (int i = 0; i < all.length; i++) {
      all[i] =
          painted.length > 0 ? painted[4 * (i / 12) + i % 4] : colors[4 * corners[i / 4] + i % 4];
    }
    colors = all;
  }

  private static double[] gathered(double[] values, int size, int... corners) {
    double[] all = new double[values.length == 0 ? 0 : size * corners.length];
    for (int i = 0; i < all.length; i++) {
      all[i] = values[size * corners[i / size] + i % size];
    }
    return all;
  }

  /** Returns three coordinates per vertex. */
  double[] positions() {
    return positions;
  }

  /** Returns the geometry of triangles between the vertices. */
  ModelGeometry geometry(int[] indices) {
    double[] none = {};
    return new ModelGeometry(positions, normals, none, uvs, none, colors, indices);
  }

  private static ModelFormatException error(String message) {
    return ModelFormatException.Kind.MALFORMED.at("element vertex", message);
  }
}
