package io.github.lumbre.model.format.ply;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.ModelLimits;
import io.github.lumbre.model.internal.PlainModel;
import io.github.lumbre.model.internal.Tally;
import io.github.lumbre.model.internal.Warnings;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * What the faces of a PLY file have besides their corners, as MeshLab and others write it: texture
 * coordinates of corners (the list {@code texcoord}), the number of a texture ({@code texnumber}),
 * and a color. Mutable.
 */
final class PlyFaceData {
  private static final List<List<String>> COLORS =
      List.of(
          List.of("red", "diffuse_red", "r"),
          List.of("green", "diffuse_green", "g"),
          List.of("blue", "diffuse_blue", "b"),
          List.of("alpha", "diffuse_alpha", "a"));

  private final Optional<PlyProperty> texcoord;
  private final Optional<PlyProperty> texnumber;

  /** Red, green, blue and alpha; empty if a color of these is missing. */
  private final List<PlyProperty> colors;

  private final Limits limits;
  private final Tally tally;

  private double[] coordinates = {};

  private int texture;
  private final float[] color = {1, 1, 1, 1};

  /** Six coordinates per triangle, four colors, and the number of a texture. */
  private double[] uvs = {};

  private float[] rgba = {};
  private int[] textures = {};

  /** The number of triangles of faces. */
  private int triangles;
  private int incomplete;

  /**
   * @param face the element of the faces
   * @param takesColors whether vertices have no colors
   * @param tally receives colors that are out of range
   */
  PlyFaceData(PlyElement face, boolean takesColors, Limits limits, Tally tally) {
    this.limits = limits;
    this.tally = tally;
    texcoord = found(face, List.of("texcoord"), true);
    texnumber = found(face, List.of("texnumber"), false);
    List<PlyProperty> found =
        COLORS.stream().flatMap(names -> found(face, names, false).stream()).toList();
    boolean hasAll = COLORS.stream().limit(3).allMatch(n -> found(face, n, false).isPresent());
    colors = takesColors && hasAll ? found : List.of();
  }

  private static Optional<PlyProperty> found(PlyElement face, List<String> names, boolean isList) {
    return face.properties().stream()
        .filter(p -> p.isList() == isList && names.contains(p.name()))
        .findFirst();
  }

  /** Returns whether a property of the faces is read here. */
  boolean uses(PlyProperty property) {
    return texcoord.filter(p -> p == property).isPresent()
        || texnumber.filter(p -> p == property).isPresent()
        || colors.contains(property);
  }

  /** Returns whether the triangles have data of their own, so that they share no vertices. */
  boolean isUsed() {
    return texcoord.isPresent() || texnumber.isPresent() || !colors.isEmpty();
  }

  void read(PlyProperty property, PlyBody body) throws ModelFormatException {
    if (property.isList()) {
      coordinates = new double[body.listLength(property)];
      for (int i = 0; i < coordinates.length; i++) {
        coordinates[i] = body.number(property);
      }
    } else if (colors.contains(property)) {
      int channel = colors.indexOf(property);
      double value = body.number(property);
      PlyVertices.count(value, property.type(), body, tally);
      double sound = Double.isNaN(value) ? 1 : value;
      color[channel] = (float) PlyVertices.color(sound, property.type(), channel == 3);
    } else {
      texture = (int) body.number(property);
    }
  }

  /**
   * Ends a face, whose triangles are a fan.
   *
   * @param first the number of its first triangle, among all of the file
   * @param end the number after its last one
   */
  void endFace(int first, int end) throws ModelFormatException {
    if (isUsed()) {
      int needed = 2 * (end - first + 2);
      incomplete += texcoord.isPresent() && coordinates.length < needed ? 1 : 0;
      cover(end);
      for (int triangle = first; triangle < end; triangle++) {
        put(0, 6 * triangle);
        put(triangle - first + 1, 6 * triangle + 2);
        put(triangle - first + 2, 6 * triangle + 4);
        textures[triangle] = texture;
        if (!colors.isEmpty()) {
          System.arraycopy(color, 0, rgba, 4 * triangle, 4);
        }
      }
      triangles += end - first;
      coordinates = new double[0];
    }
  }

  /** Stores the coordinates of a corner; 0 if they are missing or not finite. */
  private void put(int corner, int to) {
    if (texcoord.isPresent() && 2 * corner + 1 < coordinates.length) {
      for (int axis = 0; axis < 2; axis++) {
        double value = coordinates[2 * corner + axis];
        uvs[to + axis] = Double.isFinite(value) ? value : 0;
      }
    }
  }

  /** Makes room for triangles, which are light gray and have coordinates of 0 before they end. */
  void cover(int count) throws ModelFormatException {
    if (count <= textures.length) {
      return;
    }
    int larger = (int) Math.min(2L * count, ModelLimits.MAX_COUNT / 3);
    ModelLimits.require("element face", "triangles with data of their own", larger, count);
    // Each triangle gets three vertices of its own, too.
    ModelLimits.requireMemory("element face", 268L * larger, limits);
    textures = Arrays.copyOf(textures, larger);
    uvs = Arrays.copyOf(uvs, texcoord.isPresent() ? 6 * larger : 0);
    int painted = rgba.length;
    rgba = Arrays.copyOf(rgba, colors.isEmpty() ? 0 : 4 * larger);
    for (int i = painted; i < rgba.length; i++) {
      rgba[i] = i % 4 == 3 ? 1 : (float) PlainModel.ALBEDO;
    }
  }

  /**
   * Adds warnings of what lacks data: strips, and faces some of whose corners have no coordinates.
   *
   * @param all the number of all triangles
   */
  void warnOfIncomplete(int all, Warnings warnings) {
    if (triangles < all) {
      warnings.add(
          "element tristrips",
          "triangles without the colors or texture coordinates of faces: " + (all - triangles));
    }
    if (incomplete > 0) {
      warnings.add("element face", "faces without coordinates for all corners: " + incomplete);
    }
  }

  /** Returns six coordinates per triangle, at least; empty if there are none. */
  double[] uvs() {
    return texcoord.isPresent() ? uvs : new double[0];
  }

  /** Returns four linear colors per triangle, at least; empty if there are none. */
  float[] colors() {
    return colors.isEmpty() ? new float[0] : rgba;
  }

  int texture(int triangle) {
    return textures[triangle];
  }
}
