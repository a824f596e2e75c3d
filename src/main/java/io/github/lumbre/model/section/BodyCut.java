package io.github.lumbre.model.section;

import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelPart;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.DoubleStream;

/** The meshes of a part of a model, which planes cut. Confined to one thread. */
final class BodyCut {
  /** The largest number of shells that are bodies of their own. */
  private static final int MAX_BODIES = 256;

  /** The largest number of pairs of bodies that are looked at for a common area. */
  private static final int MAX_PAIRS = 1000;

  private final List<ModelPart> meshes;
  private final List<CutPlane> planes;
  private final Shells shells;
  private final Nesting.Result nesting;
  private final List<MeshCut> cuts = new ArrayList<>();
  private boolean open;
  private boolean tangled;

  private BodyCut(List<ModelPart> meshes, List<CutPlane> planes, double[][][] sides) {
    this.meshes = meshes;
    this.planes = planes;
    shells = new Shells(meshes);
    nesting = Nesting.of(meshes, shells);
    for (int plane = 0; plane < planes.size(); plane++) {
      keepTouching(plane, sides);
    }
    for (int i = 0; i < sides.length; i++) {
      cuts.add(new MeshCut(meshes.get(i).geometry(), sides[i]));
    }
  }

  /** Returns the cut; empty if positions overflow, which other code refuses. */
  static Optional<BodyCut> of(List<ModelPart> meshes, List<CutPlane> planes) {
    double[][][] sides = new double[meshes.size()][][];
    for (int i = 0; i < sides.length; i++) {
      ModelPart mesh = meshes.get(i);
      sides[i] = planes.stream().map(plane -> sides(mesh, plane)).toArray(double[][]::new);
      for (double[] each : sides[i]) {
        if (!DoubleStream.of(each).allMatch(Double::isFinite)) {
          return Optional.empty();
        }
      }
    }
    return Optional.of(new BodyCut(meshes, planes, sides));
  }

  private static double[] sides(ModelPart mesh, CutPlane plane) {
    double[] sides = new double[mesh.geometry().vertexCount()];
    for (int v = 0; v < sides.length; v++) {
      sides[v] = plane.side(mesh.position(v));
    }
    return sides;
  }

  /** Moves vertices on a plane behind it, if their shell has no vertex in front of it. */
  private void keepTouching(int plane, double[][]... sides) {
    boolean[] isInFront = new boolean[shells.end()];
    for (int m = 0; m < sides.length; m++) {
      for (int v = 0; v < sides[m][plane].length; v++) {
        isInFront[shells.of(m, v)] |= sides[m][plane][v] > 0;
      }
    }
    for (int m = 0; m < sides.length; m++) {
      for (int v = 0; v < sides[m][plane].length; v++) {
        if (sides[m][plane][v] == 0 && !isInFront[shells.of(m, v)]) {
          sides[m][plane][v] = -1;
        }
      }
    }
  }

  /** Returns what is left of a mesh. */
  ModelGeometry kept(int mesh) {
    return cuts.get(mesh).kept();
  }

  /**
   * A surface in which a plane cuts a body, in world space.
   *
   * @param number of the body: one if the file divides the model, otherwise one for each closed
   *     shell with the cavities in it
   * @param part a mesh of the body
   */
  record Surface(int number, ModelPart part, ModelGeometry shape) {}

  List<Surface> surfaces(int plane) {
    Map<Integer, Cap> caps = new TreeMap<>();
    Map<Integer, ModelPart> owners = new HashMap<>();
    for (int m = 0; m < cuts.size(); m++) {
      MeshCut mesh = cuts.get(m);
      ModelPart part = meshes.get(m);
      int number = m;
      mesh.forLines(
          plane,
          (from, to, corner) -> {
            int shell = shells.of(number, corner);
            if (shells.isClosed(shell)) {
              owners.putIfAbsent(shell, part);
              boolean isTurned = nesting.turned().get(shell);
              caps.computeIfAbsent(shell, s -> new Cap(planes.get(plane)))
                  .add(
                      point(mesh, isTurned ? to : from, part),
                      point(mesh, isTurned ? from : to, part));
            } else {
              open = true;
            }
          });
    }
    caps.values().removeIf(this::hasTwoFronts);
    join(caps);
    joinOverlapping(caps);
    List<Surface> surfaces = new ArrayList<>();
    caps.forEach(
        (shell, cap) ->
            filled(cap, plane)
                .ifPresent(shape -> surfaces.add(new Surface(shell, owners.get(shell), shape))));
    return surfaces;
  }

