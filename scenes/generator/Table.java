package generator;

/**
 * A table of 1.6 x 0.9 units, 0.75 high. The top's texture coordinates span the whole top; aprons
 * and legs take narrow strips near its edge, so that a wood's rings become their grain.
 */
final class Table {
  private static final double WIDTH = 1.6;
  private static final double DEPTH = .9;
  private static final double HEIGHT = .75;
  private static final double THICKNESS = .04;
  private static final int CORNER = 6;

  private final ObjFile obj = new ObjFile(4);

  private Table() {}

  static ObjFile obj() {
    Table table = new Table();
    table.slab();
    double x = WIDTH / 2 - .10;
    double z = DEPTH / 2 - .10;
    for (int i = 0; i < 4; i++) {
      double sx = (i & 1) == 0 ? -1 : 1;
      double sz = (i & 2) == 0 ? -1 : 1;
      table.leg(sx * x, sz * z, .13 + .19 * i);
    }
    table.apron(new Vec(0, .655, -z), new Vec(x, .05, .014));
    table.apron(new Vec(0, .655, z), new Vec(x, .05, .014));
    table.apron(new Vec(-x, .655, 0), new Vec(.014, .05, z));
    table.apron(new Vec(x, .655, 0), new Vec(.014, .05, z));
    return table.obj;
  }

  /** The top: rounded corners and an edge rounded from above to below. */
  private void slab() {
    double r = .018;
    int rows = 2 * CORNER + 2;
    int around = 4 * (CORNER + 1);
    String[][] ring = new String[rows][around + 1];
    for (int row = 0; row < rows; row++) {
      boolean below = row <= CORNER;
      double step = below ? row : row - 1;
      double a = StrictMath.toRadians(-90 + 180.0 * step / (2 * CORNER));
      double out = r * StrictMath.cos(a);
      double y = HEIGHT - (below ? THICKNESS - r : r) + r * StrictMath.sin(a);
      for (int k = 0; k <= around; k++) {
        ring[row][k] = slabCorner(k % around, out, y, StrictMath.sin(a), StrictMath.cos(a), r);
      }
    }
    for (int row = 0; row + 1 < rows; row++) {
      for (int k = 0; k < around; k++) {
        obj.face(ring[row][k], ring[row + 1][k + 1], ring[row][k + 1]);
        obj.face(ring[row][k], ring[row + 1][k], ring[row + 1][k + 1]);
      }
    }
    String bottom = top(new Vec(0, HEIGHT - THICKNESS, 0), new Vec(0, -1, 0));
    String top = top(new Vec(0, HEIGHT, 0), new Vec(0, 1, 0));
    for (int k = 0; k < around; k++) {
      obj.face(bottom, ring[0][k], ring[0][k + 1]);
      obj.face(top, ring[rows - 1][k + 1], ring[rows - 1][k]);
    }
  }

  private String slabCorner(int k, double out, double y, double up, double level, double r) {
    int quarter = k / (CORNER + 1);
    double a = StrictMath.toRadians(90 * (quarter + (double) (k % (CORNER + 1)) / CORNER));
    double c = StrictMath.cos(a);
    double s = StrictMath.sin(a);
    double round = .03;
    double cx = (quarter == 0 || quarter == 3 ? 1 : -1) * (WIDTH / 2 - round - r);
    double cz = (quarter < 2 ? 1 : -1) * (DEPTH / 2 - round - r);
    Vec p = new Vec(cx + (round + out) * c, y, cz + (round + out) * s);
    return top(p, new Vec(level * c, up, level * s));
  }

  private String top(Vec p, Vec n) {
    return obj.corner(p, .5 + p.x() / WIDTH, .5 + p.z() / DEPTH, n);
  }

  /** A square leg, turned between two square blocks. */
  private void leg(double x, double z, double grain) {
    double h = .042;
    box(new Vec(x, .62, z), new Vec(h, .105, h), grain);
    box(new Vec(x, .055, z), new Vec(.032, .055, .032), grain);
    double[] profile = {
      .026, .10, .030, .125, .026, .15, .022, .17, .027, .25, .034, .38, .037, .44, .033, .48, .025,
      .495, .036, .507, .036, .515, .027, .53
    };
    int segments = 32;
    String[][] ring = new String[profile.length / 2][segments + 1];
    for (int i = 0; i < ring.length; i++) {
      int before = Math.max(0, i - 1);
      int after = Math.min(ring.length - 1, i + 1);
      double dr = profile[2 * after] - profile[2 * before];
      double dy = profile[2 * after + 1] - profile[2 * before + 1];
      double length = StrictMath.hypot(dr, dy);
      for (int s = 0; s <= segments; s++) {
        double a = 2 * Math.PI * (s % segments) / segments;
        double c = StrictMath.cos(a);
        double d = StrictMath.sin(a);
        double r = profile[2 * i];
        Vec p = new Vec(x + r * c, profile[2 * i + 1], z + r * d);
        Vec n = new Vec(dy / length * c, -dr / length, dy / length * d);
        double strip = .04 * Math.abs(2.0 * s / segments - 1);
        ring[i][s] = obj.corner(p, .02 + strip, grain + .15 * profile[2 * i + 1], n);
      }
    }
    for (int i = 0; i + 1 < ring.length; i++) {
      for (int s = 0; s < segments; s++) {
        obj.face(ring[i][s], ring[i + 1][s + 1], ring[i][s + 1]);
        obj.face(ring[i][s], ring[i + 1][s], ring[i + 1][s + 1]);
      }
    }
  }

  private void apron(Vec centre, Vec half) {
    box(centre, half, .4);
  }

  /** A box whose grain runs along its longest side. */
  private void box(Vec c, Vec half, double grain) {
    int longest = half.x() > half.y() && half.x() > half.z() ? 0 : half.z() > half.y() ? 2 : 1;
    for (int face = 0; face < 6; face++) {
      int axis = face / 2;
      double sign = face % 2 == 0 ? -1 : 1;
      int u = (axis + 1) % 3;
      int v = (axis + 2) % 3;
      String[] corners = new String[4];
      for (int k = 0; k < 4; k++) {
        double[] d = new double[3];
        d[axis] = sign;
        d[u] = k == 1 || k == 2 ? 1 : -1;
        d[v] = k >= 2 ? 1 : -1;
        Vec p = new Vec(d[0] * half.x(), d[1] * half.y(), d[2] * half.z());
        double along = p.get(longest);
        int across = longest == u ? v : longest == v ? u : u;
        Vec n = new Vec(axis == 0 ? sign : 0, axis == 1 ? sign : 0, axis == 2 ? sign : 0);
        corners[k] = obj.corner(c.plus(p), .06 + .5 * p.get(across), grain + .15 * along, n);
      }
      boolean flip = sign < 0;
      obj.face(corners[0], corners[flip ? 2 : 1], corners[flip ? 1 : 2]);
      obj.face(corners[0], corners[flip ? 3 : 2], corners[flip ? 2 : 3]);
    }
  }
}
