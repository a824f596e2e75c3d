package io.github.lumbre.scene.internal;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/**
 * The names of the objects and materials of a scene's primitives.
 *
 * @param objects name of each primitive's object, in the order of the primitives
 * @param materials name of each primitive's material, in the order of the primitives
 */
public record SurfaceNames(List<String> objects, List<String> materials) {
  public static final SurfaceNames NONE = new SurfaceNames(List.of(), List.of());

  public SurfaceNames {
    objects = List.copyOf(objects);
    materials = List.copyOf(materials);
    if (objects.size() != materials.size()) {
      throw new IllegalArgumentException(
          "materials: expected " + objects.size() + " names, found " + materials.size());
    }
  }

  /** Returns the name of the object of a primitive; made from its number if there is none. */
  public String object(int primitive) {
    return primitive < objects.size() ? objects.get(primitive) : "object " + primitive;
  }

  /** Returns the name of the material of a primitive; made from its number if there is none. */
  public String material(int primitive) {
    return primitive < materials.size() ? materials.get(primitive) : "material " + primitive;
  }

  /** Returns the number of characters of all names. */
  public long length() {
    return Stream.concat(objects.stream(), materials.stream()).mapToLong(String::length).sum();
  }

  /** Returns the names, in which numbers replace empty ones. */
  public static SurfaceNames of(List<String> objects, List<String> materials) {
    return new SurfaceNames(completed("object", objects), completed("material", materials));
  }

  private static List<String> completed(String kind, List<String> names) {
    List<String> completed = new ArrayList<>();
    for (int i = 0; i < names.size(); i++) {
      completed.add(names.get(i).isEmpty() ? kind + " " + i : names.get(i));
    }
    return completed;
  }
}
