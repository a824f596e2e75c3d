package io.github.lumbre.model.format.dae;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.format.FormatFile;
import io.github.lumbre.model.format.dae.DaePrimitive.Input;
import io.github.lumbre.model.internal.Corners;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelLimits;
import io.github.lumbre.model.internal.PlainModel;
import io.github.lumbre.model.internal.Tally;
import io.github.lumbre.model.internal.TriangleList;
import java.util.List;
import java.util.Optional;

/**
 * The triangles of some primitives of one material, which have the same kinds of vectors, with two
 * of their sets of texture coordinates at most. Mutable while they are divided.
 */
final class DaeSurface implements PolygonDivision.Target {
  /** The memory of a corner that shares its vertex with no other. */
  private static final long CORNER_BYTES = 150;

  private static final double[] NONE = {};

  private final FormatFile file;
  private final Corners corners = new Corners();

  /** Combinations of two texture coordinates and a color, if there is more than one of them. */
  private final Corners pairs = new Corners();

  private final TriangleList raw = new TriangleList(0);
  private final TriangleList triangles = new TriangleList(0);
  private final DaePool positions = new DaePool(DaeSources.POSITION);
  private final DaePool normals = new DaePool(DaeSources.NORMAL);
  private final DaePool uvs = new DaePool(DaeSources.UV);
  private final DaePool uvs1 = new DaePool(DaeSources.UV);
  private final DaePool colors = new DaePool(DaeSources.COLOR);
  private boolean hasPairs;
  private int left = ModelLimits.INTERRUPT_MASK;

  private DaePrimitive primitive;
  private Input position;
  private Optional<Input> normal = Optional.empty();
  private Optional<Input> uv = Optional.empty();
  private Optional<Input> uv1 = Optional.empty();
  private Optional<Input> color = Optional.empty();
  private int positionStart;
  private int normalStart;
  private int uvStart;
  private int uv1Start;
  private int colorStart;

  private DaeSurface(FormatFile file) {
    this.file = file;
  }

  /**
   * Returns the triangles of primitives.
   *
   * @param sets the sets of texture coordinates to use, at most two; others are ignored
   */
  static ModelGeometry geometry(
      List<DaePrimitive> primitives, List<Integer> sets, PolygonDivision division, FormatFile file)
      throws ModelFormatException {
    DaeSurface surface = new DaeSurface(file);
    for (DaePrimitive each : primitives) {
      surface.use(each, sets);
      division.to(surface, each.location());
      each.divide(division);
    }
    return surface.geometry();
  }

  private void use(DaePrimitive newPrimitive, List<Integer> sets) {
    primitive = newPrimitive;
    position = primitive.positions().orElseThrow();
    normal = primitive.normals();
    uv = sets.isEmpty() ? Optional.empty() : Optional.of(primitive.uvs().get(sets.get(0)));
    uv1 = sets.size() < 2 ? Optional.empty() : Optional.of(primitive.uvs().get(sets.get(1)));
    color = primitive.colors();
    hasPairs = uv1.isPresent() || color.isPresent();
    positionStart = positions.start(position.vectors());
    normalStart = normal.map(input -> normals.start(input.vectors())).orElse(0);
    uvStart = uv.map(input -> uvs.start(input.vectors())).orElse(0);
    uv1Start = uv1.map(input -> uvs1.start(input.vectors())).orElse(0);
    colorStart = color.map(input -> colors.start(input.vectors())).orElse(0);
  }

  @Override
  public boolean position(int corner, double[] target, int at) {
    int index = primitive.index(position, corner, DaeSources.POSITION);
    if (index < 0) {
      tally("left out faces with indices beyond their vertices");
      return false;
    }
    System.arraycopy(position.vectors(), 3 * index, target, at, 3);
    boolean isFinite = Double.isFinite(target[at] + target[at + 1] + target[at + 2]);
    if (!isFinite) {
      tally(Tally.BROKEN);
    }
    return isFinite;
  }

  private void tally(String reason) {
    file.tally().add(reason, primitive.location());
  }

