package io.github.lumbre.model.section;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.geometry.internal.PositionIndex;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelLimits;
import io.github.lumbre.model.internal.ModelPart;
import java.util.Arrays;
import java.util.List;

/**
 * The shells of a body: the triangles of its meshes that are connected by vertices at the same
 * position, up to rounding. A shell is closed if its triangles pass each edge as often in one
 * direction as in the other; where vertices lie within an edge, its pieces count.
 */
final class Shells {
  private static final int BITS = 31;

  /**
   * Positions are the same within this part of the body's size: far less than the precision of
   * floats. Lathes leave pinholes of rounding errors at their axes.
   */
  private static final double STEPS = 1 << 30;

  /** For each mesh the places of its vertices. */
  private final int[][] places;

  /** For each place another one of its shell, or itself for the first place of the shell. */
  private final int[] parents;

  private final boolean[] open;

  /**
   * @param meshes triangles with finite positions in world space
   */
  Shells(List<ModelPart> meshes) {
    Bounds3 box = Bounds3.EMPTY;
    for (ModelPart mesh : meshes) {
      box = box.union(mesh.toWorld().bounds(mesh.geometry().bounds()));
    }
    PositionIndex index = new PositionIndex();
    places = new int[meshes.size()][];
    for (int i = 0; i < places.length; i++) {
      places[i] = places(meshes.get(i), box, index);
    }
    parents = new int[Math.max(1, index.positions().length / 3)];
    open = new boolean[parents.length];
    Arrays.setAll(parents, i -> i);
    long[] edges = edges(meshes);
    Arrays.sort(edges);
    markOpen(edges, new OpenEdges(index.positions()));
  }

  private static int[] places(ModelPart mesh, Bounds3 box, PositionIndex index) {
    double step = box.max().minus(box.min()).maxAbs() / STEPS;
    int[] places = new int[mesh.geometry().vertexCount()];
    for (int i = 0; i < places.length; i++) {
      if ((i & ModelLimits.INTERRUPT_MASK) == 0) {
        Interrupts.check();
      }
      Vec3 p = mesh.position(i).minus(box.min());
      places[i] =
          step > 0
              ? index.number(
                  Math.rint(p.x() / step), Math.rint(p.y() / step), Math.rint(p.z() / step))
              : 0;
    }
    return places;
  }

  /** Connects places, and returns the edges: the smaller place, the larger one, the direction. */
  private long[] edges(List<ModelPart> meshes) {
    long[] edges = new long[meshes.stream().mapToInt(m -> m.geometry().indices().length).sum()];
    int size = 0;
    for (int m = 0; m < places.length; m++) {
      ModelGeometry mesh = meshes.get(m).geometry();
      for (int i = 0; i < mesh.indices().length; i++) {
        int from = places[m][mesh.indices()[i]];
        int to = places[m][mesh.indices()[i % 3 == 2 ? i - 2 : i + 1]];
        parents[first(from)] = first(to);
        long pair = (long) Math.min(from, to) << BITS | Math.max(from, to);
        edges[size++] = pair << 1 | (from < to ? 1 : 0);
      }
    }
    return edges;
  }

  private void markOpen(long[] sorted, OpenEdges unpaired) {
    int i = 0;
    while (i < sorted.length) {
      long pair = sorted[i] >> 1;
      int balance = 0;
      for (; i < sorted.length && sorted[i] >> 1 == pair; i++) {
        balance += (sorted[i] & 1) == 1 ? 1 : -1;
      }
      int low = (int) (pair >> BITS);
      int high = (int) (pair & Integer.MAX_VALUE);
      if (balance != 0 && low != high) {
        unpaired.add(low, high, balance);
      }
    }
    unpaired.ends().forEach(end -> open[first(end)] = true);
  }

  private int first(int place) {
    int p = place;
    while (parents[p] != p) {
      parents[p] = parents[parents[p]];
      p = parents[p];
    }
    return p;
  }

  /** Returns the shell of a vertex of a mesh, less than {@link #end}. */
  int of(int mesh, int vertex) {
    return first(places[mesh][vertex]);
  }

  int end() {
    return parents.length;
  }

  boolean isClosed(int shell) {
    return !open[shell];
  }
}
