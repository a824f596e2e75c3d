package generator;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Maps, lists, strings, booleans and numbers as JSON; whatever fits a line stays on it. */
final class Json {
  private static final int LINE = 120;

  static Map<String, Object> map(Object... keysAndValues) {
    Map<String, Object> map = new LinkedHashMap<>();
    for (int i = 0; i < keysAndValues.length; i += 2) {
      String key = (String) keysAndValues[i];
      map.put(key, value(key, keysAndValues[i + 1]));
    }
    return map;
  }

  /** Pairs are points; triples are vectors under the keys of places, and colours elsewhere. */
  static Object value(String key, Object value) {
    if (!(value instanceof double[] v)) {
      return value;
    }
    if (v.length == 2) {
      return map("x", v[0], "y", v[1]);
    }
    boolean vector = key.startsWith("local");
    return vector ? map("x", v[0], "y", v[1], "z", v[2]) : map("r", v[0], "g", v[1], "b", v[2]);
  }

  static String write(Object value) {
    return write(value, "", 0);
  }

  private static String write(Object value, String indent, int used) {
    String line = oneLine(value);
    boolean container = value instanceof Map || value instanceof List;
    boolean root = indent.isEmpty();
    if (!container || !root && !hasChildren(value) && used + line.length() < LINE) {
      return line;
    }
    String inner = indent + "  ";
    List<String> items = new ArrayList<>();
    if (value instanceof Map<?, ?> map) {
      map.forEach((key, v) -> items.add(member(String.valueOf(key), v, inner)));
    } else {
      ((List<?>) value).forEach(v -> items.add(inner + write(v, inner, inner.length())));
    }
    String open = value instanceof Map ? "{\n" : "[\n";
    String close = value instanceof Map ? "}" : "]";
    return open + String.join(",\n", items) + "\n" + indent + close;
  }

  private static String member(String key, Object value, String indent) {
    String start = indent + quote(key) + ": ";
    return start + write(value, indent, start.length());
  }

  /** Lists of maps never share a line. */
  private static boolean hasChildren(Object value) {
    return value instanceof List || value instanceof Map<?, ?> map && map.containsKey("children");
  }

  private static String oneLine(Object value) {
    if (value instanceof Map<?, ?> map) {
      List<String> members = new ArrayList<>();
      map.forEach((key, v) -> members.add(quote(String.valueOf(key)) + ": " + oneLine(v)));
      return "{" + String.join(", ", members) + "}";
    }
    if (value instanceof List<?> list) {
      return "[" + String.join(", ", list.stream().map(Json::oneLine).toList()) + "]";
    }
    return value instanceof String s ? quote(s) : scalar(value);
  }

  /** Numbers in plain notation with at most four decimals. */
  static String scalar(Object value) {
    if (!(value instanceof Double d)) {
      return String.valueOf(value);
    }
    BigDecimal rounded = BigDecimal.valueOf(d).setScale(4, RoundingMode.HALF_EVEN);
    return rounded.signum() == 0 ? "0" : rounded.stripTrailingZeros().toPlainString();
  }

  /** The scenes' names are plain; nothing needs an escape. */
  private static String quote(String text) {
    return '"' + text + '"';
  }
}
