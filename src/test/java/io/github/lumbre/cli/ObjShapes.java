package io.github.lumbre.cli;

import java.util.function.BiFunction;

/** Shapes as texts of OBJ files. */
final class ObjShapes {
  private static final String[] QUADS = {"1342", "5687", "1265", "3784", "1573", "2486"};

  /** Returns a cube; the faces of a cavity have the other order. */
  static String cube(String name, double least, double side, int from, boolean isCavity) {
    StringBuilder text = new StringBuilder(name.isEmpty() ? "" : "o " + name + "\n");
    for (int i = 0; i < 8; i++) {
      text.append("v ").append(least + (i & 1) * side).append(' ');
      text.append(least + (i >> 1 & 1) * side).append(' ');
      text.append(least + (i >> 2) * side).append('\n');
    }
    for (String quad : QUADS) {
      String order = isCavity ? new StringBuilder(quad).reverse().toString() : quad;
      text.append('f');
      order.chars().forEach(c -> text.append(' ').append(c - '0' + from));
      text.append('\n');
    }
    return text.toString();
  }

  /** Returns a surface of n by m quadrilaterals, closed in both directions. */
  static String grid(int n, int m, BiFunction<Double, Double, double[]> at) {
    StringBuilder text = new StringBuilder("o shape\n");
    for (int i = 0; i < n * m; i++) {
      double[] p = at.apply(2 * Math.PI * (i / m) / n, 2 * Math.PI * (i % m) / m);
      text.append("v %s %s %s\n".formatted(p[0], p[1], p[2]));
    }
    for (int i = 0; i < n * m; i++) {
      int right = (i / m + 1) % n * m - n * m;
      int here = i / m * m - n * m;
      int up = (i + 1) % m;
      text.append(
          "f %d %d %d %d\n".formatted(here + i % m, here + up, right + up, right + i % m));
    }
    return text.toString();
  }

  static String torus(String name, double x, double y, double z) {
    return grid(
            96,
            48,
            (a, b) ->
                new double[] {
                  x + (2 + .7 * Math.cos(b)) * Math.cos(a),
                  y + .7 * Math.sin(b),
                  z + (2 + .7 * Math.cos(b)) * Math.sin(a)
                })
        .replace("o shape", "o " + name);
  }

  private ObjShapes() {}
}