  /** Returns whether the triangles of a shell face both sides, so that it has no inside. */
  private boolean hasTwoFronts(Cap cap) {
    if (!cap.isBalanced()) {
      return false;
    }
    try {
      boolean isEmpty = cap.surface().isEmpty();
      open |= isEmpty;
      return isEmpty;
    } catch (Triangulation.TooMuchException e) {
      return false;
    }
  }

  /** Joins the caps of shells to those of bodies, which have the number of a shell. */
  private void join(Map<Integer, Cap> caps) {
    boolean isOne = meshes.get(0).node().whole().isDivided() || caps.size() > MAX_BODIES;
    List<Integer> solids =
        caps.keySet().stream()
            .filter(shell -> isOne || caps.get(shell).area() > 0)
            .sorted(Comparator.comparingDouble(shell -> isOne ? shell : caps.get(shell).area()))
            .toList();
    for (int shell : List.copyOf(caps.keySet())) {
      Cap cap = caps.get(shell);
      Optional<Integer> around =
          isOne
              ? solids.stream().findFirst()
              : solids.stream().filter(s -> caps.get(s).surrounds(cap)).findFirst();
      boolean isJoined = isOne || !solids.contains(shell);
      if (isJoined && around.isPresent() && around.get() != shell) {
        caps.get(around.get()).add(caps.remove(shell));
      }
    }
  }

  /** Joins the caps of bodies that overlap, so that no place is filled twice. */
  private void joinOverlapping(Map<Integer, Cap> caps) {
    List<Integer> shells = List.copyOf(caps.keySet());
    int tried = 0;
    for (int one : shells) {
      for (int other : shells) {
        boolean isPair = one < other && caps.containsKey(one) && caps.containsKey(other);
        if (isPair && caps.get(one).isNear(caps.get(other)) && tried++ < MAX_PAIRS) {
          Optional<Cap> both = caps.get(one).union(caps.get(other));
          both.ifPresent(cap -> caps.put(one, cap));
          both.ifPresent(cap -> caps.remove(other));
        }
      }
    }
  }

  private Optional<ModelGeometry> filled(Cap cap, int plane) {
    try {
      Optional<ModelGeometry> surface = cap.surface();
      open |= cap.isOpen();
      return surface.flatMap(whole -> inFront(whole, plane));
    } catch (Triangulation.TooMuchException e) {
      tangled = true;
      return Optional.empty();
    }
  }

  private static Vec3 point(MeshCut mesh, int vertex, ModelPart part) {
    return part.toWorld()
        .point(
            new Vec3(mesh.position(vertex, 0), mesh.position(vertex, 1), mesh.position(vertex, 2)));
  }

  /** Returns the part of a cap that is in front of the other planes. */
  private Optional<ModelGeometry> inFront(ModelGeometry cap, int plane) {
    List<CutPlane> others = new ArrayList<>(planes);
    others.remove(plane);
    double[][] sides = new double[others.size()][cap.vertexCount()];
    double[] p = cap.positions();
    for (int i = 0; i < sides.length; i++) {
      for (int v = 0; v < cap.vertexCount(); v++) {
        sides[i][v] = others.get(i).side(new Vec3(p[3 * v], p[3 * v + 1], p[3 * v + 2]));
      }
    }
    return Optional.of(new MeshCut(cap, sides).removed()).filter(ModelGeometry::isVisible);
  }

  boolean isOpen() {
    return open;
  }

  /** Returns whether some shells may be taken as cavities, or as solids, by mistake. */
  boolean isGuess() {
    return nesting.isGuess();
  }

  /** Returns whether the outlines of a cap cross too often to be filled. */
  boolean isTangled() {
    return tangled;
  }
}
