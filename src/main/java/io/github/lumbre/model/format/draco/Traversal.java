package io.github.lumbre.model.format.draco;

import static io.github.lumbre.model.format.draco.CornerTable.NONE;
import static io.github.lumbre.model.format.draco.CornerTable.next;
import static io.github.lumbre.model.format.draco.CornerTable.previous;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.model.ModelFormatException;
import java.util.BitSet;

/** Visits all faces of a connectivity, and notes the order of its vertices. Mutable. */
final class Traversal {
  private static final int DEPTH_FIRST = 0;
  private static final int PREDICTION_DEGREE = 1;

  /** Stacks of the traversal by prediction degree: for tips that are known, likely, unlikely. */
  private static final int PRIORITIES = 3;

  private static final int INTERRUPT_MASK = (1 << 14) - 1;

  private final CornerTable table;
  private final Entries entries;
  private final BitSet visited;
  private final IntStack[] stacks = new IntStack[PRIORITIES];
  private final int[] degrees;
  private int best;

  private Traversal(CornerTable table, boolean isByDegree, DracoInput input)
      throws ModelFormatException {
    this.table = table;
    int faces = table.vertices().length / 3;
    entries = Entries.over(table, input);
    input.allocate(faces / Byte.SIZE);
    visited = new BitSet(faces);
    for (int i = 0; i < PRIORITIES; i++) {
      stacks[i] = new IntStack(input);
    }
    degrees = input.integers(isByDegree ? table.vertexCount() : 0);
  }

  /**
   * Returns the order of the vertices of a connectivity.
   *
   * @param method its code in the stream
   */
  static Entries entries(CornerTable table, int method, DracoInput input)
      throws ModelFormatException {
    if (method != DEPTH_FIRST && method != PREDICTION_DEGREE) {
      throw input.unsupported("expected depth first (0) or prediction degree (1), found " + method);
    }
    boolean isByDegree = method == PREDICTION_DEGREE;
    Traversal traversal = new Traversal(table, isByDegree, input);
    for (int corner = 0; corner < table.vertices().length; corner += 3) {
      if ((corner & INTERRUPT_MASK) < 3) {
        Interrupts.check();
      }
      if (traversal.isOpen(corner)) {
        traversal.from(corner, isByDegree);
      }
    }
    return traversal.entries;
  }

  private void from(int corner, boolean isByDegree) throws ModelFormatException {
    reach(next(corner));
    reach(previous(corner));
    if (isByDegree) {
      reach(corner);
      push(corner, 0);
      byDegree();
    } else {
      stacks[0].push(corner);
      while (!stacks[0].isEmpty()) {
        int popped = stacks[0].pop();
        if (isOpen(popped)) {
          depthFirst(popped);
        }
      }
    }
  }

  /** Returns whether a corner belongs to a face that is not visited. */
  private boolean isOpen(int corner) {
    return corner != NONE && !visited.get(corner / 3);
  }

  /** Notes the vertex of a corner, and returns whether it is a new one. */
  private boolean reach(int corner) {
    int vertex = table.vertices()[corner];
    if (entries.has(vertex)) {
      return false;
    }
    entries.add(vertex, corner);
    return true;
  }

  /** Visits faces until none is left here; goes to the right first, and around new vertices. */
  private void depthFirst(int from) throws ModelFormatException {
    int corner = from;
    while (isOpen(corner)) {
      visited.set(corner / 3);
      int right = table.right(corner);
      int left = table.left(corner);
      if (reach(corner) && !table.isOnBoundary(table.vertices()[corner])) {
        corner = right;
      } else if (!isOpen(right)) {
        corner = left;
      } else {
        if (isOpen(left)) {
          stacks[0].push(left);
        }
        corner = right;
      }
    }
  }

  /** Visits faces whose tips are easy to predict first. */
  private void byDegree() throws ModelFormatException {
    for (int corner = pop(); corner != NONE; corner = pop()) {
      while (isOpen(corner)) {
        visited.set(corner / 3);
        reach(corner);
        corner = byDegree(table.left(corner), table.right(corner));
      }
    }
  }

  /** Returns the neighbor to visit at once, or none; keeps others for later. */
  private int byDegree(int left, int right) throws ModelFormatException {
    boolean isRightOpen = isOpen(right);
    if (isOpen(left)) {
      int priority = priority(left);
      if (!isRightOpen && priority <= best) {
        return left;
      }
      push(left, priority);
    }
    if (isRightOpen) {
      int priority = priority(right);
      if (priority <= best) {
        return right;
      }
      push(right, priority);
    }
    return NONE;
  }

  private int priority(int corner) {
    int tip = table.vertices()[corner];
    return entries.has(tip) ? 0 : ++degrees[tip] > 1 ? 1 : 2;
  }

  private void push(int corner, int priority) throws ModelFormatException {
    stacks[priority].push(corner);
    best = Math.min(best, priority);
  }

  private int pop() {
    for (int i = best; i < PRIORITIES; i++) {
      if (!stacks[i].isEmpty()) {
        best = i;
        return stacks[i].pop();
      }
    }
    return NONE;
  }
}
