package io.github.lumbre.model.section;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * The triangles that a straight way between two vertices crosses, and their replacement by
 * triangles that have the way as an edge. Mutable.
 *
 * <p>The way divides the crossed triangles into two polygons. Every point of both can be seen from
 * the way, so that cutting corners one after another triangulates them (Toussaint and Avis 1982,
 * "On a convex hull algorithm for polygons and its application to triangulation problems").
 */
final class Passage {
  private static final int NONE = -1;

  private final Triangulation mesh;
  private final List<Integer> triangles = new ArrayList<>();

  /** The sides of the crossed triangles to the left of the way, from its end to its start. */
  private final List<Integer> left = new ArrayList<>();

  /** As left, to the right of the way, from its start to its end. */
  private final List<Integer> right = new ArrayList<>();

  private final int start;

  /**
   * @param first the half-edge opposite to the start that the way crosses first
   */
  Passage(Triangulation mesh, int first) {
    this.mesh = mesh;
    start = mesh.apex(first);
    triangles.add(first / 3);
    right.add(before(first));
    left.add(Triangulation.next(first));
  }

  private static int before(int halfEdge) {
    return Triangulation.next(Triangulation.next(halfEdge));
  }

  /** Returns the half-edge that the way crosses after another one, with a vertex to its left. */
  int passLeft(int crossed) {
    int other = mesh.twin(crossed);
    triangles.add(other / 3);
    left.add(before(other));
    return Triangulation.next(other);
  }

  /** Returns the half-edge that the way crosses after another one, with a vertex to its right. */
  int passRight(int crossed) {
    int other = mesh.twin(crossed);
    triangles.add(other / 3);
    right.add(Triangulation.next(other));
    return before(other);
  }

  /**
   * Ends the way at the vertex behind an edge that it crosses, and replaces the triangles. Returns
   * the half-edge along the way.
   */
  int end(int crossed) {
    int other = mesh.twin(crossed);
    int end = mesh.apex(other);
    triangles.add(other / 3);
    right.add(Triangulation.next(other));
    left.add(before(other));
    Collections.reverse(left);
    return replace(end);
  }

  private int replace(int end) {
    List<Integer> sides = new ArrayList<>(left);
    sides.addAll(right);
    int[] twins = sides.stream().mapToInt(mesh::twin).toArray();
    int[] deltas = sides.stream().mapToInt(mesh::delta).toArray();
    Map<Integer, Integer> places = new HashMap<>();
    sides.forEach(side -> places.put(side, places.size()));
    List<Integer> made = new ArrayList<>();
    int[] leftEnds = left.stream().mapToInt(mesh::to).toArray();
    int[] rightEnds = right.stream().mapToInt(mesh::to).toArray();
    int along = fill(end, leftEnds, made);
    int against = fill(start, rightEnds, made);
    mesh.link(along, against);
    for (int i = 0; i < twins.length; i++) {
      Integer inside = places.get(twins[i]);
      mesh.attach(made.get(i), inside == null ? twins[i] : made.get(inside), deltas[i]);
    }
    return along;
  }

  /**
   * Fills the polygon of some sides and the way by cutting its corners.
   *
   * @param first vertex of the polygon
   * @param ends the vertices at the ends of the sides, counterclockwise
   * @param made receives the new half-edges along the sides
   * @return the half-edge from the last vertex to the first one, which is the way
   */
  private int fill(int first, int[] ends, List<Integer> made) {
    int[] chain = new int[ends.length + 1];
    // What is at the edge to a vertex of the chain: the half-edge of a triangle that was cut off,
    // or -1 minus the number of a side.
    int[] edges = new int[chain.length];
    chain[0] = first;
    int size = 1;
    for (int v : ends) {
      int edge = -1 - made.size();
      made.add(NONE);
      while (size > 1 && mesh.area(chain[size - 2], chain[size - 1], v) > 0) {
        int t = triangles.remove(triangles.size() - 1);
        mesh.set(t, chain[size - 2], chain[size - 1], v);
        join(edge, 3 * t, made);
        join(edges[size - 1], 3 * t + 2, made);
        edge = 3 * t + 1;
        size--;
      }
      chain[size] = v;
      edges[size++] = edge;
    }
    return edges[1];
  }

  private void join(int edge, int halfEdge, List<Integer> made) {
    if (edge < 0) {
      made.set(-1 - edge, halfEdge);
    } else {
      mesh.link(edge, halfEdge);
    }
  }
}
