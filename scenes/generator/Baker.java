package generator;

/**
 * Paints the textures of an unwrapped sculpture: for every texel that a triangle covers, the paint
 * at that place of the surface, and the relief's normal in the triangle's tangent frame.
 */
final class Baker {
  private static final int DILATION = 4;

  private final Sculpture sculpture;
  private final Mesh mesh;
  private final Vec[] normals;
  private final double[] uv;
  private final int size;
  private final double step;

  /** The colours. */
  final Raster colours;

  /** The normal map, red along u and green along v. */
  final Raster relief;

  private final boolean[] covered;

  /**
   * Paints everything.
   *
   * @param normals the unit normal at each corner of each triangle
   * @param size the width and height of the textures, in texels
   * @param step half the distance over which slopes of the relief are taken
   */
  Baker(Sculpture sculpture, Mesh mesh, Vec[] normals, Atlas atlas, int size, double step) {
    this.sculpture = sculpture;
    this.mesh = mesh;
    this.normals = normals;
    this.uv = atlas.uv;
    this.size = size;
    this.step = step;
    colours = new Raster(size, size);
    relief = new Raster(size, size);
    covered = new boolean[size * size];
    for (int t = 0; t < mesh.triangleCount(); t++) {
      bake(t);
    }
    fillGaps();
  }

  /** Paints the texels whose centres lie in a triangle or within half a texel of it. */
  private void bake(int t) {
    double ax = uv[6 * t] * size;
    double ay = uv[6 * t + 1] * size;
    double bx = uv[6 * t + 2] * size - ax;
    double by = uv[6 * t + 3] * size - ay;
    double cx = uv[6 * t + 4] * size - ax;
    double cy = uv[6 * t + 5] * size - ay;
    double det = bx * cy - by * cx;
    if (det == 0) {
      return;
    }
    Vec tangent = edge(t, 1).times(cy).minus(edge(t, 2).times(by)).times(1 / det);
    Vec bitangent = edge(t, 2).times(bx).minus(edge(t, 1).times(cx)).times(1 / det);
    int x0 = (int) Math.floor(ax + Math.min(0, Math.min(bx, cx)));
    int x1 = (int) Math.ceil(ax + Math.max(0, Math.max(bx, cx)));
    int y0 = (int) Math.floor(ay + Math.min(0, Math.min(by, cy)));
    int y1 = (int) Math.ceil(ay + Math.max(0, Math.max(by, cy)));
    for (int y = y0; y < y1; y++) {
      for (int x = x0; x < x1; x++) {
        double px = x + .5 - ax;
        double py = y + .5 - ay;
        double b = (px * cy - py * cx) / det;
        double c = (bx * py - by * px) / det;
        if (b >= 0 && c >= 0 && b + c <= 1) {
          texel(t, x, y, b, c, tangent, bitangent);
        }
      }
    }
  }

  private Vec edge(int t, int corner) {
    return mesh.corner(t, corner).minus(mesh.corner(t, 0));
  }

  private void texel(int t, int x, int y, double b, double c, Vec tangent, Vec bitangent) {
    Vec p = mesh.corner(t, 0).plus(edge(t, 1).times(b)).plus(edge(t, 2).times(c));
    Vec n =
        normals[3 * t]
            .times(1 - b - c)
            .plus(normals[3 * t + 1].times(b))
            .plus(normals[3 * t + 2].times(c))
            .normalized();
    Paint paint = sculpture.paint(mesh.bodyOf(t));
    int row = size - 1 - y;
    covered[row * size + x] = true;
    colours.set(x, row, blend(paint, p, n, tangent, bitangent));
    Vec right = tangent.minus(n.times(tangent.dot(n))).normalized();
    Vec up = n.cross(right);
    up = up.dot(bitangent) < 0 ? up.times(-1) : up;
    double dx = slope(paint, p, right);
    double dy = slope(paint, p, up);
    double scale = 1 / Math.sqrt(1 + dx * dx + dy * dy);
    relief.set(x, row, Raster.normal(-dx * scale, -dy * scale, scale));
  }

  /** The mean of the colours in the four quarters of a texel. */
  private int blend(Paint paint, Vec p, Vec n, Vec tangent, Vec bitangent) {
    int[] sum = new int[3];
    for (int i = 0; i < 4; i++) {
      Vec du = tangent.times((i & 1) == 0 ? -.25 : .25);
      Vec dv = bitangent.times((i & 2) == 0 ? -.25 : .25);
      int rgb = paint.colour(p.plus(du).plus(dv), n);
      sum[0] += rgb >> 16;
      sum[1] += rgb >> 8 & 255;
      sum[2] += rgb & 255;
    }
    return (sum[0] + 2) / 4 << 16 | (sum[1] + 2) / 4 << 8 | (sum[2] + 2) / 4;
  }

  private double slope(Paint paint, Vec p, Vec along) {
    Vec d = along.times(step);
    return (paint.height(p.plus(d)) - paint.height(p.minus(d))) / (2 * step);
  }

  /** Carries the charts' borders outwards and makes what is left flat and grey. */
  private void fillGaps() {
    for (int round = 0; round < DILATION; round++) {
      boolean[] before = covered.clone();
      for (int y = 0; y < size; y++) {
        for (int x = 0; x < size; x++) {
          if (!before[y * size + x]) {
            fill(x, y, before);
          }
        }
      }
    }
    for (int i = 0; i < size * size; i++) {
      if (!covered[i]) {
        colours.set(i % size, i / size, 0x808080);
        relief.set(i % size, i / size, Raster.normal(0, 0, 1));
      }
    }
  }

  private void fill(int x, int y, boolean[] before) {
    for (int k = 0; k < 9; k++) {
      int order = k < 4 ? 2 * k + 1 : 2 * k - 8;
      int nx = x + order % 3 - 1;
      int ny = y + order / 3 - 1;
      if (nx >= 0 && ny >= 0 && nx < size && ny < size && before[ny * size + nx]) {
        covered[y * size + x] = true;
        colours.set(x, y, colours.get(nx, ny));
        relief.set(x, y, relief.get(nx, ny));
        return;
      }
    }
  }
}
