package generator;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** An object of a scene: what it is, where it stands and what hangs on it. */
final class Node {
  final Map<String, Object> map = new LinkedHashMap<>();

  Node(String type, String name, Object... keys) {
    with("id", 0, "name", name, "type", type).with(keys);
  }

  Node with(Object... keys) {
    map.putAll(Json.map(keys));
    return this;
  }

  Node at(double x, double y, double z) {
    return with("localPosition", new double[] {x, y, z});
  }

  /** Turns in degrees: about z first, then x, then y. */
  Node turn(double x, double y, double z) {
    return with("localRotation", new double[] {x, y, z});
  }

  Node scale(double factor) {
    return with("localScale", new double[] {factor, factor, factor});
  }

  Node child(Node child) {
    children(map).add(child.map);
    return child;
  }

  @SuppressWarnings("unchecked")
  private static List<Object> children(Map<String, Object> map) {
    return (List<Object>) map.computeIfAbsent("children", key -> new ArrayList<Object>());
  }

  /** Numbers the objects in the order of the file. Returns the first number not used. */
  @SuppressWarnings("unchecked")
  static int number(List<Object> objects, int first) {
    int next = first;
    for (Object object : objects) {
      Map<String, Object> map = (Map<String, Object>) object;
      map.put("id", next++);
      if (map.containsKey("children")) {
        List<Object> last = (List<Object>) map.remove("children");
        map.put("children", last);
        next = number(last, next);
      }
    }
    return next;
  }
}
