package generator;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * The text of a Wavefront OBJ file, with every position, uv and normal written once. Mutable while
 * it is built.
 */
final class ObjFile implements Triangles<String> {
  private final Map<String, Integer> positions = new LinkedHashMap<>();
  private final Map<String, Integer> coordinates = new LinkedHashMap<>();
  private final Map<String, Integer> normals = new LinkedHashMap<>();
  private final StringBuilder faces = new StringBuilder();
  private final int decimals;
  private int triangles;

  /**
   * @param decimals digits after the point of a position
   */
  ObjFile(int decimals) {
    this.decimals = decimals;
  }

  /** Returns the corner "v/t/n" to be used in {@link #face}. */
  @Override
  public String corner(Vec p, double u, double v, Vec n) {
    return index(
            positions, number(p.x(), decimals), number(p.y(), decimals), number(p.z(), decimals))
        + "/"
        + index(coordinates, number(u, 4), number(v, 4))
        + "/"
        + index(normals, number(n.x(), 3), number(n.y(), 3), number(n.z(), 3));
  }

  /** Adds a triangle, unless two of its corners coincide. */
  @Override
  public void face(String a, String b, String c) {
    String pa = a.substring(0, a.indexOf('/'));
    String pb = b.substring(0, b.indexOf('/'));
    String pc = c.substring(0, c.indexOf('/'));
    if (pa.equals(pb) || pb.equals(pc) || pc.equals(pa)) {
      return;
    }
    faces.append("f ").append(a).append(' ').append(b).append(' ').append(c).append('\n');
    triangles++;
  }

  int triangles() {
    return triangles;
  }

  void write(Path file, String title) throws IOException {
    StringBuilder text = new StringBuilder("# " + title + "\n");
    positions.keySet().forEach(p -> text.append("v ").append(p).append('\n'));
    coordinates.keySet().forEach(p -> text.append("vt ").append(p).append('\n'));
    normals.keySet().forEach(p -> text.append("vn ").append(p).append('\n'));
    Files.writeString(file, text.append(faces));
  }

  private static int index(Map<String, Integer> list, String... parts) {
    String key = String.join(" ", parts);
    list.putIfAbsent(key, list.size() + 1);
    return list.get(key);
  }

  /** The shortest decimal text of {@code value} rounded to so many digits after the point. */
  private static String number(double value, int digits) {
    long scale = 1;
    for (int i = 0; i < digits; i++) {
      scale *= 10;
    }
    long rounded = Math.round(value * scale);
    long whole = Math.abs(rounded) / scale;
    StringBuilder text = new StringBuilder(rounded < 0 ? "-" : "");
    text.append(whole == 0 && rounded % scale != 0 ? "" : whole);
    String fraction = Long.toString(Math.abs(rounded) % scale + scale).substring(1);
    fraction = fraction.replaceFirst("0+$", "");
    return fraction.isEmpty() ? text.toString() : text.append('.').append(fraction).toString();
  }
}
