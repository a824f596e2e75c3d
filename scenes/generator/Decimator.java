package generator;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.PriorityQueue;

/**
 * Takes triangles away where a mesh is flat, by collapsing edges in the order of their quadric
 * error (Garland and Heckbert 1997). Open borders are held in place by planes across them.
 */
final class Decimator {
  private static final double BORDER_WEIGHT = 20;
  private static final double LENGTH_WEIGHT = 2e-4;

  /** A collapse of two vertices into {@code position}, outdated when a version has moved on. */
  private record Collapse(double cost, int a, int b, Vec position, int versionA, int versionB)
      implements Comparable<Collapse> {
    @Override
    public int compareTo(Collapse o) {
      int order = Double.compare(cost, o.cost);
      order = order != 0 ? order : Integer.compare(a, o.a);
      return order != 0 ? order : Integer.compare(b, o.b);
    }
  }

  private final Vec[] positions;
  private final int[] triangles;
  private final boolean[] removed;
  private final Quadric[] quadrics;
  private final List<List<Integer>> around;
  private final int[] versions;
  private final PriorityQueue<Collapse> queue = new PriorityQueue<>();

  private Decimator(Mesh mesh) {
    positions = mesh.positions().clone();
    triangles = mesh.triangles().clone();
    removed = new boolean[mesh.triangleCount()];
    quadrics = new Quadric[positions.length];
    versions = new int[positions.length];
    around = new ArrayList<>();
    for (int v = 0; v < positions.length; v++) {
      quadrics[v] = new Quadric();
      around.add(new ArrayList<>(6));
    }
    for (int i = 0; i < triangles.length; i++) {
      around.get(triangles[i]).add(i / 3);
    }
  }

  /** The mesh with at most {@code target} triangles, as far as collapses allow. */
  static Mesh decimate(Mesh mesh, int target) {
    Decimator d = new Decimator(mesh);
    d.measure(mesh);
    d.collapse(target);
    return d.compact(mesh);
  }

  private void measure(Mesh mesh) {
    for (int t = 0; t < mesh.triangleCount(); t++) {
      Vec area = mesh.areaVector(t);
      double size = area.length() / 2;
      Vec n = area.normalized();
      for (int c = 0; c < 3; c++) {
        quadrics[triangles[3 * t + c]].addPlane(n, mesh.corner(t, c), size);
      }
      for (int c = 0; c < 3; c++) {
        int a = triangles[3 * t + c];
        int b = triangles[3 * t + (c + 1) % 3];
        if (shared(a, b) == 1) {
          Vec edge = positions[b].minus(positions[a]);
          Vec across = edge.cross(n).normalized();
          double weight = BORDER_WEIGHT * edge.dot(edge);
          quadrics[a].addPlane(across, positions[a], weight);
          quadrics[b].addPlane(across, positions[a], weight);
        }
      }
    }
    for (int a = 0; a < positions.length; a++) {
      for (int b : neighbours(a)) {
        if (a < b) {
          offer(a, b);
        }
      }
    }
  }

  private int shared(int a, int b) {
    int count = 0;
    for (int t : around.get(a)) {
      count += uses(t, b) ? 1 : 0;
    }
    return count;
  }

  private boolean uses(int t, int v) {
    return triangles[3 * t] == v || triangles[3 * t + 1] == v || triangles[3 * t + 2] == v;
  }

  /** The vertices joined to this one, in order, each once. */
  private int[] neighbours(int v) {
    int[] all = new int[2 * around.get(v).size()];
    int n = 0;
    for (int t : around.get(v)) {
      for (int c = 0; c < 3; c++) {
        if (triangles[3 * t + c] != v) {
          all[n++] = triangles[3 * t + c];
        }
      }
    }
    Arrays.sort(all);
    int kept = 0;
    for (int i = 0; i < n; i++) {
      if (i == 0 || all[i] != all[i - 1]) {
        all[kept++] = all[i];
      }
    }
    return Arrays.copyOf(all, kept);
  }