  @Override
  public void triangle(int a, int b, int c) throws ModelFormatException {
    int pa = primitive.index(position, a, DaeSources.POSITION);
    int pb = primitive.index(position, b, DaeSources.POSITION);
    int pc = primitive.index(position, c, DaeSources.POSITION);
    if ((pa | pb | pc) < 0) {
      tally("left out faces with indices beyond their vertices");
      return;
    }
    pa += positionStart;
    pb += positionStart;
    pc += positionStart;
    if (!raw.addSound(positions.values(), pa, pb, pc, file.tally(), primitive::location)) {
      return;
    }
    count();
    int na = normal(a);
    int nb = normal(b);
    int nc = normal(c);
    if ((na | nb | nc) < 0) {
      na = flatNormal(pa, pb, pc);
      nb = na;
      nc = na;
    }
    triangles.add(
        corners.number(pa, rest(a), na),
        corners.number(pb, rest(b), nb),
        corners.number(pc, rest(c), nc));
  }

  /** Counts triangles and memory now and then. */
  private void count() throws ModelFormatException {
    left -= 1;
    if (left == 0) {
      Interrupts.check();
      left = ModelLimits.INTERRUPT_MASK;
      file.take(primitive.location(), 3 * CORNER_BYTES * ModelLimits.INTERRUPT_MASK);
      ModelLimits.requireTriangles(
          primitive.location(), triangles.count(), file.options().limits());
    }
  }

  /** Returns the number of a corner's normal; -1 if it has none that is finite. */
  private int normal(int corner) {
    if (normal.isEmpty()) {
      return 0;
    }
    int index = primitive.index(normal.get(), corner, DaeSources.NORMAL);
    double[] n = normal.get().vectors();
    boolean isSound =
        index >= 0 && Double.isFinite(n[3 * index] + n[3 * index + 1] + n[3 * index + 2]);
    return isSound ? normalStart + index : -1;
  }

  /** Adds the normal of a triangle; (0, 1, 0) if it is too small to have one. */
  private int flatNormal(int a, int b, int c) {
    tally("computed normals of faces whose own are missing or not finite");
    Vec3 origin = vertex(a);
    Vec3 cross = vertex(b).minus(origin).cross(vertex(c).minus(origin)).normalized();
    Vec3 flat = cross.isFinite() ? cross : Vec3.Y;
    return normals.add(flat.x(), flat.y(), flat.z());
  }

  private Vec3 vertex(int index) {
    double[] p = positions.values();
    return new Vec3(p[3 * index], p[3 * index + 1], p[3 * index + 2]);
  }

  /** Returns the number of a corner's texture coordinates, or of all that it has of them. */
  private int rest(int corner) {
    int first = uvStart + index(uv, corner, DaeSources.UV);
    return hasPairs
        ? pairs.number(
            first,
            uv1Start + index(uv1, corner, DaeSources.UV),
            colorStart + index(color, corner, DaeSources.COLOR))
        : first;
  }

  private int index(Optional<Input> input, int corner, int size) {
    if (input.isEmpty()) {
      return 0;
    }
    int index = primitive.index(input.get(), corner, size);
    if (index < 0) {
      tally("took the first texture coordinates or colors for indices beyond their lists");
    }
    return Math.max(0, index);
  }

  private ModelGeometry geometry() throws ModelFormatException {
    file.take(primitive.location(), CORNER_BYTES * 3 * (triangles.count() % 0x4000));
    float[] rgba = new float[0];
    if (color.isPresent()) {
      rgba = floats(corners.gather(1, pairs.gather(2, colors.values(), 4), 4));
      PlainModel.showInvisible(primitive.location(), rgba, file.warnings());
    }
    return new ModelGeometry(
        corners.gather(0, positions.values(), 3),
        normal.isEmpty() ? NONE : corners.gather(2, normals.values(), 3),
        NONE,
        uv.isEmpty()
            ? NONE
            : corners.gather(1, hasPairs ? pairs.gather(0, uvs.values(), 2) : uvs.values(), 2),
        uv1.isEmpty() ? NONE : corners.gather(1, pairs.gather(1, uvs1.values(), 2), 2),
        rgba,
        triangles.toArray());
  }

  private static float[] floats(double... values) {
    float[] floats = new float[values.length];
    for (int i = 0; i < values.length; i++) {
      floats[i] = (float) values[i];
    }
    return floats;
  }
}
