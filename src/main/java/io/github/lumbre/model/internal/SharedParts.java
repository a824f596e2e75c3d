package io.github.lumbre.model.internal;

import io.github.lumbre.math.Transform;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Replaces parts and meshes of a pose by equal ones of the pose before it, so that both share their
 * memory and hierarchies. Mutable.
 */
final class SharedParts {
  private Map<Key, ModelPart> before = new HashMap<>();

  /** A surface, by its place in the file and its number among the surfaces of this place. */
  private record Key(String location, int number) {}

  /** Returns the parts of the next pose. */
  List<ModelPart> of(List<ModelPart> parts) {
    Map<Key, ModelPart> now = new HashMap<>();
    Map<String, Integer> counts = new HashMap<>();
    List<ModelPart> all = new ArrayList<>();
    for (ModelPart part : parts) {
      Key key = new Key(part.location(), counts.merge(part.location(), 1, Integer::sum));
      ModelPart known = before.get(key);
      ModelPart used = known == null ? part : shared(part, known);
      now.put(key, used);
      all.add(used);
    }
    before = now;
    return all;
  }

  private static ModelPart shared(ModelPart part, ModelPart known) {
    boolean isSameShape = isSame(part.geometry(), known.geometry());
    boolean isSameMaterial = part.material().equals(known.material());
    if (isSameShape && isSameMaterial && isSame(part.toWorld(), known.toWorld())) {
      return known;
    }
    return part.with(
        known.node(),
        isSameShape ? known.geometry() : part.geometry(),
        isSameMaterial ? known.material() : part.material());
  }

  private static boolean isSame(Transform a, Transform b) {
    return Arrays.equals(a.toArray(), b.toArray());
  }

  private static boolean isSame(ModelGeometry a, ModelGeometry b) {
    return a == b
        || a.isPoints() == b.isPoints()
            && Arrays.equals(a.positions(), b.positions())
            && Arrays.equals(a.normals(), b.normals())
            && Arrays.equals(a.tangents(), b.tangents())
            && Arrays.equals(a.uv0(), b.uv0())
            && Arrays.equals(a.uv1(), b.uv1())
            && Arrays.equals(a.colors(), b.colors())
            && Arrays.equals(a.indices(), b.indices());
  }
}