  private void offer(int a, int b) {
    Quadric sum = new Quadric();
    sum.add(quadrics[a]);
    sum.add(quadrics[b]);
    Vec middle = positions[a].lerp(positions[b], .5);
    double length = positions[b].minus(positions[a]).length();
    Vec best = sum.minimum(middle);
    if (best.minus(middle).length() > length) {
      best = middle;
    }
    for (Vec end : new Vec[] {positions[a], positions[b]}) {
      if (sum.at(end) < sum.at(best)) {
        best = end;
      }
    }
    double cost = sum.at(best) + LENGTH_WEIGHT * length * length * length * length;
    queue.add(new Collapse(cost, a, b, best, versions[a], versions[b]));
  }

  private void collapse(int target) {
    int left = removed.length;
    while (left > target && !queue.isEmpty()) {
      Collapse c = queue.remove();
      boolean current = versions[c.a] == c.versionA && versions[c.b] == c.versionB;
      if (current && keepsShape(c)) {
        left -= apply(c);
      }
    }
  }

  /** Whether the collapse neither pinches the surface nor turns a triangle over. */
  private boolean keepsShape(Collapse c) {
    int common = 0;
    int[] ofB = neighbours(c.b);
    for (int v : neighbours(c.a)) {
      common += Arrays.binarySearch(ofB, v) >= 0 ? 1 : 0;
    }
    return common <= shared(c.a, c.b)
        && staysUpright(c.a, c.b, c.position)
        && staysUpright(c.b, c.a, c.position);
  }

  private boolean staysUpright(int moving, int other, Vec to) {
    for (int t : around.get(moving)) {
      if (uses(t, other)) {
        continue;
      }
      int at = triangles[3 * t] == moving ? 0 : triangles[3 * t + 1] == moving ? 1 : 2;
      Vec p = positions[triangles[3 * t + (at + 1) % 3]];
      Vec q = positions[triangles[3 * t + (at + 2) % 3]];
      Vec before = p.minus(positions[moving]).cross(q.minus(positions[moving]));
      Vec after = p.minus(to).cross(q.minus(to));
      double longest =
          Math.max(q.minus(p).length(), Math.max(p.minus(to).length(), q.minus(to).length()));
      boolean turned = before.dot(after) < .3 * before.length() * after.length();
      if (turned || after.length() < .08 * longest * longest) {
        return false;
      }
    }
    return true;
  }

  /** Merges b into a; returns how many triangles that removes. */
  private int apply(Collapse c) {
    int gone = 0;
    positions[c.a] = c.position;
    quadrics[c.a].add(quadrics[c.b]);
    versions[c.a]++;
    versions[c.b] = -1;
    for (int t : around.get(c.b)) {
      if (uses(t, c.a)) {
        removed[t] = true;
        gone++;
        continue;
      }
      for (int k = 3 * t; k < 3 * t + 3; k++) {
        triangles[k] = triangles[k] == c.b ? c.a : triangles[k];
      }
      around.get(c.a).add(t);
    }
    around.get(c.b).clear();
    for (int t : around.get(c.a)) {
      if (removed[t]) {
        for (int k = 3 * t; k < 3 * t + 3; k++) {
          int v = triangles[k];
          if (v != c.a && v != c.b) {
            around.get(v).remove((Integer) t);
          }
        }
      }
    }
    around.get(c.a).removeIf(t -> removed[t]);
    for (int v : neighbours(c.a)) {
      offer(Math.min(v, c.a), Math.max(v, c.a));
    }
    return gone;
  }

  private Mesh compact(Mesh mesh) {
    int[] newIndex = new int[positions.length];
    Arrays.fill(newIndex, -1);
    List<Vec> kept = new ArrayList<>();
    int[] keptBodies = new int[positions.length];
    int[] corners = new int[triangles.length];
    int used = 0;
    for (int i = 0; i < triangles.length; i++) {
      int v = triangles[i];
      if (removed[i / 3]) {
        continue;
      }
      if (newIndex[v] < 0) {
        newIndex[v] = kept.size();
        keptBodies[kept.size()] = mesh.bodies()[v];
        kept.add(positions[v]);
      }
      corners[used++] = newIndex[v];
    }
    return new Mesh(
        kept.toArray(new Vec[0]),
        Arrays.copyOf(corners, used),
        Arrays.copyOf(keptBodies, kept.size()));
  }
}
