package io.github.lumbre.scene.internal;

import io.github.lumbre.scene.Primitive;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** The light groups of a scene. Lights without a group have the number -1. Immutable. */
public final class LightGroups {
  private static final Pattern NAME = Pattern.compile("\\w*");

  private final List<String> names;
  private final int[] ofEmitter;
  private final int[] ofPrimitive;

  /**
   * Creates the groups.
   *
   * @param ofEmitter name of each emitter's group; empty for none
   * @param ofPrimitive name of the group of each primitive's emission; empty for none
   */
  public LightGroups(List<String> ofEmitter, List<String> ofPrimitive, List<Primitive> primitives) {
    List<String> emissive =
        IntStream.range(0, primitives.size())
            .filter(i -> primitives.get(i).emission().isPresent())
            .mapToObj(ofPrimitive::get)
            .toList();
    names =
        Stream.concat(ofEmitter.stream(), emissive.stream())
            .filter(name -> !name.isEmpty())
            .distinct()
            .sorted()
            .toList();
    this.ofEmitter = ofEmitter.stream().mapToInt(names::indexOf).toArray();
    this.ofPrimitive = ofPrimitive.stream().mapToInt(names::indexOf).toArray();
  }

  /** Returns whether a text can name a group: letters, digits and underscores, or empty. */
  public static boolean isName(String name) {
    return NAME.matcher(name).matches();
  }

  /**
   * Checks the name of a group.
   *
   * @throws IllegalArgumentException if it cannot be one
   */
  public static void require(String name) {
    if (!isName(name)) {
      throw new IllegalArgumentException(
          "light group: expected letters, digits and underscores, found '" + name + "'");
    }
  }

  /** Returns the names of the groups, sorted; their numbers are the indices. */
  public List<String> names() {
    return names;
  }

  /** Returns the number of the group of an emitter of the scene, or -1. */
  public int ofEmitter(int emitter) {
    return ofEmitter[emitter];
  }

  /** Returns the number of the group of a primitive's emission, or -1. */
  public int ofPrimitive(int primitive) {
    return ofPrimitive[primitive];
  }

  /** Returns whether other emitters and primitives have the same groups, in the same order. */
  public boolean isLike(LightGroups other) {
    return names.equals(other.names)
        && Arrays.equals(ofEmitter, other.ofEmitter)
        && Arrays.equals(ofPrimitive, other.ofPrimitive);
  }
}
